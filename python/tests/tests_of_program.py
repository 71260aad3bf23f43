"""Runs the program that the package brings along."""

import subprocess
import sys


def program(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "hyzer", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False)
