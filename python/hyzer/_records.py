"""Results of hyzer: what a report holds, as attributes, tables and arrays."""

from __future__ import annotations

import copy
import html
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, SupportsIndex, cast, overload

from hyzer._extras import extra

if TYPE_CHECKING:
    import pandas as pd

# Length of a list that is shown whole in a line.
_LEN = 3


# Keys that the report has only of flights of which they are true.
_OF_SOME_FLIGHTS = {"reason", "is_summary", "seen"}


def wrap(value: Any) -> Any:
    """Give a value of JSON its attributes: objects become records, tables of objects tables."""
    if isinstance(value, dict):
        found = cast("dict[str, Any]", value)
        if found and all(isinstance(item, dict) for item in found.values()):
            return Table(found)
        return Record(found)
    if isinstance(value, list):
        items = cast("list[Any]", value)
        if items and all(isinstance(item, dict) for item in items):
            return Rows(wrap(item) for item in items)
        return [wrap(item) for item in items]
    return value


class Record(Mapping[str, Any]):
    """An object of a report: its values by attribute or by key.

    Examples
    --------
    >>> noise = Record({"sigma": 0.0015, "unit": "m"})
    >>> noise.sigma, noise["unit"]
    (0.0015, 'm')
    >>> noise
    Record(sigma=0.0015, unit='m')
    """

    def __init__(self, data: dict[str, Any]) -> None:
        self._data = data

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return wrap(self._values()[name])
        except KeyError:
            if name in _OF_SOME_FLIGHTS and "outcome" in self._values():
                return None
            known = ", ".join(self._values())
            raise AttributeError(f"found {name!r}, expected one of {known}") from None

    def _values(self) -> dict[str, Any]:
        return self._data

    def __getitem__(self, name: str) -> Any:
        return wrap(self._values()[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._values())

    def __len__(self) -> int:
        return len(self._values())

    def __dir__(self) -> Iterable[str]:
        return [*super().__dir__(), *self._values()]

    def __repr__(self) -> str:
        values = (f"{name}={_brief(value)}" for name, value in self._values().items())
        return f"{type(self).__name__}({', '.join(values)})"

    def to_dict(self) -> dict[str, Any]:
        """Return a copy of the values as dicts, lists and numbers, as in the JSON of the report."""
        return copy.deepcopy(self._values())

    def html(self) -> str:
        """Return the values as a table of HTML, which a notebook shows."""
        return _html([self._values()])

    def _repr_html_(self) -> str:
        return self.html()


class Table(Record):
    """Records by name, such as the coefficients of a fit."""

    def to_pandas(self) -> pd.DataFrame:
        """Return the records as the rows of a DataFrame, with their names as its index."""
        pandas = extra("pandas")
        frame = pandas.json_normalize(list(self._values().values()))
        frame.index = pandas.Index(list(self._values()))
        return cast("pd.DataFrame", frame)

    def html(self) -> str:
        """Return the records as a table of HTML."""
        return _html([{"": name, **row} for name, row in self._values().items()])


class Rows(list[Record]):
    """Records in order, such as the flights of a fit; a slice has `to_pandas` too."""

    @overload
    def __getitem__(self, index: SupportsIndex) -> Record: ...
    @overload
    def __getitem__(self, index: slice) -> Rows: ...
    def __getitem__(self, index: SupportsIndex | slice) -> Record | Rows:
        """Return a record, or those of a slice."""
        if isinstance(index, slice):
            return Rows(super().__getitem__(index))
        return super().__getitem__(index)

    def to_pandas(self) -> pd.DataFrame:
        """Return the records as the rows of a DataFrame."""
        rows = [record.to_dict() for record in self]
        return cast("pd.DataFrame", extra("pandas").json_normalize(rows))

    def html(self) -> str:
        """Return the records as a table of HTML."""
        return _html([record.to_dict() for record in self])

    def _repr_html_(self) -> str:
        return self.html()


def titled(result: Record, key: str) -> str:
    """Return what a notebook shows of a result: its line, and the table that it has by a key."""
    value = result.get(key)
    inside = value.html() if isinstance(value, (Record, Rows)) else ""
    return f"<p>{html.escape(repr(result))}</p>{inside}"


def _html(rows: list[dict[str, Any]]) -> str:
    """Return a table of the scalar values of rows."""
    heads = list(dict.fromkeys(name for row in rows for name in row if _is_scalar(row[name])))
    head = "".join(f'<th scope="col">{html.escape(name)}</th>' for name in heads)
    body = "".join(
        "<tr>"
        + "".join(f"<td>{html.escape(shown(row.get(name)))}</td>" for name in heads)
        + "</tr>"
        for row in rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _brief(value: object) -> str:
    """Return a value as a line shows it: an estimate with its error, or how much a list holds."""
    if isinstance(value, dict):
        found = cast("dict[str, Any]", value)
        if not isinstance(found.get("value"), (int, float)):
            return f"{{{len(found)} values}}"
        error, unit = found.get("std_error"), found.get("unit", "1")
        spread = "" if error is None else f" ± {shown(error)}"
        return f"{shown(found['value'])}{spread}{'' if unit == '1' else f' {unit}'}"
    if isinstance(value, list):
        items = cast("list[Any]", value)
        is_short = len(items) <= _LEN and all(_is_scalar(item) for item in items)
        inside = ", ".join(_brief(item) for item in items) if is_short else f"{len(items)} values"
        return f"[{inside}]"
    return shown(value) if isinstance(value, float) else repr(value)


def _is_scalar(value: object) -> bool:
    return value is None or isinstance(value, (str, float, int))


def shown(value: object) -> str:
    """Return a value as a page shows it: five digits, a dash for what does not exist."""
    if value is None:
        return "-"
    if isinstance(value, float):
        return f"{value:.5g}"
    return str(value)
