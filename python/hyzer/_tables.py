"""Texts of the files of a dataset, from DataFrames and arrays."""

from __future__ import annotations

import csv
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from hyzer import _hyzer, _toml
from hyzer._errors import InputError

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas as pd

_ENDINGS = {
    "marker": ("_x", "_y", "_z"),
    "pose": ("_x", "_y", "_z", "_qw", "_qx", "_qy", "_qz"),
    "gyroscope": ("_x", "_y", "_z"),
    "accelerometer": ("_x", "_y", "_z"),
    "speed": ("",),
}


def named(flights: Sequence[Any] | Mapping[str, Any]) -> dict[str, Any]:
    """Return flights by the names of their files."""
    if isinstance(flights, Mapping):
        return dict(flights)
    return {f"flight{k:02}.csv": flight for k, flight in enumerate(flights, start=1)}


def text_of(file: str, frame: pd.DataFrame) -> str:
    """Return the text of the table of a flight; `file` names it in messages."""
    is_indexed = "t" not in frame.columns and frame.index.name == "t"
    try:
        text: str = cast("Any", frame).to_csv(index=is_indexed)
        text.encode()
    except (csv.Error, UnicodeEncodeError) as error:
        raise InputError(f"{file}: found a cell that is no text of a table: {error}") from error
    return text


def table(file: str, flight: Mapping[str, npt.ArrayLike], kinds: Mapping[str, str]) -> str:
    """Return the text of the table of a flight from its arrays."""
    # Most of the time of `import hyzer` would be that of NumPy.
    import numpy as np

    columns: list[tuple[str, list[str], npt.ArrayLike]] = []
    for name, values in flight.items():
        # What belongs to no marker and no sensor is an input over time, if it is a series.
        is_series = name not in kinds and np.ndim(values) == 1
        endings = ("",) if is_series else _ENDINGS.get(kinds.get(name, ""))
        if endings is None:
            known = ", ".join(["t", *kinds])
            raise InputError(f"{file}: found the array {name!r}, expected one of {known}")
        columns.append((f"{file}: {name}", [name + ending for ending in endings], values))
    return _hyzer.table_text(columns)


def manifest(
    files: Sequence[str],
    model: str,
    markers: Mapping[str, Any] | None = None,
    sensors: Mapping[str, Any] | None = None,
    parameters: Mapping[str, float] | None = None,
    sigma: float | None = None,
    held_out: Iterable[str | int] | None = None,
    known: Mapping[str | int, Mapping[str, Any]] | None = None,
    recording: Mapping[str, Any] | None = None,
    unknown: Iterable[str] | Mapping[str | int, Iterable[str]] | None = None,
    inputs: Mapping[str | int, str] | None = None,
    interpolation: str | None = None,
) -> str:
    """Return the text of dataset.toml; `inputs` are the files of the inputs over time."""
    parts = [f"model = {_toml.text(os.fspath(model))}\n"]
    of_flights: Mapping[str | int, Iterable[str]] = {}
    if isinstance(unknown, Mapping):
        of_flights = cast("Mapping[str | int, Iterable[str]]", unknown)
    if unknown is not None and not isinstance(unknown, Mapping):
        parts.append(f"unknown = {_toml.text(list(unknown))}\n")
    if interpolation is not None:
        parts.append(_toml.table("[inputs]", {"interpolation": interpolation}))
    parts.append(_toml.table("[parameters]", parameters or {}))
    parts.append(_toml.table("[recording]", recording or {}))
    for marker, position in (markers or {}).items():
        parts.append(_toml.table("[[markers]]", {"name": marker, "position": position}))
    for sensor, about in (sensors or {}).items():
        parts.append(_toml.table("[[sensors]]", {"name": sensor, **about}))
    parts.append(_toml.table("[noise]", {} if sigma is None else {"sigma": sigma}))
    apart = {_file(flight, files) for flight in held_out or ()}
    own: dict[str, dict[str, Any]] = {file: {} for file in files}
    stated: list[tuple[str, Mapping[str | int, Any]]] = [
        ("known", known or {}),
        ("unknown", of_flights),
        ("inputs", inputs or {}),
    ]
    for key, values in stated:
        for flight, value in values.items():
            own[_file(flight, files)][key] = value
    for file in files:
        about = {"file": file, "role": "held-out" if file in apart else "fit"}
        parts.append(_toml.table("[[flights]]", {**about, **own[file]}))
    return "".join(parts)


def _file(flight: str | int, files: Sequence[str]) -> str:
    """Return the name of a flight given by name or number."""
    if isinstance(flight, str) and flight in files:
        return flight
    if isinstance(flight, int) and 0 <= flight < len(files):
        return files[flight]
    expected = f"one of {', '.join(files)} or its number from 0"
    raise InputError(f"found the flight {flight!r}, expected {expected}")
