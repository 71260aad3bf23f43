"""Packages that hyzer uses where they are installed."""

from __future__ import annotations

import importlib
import io
from types import ModuleType
from typing import TYPE_CHECKING, Any, cast

if TYPE_CHECKING:
    import pandas as pd

_EXTRAS = {"pandas": "pandas", "xarray": "xarray", "matplotlib.pyplot": "plot"}


def extra(name: str) -> ModuleType:
    """Import an optional package; say how to install it where it is missing."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.partition(".")[0]
        text = f"this needs {package}: pip install 'hyzer[{_EXTRAS[name]}]'"
        raise ImportError(text) from error


def frame_of(text: str, **options: Any) -> pd.DataFrame:
    """Return a table of the program as a DataFrame."""
    pandas = extra("pandas")
    if pandas.__version__.startswith("2."):
        # Its default parser is off by a unit in the last place.
        options["float_precision"] = "round_trip"
    return cast("pd.DataFrame", pandas.read_csv(io.StringIO(text), **options))
