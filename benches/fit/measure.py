"""Inside the peers' environment: makes flights, has all of us fit them in turn, and writes the page."""

import argparse
import json
import os
import pathlib
import platform
import shutil
import statistics
import subprocess

import numpy as np

import flights
import native
import ours
import page
import ways
from alone import Alone

# How far the peers start from our solution, in standard errors of each unknown.
APART = 3.0


def say(text):
    print(text, flush=True)


def start_near(run, random):
    """Unknowns near our solution, and the size of each: coefficients, then initial states."""
    both = [np.concatenate([run.coefficients(what), run.initial(what).ravel()]) for what in ("value", "std_error")]
    return both[0] + APART * both[1] * random.standard_normal(both[0].size), both[1]


def chosen(tried):
    """The fastest way of each peer for each case that agrees with ours; of the interpreted ones too."""
    found = {}
    for what in (ways.PROBLEM, ways.JOB):
        for peer in ways.PEERS:
            rows = [r for r in tried if r["peer"] == peer and r["what"] == what]
            for label, some in ((peer, rows), (f"{peer}, interpreted", [r for r in rows if "interpreted" in r["way"]])):
                good = [r for r in some if r.get("apart", np.inf) <= page.AGREE]
                if good:
                    best = min(good, key=lambda r: r["wall"])
                    best.setdefault("chosen", []).append([label, what])
                    found[label, what] = peer, what, best["way"]
    return found


def rounds(count, fit, alone, alone_on_one, contestants):
    """Every contestant in turn, round after round; before each peer ours anew."""
    times = {}

    def note(who, what, wall, cpu):
        kept = times.setdefault((who, what), {"wall": [], "cpu": []})
        kept["wall"].append(wall)
        kept["cpu"].append(cpu)

    for k in range(count):
        for (who, what), work in contestants.items():
            for _ in range(3):
                run = fit()
                note("ours", ways.JOB, run.total, run.cpu)
                note("ours, process", ways.JOB, run.wall, run.cpu)
            for _ in range(5):
                note("ours", ways.PROBLEM, *alone.solve()[2:])
            answer = work()
            note(who, what, answer.wall, answer.cpu)
        run = fit("--threads", "1")
        note("ours, one thread", ways.JOB, run.total, run.cpu)
        for _ in range(5):
            note("ours, one thread", ways.PROBLEM, *alone_on_one.solve()[2:])
        say(f"  round {k + 1} of {count}: " + ", ".join(f"{who} ({what}) {t['wall'][-1]:.4f} s" for (who, what), t in times.items()))
    rows = []
    for (who, what), t in times.items():
        medians = {kind: statistics.median(values) for kind, values in t.items()}
        rows.append({"who": who, "what": what, "spread": [min(t["wall"]), max(t["wall"])]} | medians)
    return rows


# Up to so many flights a size is fitted in each of these rounds, and the fastest counts: what others do on the machine slows.
SCALED, SCALED_ROUNDS = 2000, 5


def scaling(lib, hyzer, out, sizes):
    """Ours alone, over more and more flights."""
    made = []
    for count, duration in sizes:
        folder = out / f"many-{count}"
        data = flights.make(lib, count, duration, seed=count)
        flights.write(data, folder)
        made.append((count, duration, folder, data.seen.nbytes))
    runs = {}
    for k in range(SCALED_ROUNDS):
        for count, _, folder, _ in made:
            if k == 0 or count <= SCALED:
                runs.setdefault(count, []).append(ours.fit(hyzer, folder, out / "report"))
    rows = []
    for count, duration, folder, size in made:
        files = sum(f.stat().st_size for f in folder.iterdir())
        shutil.rmtree(folder)
        run = min(runs[count], key=lambda r: r.total)
        row = {"flights": count, "duration": duration, "total": run.total, "wall": run.wall, "cpu": min(r.cpu for r in runs[count]), "memory": run.memory}
        row |= {"data": size, "files": files, "steps": run.report["iterations"]["steps"]}
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
    for name in ("--hyzer", "--alone", "--out", "--page"):
        parser.add_argument(name, type=pathlib.Path, required=True)
    parser.add_argument("--quick", action="store_true", help="fewer rounds and ways, and no more than 200 flights")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    load = [os.getloadavg()[0]]

    say("compiling the right-hand side")
    lib = native.library(args.out)
    data = flights.make(lib, 20, 1.0, seed=1)
    flights.write(data, args.out / "flights")
    dataset = args.out / "flights"
    fit = lambda *options: ours.fit(args.hyzer, dataset, args.out / "report", *options)
    whole = fit()
    near, scale = start_near(whole, np.random.default_rng(7))
    alone, alone_on_one = Alone(args.alone, dataset), Alone(args.alone, dataset, "1")
    for each in (alone, alone_on_one):
        each.begin(near, data.sigma)
    values, note, *_ = alone.solve()
    say("the peers' ways")
    case = ways.Case(lib, data, near, scale, alone.coefficients, alone.starts)
    reference = {ways.PROBLEM: values, ways.JOB: whole.coefficients()}
    known, tried, missing = ways.trials(case, args.out, args.quick, reference, whole.coefficients("std_error"))
    say("in turn")
    contestants = {key: known[way] for key, way in chosen(tried).items()}
    medians = rounds(2 if args.quick else 7, fit, alone, alone_on_one, contestants)
    load.append(os.getloadavg()[0])
    say("more flights")
    scaled = scaling(lib, args.hyzer, args.out, [(20, 1.0), (200, 1.0)] + ([] if args.quick else [(2000, 1.0), (10000, 2.0)]))
    load.append(os.getloadavg()[0])

    results = {"schema": "hyzer.fit-bench/1", "quick": args.quick, "machine": machine(), "load": load, "missing": missing, "tried": tried}
    results |= {"medians": medians, "scaling": scaled, "steps": whole.report["iterations"]["steps"], "outliers": whole.report["noise"]["marker"]["outliers"]}
    results["tolerance"] = ways.TOLERANCE
    results["alone"] = {"note": note, "apart": float((np.abs(values - whole.coefficients()) / whole.coefficients("std_error")).max())}
    (args.out / "results.json").write_text(json.dumps(results, indent=1))
    args.page.write_text(page.text(results))
    say(f"{args.page} is written")


if __name__ == "__main__":
    main()
