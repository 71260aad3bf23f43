"""Inside the peers' environment: makes flights, has all of us fit them in turn, and writes the page."""

import argparse
import importlib
import json
import os
import pathlib
import platform
import shutil
import statistics
import subprocess
import time

import numpy as np

import flights
import native
import ours
import page

# Seconds after which a way of a peer's is given up that is far from its fastest.
LONGEST = 40.0
# How far the peers start from our solution, in standard errors of each unknown.
APART = 3.0


def say(text):
    print(text, flush=True)


def timed(work):
    wall, cpu = time.perf_counter(), time.process_time()
    result = work()
    return result, time.perf_counter() - wall, time.process_time() - cpu


def start_near(run, random):
    """Unknowns near our solution, and the size of each: coefficients, then initial states."""
    both = [np.concatenate([run.coefficients(what), run.initial(what).ravel()]) for what in ("value", "std_error")]
    return both[0] + APART * both[1] * random.standard_normal(both[0].size), both[1]


def scipy_ways(lib, data, start, scale):
    import scipy_fit

    problem = scipy_fit.Problem(lib, data, start, scale)
    return {way: lambda way=way: scipy_fit.fit(problem, way, LONGEST) for way in scipy_fit.WAYS}


def casadi_ways(lib, data, start, scale, folder, quick):
    import casadi_fit

    threads = os.cpu_count() or 1
    ways = {}
    settings = [(10, False), (6, True)] if quick else [(per, False) for per in (1, 4, 10, 20)] + [(per, True) for per in (1, 2, 4, 6, 8, 10)]
    for per, native_code in settings:
        how = "compiled by gcc" if native_code else "interpreted"
        say(f"  building CasADi's problem, {per} samples an interval, {how}")
        problem = casadi_fit.Problem(lib, data, start, scale, per, threads, folder if native_code else None)
        ways[f"IPOPT, {(data.seen.shape[1] - 1) // per} intervals a flight, {how}"] = problem.fit
    return ways


def trials(peer, ways, reference):
    """Each way once: its time and its answer, in our standard errors from ours."""
    rows = []
    for way, work in ways.items():
        row = {"peer": peer, "way": way}
        try:
            (values, note), row["wall"], row["cpu"] = timed(work)
            apart = np.abs(values - reference.coefficients()) / reference.coefficients("std_error")
            row |= {"note": note, "apart": float(apart.max())}
        except Exception as error:  # a way that fails is no result
            row["failed"] = f"over {LONGEST:.0f} s" if type(error).__name__ == "TooLong" else str(error).splitlines()[0]
        say(f"  {peer}, {way}: {row.get('wall', float('nan')):.2f} s {row.get('note', row.get('failed'))}")
        rows.append(row)
    return rows


def best(rows):
    good = [r for r in rows if r.get("apart", np.inf) <= page.AGREE]
    return min(good, key=lambda r: r["wall"])["way"] if good else None


def peers(lib, data, reference, out, quick):
    """Ways of the peers by name, and their trials; a peer that is not installed is named as missing."""
    start, scale = start_near(reference, np.random.default_rng(7))
    makers = {"scipy": lambda: scipy_ways(lib, data, start, scale), "casadi": lambda: casadi_ways(lib, data, start, scale, out, quick)}
    ways, rows, missing = {}, [], []
    for peer, make in makers.items():
        try:
            importlib.import_module(peer)
        except ImportError:
            missing.append(peer)
            continue
        ways[peer] = make()
        rows += trials(peer, ways[peer], reference)
    return ways, rows, missing


