"""Checks of values from outside: each returns the value, or raises an `IrError` with its place."""

from __future__ import annotations

import math
import reprlib
from collections.abc import Callable
from typing import Any, TypeVar, cast

from ._document import IrError

T = TypeVar("T")
SHORT = reprlib.Repr()
SHORT.maxstring = SHORT.maxother = 60


def fault(place: str, found: object, expected: str) -> IrError:
    """Return the error for a fault of a document."""
    try:
        text = SHORT.repr(found)
    except ValueError:  # An integer of too many digits.
        text = "a number of thousands of digits"
    return IrError(f"{place}: found {text}, expected {expected}")


def string(value: object, place: str) -> str:
    if isinstance(value, str):
        return value
    raise fault(place, value, "a string")


def number(value: object, place: str) -> float:
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        try:
            converted = float(value)
        except OverflowError:
            converted = math.inf
        if math.isfinite(converted):
            return converted
    raise fault(place, value, "a finite number")


def index(value: object, place: str, length: int) -> int:
    if isinstance(value, int) and not isinstance(value, bool) and 0 <= value < length:
        return value
    raise fault(place, value, f"an index from 0 to {length - 1}")


def flag(value: object, place: str) -> bool:
    if isinstance(value, bool):
        return value
    raise fault(place, value, "true or false")


def entries(value: object, place: str) -> list[object]:
    if isinstance(value, list):
        return cast("list[object]", value)
    raise fault(place, value, "a list")


def table_of(value: object, place: str) -> dict[str, object]:
    if isinstance(value, dict):
        return cast("dict[str, object]", value)
    raise fault(place, value, "an object")


def each(value: object, place: str, item: Callable[[Any, str], T]) -> tuple[T, ...]:
    """Read a list, each item by `item(value, place)`."""
    return tuple(item(entry, f"{place}[{k}]") for k, entry in enumerate(entries(value, place)))


def exactly(items: tuple[T, ...], place: str, length: int) -> tuple[T, ...]:
    if len(items) == length:
        return items
    raise fault(place, f"{len(items)} items", f"{length}")


class Fields:
    """Fields of an object, each read once by name."""

    def __init__(self, value: object, place: str) -> None:
        self.values = table_of(value, place)
        self.place = place

    def of(self, key: str, item: Callable[[Any, str], T]) -> T:
        """Read the field `key` by `item(value, place)`."""
        place = f"{self.place}.{key}" if self.place else key
        if key not in self.values:
            raise IrError(f"{place}: found nothing, expected this field")
        return item(self.values[key], place)

    def all(self, key: str, item: Callable[[Any, str], T]) -> tuple[T, ...]:
        """Read the list in the field `key`."""
        return self.of(key, lambda value, place: each(value, place, item))
