"""Functions of a model for NumPy and SciPy."""

from __future__ import annotations

import bisect
import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from ._arrays import ArrayLibrary, ArrayModel
from ._document import Ir, Table, TableOfTwo
from ._operations import Library, horner
from ._program import Programs, Values, required
from ._read import read

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    NumpyModel = ArrayModel[NDArray[np.float64]]


class NumpyLibrary(Library):
    """NumPy's functions, or those of a library with the same names."""

    def __init__(self, numpy: Any) -> None:
        self.numpy = numpy
        self.where = numpy.where
        self.both = numpy.logical_and
        names = {name: name for name in ("abs", "sqrt", "sin", "cos", "exp", "log", "tanh")}
        names |= {"asin": "arcsin", "atan2": "arctan2"}
        self.functions = {name: getattr(numpy, own) for name, own in names.items()}

    def lookup(self, table: Table, x: Any) -> Any:
        """Return the value of a piecewise cubic at `x`."""
        knots, cubics = self.numpy.asarray(table.knots), self.numpy.asarray(table.cubics)
        below = self.numpy.searchsorted(knots, x, side="right")
        h = x - knots[self.numpy.maximum(below - 1, 0)]
        return horner([cubics[below, power] for power in range(4)], h)

    def lookup_of_two(self, table: TableOfTwo, x: Any, y: Any) -> Any:
        """Return the value of a piecewise bicubic at `x`, `y`."""
        cells = self.numpy.asarray(table.bicubics)
        places: list[Any] = []
        distances: list[Any] = []
        for knots, at in ((table.knots, x), (table.second_knots, y)):
            known = self.numpy.asarray(knots)
            below = self.numpy.searchsorted(known, at, side="right")
            places.append(below)
            distances.append(at - known[self.numpy.maximum(below - 1, 0)])
        cell = places[0] * (len(table.second_knots) + 1) + places[1]
        rows = [[cells[cell, 4 * a + b] for b in range(4)] for a in range(4)]
        return horner([horner(row, distances[1]) for row in rows], distances[0])


def chosen(condition: Any, then: Any, otherwise: Any) -> Any:
    """Return `then` where `condition` holds, else `otherwise`."""
    return then if condition else otherwise


def both(a: Any, b: Any) -> Any:
    """Return whether both conditions hold."""
    return a and b


class MathLibrary(Library):
    """Functions of one number, by the standard library: a tenth of the time of NumPy's."""

    def __init__(self) -> None:
        self.where = chosen
        self.both = both
        names = ("sqrt", "sin", "cos", "asin", "exp", "log", "tanh", "atan2")
        self.functions = {"abs": abs, **{name: getattr(math, name) for name in names}}

    def lookup(self, table: Table, x: Any) -> Any:
        """Return the value of a piecewise cubic at `x`."""
        below = bisect.bisect_right(table.knots, x)
        return horner(table.cubics[below], x - table.knots[max(below - 1, 0)])

    def lookup_of_two(self, table: TableOfTwo, x: Any, y: Any) -> Any:
        """Return the value of a piecewise bicubic at `x`, `y`."""
        i, j = bisect.bisect_right(table.knots, x), bisect.bisect_right(table.second_knots, y)
        h, k = x - table.knots[max(i - 1, 0)], y - table.second_knots[max(j - 1, 0)]
        cell = table.bicubics[i * (len(table.second_knots) + 1) + j]
        return horner([horner(cell[4 * a : 4 * a + 4], k) for a in range(4)], h)


class NumpyPrograms:
    """Functions of an IR for numbers and for arrays."""

    def __init__(self, ir: Ir, numpy: Any) -> None:
        self.of_arrays = Programs(ir, NumpyLibrary(numpy))
        self.of_numbers = Programs(ir, MathLibrary())

    def __call__(self, name: str, arrays: Mapping[str, Sequence[Any]]) -> Values:
        """Evaluate the function `name` at elements of `arrays`, which broadcast."""
        try:
            numbers = {letter: [part.item() for part in parts] for letter, parts in arrays.items()}
            return self.of_numbers(name, numbers)
        except (ArithmeticError, ValueError):
            # Arrays have no item; and NumPy gives infinity where the standard library has an error.
            return self.of_arrays(name, arrays)


def to_numpy(ir: dict[str, Any] | Ir) -> NumpyModel:
    """Functions of a model over arrays of NumPy.

    Parameters
    ----------
    ir : dict or Ir
        Document as ``json.loads`` returns it.

    Returns
    -------
    ArrayModel
        Object with `rhs`, `jac`, `observe`, `observe_jac`, `quantities` and `limits`.

    Raises
    ------
    IrError
        If the document is not one of schema ``hyzer.ir/1``.
    ImportError
        If NumPy is missing.

    Examples
    --------
    A ball that is thrown upwards at 2 m/s:

    >>> import json, subprocess
    >>> text = subprocess.check_output(["hyzer", "export", "ball", "--ir"])
    >>> ball = to_numpy(json.loads(text))
    >>> ball.states
    ('x', 'y', 'z', 'vx', 'vy', 'vz')
    >>> ball.rhs(0.0, [0, 0, 1, 0, 0, 2])[2]
    np.float64(2.0)
    >>> J, Jp = ball.jac(0.0, [[0, 0, 1, 0, 0, 2], [0, 0, 1, 3, 0, 2]])
    >>> J.shape
    (2, 6, 6)
    """
    numpy = required("numpy", "to_numpy")
    checked = read(ir)

    def dense(
        values: Sequence[Any],
        places: Sequence[tuple[int, ...]],
        batch: tuple[int, ...],
        shape: tuple[int, ...],
    ) -> Any:
        if not batch and len(shape) == 1:
            return numpy.array(values)
        array = numpy.zeros(batch + shape)
        for place, value in zip(places, values, strict=True):
            index = (..., *place)
            array[index] = value
        return array

    library = ArrayLibrary(
        array=partial(numpy.asarray, dtype=float),
        broadcast_shapes=numpy.broadcast_shapes,
        dense=dense,
    )
    return ArrayModel(checked, NumpyPrograms(checked, numpy), library)
