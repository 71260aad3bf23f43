"""What a generator hands over: one function of one peer, as text, with the meaning of its output."""

from dataclasses import dataclass, field

FUNCTIONS = ("f", "fj", "fjp")
LAYOUTS = ("sparse", "dense")
NX, NP = 12, 18


@dataclass
class Unit:
    """`text` defines the C symbol SYM; `kernel` is the tool's own text, for counting."""

    peer: str
    function: str
    variant: str
    chain: str
    layout: str
    kernel: str
    text: str
    language: str  # c, cpp or rust
    J: list = field(default_factory=list)  # (row, column) of each output after the 12 of f
    Jp: list = field(default_factory=list)  # (row, column) of each output after those of J

    @property
    def key(self):
        return f"{self.peer}_{self.function}_{self.variant}_{self.chain}_{self.layout}"


def dense_map(rows, cols):
    return [(i, j) for i in range(rows) for j in range(cols)]


def shapes(function, layouts):
    """Chains and layouts that make a difference to this function."""
    if function == "f":
        return [("plain", layouts[0])]
    return [(c, layout) for c in ("plain", "air", "named") for layout in layouts]
