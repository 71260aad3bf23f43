"""Prints the figures of an installed package: time of a call, of a state in a batch, leaks.

Run from the root of the repository: python python/tools/measure.py
"""

import gc
import subprocess
import sys
import threading
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np

import hyzer

X = np.array([0, 0, 1, 14, 0, -1, 0.1, -0.2, 0, 0.5, 0, -50.0])
BATCH = X + np.random.default_rng(1).normal(0, 0.1, (10_000, 12))


def seconds(call: Callable[[], object], times: int, repeats: int = 7) -> float:
    """Return the least mean time of a call."""
    best = np.inf
    for _ in range(repeats):
        begin = time.perf_counter()
        for _ in range(times):
            call()
        best = min(best, (time.perf_counter() - begin) / times)
    return best


def calls(name: str, model: hyzer.Model) -> None:
    """Print the times of the functions of a model."""
    p = model.parameter_vector()
    print(f"{name}: rhs {1e6 * seconds(lambda: model.rhs(0.0, X), 300, 60):.2f} µs", end=", ")
    print(f"with p {1e6 * seconds(lambda: model.rhs(0.0, X, p), 300, 60):.2f} µs", end=", ")
    print(f"jac {1e6 * seconds(lambda: model.jac(0.0, X), 300, 60):.2f} µs", end=", ")
    print(f"batch {1e5 * seconds(lambda: model.rhs(0.0, BATCH), 1, 60):.1f} ns a state")


def resident() -> int:
    """Return the memory of the process, bytes."""
    return 4096 * int(Path("/proc/self/statm").read_text().split()[1])


def leaks(model: hyzer.Model) -> None:
    """Print what 1e5 rounds of calls leave behind."""

    def rounds(count: int) -> None:
        for _ in range(count):
            model.rhs(0.0, X)
            model.jac(0.0, X)
            model.observe(0.0, X, [0.1, 0.0, 0.0])
            try:
                model.rhs(0.0, X[:3])
            except hyzer.InputError:
                pass

    rounds(2000)
    gc.collect()
    tracemalloc.start()
    rounds(1000)
    before, used = tracemalloc.take_snapshot(), resident()
    rounds(100_000)
    gc.collect()
    grown = (resident() - used) / 1024
    after = tracemalloc.take_snapshot()
    traced = sum(line.size_diff for line in after.compare_to(before, "filename"))
    print(f"1e5 rounds of calls and a refusal: {traced} bytes traced, {grown:.0f} kB resident")


def threads(model: hyzer.Model) -> None:
    """Print whether threads get the same bits."""
    results: list[np.ndarray] = []
    work = [
        threading.Thread(target=lambda: results.append(model.rhs(0.0, BATCH))) for _ in range(8)
    ]
    for thread in work:
        thread.start()
    for thread in work:
        thread.join()
    print("8 threads, the same bits:", all(np.array_equal(r, results[0]) for r in results))


def process(code: str) -> float:
    """Return the least time of a process that runs a code, s."""
    command = [sys.executable, "-c", code]
    return seconds(lambda: subprocess.run(command, check=True), 1, 15)


def main() -> None:
    """Print all figures."""
    tape = hyzer.Model("disc", effects=["wind"])
    calls("machine code", hyzer.Model("disc"))
    calls("interpreted", tape)
    print(f"import: {1e3 * (process('import hyzer') - process('pass')):.1f} ms")
    for name, call in {
        "fit of examples/disc": lambda: hyzer.fit("examples/disc"),
        "diagnose of examples/mystery": lambda: hyzer.diagnose("examples/mystery"),
    }.items():
        print(f"{name}: {seconds(call, 1, 9):.3f} s")
    threads(tape)
    leaks(tape)


if __name__ == "__main__":
    main()
