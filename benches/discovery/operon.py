"""Symbolic regression beside the diagnosis: `python3 benches/discovery/operon.py CASES --hyzer PROGRAM [--page FILE]`.

What lies outside the catalogue, given to pyoperon (PyPI) as smoothed load coefficients and their variables, and to `hyzer diagnose` as
marker tracks. CASES is the folder that the example discovery_cases wrote. Writes a section of docs/studies/discovery-peers.md.
"""

import argparse
import importlib.metadata
import json
import os
import pathlib
import re
import statistics
import time

import numpy as np
import sympy
from pyoperon.sklearn import SymbolicRegressor

import ours
import tracks

HEADING = "## Outside the catalogue, beside symbolic regression"
VARIABLES = ("alpha", "speed", "r", "p1", "p2", "height", "climb", "time")
WINDOWS = {"light": tracks.LIGHT, "force": (31, 3), "turn": (21, 3), "spin": (61, 3)}
# What each effect outside the catalogue adds to its equation, of these variables.
TRUE = {
    "roll_by_angle_squared": ("roll", lambda v: v["alpha"] ** 2),
    "drag_by_climb": ("drag", lambda v: np.tanh(v["climb"] / 2)),
    "side_force_by_angle": ("side", lambda v: v["alpha"]),
    "pitching_moment_by_time": ("pitch", lambda v: v["time"]),
    "lift_by_pitch_rate": ("lift", lambda v: v["p2"] / v["speed"]),
    "drag_by_power_of_speed": ("drag", lambda v: (v["speed"] / 14) ** -0.4 - 1),
}
BASE = {
    "lift": lambda v: [np.ones_like(v["alpha"]), v["alpha"]],
    "drag": lambda v: [np.ones_like(v["alpha"]), v["alpha"] ** 2],
    "side": lambda v: [],
    "roll": lambda v: [v["r"], v["p1"]],
    "pitch": lambda v: [v["alpha"], v["p2"]],
}
# A term counts if it explains this part of what the model's own terms leave of the fitted expression, and is the right one at this
# correlation with the true term, beside the model's own.
SHARE, SAME = 0.02, 0.95


def samples(folder):
    """Variables and load coefficients of all flights, smoothed; every fifth sample."""
    body, tables = tracks.read(folder)
    variables, loads = {name: [] for name in VARIABLES}, {}
    for times, seen in tables:
        flight = tracks.Flight(body, times, seen)
        signals = flight.signals(WINDOWS)
        signals["climb"] = tracks.slope(flight.place, flight.dt, WINDOWS["force"], 1)[:, 2]
        signals["time"] = times - times[0]
        inner = slice(tracks.EDGE, -tracks.EDGE, 5)
        for name in VARIABLES:
            variables[name].append(signals[name][inner])
        for name, load in flight.loads(WINDOWS).items():
            loads.setdefault(name, []).append(load[inner])
    join = lambda columns: {name: np.concatenate(parts) for name, parts in columns.items()}
    return join(variables), join(loads)


def beside(columns, y):
    """What a least-squares fit of the columns leaves."""
    if not columns:
        return y
    x = np.column_stack(columns)
    return y - x @ np.linalg.lstsq(x, y, rcond=None)[0]


def additive_terms(text, variables):
    """Values of the additive terms of an expression, expanded."""
    names = {f"X{k + 1}": sympy.Symbol(name) for k, name in enumerate(VARIABLES)}
    expression = sympy.expand(sympy.sympify(text, locals=names))
    parts = sympy.Add.make_args(expression)
    symbols = list(names.values())
    values = []
    for part in parts:
        value = sympy.lambdify(symbols, part, "numpy")(*[variables[str(s)] for s in symbols])
        values.append(np.broadcast_to(np.asarray(value, dtype=float), variables["alpha"].shape))
    return expression, values


def judged(text, equation, true, variables):
    """Whether the true term is in the expression beside the model's own terms, and how many others are."""
    expression, values = additive_terms(text, variables)
    base = BASE[equation](variables)
    left = [beside(base, v) for v in values]
    whole = np.linalg.norm(beside(base, np.sum(values, axis=0))) or 1.0
    target = beside(base, true(variables))
    target /= np.linalg.norm(target)
    kept = [v for v in left if np.linalg.norm(v) > SHARE * whole]
    right = [abs(v @ target) / np.linalg.norm(v) > SAME for v in kept]
    total = beside(base, np.sum(values, axis=0))
    # Several terms may make up the true one together.
    together = abs(total @ target) / (np.linalg.norm(total) or 1.0) > SAME
    return {
        "found": bool(any(right) or together),
        "alone": bool(together and len(kept) <= 1),
        "others": sum(not r for r in right),
        "expression": str(expression)[:200],
    }


def by_operon(folder, effect, seconds):
    equation, true = TRUE[effect]
    clock = time.perf_counter()
    variables, loads = samples(folder)
    x = np.column_stack([variables[name] for name in VARIABLES])
    regressor = SymbolicRegressor(
        allowed_symbols="add,sub,mul,div,constant,variable,tanh,sin,exp,log,sqrt,square",
        objectives=["mse", "length"],
        max_length=30,
        population_size=500,
        generations=1000,
        max_time=seconds,
        optimizer_iterations=5,
        n_threads=1,
        model_selection_criterion="minimum_description_length",
        random_state=1,
    )
    regressor.fit(x, loads[equation])
    seconds = time.perf_counter() - clock
    text = regressor.get_model_string(regressor.model_, precision=6)
    front = [regressor.get_model_string(one["tree"], 6) for one in regressor.pareto_front_]
    anywhere = any(judged(one, equation, true, variables)["found"] for one in front)
    return judged(text, equation, true, variables) | {"seconds": seconds, "front": anywhere}