def rounds(count, hyzer, dataset, out, chosen):
    """Every contestant in turn, round after round."""
    times = {}
    note = lambda who, wall, cpu: times.setdefault(who, {"wall": [], "cpu": []}) and (times[who]["wall"].append(wall), times[who]["cpu"].append(cpu))
    for k in range(count):
        for _ in range(3):
            run = ours.fit(hyzer, dataset, out / "report")
            note("ours", run.total, run.cpu)
            note("ours, process", run.wall, run.cpu)
        run = ours.fit(hyzer, dataset, out / "report", "--threads", "1")
        note("ours, one thread", run.total, run.cpu)
        for who, work in chosen.items():
            _, wall, cpu = timed(work)
            note(who, wall, cpu)
        say(f"  round {k + 1} of {count}: " + ", ".join(f"{who} {t['wall'][-1]:.3f} s" for who, t in times.items()))
    medians = {who: {what: statistics.median(values) for what, values in t.items()} for who, t in times.items()}
    return {who: m | {"spread": [min(times[who]["wall"]), max(times[who]["wall"])]} for who, m in medians.items()}


def scaling(lib, hyzer, out, sizes):
    """Ours alone, over more and more flights."""
    rows = []
    for count, duration in sizes:
        folder = out / "many"
        data = flights.make(lib, count, duration, seed=count)
        flights.write(data, folder)
        run = min((ours.fit(hyzer, folder, out / "report") for _ in range(3 if count <= 200 else 1)), key=lambda r: r.total)
        files = sum(f.stat().st_size for f in folder.iterdir())
        shutil.rmtree(folder)
        row = {"flights": count, "duration": duration, "total": run.total, "wall": run.wall, "cpu": run.cpu, "memory": run.memory}
        row |= {"data": data.seen.nbytes, "files": files, "steps": run.report["iterations"]["steps"]}
        truth = np.array([flights.TRUTH[name] for name in native.COEFFICIENTS])
        row["from_truth"] = float((np.abs(run.coefficients() - truth) / run.coefficients("std_error")).max())
        say(f"  {count} flights of {duration} s: {run.total:.2f} s, {run.memory / 1e6:.0f} MB")
        rows.append(row)
    return rows


def machine():
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines() if platform.system() == "Linux" else []
    cpu = next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), platform.processor())
    gcc = subprocess.run(["gcc", "--version"], capture_output=True, text=True).stdout.splitlines()[0]
    rustc = subprocess.run(["rustc", "--version"], capture_output=True, text=True).stdout.strip()
    return {"cpu": cpu, "threads": os.cpu_count(), "gcc": gcc, "rustc": rustc}


def main():
    parser = argparse.ArgumentParser()
    for name in ("--hyzer", "--out", "--page"):
        parser.add_argument(name, type=pathlib.Path, required=True)
    parser.add_argument("--quick", action="store_true", help="fewer rounds and ways, and no more than 200 flights")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    load = [os.getloadavg()[0]]

    say("compiling the right-hand side")
    lib = native.library(args.out)
    data = flights.make(lib, 20, 1.0, seed=1)
    flights.write(data, args.out / "flights")
    reference = ours.fit(args.hyzer, args.out / "flights", args.out / "report")
    say("the peers' ways, each once")
    ways, tried, missing = peers(lib, data, reference, args.out, args.quick)
    chosen = {}
    for peer, mine in ways.items():
        rows = [r for r in tried if r["peer"] == peer]
        for label, some in ((peer, rows), (f"{peer}, interpreted", [r for r in rows if "interpreted" in r["way"]])):
            if way := best(some):
                chosen[label] = mine[way]
                next(r for r in rows if r["way"] == way).setdefault("chosen", []).append(label)
    say("in turn")
    medians = rounds(2 if args.quick else 7, args.hyzer, args.out / "flights", args.out, chosen)
    load.append(os.getloadavg()[0])
    say("more flights")
    scaled = scaling(lib, args.hyzer, args.out, [(20, 1.0), (200, 1.0)] + ([] if args.quick else [(2000, 1.0), (10000, 2.0)]))
    load.append(os.getloadavg()[0])

    results = {"schema": "hyzer.fit-bench/1", "quick": args.quick, "machine": machine(), "load": load, "missing": missing, "tried": tried}
    results |= {"medians": medians, "scaling": scaled, "steps": reference.report["iterations"]["steps"], "outliers": reference.report["noise"]["outliers"]}
    (args.out / "results.json").write_text(json.dumps(results, indent=1))
    args.page.write_text(page.text(results))
    say(f"{args.page} is written")


if __name__ == "__main__":
    main()
