"""Texts of the files of a dataset, from DataFrames and arrays."""

from __future__ import annotations

import csv
import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, cast

from hyzer import _hyzer, _toml
from hyzer._arguments import (
    clock,
    file_of,
    floats,
    mapping,
    names,
    plain,
    seconds,
    selected,
)
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


def named(flights: Any) -> tuple[dict[str, Any], dict[Any, str]]:
    """Return flights by the names of their files, and these names by the keys of the flights."""
    if not hasattr(flights, "__iter__"):
        raise InputError(f"flights: found {flights!r}, expected a table for each flight")
    if not isinstance(flights, Mapping):
        flights = [flights] if hasattr(flights, "columns") else flights
        found = {f"flight{k:02}.csv": flight for k, flight in enumerate(flights, start=1)}
        return found, {file: file for file in found}
    by_key = cast("Mapping[Any, Any]", flights)
    files = {plain(key): _file(plain(key)) for key in by_key}
    if len(set(files.values())) < len(files):
        raise InputError("found flights of the same name, expected a name for each")
    return dict(zip(files.values(), by_key.values(), strict=True)), files


def _file(key: Any) -> str:
    """Return the name of the file of a flight: its key, or what `groupby` made of it."""
    if isinstance(key, str):
        return key
    parts = cast("tuple[Any, ...]", key) if isinstance(key, tuple) else (key,)
    return "_".join(str(plain(part)) for part in parts) + ".csv"


def text_of(
    file: str, frame: pd.DataFrame, recording: Any = None, beside: pd.DataFrame | None = None
) -> str:
    """Return the text of the table of a flight, or of inputs `beside` one.

    `file` names the table in messages. Dates count from the first of the flight.
    """
    if not hasattr(frame, "to_csv"):
        module, name = type(frame).__module__.partition(".")[0], type(frame).__name__
        found = name if module == "builtins" else f"{name} of {module}"
        hint = ": .to_pandas() makes one" if hasattr(frame, "to_pandas") else ""
        raise InputError(f"{file}: found a {found}, expected a DataFrame of pandas{hint}")
    times = _times(frame)
    kind = clock(times)
    if kind != "numbers" and "time" in mapping(recording, "recording"):
        raise InputError(f"{file}: its times are {kind}; recording states a unit of numbers, time")
    origin = None if beside is None else _times(beside)
    kinds = {kind, kind if beside is None else clock(origin)}
    if len(kinds) > 1 and kinds != {"numbers", "differences of time"}:
        raise InputError(
            f"{file}: its times are {kind}, and those of the flight {clock(origin)}; "
            "expected times of one clock"
        )
    since = seconds(times, origin)
    given = cast("Any", frame)
    is_indexed = _is_indexed(frame)
    if since is not times:
        given = given.reset_index(drop=not is_indexed).assign(t=since)
        is_indexed = False
    try:
        text: str = given.to_csv(index=is_indexed)
        text.encode()
    except (csv.Error, UnicodeEncodeError) as error:
        raise InputError(f"{file}: found a cell that is no text of a table: {error}") from error
    return text


def _times(frame: pd.DataFrame) -> Any:
    """Return the times of a table: its column or index `t`; None if it has none."""
    return frame.index if _is_indexed(frame) else cast("Any", frame).get("t")


def _is_indexed(frame: pd.DataFrame) -> bool:
    """Return whether the index of a table has its times."""
    return "t" not in frame.columns and frame.index.name == "t"


def table(file: str, flight: Mapping[str, npt.ArrayLike], kinds: Mapping[str, str]) -> str:
    """Return the text of the table of a flight from its arrays."""
    # Most of the time of `import hyzer` would be that of NumPy.
    import numpy as np

    columns: list[tuple[str, list[str], npt.ArrayLike]] = []
    for name, values in mapping(flight, file).items():
        # What belongs to no marker and no sensor is an input over time, if it is a series.
        is_series = name not in kinds and np.ndim(values) == 1
        endings = ("",) if is_series else _ENDINGS.get(kinds.get(name, ""))
        if endings is None and name in kinds:
            expected = ", ".join(kind for kind in _ENDINGS if kind != "marker")
            found = f"sensors: found the kind {kinds[name]!r} of {name!r}"
            raise InputError(f"{found}, expected one of {expected}")
        if endings is None:
            known = ", ".join(["t", *kinds])
            raise InputError(f"{file}: found the array {name!r}, expected one of {known}")
        given = floats(seconds(values) if name == "t" else values)
        columns.append((f"{file}: {name}", [name + ending for ending in endings], given))
    return _hyzer.table_text(columns)


def model_name(model: Any) -> str:
    """Return the name or path of a model, which a dataset is stored with."""
    if isinstance(model, os.PathLike) or (type(model) is str and ";" not in model):
        return os.fspath(cast("str", model))
    found = "the text of a model" if isinstance(model, str) else f"a {type(model).__name__}"
    raise InputError(
        f"model: found {found}, expected a name or a path, as a dataset is stored with it; "
        "fits and diagnoses take a text or a Model: hyzer.fit(data, model=...)"
    )


def manifest(
    files: Mapping[Any, str],
    model: str | os.PathLike[str],
    markers: Mapping[str, Any] | None = None,
    sensors: Mapping[str, Any] | None = None,
    parameters: Mapping[str, float] | None = None,
    sigma: float | None = None,
    held_out: Any = (),
    known: Mapping[Any, Mapping[str, Any]] | None = None,
    recording: Mapping[str, Any] | None = None,
    unknown: Iterable[str] | str | Mapping[Any, Iterable[str] | str] | None = None,
    inputs: Mapping[Any, str] | None = None,
    interpolation: str | None = None,
) -> str:
    """Return the text of dataset.toml.

    `files` are those of the flights by their keys, `inputs` those of the inputs over time.
    """
    parts = [f"model = {_toml.text(model_name(model))}\n"]
    of_flights: dict[Any, list[str]] = {}
    if isinstance(unknown, Mapping):
        by_flight = cast("Mapping[Any, Iterable[str] | str]", unknown)
        of_flights = {flight: names(each) for flight, each in by_flight.items()}
    elif unknown is not None:
        parts.append(f"unknown = {_toml.text(names(unknown))}\n")
    if interpolation is not None:
        parts.append(_toml.table("[inputs]", {"interpolation": interpolation}))
    parts.append(_toml.table("[parameters]", mapping(parameters, "parameters")))
    parts.append(_toml.table("[recording]", mapping(recording, "recording")))
    for marker, position in mapping(markers, "markers").items():
        parts.append(_toml.table("[[markers]]", {"name": marker, "position": position}))
    for sensor, about in mapping(sensors, "sensors").items():
        parts.append(_toml.table("[[sensors]]", {"name": sensor, **about}))
    parts.append(_toml.table("[noise]", {} if sigma is None else {"sigma": sigma}))
    apart = set(selected(held_out, files, "held_out"))
    own: dict[str, dict[str, Any]] = {file: {} for file in files.values()}
    stated: list[tuple[str, Mapping[Any, Any]]] = [
        ("known", mapping(known, "known")),
        ("unknown", of_flights),
        ("inputs", inputs or {}),
    ]
    for key, values in stated:
        for flight, value in values.items():
            own[file_of(flight, files, key)][key] = value
    for file in files.values():
        about = {"file": file, "role": "held-out" if file in apart else "fit"}
        parts.append(_toml.table("[[flights]]", {**about, **own[file]}))
    return "".join(parts)
