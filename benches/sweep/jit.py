"""heyoka.py and symjit, which compile at run time, in turn with our lanes in one process: many states at once, and flights.

The disc is that of benches/peers/disc.py. Prints the tables of the page as JSON.
"""

import argparse
import ctypes
import importlib.metadata
import json
import pathlib
import statistics
import sys

import heyoka
import numpy as np
import symjit

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "peers"))
import check
import disc
import gen_sympy
import states

from flown import BACKHAND, DISC, FLIGHTS, Ours, pointer, scattered, timed

# A round runs each way several times over the same states, so that the caches are its own.
COUNT, REPEATS = 1000, 20
NX, NP = len(disc.STATES), len(disc.PARAMETERS)
TITLES = {"f": "f", "fjp": "f+J+Jp"}


class Heyoka:
    """What disc.py asks of a tool."""

    sin, cos, sqrt, atan2 = heyoka.sin, heyoka.cos, heyoka.sqrt, heyoka.atan2


def ours(library, function, rows):
    results = np.zeros((12 if function == "f" else 139, COUNT))
    return lambda: (library.disc_states(function != "f", COUNT, pointer(rows), pointer(results)), results)[1]


def by_heyoka(function, variant, places, rows, fast_math):
    x, p = heyoka.make_vars(*disc.STATES), heyoka.make_vars(*["p_" + name for name in disc.PARAMETERS])
    rates, _ = disc.derivative(Heyoka, x, p, variant)
    if function == "fjp":
        jacobian = heyoka.diff_tensors(rates, diff_args=[*x, *p], diff_order=1).jacobian
        rates = [*rates, *(jacobian[row, column] for row, column in places)]
    compiled = heyoka.cfunc(rates, vars=[*x, *p], fast_math=fast_math)
    results = np.zeros((len(rates), COUNT))
    return lambda: compiled(rows, outputs=results)


def by_symjit(function, variant, places, rows, fast_math):
    x, p, _, rates, jacobians = gen_sympy.tables(variant, "plain")
    if function == "fjp":
        by_state, by_parameter = jacobians
        rates = [*rates, *((by_state[row] + by_parameter[row])[column] for row, column in places)]
    compiled = symjit.compile_func([*x, *p], list(rates), fastmath=fast_math, use_threads=False, enable_simd512=True)
    return lambda: compiled(*rows)


def dense(results, places):
    """As check.worst wants it."""
    results = np.asarray(results)
    whole = np.zeros((results.shape[1], 12, NX + NP))
    for (row, column), values in zip(places, results[12:]):
        whole[:, row, column] = values
    return results[:12].T, whole[:, :, :NX], whole[:, :, NX:]


def many_states(library, rounds):
    """Rows of the table: the best way of each, ns of the processor a state, and the worst difference from ours."""
    places = np.zeros((127, 2), dtype=np.uint32)
    library.disc_places(places.ctypes.data_as(ctypes.c_void_p))
    places = places.tolist()
    drawn = states.draw(COUNT)
    rows = np.ascontiguousarray(drawn.T)
    reference = dense(ours(library, "fjp", rows)(), places)
    ways, differences = {}, {}
    for function in TITLES:
        ways["hyzer, lanes", function, ""] = ours(library, function, rows)
        for title, tool in (("heyoka.py, `cfunc`", by_heyoka), ("symjit, `compile_func`", by_symjit)):
            for variant in disc.VARIANTS:
                for fast_math in (False, True):
                    way = tool(function, variant, places, rows, fast_math)
                    got = dense(way(), places if function == "fjp" else [])
                    want = [part if function == "fjp" or k == 0 else 0 * part for k, part in enumerate(reference)]
                    worst = max(check.worst(got, want, drawn, reference))
                    if worst <= check.TOLERANCE:
                        ways[title, function, f"{variant}{', fast math' if fast_math else ''}"] = way
                        differences[title] = max(worst, differences.get(title, 0.0))
    times = {key: [] for key in ways}
    for _ in range(rounds):
        for key, way in ways.items():
            times[key].append(timed(lambda: [way() for _ in range(REPEATS)]))
    medians = {key: 1e9 * statistics.median(values) / COUNT / REPEATS for key, values in times.items()}
    table = []
    for title in dict.fromkeys(key[0] for key in ways):
        best = {f: min((ns, way) for (t, g, way), ns in medians.items() if (t, g) == (title, f)) for f in TITLES}
        mine = {f: medians["hyzer, lanes", f, ""] for f in TITLES}
        cells = [f"{best[f][0]:.1f} ({best[f][0] / mine[f]:.1f})" for f in TITLES]
        table.append([title, *cells, best["fjp"][1] or "-", f"{differences[title]:.1e}" if title in differences else "is ours"])
    return table


