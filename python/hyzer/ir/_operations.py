"""What each operation computes, in terms of a few functions of a library."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from typing import Any

from ._document import Table, TableOfTwo

TINY = 1e-75
"""Below this magnitude a number counts as zero where it would be divided by."""

Operation = Callable[..., Any]


class Library:
    """Functions of a library, for its numbers, arrays or expressions.

    Attributes
    ----------
    where : callable
        ``where(condition, then, otherwise)``.
    both : callable
        Whether two conditions hold.
    functions : dict
        Functions ``abs``, ``sqrt``, ``sin``, ``cos``, ``asin``, ``exp``, ``log``, ``tanh`` and
        ``atan2``.
    """

    where: Operation
    both: Operation
    functions: dict[str, Operation]

    def is_zero(self, x: Any) -> Any:
        """Return whether `x` is zero."""
        return x == 0

    def negligible(self, x: Any) -> Any:
        """Return whether `x` counts as zero where it would be divided by."""
        return self.functions["abs"](x) < TINY

    def replaced(self, condition: Any, harmless: float, x: Any) -> Any:
        """Return `x`, and a harmless number where the function of it would be singular.

        Then derivatives by the library are those of docs/reference/ir.md, and no warning appears.
        """
        return self.where(condition, harmless, x)

    def reciprocal(self, x: Any) -> Any:
        """Return ``1 / x``, where `x` is not negligible."""
        return 1.0 / x

    def lookup(self, table: Table, x: Any) -> Any:
        """Return the value of a piecewise cubic at `x`."""
        raise NotImplementedError

    def lookup_of_two(self, table: TableOfTwo, x: Any, y: Any) -> Any:
        """Return the value of a piecewise bicubic at `x`, `y`."""
        columns = len(table.second_knots) + 1

        def along(column: int, power: int) -> Any:
            cells = table.bicubics[column::columns]
            cubics = tuple(cell[power::4] for cell in cells)
            return self.lookup(Table(table.name, table.knots, cubics), x)

        rows = (tuple(along(column, power) for power in range(4)) for column in range(columns))
        return self.lookup(Table(table.name, table.second_knots, tuple(rows)), y)


def operations(library: Library) -> dict[str, Operation]:
    """Return the operations by name, except those that look up tables."""
    return {**arithmetic(), **conditional(library), **guarded(library)}


def arithmetic() -> dict[str, Operation]:
    """Return the operations that need no library."""
    return {
        "neg": operator.neg,
        "recip": recip,
        "add": operator.add,
        "sub": operator.sub,
        "mul": operator.mul,
        "div": div,
        "mul_add": mul_add,
        "mul_sub": mul_sub,
        "neg_mul_add": neg_mul_add,
    }


def recip(x: Any) -> Any:
    """Return ``1 / x``."""
    return 1.0 / x


def div(a: Any, b: Any) -> Any:
    """Return ``a / b``."""
    return a / b


def mul_add(a: Any, b: Any, c: Any) -> Any:
    """Return ``a * b + c``."""
    return a * b + c


def mul_sub(a: Any, b: Any, c: Any) -> Any:
    """Return ``a * b - c``."""
    return a * b - c


def neg_mul_add(a: Any, b: Any, c: Any) -> Any:
    """Return ``c - a * b``."""
    return c - a * b


def conditional(library: Library) -> dict[str, Operation]:
    """Return the operations that choose between values."""
    where, negligible = library.where, library.negligible

    def recip_or_zero(x: Any) -> Any:
        zero = negligible(x)
        return where(zero, 0.0, library.reciprocal(library.replaced(zero, 1.0, x)))

    def if_zero(x: Any, then: Any, otherwise: Any) -> Any:
        return where(negligible(x), then, otherwise)

    def nonzero(x: Any) -> Any:
        return where(negligible(x), 0.0, 1.0)

    def sign(x: Any) -> Any:
        return where(x > 0, 1.0, where(x < 0, -1.0, 0.0))

    def step(x: Any) -> Any:
        return where(x > 0, 1.0, 0.0)

    def minimum(a: Any, b: Any) -> Any:
        return where(a < b, a, b)

    def maximum(a: Any, b: Any) -> Any:
        return where(b < a, a, b)

    own: dict[str, Operation] = {
        "recip_or_zero": recip_or_zero,
        "if_zero": if_zero,
        "nonzero": nonzero,
    }
    return {**own, "sign": sign, "step": step, "min": minimum, "max": maximum}


def guarded(library: Library) -> dict[str, Operation]:
    """Return the elementary functions, with their values at singular points."""
    where, named = library.where, library.functions

    def above_zero(function: Operation) -> Operation:
        def evaluate(x: Any) -> Any:
            outside = x <= 0
            return where(outside, 0.0, function(library.replaced(outside, 1.0, x)))

        return evaluate

    def asin(x: Any) -> Any:
        outside = named["abs"](x) >= 1
        inside = named["asin"](library.replaced(outside, 0.0, x))
        return where(outside, where(x > 0, math.pi / 2, -math.pi / 2), inside)

    def atan2(y: Any, x: Any) -> Any:
        origin = library.both(library.is_zero(x), library.is_zero(y))
        return where(origin, 0.0, named["atan2"](y, library.replaced(origin, 1.0, x)))

    plain = {name: named[name] for name in ("abs", "sin", "cos", "exp", "tanh")}
    singular = {name: above_zero(named[name]) for name in ("sqrt", "log")}
    return {**plain, **singular, "asin": asin, "atan2": atan2}


def horner(coefficients: Any, h: Any) -> Any:
    """Return the cubic with the coefficients of the powers 0 to 3 at the distance `h`."""
    a, b, c, d = coefficients
    return ((d * h + c) * h + b) * h + a
