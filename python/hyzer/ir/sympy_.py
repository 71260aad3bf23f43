"""Expressions of a model for SymPy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from ._document import Ir, Table
from ._operations import Library, horner
from ._program import Programs, Values, required
from ._read import read

if TYPE_CHECKING:
    import sympy  # type: ignore[import-untyped]


@dataclass(frozen=True)
class SympyModel:
    """Expressions of a model by name, each computed when it is first asked for.

    Attributes
    ----------
    symbols : dict
        Real symbols by name: ``time``, the states, the parameters, the marker's coordinates.
    ir : Ir
        Names, units and default values.
    """

    symbols: dict[str, sympy.Symbol]
    ir: Ir
    _programs: Programs
    _sympy: Any

    @cached_property
    def rhs(self) -> dict[str, sympy.Expr]:
        """Time derivative of each state."""
        return self._named("rhs", "dx", [state.name for state in self.ir.states])

    @cached_property
    def jac(self) -> tuple[sympy.Matrix, sympy.Matrix]:
        """Derivatives of `rhs` with respect to states and parameters: matrices J and Jp."""
        values = self._values("jacobian")
        outputs = self.ir.functions["jacobian"].outputs[1:]
        j, jp = (self._matrix(o.shape, o.entries or (), values[o.name]) for o in outputs)
        return j, jp

    @cached_property
    def observe(self) -> dict[str, sympy.Expr]:
        """Observed position ``x``, ``y``, ``z``, m; empty if the model has no observation."""
        return self._named("observe", "y", ["x", "y", "z"])

    @cached_property
    def quantities(self) -> dict[str, sympy.Expr]:
        """Auxiliary variables of the model."""
        return self._named("quantities", "q", [part.name for part in self.ir.quantities])

    @cached_property
    def limits(self) -> dict[str, sympy.Expr]:
        """Margins to the limits of validity by their reason; above 0 where the model holds."""
        values = self._named("limits", "l", [limit.reason for limit in self.ir.limits])
        return {limit.reason: values[limit.reason] - limit.bound for limit in self.ir.limits}

    def _values(self, function: str) -> Values:
        names = {
            "x": [state.name for state in self.ir.states],
            "p": [parameter.name for parameter in self.ir.parameters],
            "m": self.ir.marker,
            "t": ["time"],
        }
        symbols = {letter: [self.symbols[name] for name in own] for letter, own in names.items()}
        return self._programs(function, symbols)

    def _named(self, function: str, output: str, names: Sequence[str]) -> dict[str, Any]:
        return dict(zip(names, self._values(function)[output], strict=False))

    def _matrix(
        self, shape: tuple[int, ...], places: Sequence[tuple[int, int]], values: list[Any]
    ) -> Any:
        matrix = self._sympy.zeros(*shape)
        for place, value in zip(places, values, strict=True):
            matrix[place] = value
        return matrix


class SympyLibrary(Library):
    """SymPy's functions of expressions; a number is negligible where it is 0."""

    def __init__(self, sympy: Any) -> None:
        self.sympy = sympy
        self.both = sympy.And
        names = ("sqrt", "sin", "cos", "asin", "exp", "log", "tanh", "atan2")
        self.functions = {"abs": sympy.Abs, **{name: getattr(sympy, name) for name in names}}

    def where(self, condition: Any, then: Any, otherwise: Any) -> Any:
        """Return the expression that is `then` where the condition holds."""
        condition = self.without_pieces(condition)
        return self.pieces((then, condition), (otherwise, True))

    def without_pieces(self, condition: Any) -> Any:
        """Return a condition on a `Piecewise` as conditions on its pieces, which print."""
        if not condition.has(self.sympy.Piecewise):
            return condition
        folded = self.sympy.piecewise_fold(condition)
        if not isinstance(folded, self.sympy.Piecewise):
            return folded
        holds = self.sympy.false
        for piece, where in reversed(folded.args):
            here = self.sympy.And(where, self.without_pieces(piece))
            holds = self.sympy.Or(here, self.sympy.And(self.sympy.Not(where), holds))
        return holds

    def pieces(self, *pairs: tuple[Any, Any]) -> Any:
        """Return a `Piecewise` as it is written, without a search for simpler conditions."""
        exact = [(self.number(x) if isinstance(x, float) else x, where) for x, where in pairs]
        return self.sympy.Piecewise(*exact, evaluate=False)

    def number(self, value: float) -> Any:
        """Return an integer, or a float of 53 bits."""
        exact = int(value)
        return self.sympy.Integer(exact) if value == exact else self.sympy.Float(value)

    def is_zero(self, x: Any) -> Any:
        """Return the condition that `x` is zero."""
        return self.sympy.Eq(x, 0)

    negligible = is_zero

    def replaced(self, condition: Any, harmless: float, x: Any) -> Any:
        """Return `x`: no expression is evaluated where its condition does not hold."""
        return x

    def reciprocal(self, x: Any) -> Any:
        """Return the reciprocal; of a `Piecewise`, that of each piece that is not 0."""
        if not isinstance(x, self.sympy.Piecewise):
            return 1 / x
        pairs = [(0 if e == 0 else self.reciprocal(e), where) for e, where in x.args]
        return self.pieces(*pairs)

    def lookup(self, table: Table, x: Any) -> Any:
        """Return the value of a piecewise cubic at `x`."""
        origins = (table.knots[0], *table.knots)
        parts = [horner(c, x - o) for c, o in zip(table.cubics, origins, strict=True)]
        ends = [x < knot for knot in table.knots]
        return self.pieces(*zip(parts, [*ends, True], strict=True))


def to_sympy(ir: dict[str, Any] | Ir) -> SympyModel:
    """Expressions of a model for SymPy.

    Parameters
    ----------
    ir : dict or Ir
        Document as ``json.loads`` returns it.

    Returns
    -------
    SympyModel
        Object with the expressions `rhs`, `jac`, `observe`, `quantities` and `limits`.

    Raises
    ------
    IrError
        If the document is not one of schema ``hyzer.ir/1``.
    ImportError
        If SymPy is missing.

    Examples
    --------
    >>> import json, subprocess
    >>> text = subprocess.check_output(["hyzer", "export", "ball", "--ir"])
    >>> ball = to_sympy(json.loads(text))
    >>> ball.rhs["x"]
    vx
    >>> ball.symbols["C_D"] in ball.rhs["vx"].free_symbols
    True
    """
    sympy = required("sympy", "to_sympy")
    checked = read(ir)
    states = [state.name for state in checked.states]
    parameters = [parameter.name for parameter in checked.parameters]
    names = ["time", *states, *parameters, *checked.marker]
    symbols = {name: sympy.Symbol(name, real=True) for name in names}
    library = SympyLibrary(sympy)
    return SympyModel(symbols, checked, Programs(checked, library, library.number), sympy)
