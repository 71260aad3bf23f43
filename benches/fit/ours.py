"""`hyzer fit` in a process of its own, watched."""

import json
import pathlib
import shutil
import subprocess
import sys
from dataclasses import dataclass

import numpy as np

import native

HERE = pathlib.Path(__file__).resolve().parent


@dataclass
class Run:
    """One fit; times in s, memory in bytes."""

    total: float  # as the report says: all of the fit, without reading files, the tests of lack of fit, and figures
    wall: float  # of the process
    cpu: float  # of the process
    memory: int  # its peak
    report: dict

    def coefficients(self, what="value"):
        return np.array([self.report["coefficients"][name][what] for name in native.COEFFICIENTS])

    def initial(self, what="value"):
        rows = [[f["initial"][s][what] for s in native.disc.STATES] for f in self.report["flights"]]
        return np.array(rows)


def fit(hyzer, dataset, out, *options):
    shutil.rmtree(out, ignore_errors=True)
    command = [str(hyzer), "fit", str(dataset), "--out", str(out), *options]
    watched = [sys.executable, "-I", "-S", HERE / "watched.py", *command]
    seen = json.loads(subprocess.run(watched, check=True, capture_output=True, text=True).stdout)
    if seen.pop("status"):
        raise SystemExit(f"failed: {' '.join(command)}")
    report = json.loads((out / "report.json").read_text())
    seconds = report["seconds"]
    return Run(seconds["total"] - seconds["lack_of_fit"], report=report, **seen)
