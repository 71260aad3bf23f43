"""Every way of every peer, for the same problem and for the same job; each gives its answer with the seconds that it took.

The same problem: the least squares alone, from 3 standard errors away, the noise known. The same job: from the model's own coefficients and
the markers' poses, with equal weights; then again with the weights that the residuals of each axis ask for.
"""

import importlib
import os
import time
from dataclasses import dataclass

import numpy as np

import flights
from native import NC, NX
from page import JOB, PROBLEM

# Seconds after which a way of a peer's is given up that is far from its fastest.
LONGEST = 40.0
# IPOPT's, where unknowns are in units of standard errors; finer ones take an iteration more for the same answer.
TOLERANCE = 1e-2


@dataclass
class Answer:
    values: np.ndarray
    note: str
    wall: float
    cpu: float


def timed(work):
    wall, cpu = time.perf_counter(), time.process_time()
    result = work()
    return result, time.perf_counter() - wall, time.process_time() - cpu


def once(solve, values):
    """One solution of the least squares."""
    (found, note), wall, cpu = timed(solve)
    return Answer(values(found)[0], note, wall, cpu)


def twice(solve, values, data, lib, substeps):
    """With equal weights, then with those of the axes; what the weights are is not timed."""
    (found, first), wall_1, cpu_1 = timed(solve)
    coefficients, own = values(found)
    left = lib.residuals(flights.parameters(coefficients), np.ascontiguousarray(own), data, substeps).reshape(-1, 3)
    weights = 1 / np.sqrt((left**2).mean(axis=0))
    (found, second), wall_2, cpu_2 = timed(lambda: solve(found, weights))
    return Answer(values(found)[0], f"{first}; then {second}", wall_1 + wall_2, cpu_1 + cpu_2)


@dataclass
class Case:
    """What all begin with: the flights, unknowns near our solution with their sizes, and those that ours begins with."""

    lib: object
    data: object
    near: np.ndarray
    scale: np.ndarray
    coefficients: np.ndarray
    states: np.ndarray  # of each flight at each of its samples, by the markers alone


def followed(case, substeps):
    """The states by the markers without gaps: flown on where none are, and angles by whole turns where a flight from the last has them."""
    p, states = flights.parameters(case.coefficients), case.states.copy()
    for k in range(1, states.shape[1]):
        flown = case.lib.fly(p, states[:, k - 1], 2, case.data.interval, substeps)[:, 1]
        states[:, k] = np.where(np.isnan(states[:, k]), flown, states[:, k])
        angles = states[:, k, 6:9]
        angles += np.round((flown[:, 6:9] - angles) / (2 * np.pi)) * (2 * np.pi)
    return states


def scipy_ways(case, folder, quick):
    import scipy_fit

    problem = scipy_fit.Problem(case.lib, case.data, case.near, case.scale)
    values = lambda x: (x[:NC], x[NC:].reshape(-1, NX))
    begun = np.concatenate([case.coefficients, case.states[:, 0].ravel()])

    def solver(way, start):
        def solve(begin=None, weights=np.ones(3)):
            problem.weigh(weights)
            return scipy_fit.fit(problem, way, LONGEST, start if begin is None else begin)

        return solve

    for way in scipy_fit.WAYS:
        yield PROBLEM, way, lambda way=way: once(solver(way, case.near), values)
    for way in scipy_fit.WAYS:
        if "exact Jacobian, dense" in way:
            yield JOB, way, lambda way=way: twice(solver(way, begun), values, case.data, case.lib, scipy_fit.SUBSTEPS)


def casadi_ways(case, folder, quick):
    import casadi_fit

    threads = os.cpu_count() or 1
    settings = [(10, False), (6, True)] if quick else [(per, False) for per in (1, 4, 10, 20)] + [(per, True) for per in (1, 2, 4, 6, 8, 10)]
    p = flights.parameters(case.coefficients)
    nodes = {
        "flown from the markers": case.lib.fly(p, case.states[:, 0], case.states.shape[1], case.data.interval, casadi_fit.SUBSTEPS),
        "by the markers": followed(case, casadi_fit.SUBSTEPS),
    }
    for per, native_code in settings:
        how = "compiled by gcc" if native_code else "interpreted"
        way = f"IPOPT, {(case.data.seen.shape[1] - 1) // per} intervals a flight, {how}"
        print(f"  building CasADi's problem, {per} samples an interval, {how}", flush=True)
        problem = casadi_fit.Problem(case.lib, case.data, case.near, case.scale, per, threads, folder if native_code else None, TOLERANCE)
        yield PROBLEM, way, lambda problem=problem: once(problem.fit, problem.values)
        for start, states in nodes.items():
            if native_code and per >= 4:
                begun = problem.from_nodes(case.coefficients, states)
                solve = lambda begin=None, weights=np.ones(3), problem=problem, begun=begun: problem.fit(begun if begin is None else begin, weights)
                job = lambda problem=problem, solve=solve: twice(solve, problem.values, case.data, case.lib, casadi_fit.SUBSTEPS)
                yield JOB, f"{way}, nodes {start}", job


PEERS = {"scipy": scipy_ways, "casadi": casadi_ways}


# A way that takes less, s, is tried three times.
OFTEN = 2.0


def trials(case, folder, quick, reference, errors):
    """Each way: its fastest time and its answer, in our standard errors from ours; the ways by name, and peers that are not installed."""
    ways, rows, missing = {}, [], []
    for peer, make in PEERS.items():
        try:
            importlib.import_module(peer)
        except ImportError:
            missing.append(peer)
            continue
        for what, way, work in make(case, folder, quick):
            ways[peer, what, way] = work
            row = {"peer": peer, "what": what, "way": way}
            try:
                answer = work()
                # Which way is best must not hang on what else the machine did.
                again = [work() for _ in range(2 if answer.wall < OFTEN else 0)]
                answer = min([answer, *again], key=lambda one: one.wall)
                apart = np.abs(answer.values - reference[what]) / errors
                row |= {"wall": answer.wall, "cpu": answer.cpu, "note": answer.note, "apart": float(apart.max())}
            except Exception as error:  # a way that fails is no result
                row["failed"] = f"over {LONGEST:.0f} s" if type(error).__name__ == "TooLong" else str(error).splitlines()[0]
            print(f"  {peer}, {what}, {way}: {row.get('wall', float('nan')):.2f} s {row.get('note', row.get('failed'))} {row.get('apart', '')}", flush=True)
            rows.append(row)
    return ways, rows, missing
