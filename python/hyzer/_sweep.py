"""Many flights by a plan."""

from __future__ import annotations

import json
import os
from collections import defaultdict
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast, overload

from hyzer import _hyzer, _toml
from hyzer._analyses import report_of
from hyzer._arguments import is_path, mapping, text_of, whole
from hyzer._errors import InputError
from hyzer._extras import extra, frame_of
from hyzer._model import Model
from hyzer._progress import Progress, Watching
from hyzer._records import Record, titled
from hyzer._results import Fit

if TYPE_CHECKING:
    import pandas as pd


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
        super().__init__(json.loads(summary))
        self._table = table
        self.folder = None if folder is None else folder.absolute()

    @cached_property
    def frame(self) -> pd.DataFrame:
        """The flights as a DataFrame, a row for each."""
        if self._table is not None:
            # The types of the columns of `flights.parquet`.
            kinds: Any = defaultdict(lambda: float, flight=int, status=str)
            return frame_of(self._table, dtype=kinds)
        # Where the sweep was written to a folder, its table is there.
        found = extra("pandas").read_parquet(cast(Path, self.folder) / "flights.parquet")
        return cast("pd.DataFrame", found)

    def to_pandas(self) -> pd.DataFrame:
        """Return the flights as a DataFrame, a row for each."""
        return self.frame

    def __repr__(self) -> str:
        return f"<Sweep of {self['flights']} flights>"

    def _repr_html_(self) -> str:
        return titled(self, "columns")


@overload
def sweep(
    plan: str | os.PathLike[str] | Mapping[str, Any],
    *,
    out: str | os.PathLike[str] | None = None,
    part: None = None,
    threads: int | None = None,
    progress: Progress | bool | None = None,
) -> Sweep: ...
@overload
def sweep(
    plan: str | os.PathLike[str] | Mapping[str, Any],
    *,
    out: str | os.PathLike[str],
    part: tuple[int, int],
    threads: int | None = None,
    progress: Progress | bool | None = None,
) -> None: ...
def sweep(
    plan: str | os.PathLike[str] | Mapping[str, Any],
    *,
    out: str | os.PathLike[str] | None = None,
    part: tuple[int, int] | None = None,
    threads: int | None = None,
    progress: Progress | bool | None = None,
) -> Sweep | None:
    """Simulate many flights: releases, coefficients and wind from grids or distributions.

    Parameters
    ----------
    plan : str, path or mapping
        `backhands`, the built-in plan; a plan file; the text of one, which has more than one line;
        or its keys and tables as a mapping: those on the page of sweep plans in the reference. The
        model of a mapping is a name, a path or a `Model`, and the report of `fit` also a `Fit`.
    out : path, optional
        Folder for `flights.parquet` and `summary.json`; a sweep that was ended goes on there.
        Without it the flights are kept in memory.
    part : (int, int), optional
        Fly only the i-th of n equal shares, (i, n) with i from 1, for several processes or machines
        with one folder `out`; the call without it flies the rest and joins all.
    threads : int, optional
        Number of threads; the result does not depend on it.
    progress : callable, bool or None
        As in `fit`.

    Returns
    -------
    Sweep
        Its `to_pandas()` has a row for each flight. None for a part.

    Examples
    --------
    >>> import hyzer
    >>> launches = {"launch": {"values": [20.0, 30.0, 40.0]}}
    >>> plan = {"model": "ball", "until": "ground", "throw": {"speed": 30}, "vary": launches}
    >>> hyzer.sweep(plan).to_pandas().shape[0]
    3
    """
    if part is not None and out is None:
        raise InputError("part needs out: the folder that the shares have in common")
    # A tenth of the time of importing hyzer, which fits do not need.
    import tempfile

    threads = whole(threads, "threads")
    with tempfile.TemporaryDirectory() as made, Watching(progress) as watch:
        of = _plan(plan, Path(made))
        if out is not None:
            summary = _hyzer.sweep(of, out, False, threads, part, watch)
            return None if summary is None else Sweep(summary, None, Path(out))
        inside = Path(made) / "swept"
        summary = _hyzer.sweep(of, inside, True, threads, None, watch)
        table = (inside / "flights.csv").read_text(encoding="utf-8")
        return Sweep(cast(str, summary), table, None)


def _plan(plan: Any, made: Path) -> tuple[str, str, str]:
    """Return name, text and folder of a plan; objects in it are written to `made`."""
    if not is_path(plan):
        keys, folder = mapping(plan, "plan"), "."
        fitted = keys.get("fit")
        if fitted is not None:
            fitted = {"report": fitted} if isinstance(fitted, Fit) else mapping(fitted, "fit")
            report = fitted.get("report", "")
            if isinstance(report, Fit):
                written = made / "report.json"
                written.write_text(cast(str, report_of(report)), encoding="utf-8")
                report = written
            keys["fit"] = {**fitted, "report": os.path.abspath(report)}
        if isinstance(keys.get("model"), _hyzer.Model):
            model = Model(keys["model"].text, keys.pop("effects", ()))
            keys["model"], folder = f"{model.name}.hyz", str(made)
            (made / keys["model"]).write_text(model.text, encoding="utf-8")
        return "plan", _toml.document(keys), folder
    named = os.fspath(plan)
    if "\n" in named:
        return "plan", named, "."
    if named == "backhands" and not Path(named).is_file():
        return named, _hyzer.sweep_plan(), "."
    if not Path(named).is_file():
        expected = "a plan file, the text of one, or the built-in plan backhands"
        raise InputError(f"plan: found no file {named!r}, expected {expected}")
    return named, text_of(named, "plan"), str(Path(named).parent)
