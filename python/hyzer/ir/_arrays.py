"""Functions of a model over arrays, shared by NumPy and JAX."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Generic, NamedTuple, TypeVar

from ._document import Ir, Output
from ._program import Programs

A = TypeVar("A")
"""Array of the library."""


class ArrayLibrary(NamedTuple):
    """Functions of a library of arrays."""

    array: Callable[[Any], Any]
    """Return an array of float64."""
    broadcast_shapes: Callable[..., tuple[int, ...]]
    dense: Callable[[Sequence[Any], Sequence[tuple[int, ...]], tuple[int, ...], tuple[int, ...]], Any]
    """Return an array from the values, their indices, the shape of the batch and that of one."""


class ArrayModel(Generic[A]):
    """Functions of a model over arrays of states.

    The last axis of `x`, `p` and `marker` is that of their elements. The axes before it, and `t`,
    are broadcast against each other: one state or an array of them.

    Parameters
    ----------
    ir : Ir
        Checked document.
    programs : Programs
        Its functions, for elements of the arrays.
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

    def __init__(self, ir: Ir, programs: Programs, library: ArrayLibrary) -> None:
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
        """Derivatives of `rhs` with respect to the states and the parameters.

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
        """Derivatives of `observe` with respect to states, parameters and marker.

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
        values = self._all("quantities", t, x, p, None, inputs)[0]
        return {part.name: values[..., k] for k, part in enumerate(self.ir.quantities)}

    def limits(self, t: Any, x: Any, p: Any = None, **inputs: Any) -> A:
        """Margins to the limits of validity, SI: the model holds where all are above 0.

        Returns
        -------
        array, shape (..., number of limits)
            Values minus bounds; ``ir.limits`` has the reasons.
        """
        values = self._all("limits", t, x, p, None, inputs)[0]
        return values - self._library.array([limit.bound for limit in self.ir.limits])

    def _observed(self) -> None:
        if not self.ir.functions["observe"].outputs[0].values:
            raise ValueError(f"the model {self.ir.model} has no observation")

    def _all(
        self, name: str, t: Any, x: Any, p: Any, marker: Any, inputs: dict[str, Any]
    ) -> list[A]:
        """Return each output of a function as a dense array."""
        t = self._library.array(t)
        arrays = {
            "t": [t],
            "x": self._elements("x", x, self.states),
            "p": self._elements("p", self.p0 if p is None else p, self.parameters),
            "m": [],
        }
        for given, value in inputs.items():
            self._replace(arrays["p"], given, value)
        if marker is not None:
            arrays["m"] = self._marker(marker)
        shapes = (element.shape for elements in arrays.values() for element in elements)
        batch = self._library.broadcast_shapes(*dict.fromkeys(shapes))
        values = self._programs(name, arrays)
        return [
            self._library.dense(values[output.name], indices(output), batch, output.shape)
            for output in self.ir.functions[name].outputs
        ]

    def _elements(self, name: str, value: Any, names: Sequence[str]) -> list[Any]:
        """Return the elements along the last axis."""
        value = self._library.array(value)
        if value.ndim == 0 or value.shape[-1] != len(names):
            expected = f"(..., {len(names)}), for {', '.join(names)}"
            raise ValueError(f"{name}: found an array of shape {value.shape}, expected {expected}")
        return [value[..., k] for k in range(len(names))]

    def _replace(self, p: list[Any], name: str, value: Any) -> None:
        """Replace the components of an input among the parameters."""
        known = {given.name: given.parameters for given in self.ir.inputs}
        if name not in known:
            expected = ", ".join(known) or "none, which this model has"
            raise TypeError(f"found the input {name!r}, expected one of: {expected}")
        parts = self._elements(name, value, known[name])
        for parameter, part in zip(known[name], parts, strict=True):
            p[self.parameters.index(parameter)] = part

    def _marker(self, value: Any) -> list[Any]:
        value = self._library.array(value)
        if value.ndim == 0:
            return [value] * len(self.ir.marker)
        return self._elements("marker", value, self.ir.marker)


def indices(output: Output) -> Sequence[tuple[int, ...]]:
    """Return the index of each value of an output in its vector or matrix."""
    return output.entries or [(k,) for k in range(len(output.values))]
