"""Arguments as they come: names, mappings, numbers, times and files, also of NumPy and pandas."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from datetime import datetime, timedelta, timezone
from pathlib import Path
from typing import Any, TypeGuard, cast

from hyzer._errors import InputError


def is_path(value: Any) -> TypeGuard[str | os.PathLike[str]]:
    """Return whether a value is a string or path."""
    return isinstance(value, (str, os.PathLike))


def names(value: Any) -> list[str]:
    """Return a list of names or paths; a string or path is one."""
    if value is None:
        return []
    each: list[Any] = [value] if is_path(value) else list(value)
    return [os.fspath(name) if is_path(name) else name for name in each]


def mapping(value: Any, what: str) -> dict[Any, Any]:
    """Return a mapping or a pandas Series as a dict; nothing is an empty one."""
    if value is None:
        return {}
    if not hasattr(value, "items"):
        raise InputError(f"{what}: found {value!r}, expected a mapping by name")
    return dict(value.items())


def numbers(values: Any, what: str) -> dict[str, float]:
    """Return finite numbers by name."""
    found: dict[str, float] = {}
    for name, value in mapping(values, what).items():
        number: Any = plain(value)
        if not hasattr(number, "__float__"):
            raise InputError(f"{what}: {name} is {value!r}, expected a number")
        if not math.isfinite(number):
            raise InputError(f"{what}: {name} is {value}, expected a finite number")
        found[str(name)] = float(number)
    return found


def whole(value: Any, what: str) -> Any:
    """Return a whole number from 0; None as it is."""
    number = plain(value)
    if number is None or (isinstance(number, int) and type(number) is not bool and number >= 0):
        return number
    raise InputError(f"{what} is {value!r}, expected a whole number from 0")


def plain(value: Any) -> Any:
    """Return a scalar of NumPy as that of Python, a masked one as NaN; other values as they are."""
    if getattr(value, "ndim", None) != 0:
        return value
    return math.nan if getattr(value, "mask", False) else value.item()


def selected(value: Any, files: Mapping[Any, str], what: str) -> list[str]:
    """Return the files of flights given by key, by number from 0, or by a mask of all flights.

    A key that is a number comes before the number of a flight.
    """
    if value is None:
        return []
    is_mapping = isinstance(value, Mapping)
    labels: list[Any] | None = None
    if is_mapping or hasattr(value, "iloc"):
        pairs: list[tuple[Any, Any]] = list(cast("Any", value).items())
        labels, value = [plain(label) for label, _ in pairs], [item for _, item in pairs]
    is_one = isinstance(value, str) or not hasattr(value, "__iter__")
    each: list[Any] = [value] if is_one else list(value)
    items = [plain(item) for item in each]
    if items and all(isinstance(item, bool) for item in items):
        is_name = [isinstance(label, str) or label in files for label in labels or ()]
        if labels and (is_mapping or all(is_name)):
            return [
                file_of(label, files, what)
                for label, is_in in zip(labels, items, strict=True)
                if is_in
            ]
        if len(items) != len(files):
            raise InputError(
                f"{what}: found a mask of {len(items)}, expected one of the {len(files)} flights"
            )
        return [file for file, is_in in zip(files.values(), items, strict=True) if is_in]
    if is_mapping and items:
        raise InputError(f"{what}: found a mapping of {items[0]!r}, expected one of True and False")
    return [file_of(item, files, what) for item in items]


def file_of(flight: Any, files: Mapping[Any, str], what: str) -> str:
    """Return the file of a flight given by key or number."""
    flight, known = plain(flight), list(files.values())
    if isinstance(flight, bool):
        pass
    elif flight in files:
        return files[flight]
    elif flight in known:
        return cast(str, flight)
    elif isinstance(flight, int) and 0 <= flight < len(known) and not _numbered(files):
        return known[flight]
    of_keys = "" if _numbered(files) else " or its number from 0"
    expected = f"one of {', '.join(str(key) for key in files)}{of_keys}"
    raise InputError(f"{what}: found the flight {flight!r}, expected {expected}")


def _numbered(files: Mapping[Any, str]) -> bool:
    return any(isinstance(key, int) for key in files)


def floats(values: Any) -> Any:
    """Return columns of pandas that may be missing as numbers, NaN for a missing one.

    Other values are returned as they are.
    """
    dtypes: Any = getattr(values, "dtypes", getattr(values, "dtype", None))
    each: list[Any] = list(dtypes) if hasattr(dtypes, "__iter__") else [dtypes]
    if not any(hasattr(dtype, "na_value") and hasattr(dtype, "_is_numeric") for dtype in each):
        return values
    return values.to_numpy(dtype=float, na_value=math.nan)


def clock(times: Any) -> str:
    """Return what times are: numbers, differences of time, dates, or dates in a time zone."""
    about: Any = getattr(times, "dtype", None)
    kind = getattr(about, "kind", "O")
    if kind == "O":
        about = next(iter(times), None) if hasattr(times, "__len__") else None
        kind = "M" if isinstance(about, datetime) else "m" if isinstance(about, timedelta) else ""
    if kind == "M":
        zone = getattr(about, "tz", None) or getattr(about, "tzinfo", None)
        return "dates" if zone is None else "dates in a time zone"
    return "differences of time" if kind == "m" else "numbers"


def seconds(times: Any, origin: Any = None) -> Any:
    """Return times in seconds: differences of time as they are, dates from the first of `origin`.

    Dates count from their own first without `origin`.
    """
    # Most of the time of `import hyzer` would be that of NumPy.
    import numpy as np

    of_times = clock(times)
    if of_times == "numbers":
        return times
    if of_times == "differences of time":
        return np.asarray(times, dtype="timedelta64[ns]") / np.timedelta64(1, "s")
    dates = _dates(times)
    return (dates - (dates if origin is None else _dates(origin))[:1]) / np.timedelta64(1, "s")


def _dates(times: Any) -> Any:
    """Return dates as an array of NumPy, in UTC where they are in a time zone."""
    import numpy as np

    if getattr(getattr(times, "dtype", None), "kind", "O") == "O":
        times = [t.astimezone(timezone.utc).replace(tzinfo=None) if t.tzinfo else t for t in times]
    return np.asarray(times, dtype="datetime64[ns]")


def text_of(path: str | os.PathLike[str], what: str) -> str:
    """Return the text of a file; `what` names the argument in messages."""
    try:
        return Path(path).read_text(encoding="utf-8")
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is no text"
        raise InputError(f"{what}: {os.fspath(path)}: {reason}") from error