def taylor(variant, tolerance, width):
    """A function that flies `width` equal backhands to the ground by Taylor series, and gives the end of the first."""
    x = heyoka.make_vars(*disc.STATES)
    rates, _ = disc.derivative(Heyoka, x, [heyoka.expression(float(value)) for value in DISC], variant)
    system, start = list(zip(x, rates)), np.array(BACKHAND, dtype=float)
    down = heyoka.event_direction.negative
    if width == 1:
        flight = heyoka.taylor_adaptive(system, start, tol=tolerance, t_events=[heyoka.t_event(x[2], direction=down)])
    else:
        starts = np.tile(start[:, None], (1, width))
        event = heyoka.t_event_batch(x[2], direction=down)
        flight = heyoka.taylor_adaptive_batch(system, starts, tol=tolerance, t_events=[event])

    def fly():
        if width == 1:
            flight.time = 0.0
        else:
            flight.set_time(0.0)
        flight.reset_cooldowns()
        flight.state[:] = start if width == 1 else start[:, None]
        flight.propagate_until(600.0)
        return np.append(flight.time, flight.state) if width == 1 else np.append(flight.time[0], flight.state[:, 0])

    return fly


def flights(library, exact, rounds):
    """Rows of the table: time of a flight, and error at the landing."""
    width = heyoka.recommended_simd_size()
    runs, errors = {}, {}
    error = lambda end: np.max(np.abs(end - exact) / np.maximum(1, np.abs(exact)))
    starts = scattered(BACKHAND, 2)
    for tolerance in (1e-6, 1e-9):
        ours_title = f"hyzer, lanes, DOP853 at {tolerance:g}"
        runs[ours_title] = (lambda t=tolerance: library.fly(1, 1, t, t, starts, DISC)[0][0], FLIGHTS)
        for title, lanes in (("one flight", 1), (f"batches of {width} equal flights", width)):
            runs[f"heyoka.py, Taylor series at {tolerance:g}, {title}"] = (taylor("algebraic", tolerance, lanes), lanes)
    for title, (fly, _) in runs.items():
        errors[title] = error(fly())
    assert max(errors.values()) < 1e-4, errors
    times = {title: [] for title in runs}
    for _ in range(rounds):
        for title, (fly, count) in runs.items():
            repeats = 1 if count == FLIGHTS else 20
            times[title].append(timed(lambda: [fly() for _ in range(repeats)]) / repeats / count)
    return [[title, f"{1e6 * statistics.median(times[title]):.1f} µs", f"{errors[title]:.1e}"] for title in runs]


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("library")
    arguments.add_argument("--rounds", type=int, default=31)
    asked = arguments.parse_args()
    library = Ours(asked.library)
    exact = taylor("trig", 1e-15, 1)()
    tables = {
        "versions": {"heyoka.py": heyoka.__version__, "symjit": importlib.metadata.version("symjit")},
        "states": many_states(library, asked.rounds),
        "flights": flights(library, exact, asked.rounds),
    }
    json.dump(tables, sys.stdout, indent=1)


if __name__ == "__main__":
    main()
