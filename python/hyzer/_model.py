"""Models of flying bodies."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Literal

from hyzer import _hyzer
from hyzer._arguments import mapping, names, numbers
from hyzer._flight import Flight
from hyzer._release import Release

if TYPE_CHECKING:
    from typing_extensions import Self

    from hyzer.ir import CasadiModel, SympyModel
    from hyzer.ir.jax_ import JaxModel
    from hyzer.ir.numpy_ import NumpyModel


class Model(_hyzer.Model):
    """A checked model of a flying body, dx/dt = f(t, x, p), with its exact derivatives.

    Parameters
    ----------
    source : str or path
        A built-in model by name (`disc`, `disc_quaternion`, `discus`, `ball`), the path of a file,
        or a text in the model language, which has more than one line.
    effects : iterable of str, or str
        Effects to add, by name or path: `hyzer effects` lists those that are built in.
    parameters : mapping of str to float
        Default values to replace, SI: constants, coefficients, components of inputs (`wind_x`).

    Attributes
    ----------
    name : str
        Name of the model.
    states : tuple of str
        Names of the states, in the order of `x`.
    parameters : tuple of str
        Names of the parameters, in the order of `p`: constants, coefficients, components of inputs.
    coefficients : tuple of str
        Those of the parameters that a fit estimates.
    effects : tuple of str
        Names of the effects added.
    units : dict of str to str
        Unit of each state and parameter; all are SI.
    defaults : dict of str to float
        Default value of each parameter, and default initial value of each state, SI.
    text : str
        The model in the model language, with the effects merged into its equations.

    Raises
    ------
    ModelError
        If there is no such model or effect, or a text has faults: the message of `hyzer check`,
        with the place and hint of the first fault as attributes, and all of them in `faults`.

    Examples
    --------
    >>> import hyzer
    >>> disc = hyzer.Model("disc", effects=["zero-lift-drag-angle"], parameters={"m": 0.18})
    >>> disc.states
    ('x', 'y', 'z', 'u', 'v', 'w', 'phi', 'theta', 'gamma', 'phidot', 'thetadot', 'gammadot')
    >>> disc.units["C_La"], disc.defaults["m"]
    ('1/rad', 0.18)
    >>> hyzer.Model("dsic")
    Traceback (most recent call last):
    hyzer._errors.ModelError: there is no model `dsic`...did you mean `disc`?...
    """

    def __new__(
        cls,
        source: str | os.PathLike[str],
        effects: Iterable[str] | str = (),
        parameters: Mapping[str, float] | None = None,
    ) -> Self:
        """Load and check the model."""
        replaced = None if parameters is None else mapping(parameters, "parameters")
        return super().__new__(cls, os.fspath(source), names(effects), replaced)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the names of which the model was made where all is built in, else its text."""
        return type(self), self.made()

    def fly(
        self,
        release: str | os.PathLike[str] | Release | Mapping[str, float],
        until: str | float | None = None,
        *,
        rate: float = 120.0,
        tolerance: float = 1e-9,
        **values: float,
    ) -> Flight:
        """Simulate the flight from a release.

        Parameters
        ----------
        release : str, path, Release or mapping
            A built-in release by name (`backhand`, `discus`, `serve`, `fssh3`, `bffl8`), a release
            file, a `Release`, or the initial value of every state by name.
        until : {"ground"} or float, optional
            Where the flight ends: on the ground, or after a number of seconds. By default that
            of the release.
        rate : float
            Samples per second of `Flight.t` and `Flight.states`.
        tolerance : float
            Relative and absolute tolerance of a step.
        **values : float
            Parameters, coefficients, initial states or components of inputs (`wind_x`) to
            replace, by name, SI.

        Returns
        -------
        Flight

        Raises
        ------
        InputError
            If the release or a value is wrong.
        FlightError
            If the flight cannot be simulated, for example because it never lands.

        Examples
        --------
        >>> import hyzer
        >>> disc = hyzer.Model("disc")
        >>> flight = disc.fly("backhand", until=1.0)
        >>> flight.states.shape
        (121, 12)
        >>> throw = hyzer.Release(speed=20, launch=8, nose=2, spin=700)
        >>> float(disc.fly(throw, C_D0=0.10).landing[0]) > float(disc.fly(throw).landing[0])
        True
        """
        begun = Release.of(release)
        if begun.lacks_spin and self.has_rotating_body:
            warnings.warn("thrown without spin; spin= states it, in rpm", stacklevel=2)
        name, text = begun.texts(self.name)
        pairs = list(numbers(values, "fly").items())
        return Flight.fly(self, name, text, until, rate, tolerance, pairs)

    def ir(self) -> dict[str, Any]:
        """Return the compiled model as data: its functions as lists of statements.

        Returns
        -------
        dict
            The document of `hyzer export --ir`; the page of a model as data in the reference
            explains it.

        Examples
        --------
        >>> import hyzer
        >>> ir = hyzer.Model("ball").ir()
        >>> ir["schema"], [state["name"] for state in ir["states"]]
        ('hyzer.ir/1', ['x', 'y', 'z', 'vx', 'vy', 'vz'])
        """
        document: dict[str, Any] = json.loads(self.ir_json())
        return document

    def to_numpy(self) -> NumpyModel:
        """Return the functions of the model over arrays of NumPy: `hyzer.ir.to_numpy`."""
        from hyzer import ir

        return ir.to_numpy(self.ir())

    def to_jax(self) -> JaxModel:
        """Return the functions of the model for JAX: `hyzer.ir.to_jax`."""
        from hyzer import ir

        return ir.to_jax(self.ir())

    def to_casadi(self, kind: Literal["SX", "MX"] = "SX") -> CasadiModel:
        """Return the functions of the model for CasADi: `hyzer.ir.to_casadi`."""
        from hyzer import ir

        return ir.to_casadi(self.ir(), kind)

    def to_sympy(self) -> SympyModel:
        """Return the expressions of the model for SymPy: `hyzer.ir.to_sympy`."""
        from hyzer import ir

        return ir.to_sympy(self.ir())


def model_of(model: str | os.PathLike[str] | _hyzer.Model | None) -> _hyzer.Model | None:
    """Return a model given by name, path, text or as an object."""
    if model is None or isinstance(model, _hyzer.Model):
        return model
    return Model(model)
