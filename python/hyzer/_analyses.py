"""Analyses of models: designed throws, stability, refits."""

from __future__ import annotations

import io
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from hyzer import _hyzer, _toml
from hyzer._dataset import Dataset, dataset_of
from hyzer._extras import extra
from hyzer._fit import options
from hyzer._model import model_of
from hyzer._progress import Progress, Watching
from hyzer._release import Release
from hyzer._results import Result

if TYPE_CHECKING:
    import pandas as pd

    AnyModel = str | os.PathLike[str] | _hyzer.Model
    AnyRelease = str | os.PathLike[str] | Release | Mapping[str, float]


class Report(Result):
    """Result of an analysis. Attributes are the keys of the JSON that the program writes."""

    _native: _hyzer.Report

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {self._about()}>"

    def _about(self) -> str:
        return str(self._values().get("model", "a model"))


class Bootstrap(Report):
    """Refits to flights drawn with replacement. Attributes are the keys of `hyzer.bootstrap/1`.

    Attributes
    ----------
    coefficients : Table
        By name: `value`, `std_error` (of the refits), `std_error_fit`, `mean`, `interval`, `unit`.
    refits, converged : int
        Numbers of refits, and of those that converged.
    """

    def to_pandas(self) -> pd.DataFrame:
        """Return the estimates, a row for each refit, SI."""
        text = self._native.file_text("refits.csv") or ""
        return cast("pd.DataFrame", extra("pandas").read_csv(io.StringIO(text), index_col="refit"))


class Design(Report):
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

    @property
    def release(self) -> Release:
        """The throw as a release, which `Model.fly` flies."""
        text = self._native.file_text("release.toml") or ""
        return Release.parse("release.toml", text)


class Stability(Report):
    """Modes of the linearised motion and criteria. Attributes are the keys of `stability.json`."""

    def to_pandas(self) -> pd.DataFrame:
        """Return the modes along the flight as a DataFrame."""
        text = self._native.file_text("modes.csv") or ""
        return cast("pd.DataFrame", extra("pandas").read_csv(io.StringIO(text)))


def bootstrap(
    data: str | os.PathLike[str] | Dataset,
    model: AnyModel | None = None,
    *,
    refits: int = 200,
    seed: int = 1,
    fixed: Mapping[str, float | None] | Iterable[str] = (),
    free: Iterable[str] = (),
    priors: Mapping[str, tuple[float, float]] | None = None,
    unbounded: bool = False,
    trust_data: bool = False,
    threads: int | None = None,
    progress: Progress | bool | None = None,
) -> Bootstrap:
    """Refit to flights drawn with replacement: errors and intervals without a distribution.

    Parameters
    ----------
    data, model, fixed, free, priors, unbounded, trust_data, threads, progress
        As in `fit`.
    refits : int
        Number of refits.
    seed : int
        Seed of the draws; a refit depends on it and on its number alone.

    Returns
    -------
    Bootstrap

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
    with Watching(progress) as watch:
        of = model_of(model)
        return Bootstrap(_hyzer.bootstrap(dataset_of(data), of, asked, refits, seed, watch))


def design(
    model: AnyModel,
    goal: str,
    *,
    target: Sequence[float] | None = None,
    bounds: Mapping[str, Any] | str | os.PathLike[str] | None = None,
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
    """
    limits: str | None = None
    if isinstance(bounds, Mapping):
        limits = _toml.document(bounds)
    elif bounds is not None:
        limits = Path(bounds).read_text(encoding="utf-8")
    point = None if target is None else [float(x) for x in target]
    of = cast(_hyzer.Model, model_of(model))
    return Design(_hyzer.design(of, goal, point, limits, starts, samples, seed, threads))


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
    return Stability(_hyzer.stability(of, name, text, times))
