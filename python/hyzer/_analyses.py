"""Analyses of models: designed throws, stability, refits."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, cast, overload

from hyzer import _hyzer, _toml
from hyzer._arguments import mapping, text_of, whole
from hyzer._dataset import Dataset, dataset_of
from hyzer._errors import InputError
from hyzer._extras import frame_of
from hyzer._fit import options
from hyzer._model import model_of
from hyzer._progress import Progress, Watching
from hyzer._records import titled
from hyzer._release import Release
from hyzer._results import Fit, Paged, Result

if TYPE_CHECKING:
    import pandas as pd

    AnyModel = str | os.PathLike[str] | _hyzer.Model
    AnyRelease = str | os.PathLike[str] | Release | Mapping[str, float]


class Report(Result):
    """Result of an analysis. Attributes are the keys of the JSON that the program writes."""

    _native: _hyzer.Report

    _shown: ClassVar[str] = ""
    """Key of the table that a notebook shows."""

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {self._about()}>"

    def _about(self) -> str:
        return str(self._values().get("model", "a model"))

    def _repr_html_(self) -> str:
        return titled(self, self._shown)


class Bootstrap(Report):
    """Refits to flights drawn with replacement. Attributes are the keys of `hyzer.bootstrap/1`.

    Attributes
    ----------
    coefficients : Table
        By name: `value`, `std_error` (of the refits), `std_error_fit`, `mean`, `interval`, `unit`.
    refits, converged : int
        Numbers of refits, and of those that converged.
    """

    _shown = "coefficients"

    def to_pandas(self) -> pd.DataFrame:
        """Return the estimates, a row for each refit, SI."""
        text = self._native.file_text("refits.csv") or ""
        return frame_of(text, index_col="refit")


class Design(Report, Paged):
    """A throw for a purpose. Attributes are the keys of `hyzer.design/1`.

    Attributes
    ----------
    feasible : bool
        Whether the throw serves its purpose.
    throw : Record
        The throw that was found.
    landing : list of float
        Where it lands, m.
    """

    _shown = "throw"

    @property
    def release(self) -> Release:
        """The throw as a release, which `Model.fly` flies."""
        text = self._native.file_text("release.toml") or ""
        return Release.parse("release.toml", text)


class Stability(Report, Paged):
    """Modes of the linearised motion and criteria. Attributes are the keys of `stability.json`."""

    _shown = "release"

    def to_pandas(self) -> pd.DataFrame:
        """Return the modes along the flight as a DataFrame."""
        text = self._native.file_text("modes.csv") or ""
        return frame_of(text)


@overload
def bootstrap(
    data: str | os.PathLike[str] | Dataset,
    model: AnyModel | None = None,
    *,
    refits: int = 200,
    seed: int = 1,
    out: str | os.PathLike[str] | None = None,
    part: None = None,
    fixed: Mapping[str, float | None] | Iterable[str] | str = (),
    free: Iterable[str] | str = (),
    priors: Mapping[str, tuple[float, float]] | None = None,
    unbounded: bool = False,
    trust_data: bool = False,
    threads: int | None = None,
    progress: Progress | bool | None = None,
) -> Bootstrap: ...
@overload
def bootstrap(
    data: str | os.PathLike[str] | Dataset,
    model: AnyModel | None = None,
    *,
    refits: int = 200,
    seed: int = 1,
    out: str | os.PathLike[str],
    part: tuple[int, int],
    fixed: Mapping[str, float | None] | Iterable[str] | str = (),
    free: Iterable[str] | str = (),
    priors: Mapping[str, tuple[float, float]] | None = None,
    unbounded: bool = False,
    trust_data: bool = False,
    threads: int | None = None,
    progress: Progress | bool | None = None,
) -> None: ...
def bootstrap(
    data: str | os.PathLike[str] | Dataset,
    model: AnyModel | None = None,
    *,
    refits: int = 200,
    seed: int = 1,
    out: str | os.PathLike[str] | None = None,
    part: tuple[int, int] | None = None,
    fixed: Mapping[str, float | None] | Iterable[str] | str = (),
    free: Iterable[str] | str = (),
    priors: Mapping[str, tuple[float, float]] | None = None,
    unbounded: bool = False,
    trust_data: bool = False,
    threads: int | None = None,
    progress: Progress | bool | None = None,
) -> Bootstrap | None:
    """Refit to flights drawn with replacement: errors and intervals without a distribution.

    Parameters
    ----------
    data, model, fixed, free, priors, unbounded, trust_data, threads, progress
        As in `fit`.
    refits : int
        Number of refits.
    seed : int
        Seed of the draws; a refit depends on it and on its number alone.
    out : path, optional
        Folder where the refits are kept as they are done, with `refits.csv` and `summary.json` in
        the end; a run that was ended goes on there. Without it they are kept in memory.
    part : (int, int), optional
        Do only the i-th of n equal shares, (i, n) with i from 1, for several processes or machines
        with one folder `out`; the call without it does the rest and joins all.

    Returns
    -------
    Bootstrap
        None for a part.

    Examples
    --------
    >>> import hyzer
    >>> scatter = hyzer.bootstrap("examples/disc", refits=20)
    >>> scatter.converged, scatter.coefficients.C_D0.unit
    (20, '1')
    """
    asked = options(
        fixed, free, priors, unbounded=unbounded, trust_data=trust_data, threads=threads
    )
    if part is not None and out is None:
        raise InputError("part needs out: the folder that the shares have in common")
    with Watching(progress) as watch:
        of, on = model_of(model), dataset_of(data)
        found = _hyzer.bootstrap(
            on, of, asked, whole(refits, "refits"), whole(seed, "seed"), out, part, watch
        )
        return None if found is None else Bootstrap(found)


def design(
    model: AnyModel,
    goal: str,
    *,
    target: Sequence[float] | None = None,
    bounds: Mapping[str, Any] | str | os.PathLike[str] | None = None,
    wind: Sequence[float] | str | os.PathLike[str] | None = None,
    fit: Fit | str | os.PathLike[str] | None = None,
    starts: int = 384,
    samples: int = 400,
    seed: int = 1,
    threads: int | None = None,
) -> Design:
    """Find a throw for a purpose, with its sensitivities and the spread of its landings.

    Parameters
    ----------
    model : str, path or Model
        The model, which has a body.
    goal : {"range", "hangtime", "hit", "curve", "flare", "spread"}
        Farthest, longest; through a point; through a point with most curve around an obstacle;
        level at a point; landing at a point with the least spread.
    target : sequence of 3 floats, optional
        The point of the goal, m, with the release above the origin.
    bounds : mapping or path, optional
        Least and greatest `speed` (m/s), `heading`, `launch`, `nose`, `hyzer` (deg), `spin` (rpm)
        and `height` (m), or one number to hold; `obstacle`, `circle` and `scatter` as mappings; or
        a file of bounds with these keys.
    wind : sequence of 3 floats or path, optional
        Velocity of the air in the inertial frame, m/s, or a file with `[wind]`.
    fit : Fit or path, optional
        A fit, or its `report.json`, whose coefficients are flown, with their standard errors in the
        spread. Those that the model does not have are left out, with a warning.
    starts, samples, seed : int
        Numbers of starting throws and of sampled landings; seed of both.
    threads : int, optional
        Number of threads; the result does not depend on it.

    Returns
    -------
    Design

    Raises
    ------
    InputError
        If the goal, the target or the bounds are wrong.
    FlightError
        If no throw within the bounds can be flown.

    Examples
    --------
    >>> import hyzer
    >>> found = hyzer.design("ball", "hit", target=(4, 1, 0), starts=64, samples=50)
    >>> found.feasible
    True
    >>> hyzer.Model("ball").fly(found.release).ended_by
    'ground'
    >>> hyzer.design("ball", "range", wind=(-3, 0, 0), starts=32, samples=0).throw.launch < 45
    True
    """
    limits: str | None = None
    if isinstance(bounds, Mapping) or hasattr(bounds, "iloc"):
        limits = _toml.document(mapping(bounds, "bounds"))
    elif bounds is not None:
        limits = text_of(bounds, "bounds")
    asked = {
        "target": None if target is None else _numbers(target, "target"),
        "bounds": limits,
        "wind": _wind(wind),
        "fit": report_of(fit),
        "starts": starts,
        "samples": samples,
        "seed": seed,
        "threads": threads,
    }
    found, unknown = _hyzer.design(cast(_hyzer.Model, model_of(model)), goal, asked)
    if unknown:
        text = f"the model has no {', '.join(unknown)} of the fit; left out"
        warnings.warn(text, stacklevel=2)
    return Design(found)


def _numbers(values: Sequence[float], what: str) -> list[float]:
    try:
        return [float(value) for value in values]
    except (TypeError, ValueError):
        raise InputError(f"{what} is {values!r}, expected numbers") from None


def _wind(wind: Sequence[float] | str | os.PathLike[str] | None) -> str | None:
    """Return a wind as the program takes it: components or the path of a file."""
    if wind is None or isinstance(wind, (str, os.PathLike)):
        return None if wind is None else os.fspath(wind)
    return ",".join(map(repr, _numbers(wind, "wind")))


def report_of(fit: Fit | str | os.PathLike[str] | None) -> str | None:
    """Return the report of a fit, a JSON text."""
    if fit is None or isinstance(fit, Fit):
        return None if fit is None else json.dumps(fit.to_dict())
    return text_of(fit, "fit")


def stability(model: AnyModel, release: AnyRelease | None = None, *, times: int = 60) -> Stability:
    """Compute the modes of the linearised motion, and criteria of stability.

    Parameters
    ----------
    model : str, path or Model
        The model, which has a body.
    release : str, path, Release or mapping, optional
        The motion at which it is linearised; by default a throw of 16 m/s and 700 rpm.
    times : int
        Number of instants along the flight.

    Returns
    -------
    Stability

    Examples
    --------
    >>> import hyzer
    >>> found = hyzer.stability("disc", "backhand", times=5)
    >>> "nutation" in found.text()
    True
    """
    of = cast(_hyzer.Model, model_of(model))
    begun = Release(speed=16, spin=700) if release is None else Release.of(release)
    name, text = begun.texts(of.name)
    return Stability(_hyzer.stability(of, name, text, whole(times, "times")))
