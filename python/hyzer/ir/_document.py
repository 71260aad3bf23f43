"""The parts of an IR document, as they are after the check by :func:`read`."""

from __future__ import annotations

from dataclasses import dataclass

SCHEMA = "hyzer.ir/1"
"""Value of ``schema`` in the documents that this package reads."""

ARITY = {
    **dict.fromkeys(("neg", "recip", "recip_or_zero", "nonzero", "sign", "step", "abs"), 1),
    **dict.fromkeys(("sqrt", "sin", "cos", "asin", "exp", "log", "tanh", "table"), 1),
    **dict.fromkeys(("add", "sub", "mul", "div", "atan2", "min", "max", "table_of_two"), 2),
    **dict.fromkeys(("mul_add", "mul_sub", "neg_mul_add", "if_zero"), 3),
}
"""Number of operands of each operation; docs/reference/ir.md states what each computes."""

Operand = float | tuple[str, int]
"""A constant, or an element of an array: its letter and its index."""


class IrError(ValueError):
    """An IR document is not what :func:`hyzer.ir.read` can read.

    The message says where the fault is, what was found and what was expected.
    """


@dataclass(frozen=True)
class State:
    """A state: its name, its SI unit and its default initial value."""

    name: str
    unit: str
    value: float


@dataclass(frozen=True)
class Parameter:
    """A known constant, a coefficient or a component of an input, with its default value, SI."""

    name: str
    unit: str
    value: float
    coefficient: bool
    bounds: tuple[float, float] | None
    doc: str


@dataclass(frozen=True)
class Input:
    """A vector that is given with each flight; `parameters` are the names of its components."""

    name: str
    unit: str
    frame: str
    parameters: tuple[str, str, str]


@dataclass(frozen=True)
class Quantity:
    """An auxiliary variable of the model, or a component of one, with its SI unit."""

    name: str
    unit: str


@dataclass(frozen=True)
class Limit:
    """A limit of validity: the model holds where the value exceeds `bound`."""

    bound: float
    reason: str


@dataclass(frozen=True)
class Table:
    """A piecewise cubic: increasing knots, and one cubic more than knots."""

    name: str
    knots: tuple[float, ...]
    cubics: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class TableOfTwo:
    """A piecewise bicubic: increasing knots of both arguments, and coefficients of each cell."""

    name: str
    knots: tuple[float, ...]
    second_knots: tuple[float, ...]
    bicubics: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class Statement:
    """One operation; `table` is the index of the table that it looks up, else None."""

    operation: str
    operands: tuple[Operand, ...]
    table: int | None


@dataclass(frozen=True)
class Output:
    """A vector, or the stored entries (row, column) of a matrix."""

    name: str
    shape: tuple[int, ...]
    values: tuple[Operand, ...]
    entries: tuple[tuple[int, int], ...] | None


@dataclass(frozen=True)
class Function:
    """Straight-line program: statements, and outputs that refer to them."""

    inputs: tuple[str, ...]
    statements: tuple[Statement, ...]
    outputs: tuple[Output, ...]


@dataclass(frozen=True)
class Ir:
    """A checked IR document."""

    version: str
    model: str
    effects: tuple[str, ...]
    states: tuple[State, ...]
    parameters: tuple[Parameter, ...]
    inputs: tuple[Input, ...]
    marker: tuple[str, ...]
    quantities: tuple[Quantity, ...]
    limits: tuple[Limit, ...]
    tables: tuple[Table | TableOfTwo, ...]
    functions: dict[str, Function]
