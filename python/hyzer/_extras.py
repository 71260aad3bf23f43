"""Packages that hyzer uses where they are installed."""

from __future__ import annotations

import importlib
from types import ModuleType

_EXTRAS = {"pandas": "pandas", "xarray": "xarray", "matplotlib.pyplot": "plot"}


def extra(name: str) -> ModuleType:
    """Import an optional package; say how to install it where it is missing."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.partition(".")[0]
        text = f"this needs {package}: pip install 'hyzer[{_EXTRAS[name]}]'"
        raise ImportError(text) from error
