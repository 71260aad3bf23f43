"""FrisPy, SciPy and our lanes in one process, in turn, round after round; the page docs/studies/benchmarks-sweep.md."""

import argparse
import ctypes
import json
import os
import pathlib
import platform
import statistics
import subprocess
import tempfile
import time

import numba
import numpy as np
from frispy.disc import Disc
from frispy.equations_of_motion import EOM
from scipy.integrate import solve_ivp

import nutation
from flown import BACKHAND, DISC, FLIGHTS, Ours, pointer, scattered, timed

ROOT = pathlib.Path(__file__).resolve().parents[2]
FRISPY = [0.175, 0.273049106904806, 0.058556, 1.225, 9.81, 1, 0.001219, 0.002352, 0.33, 1.9, 0.18, 0.69, -0.013, -0.0017, -0.082]
FRISPY += [0.43, -0.014, -3.4e-5, 0.06981317007977318]
DEFAULT = [0, 0, 1, 10, 0, 0, 0, 0, 0, 0, 0, 62]
METHODS = ["Tsit5", "DOP853"]


class Groundless(EOM):
    """Without the stop below the ground, so that an event can find it."""

    def compute_derivatives(self, t, y):
        return super().compute_derivatives(t, np.concatenate((y[:2], [1.0], y[3:])))


def scipy_disc(library):
    """The same disc for SciPy: our own compiled right-hand side, called by a function that Numba compiles."""
    rate = library.disc_rate
    rate.argtypes = [ctypes.c_void_p] * 4
    rate.restype = None
    p, prepared = np.array(DISC, dtype=float), np.zeros(22)
    library.disc_prepare(pointer(p), pointer(prepared))
    p_at, prepared_at = p.ctypes.data, prepared.ctypes.data
    keep = (p, prepared)

    @numba.njit
    def f(t, y):
        dx = np.empty(12)
        rate(y.ctypes.data, p_at, prepared_at, dx.ctypes.data)
        return dx

    @numba.njit
    def height(t, y):
        return y[2]

    f(0.0, np.array(BACKHAND)), height(0.0, np.array(BACKHAND))
    ground = lambda t, y: height(t, y)
    ground.terminal = True

    def fly(tolerance, method="DOP853"):
        return solve_ivp(f, (0, 600), BACKHAND, method=method, rtol=tolerance, atol=tolerance, events=ground)

    fly.keep = keep
    return fly


def scaling(hyzer):
    """Flights a second of `hyzer sweep` as a whole on one thread and on all: of the wall's time, and of the processor's per thread."""
    threads = len(os.sched_getaffinity(0))
    walls, processors = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        plan = pathlib.Path(folder) / "plan.toml"
        text = subprocess.run([hyzer, "sweep", "--example"], check=True, capture_output=True, text=True).stdout
        plan.write_text(text.replace("flights = 2000", "flights = 20000"))
        for k in range(2):
            for count in (1, threads):
                wall, before = time.perf_counter(), os.times()
                out = pathlib.Path(folder) / f"{k}-{count}"
                subprocess.run([hyzer, "sweep", plan, "--out", out, "--threads", str(count)], check=True, capture_output=True)
                after = os.times()
                used = after.children_user + after.children_system - before.children_user - before.children_system
                walls.setdefault(count, []).append(60_000 / (time.perf_counter() - wall))
                processors.setdefault(count, []).append(60_000 / used)
    best = lambda rates: {count: max(values) for count, values in rates.items()}
    return threads, best(walls), best(processors)