# Catalogue effects as functions of the variables, where a diagnosis may name one.
LISTED = {"drag-by-reynolds": "log(V)", "drag-by-spin": "r", "ground-effect": "exp(-z)"}
# Names of the model language, by the variables here.
NAMES = {"V": "speed", "z": "height", "rate_1": "p1", "rate_2": "p2", "d": None}


def evaluated(formula, variables):
    """Values of a formula of the model language; units are dropped, as a factor does not matter."""
    text = re.sub(r"\[[^\]]*\]", "", formula)
    text = re.sub(r"\(([\d.]+) [a-z/]+\)", r"(\1)", text).replace("^", "**")
    names = {name: variables[name] for name in VARIABLES}
    names |= {name: variables[ours] if ours else 1.0 for name, ours in NAMES.items()}
    functions = {name: getattr(np, name) for name in ("log", "tanh", "sin", "cos", "exp", "sqrt", "abs")}
    functions |= {"max": np.maximum, "min": np.minimum, "ratio": lambda a, b, _: a / b}
    return np.broadcast_to(np.asarray(eval(text, {"__builtins__": {}}, names | functions), dtype=float), variables["alpha"].shape)


def explains(formulas, equation, true, variables):
    """Whether a combination of formulas is the true term, beside the model's own terms."""
    base = BASE[equation](variables)
    target = beside(base, true(variables))
    left = beside(base + [evaluated(formula, variables) for formula in formulas], true(variables))
    return bool(1 - (left @ left) / (target @ target) > SAME**2)


def by_hyzer(program, folder, out, effect):
    report, process = ours.diagnose(program, folder, out, "--threads", "1")
    site, true = TRUE[effect]
    unattributed = report.get("unattributed") or {}
    found = [(t["site"], t["formula"]) for t in unattributed.get("terms", []) if t["selected"]]
    # The terms of an answer from outside the catalogue are its effects too.
    causes = [] if found else [e for cause in report["explanations"] for e in cause["effects"]]
    found += [(e["site"], LISTED.get(e["name"], e["name"])) for e in causes]
    there = [formula for where, formula in found if where == site]
    try:
        right = bool(there) and explains(there, site, true, samples(folder)[0])
    except (NameError, SyntaxError):
        right = False
    return {
        "verdict": report["verdict"],
        "found": right,
        "site": bool(there),
        "others": len(found) - len(there),
        "seconds": process,
        "expression": ", ".join(formula for _, formula in found),
    }


def table(rows):
    lines = [
        "| hidden | size | pyoperon: right term | on its front | other terms | s | `hyzer diagnose`: verdict | right term | right load | other terms | s | pyoperon's expression | terms of `hyzer` |",
        "|---|---|---|---|---:|---:|---|---|---|---:|---:|---|---|",
    ]
    yes = lambda value: "yes" if value else "no"
    for r in rows:
        o, h = r["operon"], r["hyzer"]
        cells = [f"`{r['effect']}`", r["size"], yes(o["found"]), yes(o["front"]), o["others"], f"{o['seconds']:.0f}"]
        cells += [h["verdict"], yes(h["found"]), yes(h["site"]), h["others"], f"{h['seconds']:.1f}"]
        cells += [f"`{text.replace('|', '/')}`" if text else "" for text in (o["expression"], h["expression"])]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


def section(rows, seconds):
    count = lambda who, what: sum(bool(r[who][what]) for r in rows)
    middle = lambda who, what: statistics.median(r[who][what] for r in rows)
    return f"""{HEADING}

Effects that the catalogue does not list, given to pyoperon {importlib.metadata.version("pyoperon")} and to `hyzer diagnose`. pyoperon was given the one load coefficient that the effect changes
(which it could not know), from smoothed poses, with the variables {", ".join(VARIABLES)}, {seconds} s on one thread, and the model of least description length on its front;
*On its front*: whether any model on its Pareto front has the right term. A term is right where its part beside the model's own terms correlates
with the true one by more than {SAME}; others count where they explain more than {SHARE:.0%}. `hyzer diagnose` was given the marker tracks alone; its terms on the right load are judged alike, together.
`python3 benches/discovery/operon.py` makes this section.

pyoperon has the right term in {count("operon", "found")} of {len(rows)} ({count("operon", "front")} anywhere on its front), with {middle("operon", "others"):g} other terms (median), in {middle("operon", "seconds"):.0f} s;
`hyzer diagnose` has it in {count("hyzer", "found")} of {len(rows)}, and the right load in {count("hyzer", "site")}, with {middle("hyzer", "others"):g} other terms, in {middle("hyzer", "seconds"):.1f} s.

{table(rows)}
"""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cases", type=pathlib.Path)
    parser.add_argument("--hyzer", type=pathlib.Path, required=True)
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=30, help="of pyoperon for each case")
    args = parser.parse_args()
    cases = json.loads((args.cases / "cases.json").read_text())
    rows = []
    for case in (c for c in cases if c["effect"] in TRUE and c["noise"]):
        folder = args.cases / case["name"]
        operon = by_operon(folder, case["effect"], args.seconds)
        hyzer = by_hyzer(args.hyzer, folder, args.cases / "out", case["effect"])
        rows.append({"effect": case["effect"], "size": case["size"], "operon": operon, "hyzer": hyzer})
        print(json.dumps(rows[-1]), flush=True)
    text = section(rows, args.seconds)
    if not args.page:
        print(text)
        return
    page = args.page.read_text()
    start = page.find(HEADING)
    if start >= 0:
        end = page.find("\n## ", start + 1)
        page = page[:start] + (page[end + 1 :] if end >= 0 else "")
    args.page.write_text(page.rstrip() + "\n\n" + text)


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    main()
