"""Progress of long work: a bar in terminals and notebooks, a function of one's own, or nothing."""

from __future__ import annotations

import sys
from collections.abc import Callable
from types import TracebackType
from typing import TextIO

Progress = Callable[[str, int, int], object]
"""Called with the name of the stage, the number of parts done, and their total."""

_WIDTH = 20


class Bar:
    """A line that shows the progress and is erased at the end."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._len = 0

    def __call__(self, stage: str, done: int, total: int) -> None:
        """Show the progress."""
        full = _WIDTH * done // max(total, 1)
        line = f"{stage} [{'=' * full}{' ' * (_WIDTH - full)}] {done}/{total}"
        self._write(line)

    def clear(self) -> None:
        """Erase the line."""
        if self._len:
            self._write("")
            self._stream.write("\r")
            self._stream.flush()

    def _write(self, line: str) -> None:
        self._stream.write("\r" + line.ljust(self._len))
        self._stream.flush()
        self._len = len(line)


class Watching:
    """The progress that a caller asked for: `None` shows a bar where somebody sees it."""

    def __init__(self, progress: Progress | bool | None) -> None:
        stream = _stream(shown=progress is True)
        self._bar: Bar | None = None
        self._progress: Progress | None = None
        if progress is not None and not isinstance(progress, bool):
            self._progress = progress
        elif stream and progress is not False:
            self._progress = self._bar = Bar(stream)

    def __enter__(self) -> Progress | None:
        """Return the function to call."""
        return self._progress

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        """Erase the bar."""
        if self._bar:
            self._bar.clear()


def _stream(*, shown: bool) -> TextIO | None:
    if "ipykernel" in sys.modules:
        return sys.stdout
    # Without a console, as in pythonw, there is no stream.
    stream: TextIO | None = sys.stderr
    return stream if stream and (shown or stream.isatty()) else None
