"""Texts of TOML files, so that values in memory pass the same checks as files."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from typing import Any, cast

from hyzer._arguments import is_path, plain


def text(value: Any) -> str:
    """Return the text of a TOML value: a string, boolean, number, list or inline table."""
    value = os.fspath(value) if is_path(value) else plain(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Mapping) or hasattr(value, "iloc"):
        # A pandas Series is a mapping by its labels.
        items = cast("Mapping[Any, Any]", value)
        each = (f"{text(str(name))} = {text(item)}" for name, item in items.items())
        return "{ " + ", ".join(each) + " }"
    if isinstance(value, Iterable):
        parts = cast("Iterable[Any]", value)
        return "[" + ", ".join(text(part) for part in parts) + "]"
    return repr(float(cast("float", value)))


def document(values: Mapping[str, Any]) -> str:
    """Return a document: plain keys first, then the tables."""
    plain = {key: value for key, value in values.items() if not isinstance(value, Mapping)}
    lines = [f"{text(str(key))} = {text(value)}\n" for key, value in plain.items()]
    tables = [table(f"[{text(str(key))}]", values[key]) for key in values if key not in plain]
    return "".join([*lines, *tables])


def table(heading: str, values: Mapping[str, Any]) -> str:
    """Return a table with its heading; nothing where it is empty."""
    lines = [f"{text(str(name))} = {text(value)}\n" for name, value in values.items()]
    return f"\n{heading}\n" + "".join(lines) if lines else ""
