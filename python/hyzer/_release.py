"""Releases: how flights begin."""

from __future__ import annotations

import os
import reprlib
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, cast

from hyzer import _hyzer, _toml
from hyzer._arguments import floats, is_path, mapping, plain, seconds
from hyzer._errors import InputError

if TYPE_CHECKING:
    from hyzer._analyses import AnyRelease


class Release:
    """How a flight begins: by a throw, or by the initial value of every state.

    Parameters
    ----------
    initial : mapping of str to float, optional
        Initial value of every state by name, SI. Without it the release is a throw.
    speed : float
        Speed of the mass centre over the ground, m/s.
    heading : float
        Direction of the velocity over the ground, from +x to the left, deg.
    launch : float
        Angle of the velocity above the horizontal, deg.
    nose : float
        Angle of attack, positive nose-up, deg.
    hyzer : float
        Tilt about the velocity, positive when the left edge is the lower one, seen from behind,
        deg.
    spin : float
        Spin, positive clockwise seen from above, rpm; 0 by default. A disc without spin tumbles:
        `Model.fly` warns of a throw that states none.
    height : float
        Height of the mass centre at release, m; 1 by default.
    wobble : float
        Angle between the body's axis and its angular momentum, deg.
    wind : sequence of 3 floats or mapping, optional
        Constant velocity of the air in the inertial frame, m/s, or the keys of `[wind]` in a
        release file: profiles over height, gusts.
    known : mapping of str to sequence of 3 floats, optional
        Other inputs of the model, such as the spin of a ball, `omega`, in rad/s.
    inputs : mapping of str to float, pair of arrays, pandas Series or mapping, optional
        Scalar inputs of the model, SI: a constant; the times since release, s, and the values, as
        a pair of arrays or as a Series by time, with straight lines between them; or a mapping
        with `t`, `value` and `interpolation` (`linear`, `hold`, `cubic`).
    until : {"ground"} or float
        Where the flight ends: on the ground, or after a number of seconds.
    parameters, coefficients : mapping of str to float, optional
        Values that replace the model's defaults, SI.

    Notes
    -----
    A release is checked when it is flown, with the messages of release files: they name the file
    `release`.

    Examples
    --------
    >>> import hyzer
    >>> throw = hyzer.Release(speed=20, launch=8, nose=2, hyzer=10, spin=700, height=1.5)
    >>> flight = hyzer.Model("disc").fly(throw)
    >>> hyzer.Model("ball").fly(throw)
    Traceback (most recent call last):
    hyzer._errors.InputError: release:...: found nose, but the model ball is a point mass...

    The spin of a ball is an input of its model, here a backspin of 50 revolutions per second.

    >>> ball = hyzer.Model("table_tennis_ball")
    >>> plain = hyzer.Release(speed=9, launch=20)
    >>> sliced = hyzer.Release(speed=9, launch=20, known={"omega": (0, -314, 0)})
    >>> float(ball.fly(sliced).t[-1]) > float(ball.fly(plain).t[-1])
    True

    The motors of a quadrotor are inputs over time.

    >>> import numpy as np
    >>> t = np.linspace(0, 2, 21)
    >>> motors = {f"motor_{k}": (t, 0.75 + 0.1 * np.sin(3 * t)) for k in (1, 2, 3, 4)}
    >>> hover = hyzer.Release(speed=1, inputs={**motors, "voltage": 3.9}, spin=0, until=2.0)
    >>> flight = hyzer.Model("quadrotor").fly(hover)
    >>> float(flight.t[-1])
    2.0
    """

    def __init__(
        self,
        initial: Mapping[str, float] | None = None,
        *,
        speed: float | None = None,
        heading: float | None = None,
        launch: float | None = None,
        nose: float | None = None,
        hyzer: float | None = None,
        spin: float | None = None,
        height: float | None = None,
        wobble: float | None = None,
        wind: Iterable[float] | Mapping[str, Any] | None = None,
        known: Mapping[str, Iterable[float]] | None = None,
        inputs: Mapping[str, Any] | None = None,
        until: str | float = "ground",
        parameters: Mapping[str, float] | None = None,
        coefficients: Mapping[str, float] | None = None,
    ) -> None:
        stated = {
            "speed": speed,
            "heading": heading,
            "launch": launch,
            "nose": nose,
            "hyzer": hyzer,
            "spin": spin,
            "height": height,
            "wobble": wobble,
        }
        self.name = "release"
        self._throw = {name: value for name, value in stated.items() if value is not None}
        self._initial = None if initial is None else mapping(initial, "initial")
        if self._initial and self._throw:
            found = ", ".join(self._throw)
            raise InputError(f"found states and {found}, expected all states or those of a throw")
        self._until = until
        blown: Mapping[str, Any] = {"constant": wind} if wind is not None else {}
        if isinstance(wind, Mapping):
            blown = dict(cast("Mapping[str, Any]", wind))
        self._tables: dict[str, Mapping[str, Any]] = {
            "parameters": mapping(parameters, "parameters"),
            "coefficients": mapping(coefficients, "coefficients"),
            "wind": blown,
            "known": mapping(known, "known"),
            "inputs": {
                name: over_time(name, value) for name, value in mapping(inputs, "inputs").items()
            },
        }
        self._text: str | None = None

    @classmethod
    def read(cls, name: str | os.PathLike[str]) -> Release:
        """Read a release file, or a built-in release by name.

        Examples
        --------
        >>> import hyzer
        >>> hyzer.Release.read("backhand")
        Release('backhand')
        """
        named = os.fspath(name)
        return cls.parse(named, _hyzer.release_text(named))

    @classmethod
    def parse(cls, name: str, text: str) -> Release:
        """Make a release of the text of a release file; `name` names it in messages."""
        release = cls()
        release.name, release._text = name, text
        return release

    @classmethod
    def of(cls, release: str | os.PathLike[str] | Release | Mapping[str, float]) -> Release:
        """Return a release given by name, path, states or as an object."""
        if isinstance(release, Release):
            return release
        if isinstance(release, Mapping) or hasattr(release, "iloc"):
            return cls(cast("Mapping[str, float]", release))
        if not is_path(release):
            found = type(release).__name__
            raise InputError(f"release: found a {found}, expected a name, path, Release or mapping")
        return cls.read(release)

    @classmethod
    def several(cls, releases: AnyRelease | Iterable[AnyRelease]) -> list[Release]:
        """Return one release or several as a list."""
        if not hasattr(releases, "__iter__") and not isinstance(releases, (os.PathLike, Release)):
            raise InputError(f"releases: found {releases!r}, expected a release or several")
        is_one = isinstance(releases, (str, os.PathLike, Release, Mapping))
        each = cast("Iterable[AnyRelease]", [releases] if is_one else releases)
        return [cls.of(release) for release in each]

    def to_toml(self, model: str) -> str:
        """Return the text of a release file for a model, which `hyzer simulate --release` flies."""
        if self._text is not None:
            return self._text
        until: dict[str, Any] = {"until": self._until}
        if not isinstance(self._until, str):
            until = {"duration": self._until}
        lines = [
            f"{name} = {_toml.text(value)}\n" for name, value in {"model": model, **until}.items()
        ]
        of_motion = "[throw]" if self._initial is None else "[initial]"
        motion = self._throw if self._initial is None else self._initial
        tables = [_toml.table(f"[{name}]", values) for name, values in self._tables.items()]
        return "".join([*lines, *tables, _toml.table(of_motion, motion)])

    @property
    def lacks_spin(self) -> bool:
        """Whether it is a throw that does not state its spin."""
        return bool(self._throw) and self._initial is None and "spin" not in self._throw

    def texts(self, model: str) -> tuple[str, str]:
        """Return the name of the release in messages, and its text."""
        return self.name, self.to_toml(model)

    def __repr__(self) -> str:
        if self._text is not None:
            return f"Release({self.name!r})"
        values = self._initial or self._throw
        parts = [f"{name}={plain(value):g}" for name, value in values.items()]
        parts += [f"{name}={reprlib.repr(value)}" for name, value in self._tables.items() if value]
        parts += [] if self._until == "ground" else [f"until={self._until!r}"]
        return f"Release({', '.join(parts)})"


def over_time(name: str, value: Any) -> float | Mapping[str, Any]:
    """Return an input in the form of a release file: a constant, or times and values."""
    value = plain(value)
    if isinstance(value, Mapping):
        return cast("Mapping[str, Any]", value)
    if isinstance(value, int | float):
        return float(value)
    if not hasattr(value, "__len__"):
        raise InputError(f"inputs: {name} is {value!r}, expected a number, or times and values")
    if hasattr(value, "iloc"):
        value = (value.index, value)
    if len(value) != 2:
        raise InputError(
            f"inputs: {name} has {len(value)} parts, expected the times and the values"
        )
    t, values = value
    return {"t": [*map(plain, seconds(t))], "value": [*map(plain, floats(values))]}