def verdict(ratio, bar):
    return f"{ratio:.0f}: " + ("holds" if ratio >= bar else "**missed**") + f" (bar {bar})"


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("library")
    arguments.add_argument("hyzer")
    arguments.add_argument("compiled", type=pathlib.Path, help="what jit.py measured")
    arguments.add_argument("--rounds", type=int, default=31)
    arguments.add_argument("--out", default=str(ROOT / "docs" / "studies" / "benchmarks-sweep.md"))
    asked = arguments.parse_args()
    ours = Ours(asked.library)
    fly_scipy = scipy_disc(ours.library)

    # The answers first.
    ground = lambda t, y: y[2]
    ground.terminal = True
    _, exact = Disc(eom_class=Groundless).compute_trajectory(flight_time=10.0, events=ground, rtol=1e-11, atol=1e-13)
    frispy_end = np.concatenate(([exact.t_events[0][0]], exact.y_events[0][0]))
    exact = fly_scipy(1e-12)
    disc_end = np.concatenate(([exact.t_events[0][0]], exact.y_events[0][0]))
    frispy_starts, disc_starts = scattered(DEFAULT, 1), scattered(BACKHAND, 2)
    sets = [(0, 1e-9, frispy_starts, FRISPY, frispy_end), (1, 1e-6, disc_starts, DISC, disc_end)]
    errors, evaluations = {}, {}
    for model, atol, starts, p, end in sets:
        for method in range(2):
            ends, evaluations[model, method] = ours.fly(model, method, 1e-6, atol, starts, p)
            errors[model, method] = np.max(np.abs(ends[0] - end) / np.maximum(1, np.abs(end)))
            assert errors[model, method] < 1e-4, errors
    scipy_one = fly_scipy(1e-6)
    scipy_end = np.concatenate(([scipy_one.t_events[0][0]], scipy_one.y_events[0][0]))
    scipy_error = np.max(np.abs(scipy_end - disc_end) / np.maximum(1, np.abs(disc_end)))

    land = float(frispy_end[0])
    times = {}
    for _ in range(asked.rounds):
        flown = timed(lambda: [Disc().compute_trajectory(flight_time=land, rtol=1e-6, atol=1e-9) for _ in range(3)])
        times.setdefault("frispy", []).append(flown / 3)
        times.setdefault("scipy", []).append(timed(lambda: fly_scipy(1e-6)))
        for model, atol, starts, p, _ in sets:
            for method in range(2):
                flown = timed(lambda: ours.fly(model, method, 1e-6, atol, starts, p))
                times.setdefault((model, method), []).append(flown / FLIGHTS)
    medians = {name: statistics.median(values) for name, values in times.items()}
    frispy, scipy = medians["frispy"], medians["scipy"]
    load = os.getloadavg()[0]
    threads, rates, processor = scaling(asked.hyzer)
    turned = nutation.table(ours.library, DISC, BACKHAND)
    flags = next(line for line in open("/proc/cpuinfo") if line.startswith("flags"))
    cpu = next(line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name"))
    lanes = "AVX-512, eight lanes" if "avx512dq" in flags else "four lanes"
    rows = [
        f"| FrisPy, one flight, rtol 1e-6, atol 1e-9 | {1e3 * frispy:.2f} ms | | | |",
        f"| SciPy, our disc's backhand, DOP853 at 1e-6, {scipy_one.nfev} evaluations | {1e3 * scipy:.2f} ms | {scipy_error:.1e} | | |",
    ]
    for method, name in enumerate(METHODS):
        t = medians[0, method]
        rows.append(
            f"| FrisPy's equations by our lanes, {name}, rtol 1e-6, atol 1e-9, {evaluations[0, method]:.0f} evaluations"
            f" | {1e6 * t:.2f} µs | {errors[0, method]:.1e} | {verdict(frispy / t, 5000)} | |"
        )
    for method, name in enumerate(METHODS):
        t = medians[1, method]
        rows.append(
            f"| our disc's backhand by our lanes, {name} at 1e-6, {evaluations[1, method]:.0f} evaluations | {1e6 * t:.2f} µs"
            f" | {errors[1, method]:.1e} | {verdict(frispy / t, 250)} | {verdict(scipy / t, 500)} |"
        )
    share = rates[threads] / rates[1] / threads
    compiled = json.loads(asked.compiled.read_text())
    table = lambda name: chr(10).join(f"| {' | '.join(row)} |" for row in compiled[name])
    text = f"""# Benchmarks of sweeps

`python3 benches/sweep/run.py` makes this page: FrisPy {'2.0.2'}, SciPy with our own compiled right-hand side (called through
Numba {numba.__version__}) and our lanes fly to the landing in one process, in turn, {asked.rounds} rounds; medians of processor time a flight, on one
core of {cpu}, {lanes}, Python {platform.python_version()}. Ours are batches of {FLIGHTS} flights whose speeds and rates scatter by a tenth about the peers' one; each
flight has step sizes of its own. FrisPy's equations are those of `model-spec/refuted/frispy.hyz`, as `hyzer generate --lanes` prints them.

| | time of a flight | error at the landing | FrisPy's flight over it | SciPy's over it |
|---|---:|---:|---:|---:|
{chr(10).join(rows)}

None of them seeks the greatest height. Errors are of each state's magnitude or 1, against the same equations at 1e-11 (FrisPy) and 1e-12 (SciPy).

`hyzer sweep` as a whole (the built-in plan with 60,000 flights: draws, throws, flights, Parquet, summary), best of two:
{rates[1]:.0f} flights a second on one thread, {rates[threads]:.0f} on {threads}: {share:.2f} of each thread (bar 0.9: {'holds' if share >= 0.9 else '**missed**'}).
Of the processor's time alone: {processor[1]:.0f} flights a second on one thread, {processor[threads]:.0f} on each of {threads}; load before: {load:.1f}.

## Compilers at run time

heyoka.py {compiled['versions']['heyoka.py']} and symjit {compiled['versions']['symjit']} compile the disc of `benches/peers/disc.py`, in turn with our lanes on one thread. 1000 states at once, each
with its own parameters: ns of processor time a state, in brackets its ratio to ours; of each the fastest way that agrees, without a chain rule by hand.

| | f | f+J+Jp | way for f+J+Jp | worst difference from ours |
|---|---:|---:|---|---:|
{table('states')}

The backhand to the landing; errors against heyoka.py at 1e-15. Our flights scatter, heyoka.py's of a batch are equal.

| | time of a flight | error at the landing |
|---|---:|---:|
{table('flights')}

## Nutation

The backhand's axis nutates at about 100 rad/s, which sets its steps. Tried against it: integrating factors (Lawson, SIAM J. Numer. Anal. 4,
1967) by the Jacobian at the start of each step (central differences), restricted to the rates, to rates and angles, or whole; and a Lie-group
method (Munthe-Kaas, Appl. Numer. Math. 29, 1999), which integrates the turn of the axis, position, velocity and angular momentum in the inertial
frame, so that nutation without a moment is exact however long the step (`benches/sweep/nutation.py`). Steps over {nutation.DURATION:.0f} s at {nutation.TOLERANCE:g}, or as said:

| release | method | factor by | steps | rejected | evaluations | error at the end |
|---|---|---|---:|---:|---:|---:|
{chr(10).join(turned)}

The forces see the attitude as it turns, so that a factor of the rates alone leaves as much to resolve as it takes away, and a disc without
rates across its axis nutates all the same, driven by its pitching moment. The whole Jacobian saves a part of the steps, at the price of exponentials
of a 12 × 12 matrix for each stage, several products of 1,728 multiplications each, where an evaluation has 108 operations.
The Lie-group method halves the steps at the same tolerance, but its errors are larger there: what it leaves is the forces, which turn with the axis
all the same. At equal error, a tolerance ten times tighter, it saves a third of DOP853's evaluations, each of which costs that much more, and it
holds for bodies of revolution alone. What pays for any model is order: DOP853 beside Tsit5.
"""
    pathlib.Path(asked.out).write_text(text)
    print(text)


if __name__ == "__main__":
    main()
