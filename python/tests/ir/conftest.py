"""Documents, and values of the tape, from the programs of this repository."""

from __future__ import annotations

import json
import os
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import jax
import numpy as np

from hyzer.ir import Ir, read

jax.config.update("jax_enable_x64", True)

ROOT = Path(__file__).parents[3]
ZOO = str(ROOT / "codegen/tests/integration/zoo/zoo.hyz")
MODELS = ("ball", "disc", "disc_appendix", "disc_quaternion", "discus")
EFFECTS = (
    ("disc", "stall", "wind_by_height", "unequal_diametral_inertias"),
    ("disc", "wind_of_each_flight", "clock_rate", "ground_effect", "rolling_shutter"),
    ("disc_quaternion", "mass_imbalance", "lens_distortion", "added_mass"),
    ("disc", "drag_by_reynolds", "side_force_by_spin_and_angle", "marker_time_offset"),
    ("ball", "drag_crisis", "magnus", "wind_by_height", "buoyancy"),
)
CASES = (*((name,) for name in MODELS), *EFFECTS, (ZOO,))
"""Models and the effects that are added to them; the zoo has every function of the language."""

SIZES = {"phi": 0.9, "theta": 0.9, "gamma": 0.9, "a": 0.9, "b": 0.9, "e": 0.9}
SIZES |= dict.fromkeys(("u", "v", "w", "vx", "vy", "vz"), 12.0)


def name_of(case: tuple[str, ...]) -> str:
    return " ".join(Path(part).stem for part in case)


@cache
def program(*arguments: str) -> Path:
    """Return the path of a program of the repository, built unless HYZER_PROGRAMS has it."""
    if "HYZER_PROGRAMS" in os.environ:
        folder = Path(os.environ["HYZER_PROGRAMS"])
    else:
        subprocess.run(["cargo", "build", "--quiet", *arguments], cwd=ROOT, check=True)
        folder = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "debug"
    return folder / ("examples" if "--example" in arguments else ".") / arguments[-1]


def hyzer(*arguments: str) -> str:
    """Run the program and return what it prints."""
    command = [str(program("--bin", "hyzer")), *arguments]
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout


@cache
def exported(case: tuple[str, ...]) -> str:
    """Return the document of a model with effects."""
    effects = [word for effect in case[1:] for word in ("--with", effect)]
    return hyzer("export", case[0], "--ir", *effects)


def document(case: tuple[str, ...]) -> dict[str, Any]:
    return json.loads(exported(case))


class Points:
    """Random states and parameters, and what the tape computes there.

    Attributes
    ----------
    t, x, p, marker : array, one row per point
    expected : dict of array
        Outputs of the functions by name; matrices by their stored entries.
    """

    def __init__(self, case: tuple[str, ...], count: int) -> None:
        self.ir = read(document(case))
        random = np.random.default_rng(7)
        start = np.array([state.value for state in self.ir.states])
        size = np.array([self.size(state.name) for state in self.ir.states])
        value = np.array([parameter.value for parameter in self.ir.parameters])
        self.t = random.uniform(0, 3, count)
        self.x = start + size * random.uniform(-1, 1, (count, len(start)))
        factor = random.uniform(-1, 1, (count, len(value)))
        self.p = np.where(value == 0, 0.3 * factor, value * (1 + 0.3 * factor))
        self.marker = random.uniform(-0.1, 0.1, (count, len(self.ir.marker)))
        self.expected = self._tape(case)

    @staticmethod
    def size(state: str) -> float:
        return 0.0 if state.startswith("q") and len(state) == 2 else SIZES.get(state, 5.0)

    def _tape(self, case: tuple[str, ...]) -> dict[str, Any]:
        rows = np.column_stack([self.t, self.x, self.p, self.marker])
        text = "\n".join(" ".join(map(repr, row)) for row in rows.tolist())
        tape = program("-p", "hyzer-codegen", "--example", "tape")
        command = [str(tape), *case]
        done = subprocess.run(command, input=text, check=True, capture_output=True, text=True)
        values = np.array(
            [[float(word) for word in line.split()] for line in done.stdout.splitlines()]
        )
        outputs = [
            output
            for function in ("jacobian", "observe_jacobian", "quantities", "limits")
            for output in self.ir.functions[function].outputs
        ]
        ends = np.cumsum([len(output.values) for output in outputs])
        parts = np.split(values, ends[:-1], axis=1)
        assert ends[-1] == values.shape[1]
        return {output.name: part for output, part in zip(outputs, parts, strict=True)}


@cache
def points(case: tuple[str, ...], count: int = 1000) -> Points:
    return Points(case, count)


def entries(ir: Ir, function: str, output: str, dense: Any) -> Any:
    """Return the stored entries of a dense array."""
    (part,) = [part for part in ir.functions[function].outputs if part.name == output]
    rows, columns = np.array(part.entries, dtype=int).reshape(-1, 2).T
    return np.asarray(dense)[..., rows, columns]


def error(expected: Any, found: Any) -> float:
    """Return the largest difference, relative to the largest magnitude of the same row, or to 1."""
    expected, found = np.asarray(expected), np.asarray(found)
    assert expected.shape == found.shape
    assert np.isfinite(expected).all()
    size = np.max(np.abs(expected), axis=-1, keepdims=True, initial=1.0)
    return float(np.max(np.abs(expected - found) / size, initial=0.0))
