"""Analyses of models: designed throws, stability, sweeps, refits, verification, differences."""

from __future__ import annotations

import io
import os
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from hyzer import _hyzer, _toml
from hyzer._dataset import Dataset, dataset_of
from hyzer._extras import extra
from hyzer._fit import options
from hyzer._model import Model, model_of
from hyzer._progress import Progress, Watching
from hyzer._records import Record
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


class Verification(Report):
    """Result of the independent checks of a model. Attributes are the keys of its JSON.

    Attributes
    ----------
    outcome : str
        `verified`, `not_verified` or `refuted`.
    rows : Rows
        Each check with its verdict.
    """


class Difference(Report):
    """What a change of a model changes. Attributes are the keys of its JSON.

    Attributes
    ----------
    changed : bool
        Whether any derivative, observation or limit is another function.
    rows : Rows
        Each row with what differs.
    """

    def _about(self) -> str:
        models = self["models"]
        return f"{models['old']} and {models['new']}"


class Sweep(Record):
    """Many flights: the keys of `summary.json`, and a row for each flight.

    Attributes
    ----------
    flights : int
        Number of flights.
    columns : Table
        Mean, standard deviation and quantiles of each column.
    statuses : Record
        Numbers of flights by how they ended.
    """

    def __init__(self, summary: str, table: str | None, folder: Path | None) -> None:
        import json

        super().__init__(json.loads(summary))
        self._table = table
        self.folder = folder

    @cached_property
    def frame(self) -> pd.DataFrame:
        """The flights as a DataFrame, a row for each."""
        pandas = extra("pandas")
        if self._table is not None:
            return cast("pd.DataFrame", pandas.read_csv(io.StringIO(self._table)))
        # Where the sweep was written to a folder, its table is there.
        return cast("pd.DataFrame", pandas.read_parquet(cast(Path, self.folder) / "flights.parquet"))

    def to_pandas(self) -> pd.DataFrame:
        """Return the flights as a DataFrame, a row for each."""
        return self.frame

    def __repr__(self) -> str:
        return f"<Sweep of {self['flights']} flights>"


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
    """Refit to flights drawn with replacement: errors and intervals without assuming a distribution.

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
    bounds: Mapping[str, Sequence[float]] | str | os.PathLike[str] | None = None,
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
        Farthest, longest; through a point; through a point with most curve around an obstacle; level at
        a point; landing at a point with the least spread.
    target : sequence of 3 floats, optional
        The point of the goal, m, with the release above the origin.
    bounds : mapping of str to (float, float), or path, optional
        Least and greatest `speed` (m/s), `heading`, `launch`, `nose`, `hyzer` (deg), `spin` (rpm) and
        `height` (m); or a file of bounds, which may have an obstacle and a scatter.
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
        limits = _toml.table("[bounds]", bounds)
    elif bounds is not None:
        limits = Path(bounds).read_text(encoding="utf-8")
    point = None if target is None else [float(x) for x in target]
    of = cast(_hyzer.Model, model_of(model))
    return Design(_hyzer.design(of, goal, point, limits, starts, samples, seed, threads))


def stability(model: AnyModel, release: AnyRelease | None = None, *, times: int = 60) -> Stability:
    """Compute the modes of the linearised motion with frequency and damping, and criteria of stability.

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


def sweep(
    plan: str | os.PathLike[str] | Mapping[str, Any],
    *,
    out: str | os.PathLike[str] | None = None,
    threads: int | None = None,
    progress: Progress | bool | None = None,
) -> Sweep:
    """Simulate many flights: releases, coefficients and wind from grids or distributions.

    Parameters
    ----------
    plan : str, path or mapping
        `backhands`, the built-in plan; a plan file; the text of one, which has more than one line; or
        its keys and tables as a mapping: `docs/reference/sweep.md`.
    out : path, optional
        Folder for `flights.parquet` and `summary.json`; a sweep that was ended goes on there. Without it
        the flights are kept in memory.
    threads : int, optional
        Number of threads; the result does not depend on it.
    progress : callable, bool or None
        As in `fit`.

    Returns
    -------
    Sweep
        Its `to_pandas()` has a row for each flight.

    Examples
    --------
    >>> import hyzer
    >>> launches = {"launch": {"values": [20.0, 30.0, 40.0]}}
    >>> plan = {"model": "ball", "until": "ground", "throw": {"speed": 30}, "vary": launches}
    >>> hyzer.sweep(plan).to_pandas().shape[0]
    3
    """
    name, text, folder = _plan(plan)
    with Watching(progress) as watch:
        if out is not None:
            summary = _hyzer.sweep(name, text, folder, out, False, threads, watch)
            return Sweep(summary, None, Path(out))
        with tempfile.TemporaryDirectory() as made:
            inside = Path(made) / "swept"
            summary = _hyzer.sweep(name, text, folder, inside, True, threads, watch)
            table = (inside / "flights.csv").read_text(encoding="utf-8")
            return Sweep(summary, table, None)


