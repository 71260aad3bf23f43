"""Texts of TOML files, so that values in memory pass the same checks as files."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from typing import Any, cast

from hyzer._arguments import is_path, plain
from hyzer._errors import InputError


def text(value: Any, name: str = "") -> str:
    """Return the text of a TOML value: a string, boolean, number, list or inline table.

    `name` is that of the value in messages.
    """
    value = os.fspath(value) if is_path(value) else plain(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Mapping) or hasattr(value, "iloc"):
        # A pandas Series is a mapping by its labels.
        items = cast("Mapping[Any, Any]", value)
        each = (f"{text(str(key))} = {text(item, str(key))}" for key, item in items.items())
        return "{ " + ", ".join(each) + " }"
    if isinstance(value, Iterable):
        parts = cast("Iterable[Any]", value)
        return "[" + ", ".join(text(part, name) for part in parts) + "]"
    if not hasattr(value, "__float__"):
        raise InputError(f"{name or 'value'}: found {value!r}, expected a number, text or list")
    return repr(float(cast("float", value)))


def document(values: Mapping[str, Any]) -> str:
    """Return a document: plain keys first, then the tables."""
    plain = {key: value for key, value in values.items() if not isinstance(value, Mapping)}
    lines = [line(key, value) for key, value in plain.items()]
    tables = [table(f"[{text(str(key))}]", values[key]) for key in values if key not in plain]
    return "".join([*lines, *tables])


def line(name: Any, value: Any) -> str:
    """Return the line of a key and its value."""
    return f"{text(str(name))} = {text(value, str(name))}\n"


def table(heading: str, values: Mapping[str, Any]) -> str:
    """Return a table with its heading; nothing where it is empty."""
    lines = [line(name, value) for name, value in values.items()]
    return f"\n{heading}\n" + "".join(lines) if lines else ""
