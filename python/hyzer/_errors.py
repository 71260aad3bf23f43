"""Exceptions of hyzer.

Every exception that hyzer raises on purpose is an `Error`, except `Cancelled`, which follows
Ctrl-C.
"""

from __future__ import annotations

from typing import TypedDict


class Fault(TypedDict):
    """One fault of a text, with its place; lines and columns count from 1."""

    message: str
    file: str | None
    line: int | None
    column: int | None
    hint: str | None


class Error(Exception):
    """Base of the exceptions of hyzer.

    Attributes
    ----------
    file : str or None
        File or text in which the error is.
    line, column : int or None
        Place in the file, from 1.
    hint : str or None
        What to do about it.
    faults : list of dict
        All faults found, where there may be several: `message`, `file`, `line`, `column`, `hint`.
    """

    file: str | None = None
    line: int | None = None
    column: int | None = None
    hint: str | None = None
    faults: list[Fault] = []  # noqa: RUF012  Replaced as a whole where there are faults.


class InputError(Error, ValueError):
    """An argument, a dataset or a release is wrong: what was found, and what was expected."""


class ModelError(Error, ValueError):
    """A model or an effect cannot be loaded, or its text has faults."""


class FitError(Error):
    """A model cannot be fitted to a dataset."""


class FlightError(Error):
    """A flight cannot be simulated, or no throw or state has the motion asked for."""


class FolderError(Error, OSError):
    """A folder cannot be read or written, or holds files that are not results of hyzer."""


class InternalError(Error, RuntimeError):
    """A mistake in hyzer itself."""


class Cancelled(KeyboardInterrupt):
    """Work was ended by Ctrl-C; what it had not finished was not written."""