def _plan(plan: str | os.PathLike[str] | Mapping[str, Any]) -> tuple[str, str, str]:
    """Return name, text and folder of a plan."""
    if isinstance(plan, Mapping):
        plain = {key: value for key, value in plan.items() if not isinstance(value, Mapping)}
        tables = {key: value for key, value in plan.items() if isinstance(value, Mapping)}
        text = "".join(f"{_toml.text(key)} = {_toml.text(value)}\n" for key, value in plain.items())
        return "plan", text + "".join(_toml.table(f"[{k}]", t) for k, t in tables.items()), "."
    named = os.fspath(plan)
    if "\n" in named:
        return "plan", named, "."
    if named == "backhands" and not Path(named).is_file():
        return named, _hyzer.sweep_plan(), "."
    return named, Path(named).read_text(encoding="utf-8"), str(Path(named).parent)


def verify(
    model: AnyModel, *, cases: int = 200, seed: int = 1, mutants: bool = False
) -> Verification:
    """Run every independent check of a model against a reference implementation.

    Parameters
    ----------
    model : str, path or Model
        The model.
    cases : int
        Number of random points of each check.
    seed : int
        Seed of the points.
    mutants : bool
        Also count the mutants of the model that the checks refuse.

    Returns
    -------
    Verification

    Examples
    --------
    >>> import hyzer
    >>> hyzer.verify("ball", cases=20).outcome
    'verified'
    """
    of = cast(_hyzer.Model, model_of(model))
    return Verification(_hyzer.verify(of, cases, seed, mutants))


def diff(old: AnyModel, new: AnyModel, *, releases: Iterable[str] = ()) -> Difference:
    """Compare two models: statements, derivatives (exactly), operation counts, landings.

    Parameters
    ----------
    old, new : str, path or Model
        The models.
    releases : iterable of str
        Releases, by name or path, that are flown with both.

    Returns
    -------
    Difference

    Examples
    --------
    >>> import hyzer
    >>> hyzer.diff("disc", hyzer.Model("disc", effects=["wind"])).changed
    True
    """
    before, after = cast(_hyzer.Model, model_of(old)), cast(_hyzer.Model, model_of(new))
    return Difference(_hyzer.diff(before, after, list(releases)))


def synthesize(
    model: AnyModel,
    releases: AnyRelease | Sequence[AnyRelease],
    *,
    flights: int = 8,
    held_out: int = 0,
    spread: float = 0.1,
    duration: float | None = None,
    rate: float = 120.0,
    markers: Mapping[str, Iterable[float]] | None = None,
    noise_sigma: float = 0.0015,
    noise_ar1: float = 0.0,
    outliers: float = 0.0,
    outlier_size: float = 0.05,
    dropouts: float = 0.0,
    seed: int = 1,
) -> Dataset:
    """Make a dataset: simulate releases of a model, observe its markers, add noise.

    Parameters
    ----------
    model : str, path or Model
        The model.
    releases : release or sequence of releases
        Flown in turn, as in `Model.fly`.
    flights, held_out : int
        Number of flights, and of those that are held out, the last ones.
    spread : float
        Standard deviation of the initial states but the position, as a fraction.
    duration : float, optional
        Duration of each flight, s; by default that of its release.
    rate : float
        Samples per second.
    markers : mapping of str to sequence of 3 floats, optional
        Positions of the markers in the body frame, m.
    noise_sigma, noise_ar1 : float
        Standard deviation of the noise along each axis, m, and its lag-1 autocorrelation.
    outliers, outlier_size, dropouts : float
        Fraction of outliers, their standard deviation, m, and fraction of missing points.
    seed : int
        Seed of all random numbers.

    Returns
    -------
    Dataset

    Examples
    --------
    >>> import hyzer
    >>> data = hyzer.synthesize("disc", "backhand", flights=3, duration=0.5)
    >>> len(data), hyzer.fit(data, "disc").coefficients.C_D0.unit
    (3, '1')
    """
    of = model_of(model) or Model("disc")
    several: Sequence[AnyRelease]
    if isinstance(releases, (str, os.PathLike, Release, Mapping)):
        several = [releases]
    else:
        several = releases
    texts = [Release.of(release).texts(of.name) for release in several]
    asked = {
        "flights": flights,
        "held_out": held_out,
        "spread": spread,
        "duration": duration,
        "rate": rate,
        "markers": [(name, list(at)) for name, at in (markers or {}).items()],
        "noise_sigma": noise_sigma,
        "noise_ar1": noise_ar1,
        "outliers": outliers,
        "outlier_size": outlier_size,
        "dropouts": dropouts,
        "seed": seed,
    }
    return Dataset(_hyzer.synthesize(of, texts, asked))
