"""The program `hyzer`, which the package brings along."""

from __future__ import annotations

import sys

from hyzer import _hyzer


def main() -> int:
    """Run the program with the arguments of the process; return its exit status."""
    return _hyzer.main(["hyzer", *sys.argv[1:]])
