"""Functions of a model for CasADi."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, cast

from ._arrays import by_name, ordered
from ._document import Ir, Output, Table
from ._operations import Library, horner
from ._program import Programs, required
from ._read import read

if TYPE_CHECKING:
    import casadi


@dataclass(frozen=True)
class CasadiModel:
    """Functions of a model, each a ``casadi.Function``.

    States, parameters and markers are vectors in the order of `ir`; a Series or DataFrame goes by
    its labels, a mapping by its keys, where parameters that it lacks are those of the model.

    Attributes
    ----------
    rhs : (t, x, p) -> dx
        Time derivatives of the states, SI.
    jac : (t, x, p) -> J, Jp
        Their derivatives with respect to states and parameters, sparse.
    observe : (t, x, p, marker) -> y
        Position at which a marker is observed, m; without rows if the model has no observation.
    quantities : (t, x, p) -> q
        Auxiliary variables, in the order of ``ir.quantities``.
    limits : (t, x, p) -> margin
        Margins to the limits of validity: the model holds where all are above 0.
    ir : Ir
        Names, units and default values.
    """

    rhs: casadi.Function
    jac: casadi.Function
    observe: casadi.Function
    quantities: casadi.Function
    limits: casadi.Function
    ir: Ir

    @property
    def x0(self) -> list[float]:
        """Default initial state, SI."""
        return [state.value for state in self.ir.states]

    @property
    def p0(self) -> list[float]:
        """Default values of the parameters, SI."""
        return [parameter.value for parameter in self.ir.parameters]


class CasadiLibrary(Library):
    """CasADi's functions of symbolic expressions."""

    def __init__(self, casadi: Any) -> None:
        self.where = casadi.if_else
        self.both = casadi.logic_and
        names = ("sqrt", "sin", "cos", "asin", "exp", "log", "tanh", "atan2")
        self.functions = {"abs": casadi.fabs, **{name: getattr(casadi, name) for name in names}}

    def lookup(self, table: Table, x: Any) -> Any:
        """Return the value of a piecewise cubic at `x`."""
        value = horner(table.cubics[0], x - table.knots[0])
        for knot, cubic in zip(table.knots, table.cubics[1:], strict=True):
            value = self.where(x >= knot, horner(cubic, x - knot), value)
        return value


def to_casadi(ir: dict[str, Any] | Ir, kind: Literal["SX", "MX"] = "SX") -> CasadiModel:
    """Functions of a model as functions of CasADi.

    Parameters
    ----------
    ir : dict or Ir
        Document as ``json.loads`` returns it.
    kind : {"SX", "MX"}
        Kind of the expressions. SX is faster; a function of either can be called with both.

    Returns
    -------
    CasadiModel
        Object with the functions `rhs`, `jac`, `observe`, `quantities` and `limits`.

    Raises
    ------
    IrError
        If the document is not one of schema ``hyzer.ir/1``.
    ImportError
        If CasADi is missing.
    ValueError
        If `kind` is neither "SX" nor "MX".

    Examples
    --------
    >>> import json, subprocess
    >>> text = subprocess.check_output(["hyzer", "export", "ball", "--ir"])
    >>> ball = to_casadi(json.loads(text))
    >>> ball.rhs
    Function(rhs:(t,x[6],p[11])->(dx[6]) SXFunction)
    >>> ball.rhs(0, ball.x0, ball.p0)[5]
    DM(-9.81)
    """
    if kind not in ("SX", "MX"):
        raise ValueError(f"kind: found {kind!r}, expected 'SX' or 'MX'")
    casadi = required("casadi", "to_casadi")
    checked = read(ir)
    symbolic = getattr(casadi, kind)
    programs = Programs(checked, CasadiLibrary(casadi), symbolic)
    sizes = {"t": 1, "x": len(checked.states), "p": len(checked.parameters)}
    symbols = {name: symbolic.sym(name, size) for name, size in sizes.items()}
    marker = symbolic.sym("marker", len(checked.marker))
    arrays: dict[str, list[Any]] = {
        letter: casadi.vertsplit(symbol) if symbol.numel() else []
        for letter, symbol in {**symbols, "m": marker}.items()
    }

    def function(name: str, outputs: dict[str, str], *more: Any) -> Any:
        values = programs(name, arrays)
        parts = {output.name: output for output in checked.functions[name].outputs}
        results = [_matrix(symbolic, parts[own], values[own]) for own in outputs.values()]
        if name == "limits":
            results[0] -= casadi.DM([limit.bound for limit in checked.limits])
        named = [*symbols, *(["marker"] if more else [])]
        made = casadi.Function(name, [*symbols.values(), *more], results, named, [*outputs])
        return _by_labels(casadi, made, checked)

    return CasadiModel(
        rhs=function("rhs", {"dx": "dx"}),
        jac=function("jacobian", {"J": "j", "Jp": "jp"}),
        observe=function("observe", {"y": "y"}, marker),
        quantities=function("quantities", {"q": "q"}),
        limits=function("limits", {"margin": "l"}),
        ir=checked,
    )


def _by_labels(casadi: Any, function: Any, ir: Ir) -> Any:
    """Return the function, which takes labelled arguments by their labels when it is called."""
    names = {"x": [own.name for own in ir.states], "p": [own.name for own in ir.parameters]}
    names["marker"] = list(ir.marker)
    defaults = {"p": [own.value for own in ir.parameters]}

    class Labelled(casadi.Function):  # type: ignore[misc]
        def __init__(self, function: Any) -> None:
            casadi.Function.__init__(self, function)

        def __call__(self, *arguments: Any, **named: Any) -> Any:
            of = [function.name_in(k) for k in range(len(arguments))]
            given = [self._vector(own, value) for own, value in zip(of, arguments, strict=True)]
            others = {k: self._vector(k, v) for k, v in named.items()}
            return casadi.Function.__call__(self, *given, **others)

        def __reduce__(self) -> Any:
            return casadi.Function.deserialize, (self.serialize(),)

        @staticmethod
        def _vector(own: str, value: Any) -> Any:
            return _vector(casadi, own, value, names.get(own, ()), defaults.get(own))

    return Labelled(function)


def _vector(casadi: Any, what: str, value: Any, names: Sequence[str], defaults: Any) -> Any:
    """Return a labelled vector, or the labelled rows of a table as columns, in order."""
    if isinstance(value, Mapping):
        given = by_name(what, cast("Mapping[Any, Any]", value), names, defaults)
        return casadi.vertcat(*given)
    found = ordered(what, value, names)
    return found.T if hasattr(value, "columns") and found is not value else found


def _matrix(symbolic: Any, output: Output, values: list[Any]) -> Any:
    """Return the matrix of an output, with the entries that it stores."""
    rows, columns = (*output.shape, 1)[:2]
    matrix = symbolic(rows, columns)
    vector = [(k, 0) for k in range(rows)]
    places = vector if output.entries is None else output.entries
    for (row, column), value in zip(places, values, strict=True):
        matrix[row, column] = value
    return matrix
