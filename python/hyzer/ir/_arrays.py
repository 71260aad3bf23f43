"""Functions of a model over arrays, shared by NumPy and JAX."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Generic, NamedTuple, TypeVar, cast

from ._document import Ir, Output
from ._program import Values

A = TypeVar("A")
"""Array of the library."""


Evaluate = Callable[[str, Mapping[str, Sequence[Any]]], Values]


class ArrayLibrary(NamedTuple):
    """Functions of a library of arrays."""

    array: Callable[[Any], Any]
    """Return an array of float64."""
    broadcast_shapes: Callable[..., tuple[int, ...]]
    dense: Callable[
        [Sequence[Any], Sequence[tuple[int, ...]], tuple[int, ...], tuple[int, ...]], Any
    ]
    """Return an array from the values, their indices, the shape of the batch and that of one."""


class ArrayModel(Generic[A]):
    """Functions of a model over arrays of states.

    The last axis of `x`, `p` and `marker` is that of their elements. The axes before it, and `t`,
    are broadcast against each other: one state or an array of them.

    Parameters
    ----------
    ir : Ir
        Checked document.
    programs : callable
        Evaluates its functions by name, at elements of the arrays.
    library : ArrayLibrary
        Functions of the library.

    Attributes
    ----------
    states, parameters : tuple of str
        Names of the elements of `x` and `p`. The last parameters are the components of inputs.
    x0 : array, shape (n,)
        Default initial state, SI.
    p0 : array, shape (k,)
        Default values of the parameters, SI.
    """

    def __init__(self, ir: Ir, programs: Evaluate, library: ArrayLibrary) -> None:
        self.ir = ir
        self.states = tuple(state.name for state in ir.states)
        self.parameters = tuple(parameter.name for parameter in ir.parameters)
        self._programs = programs
        self._library = library
        self.x0: A = library.array([state.value for state in ir.states])
        self.p0: A = library.array([parameter.value for parameter in ir.parameters])

    def rhs(self, t: Any, x: Any, p: Any = None, **inputs: Any) -> A:
        """Time derivatives of the states.

        Parameters
        ----------
        t : float or array
            Time since release, s.
        x : array, shape (..., n)
            States, SI.
        p : array, shape (..., k), optional
            Parameters, SI. Default: those of the model.
        **inputs : array, shape (..., 3)
            Inputs by name, such as ``wind=(1, 0, 0)``, in place of their components in `p`.

        Returns
        -------
        array, shape (..., n)
            Derivatives, SI.
        """
        return self._all("rhs", t, x, p, None, inputs)[0]

    def jac(self, t: Any, x: Any, p: Any = None, **inputs: Any) -> tuple[A, A]:
        """Jacobians of `rhs` with respect to the states and the parameters.

        The arguments are those of `rhs`.

        Returns
        -------
        J : array, shape (..., n, n)
            Element (i, k) is the derivative of ``rhs[i]`` with respect to ``x[k]``, SI.
        Jp : array, shape (..., n, k)
            The same with respect to ``p[k]``, SI.
        """
        _, j, jp = self._all("jacobian", t, x, p, None, inputs)
        return j, jp

    def observe(self, t: Any, x: Any, p: Any = None, marker: Any = 0.0, **inputs: Any) -> A:
        """Position at which a marker is observed, in the inertial frame, m.

        Parameters
        ----------
        t, x, p, **inputs
            As in `rhs`.
        marker : array, shape (..., 3), optional
            Coordinates of the marker in its frame, m. Default: the origin.

        Returns
        -------
        array, shape (..., 3)
            Position, m.
        """
        self._observed()
        return self._all("observe", t, x, p, marker, inputs)[0]

    def observe_jac(
        self, t: Any, x: Any, p: Any = None, marker: Any = 0.0, **inputs: Any
    ) -> tuple[A, A, A]:
        """Jacobians of `observe` with respect to states, parameters and marker.

        The arguments are those of `observe`.

        Returns
        -------
        dy_dx, dy_dp, dy_dmarker : array, shape (..., 3, n), (..., 3, k), (..., 3, 3)
            Derivatives, SI.
        """
        self._observed()
        _, dy_dx, dy_dp, dy_dmarker = self._all("observe_jacobian", t, x, p, marker, inputs)
        return dy_dx, dy_dp, dy_dmarker

    def quantities(self, t: Any, x: Any, p: Any = None, **inputs: Any) -> dict[str, A]:
        """Auxiliary variables of the model by name, SI; each has the shape of the batch."""
        values: Any = self._all("quantities", t, x, p, None, inputs)[0]
        return {part.name: values[..., k] for k, part in enumerate(self.ir.quantities)}

    def limits(self, t: Any, x: Any, p: Any = None, **inputs: Any) -> A:
        """Margins to the limits of validity, SI: the model holds where all are above 0.

        Returns
        -------
        array, shape (..., number of limits)
            Values minus bounds; ``ir.limits`` has the reasons.
        """
        values: Any = self._all("limits", t, x, p, None, inputs)[0]
        margins: A = values - self._library.array([limit.bound for limit in self.ir.limits])
        return margins

    def _observed(self) -> None:
        if not self.ir.functions["observe"].outputs[0].values:
            raise ValueError(f"the model {self.ir.model} has no observation")

    def _all(
        self, name: str, t: Any, x: Any, p: Any, marker: Any, inputs: dict[str, Any]
    ) -> list[A]:
        """Return each output of a function as a dense array."""
        given = {
            "t": self._library.array(t)[..., None],
            "x": self._checked("x", x, self.states),
            "p": self._checked("p", self.p0 if p is None else p, self.parameters, self.p0),
        }
        if marker is not None:
            given["m"] = self._marker(marker)
        arrays = {letter: elements(array) for letter, array in given.items()}
        shapes = {array.shape[:-1] for array in given.values()}
        for own, value in inputs.items():
            shapes.add(self._replace(arrays["p"], own, value))
        batch = self._library.broadcast_shapes(*shapes)
        values = self._programs(name, arrays)
        return [
            self._library.dense(values[output.name], indices(output), batch, output.shape)
            for output in self.ir.functions[name].outputs
        ]

    def _checked(self, name: str, value: Any, names: Sequence[str], defaults: Any = None) -> Any:
        """Return an array with an element for each name along its last axis."""
        if isinstance(value, Mapping):
            given = by_name(name, cast("Mapping[Any, Any]", value), names, defaults)
            parts = [self._library.array(part) for part in given]
            batch = self._library.broadcast_shapes(*(part.shape for part in parts))
            places = [(k,) for k in range(len(names))]
            return self._library.dense(parts, places, batch, (len(names),))
        array = self._library.array(ordered(name, value, names))
        if array.ndim == 0 or array.shape[-1] != len(names):
            expected = f"(..., {len(names)}), for {', '.join(names)}"
            raise ValueError(f"{name}: found an array of shape {array.shape}, expected {expected}")
        return array

    def _replace(self, p: list[Any], name: str, value: Any) -> tuple[int, ...]:
        """Replace the components of an input among the parameters; return its batch shape."""
        known = {given.name: given.parameters for given in self.ir.inputs}
        if name not in known:
            expected = ", ".join(known) or "none, which this model has"
            raise TypeError(f"found the input {name!r}, expected one of: {expected}")
        array = self._checked(name, value, known[name])
        for parameter, part in zip(known[name], elements(array), strict=True):
            p[self.parameters.index(parameter)] = part
        shape: tuple[int, ...] = array.shape[:-1]
        return shape

    def _marker(self, value: Any) -> Any:
        if isinstance(value, Mapping):
            return self._checked("marker", value, self.ir.marker)
        array = self._library.array(value)
        if array.ndim == 0:
            return self._library.array([value] * len(self.ir.marker))
        return self._checked("marker", array, self.ir.marker)


def by_name(what: str, values: Mapping[Any, Any], names: Sequence[str], defaults: Any) -> list[Any]:
    """Return the values of a mapping in the order of `names`, with `defaults` for others."""
    is_whole = defaults is not None or all(name in values for name in names)
    if not is_whole or any(name not in names for name in values):
        found, expected = ", ".join(map(str, values)), ", ".join(names)
        some = "some of " if defaults is not None else ""
        raise ValueError(f"{what}: found the names {found}, expected {some}{expected}")
    others = [None for _ in names] if defaults is None else defaults
    return [values.get(name, other) for name, other in zip(names, others, strict=True)]


def ordered(what: str, value: Any, names: Sequence[str]) -> Any:
    """Return an array by its labels along the last axis: in the order of `names`, without labels.

    Labels are the index of a Series, the columns of a DataFrame, the coordinates of an xarray;
    numbers are no labels. Rows of a list have labels of their own.
    """
    if isinstance(value, (list, tuple)):
        rows = cast("Sequence[Any]", value)
        return [ordered(what, row, names) for row in rows] if _has_rows(rows) else rows
    labels = _labels(value)
    if not any(isinstance(label, str) for label in labels):
        return value
    if sorted(map(str, labels)) != sorted(names):
        found, expected = ", ".join(map(str, labels)), ", ".join(names)
        raise ValueError(f"{what}: found the labels {found}, expected {expected}")
    places = [labels.index(name) for name in names]
    values: Any = value.to_numpy() if hasattr(value, "to_numpy") else value.values
    return values[..., places]


def _has_rows(value: Sequence[Any]) -> bool:
    return any(hasattr(row, "iloc") or hasattr(row, "dims") for row in value)


def _labels(value: Any) -> list[Any]:
    """Return the labels of the last axis of an array of pandas, polars or xarray; else none."""
    columns = getattr(value, "columns", None)
    # Matrices of CasADi have a method of that name.
    if columns is not None and not callable(columns):
        return list(columns)
    if hasattr(value, "iloc"):
        return list(value.index)
    dims, coords = getattr(value, "dims", ()), getattr(value, "coords", {})
    return list(coords[dims[-1]].values) if dims and dims[-1] in coords else []


def elements(array: Any) -> list[Any]:
    """Return the elements along the last axis."""
    if array.ndim == 1:
        return list(array)
    return [array[..., k] for k in range(array.shape[-1])]


def indices(output: Output) -> Sequence[tuple[int, ...]]:
    """Return the index of each value of an output in its vector or matrix."""
    if output.entries is None:
        return [(k,) for k in range(len(output.values))]
    return output.entries
