"""Inside the peers' environment: everybody on every case, then in turn against the clock, and the page."""

import argparse
import concurrent.futures
import importlib.metadata
import json
import os
import pathlib
import platform
import shutil
import time

import library
import ours
import page
import peers
import sparse


def say(text):
    print(text, flush=True)


def windows_of(pool, root, cases):
    """The peers' smoothing, chosen by those who know what is hidden on the first dataset of each effect and strength."""
    first = [case for case in cases if case["effect"] and case["name"].endswith("-1")]
    return peers.windows(pool.map(peers.smoothed, [root / case["name"] for case in first], first))


def one(hyzer, root, out, windows, case):
    """What everybody finds in one case."""
    folder, report = root / case["name"], out / case["name"]
    found = peers.all_of(folder, windows)
    if case["noise"]:
        found["ours"] = ours.told(ours.diagnose(hyzer, folder, report, "--threads", "1")[0])
        shutil.rmtree(report)
    return found


def timed(work):
    clock = time.perf_counter()
    result = work()
    return result, time.perf_counter() - clock


def clocked(hyzer, root, out, windows, cases, settings):
    """Seconds of each in turn, from numbers in memory to the answer; the peers with their settings known."""
    rows = []
    for case in cases:
        body, tables = peers.tracks.read(root / case["name"])
        (report, process) = ours.diagnose(hyzer, root / case["name"], out / "clocked")
        row = {"case": case["name"], "ours": report["seconds"]["total"], "process": process}
        for who, work in (("stepwise", peers.by_steps), ("pysindy", lambda e, setting: peers.by_sparsity(e, [setting]))):
            ready = lambda: library.equations([peers.tracks.Flight(body, *table) for table in tables], windows[who])
            equations, before = timed(ready)
            _, choice = timed(lambda: work(equations, settings[who]))
            row |= {who: before + choice, f"before {who}": before}
        rows.append(row)
    return rows


def judged(cases, found):
    """Each peer's answers as verdicts, with the settings that were chosen."""
    each = {who: [[peers.judged(c, picks) for picks in f[who]] for c, f in zip(cases, found)] for who in ("stepwise", "pysindy", "pysindy, not told")}
    best = {who: peers.best_of_all(cases, verdicts) for who, verdicts in each.items()}
    fixed = lambda who, k: [v[k] for v in each[who]]
    free = lambda who: [peers.best_of_each(c, v) for c, v in zip(cases, each[who])]
    return {
        "PSE": fixed("stepwise", peers.STEPWISE.index(peers.PLAIN)),
        "PSE, best": fixed("stepwise", best["stepwise"]),
        "pysindy, one": fixed("pysindy", best["pysindy"]),
        "pysindy, each": free("pysindy"),
        "pysindy, not told": free("pysindy, not told"),
    }, {"stepwise": peers.STEPWISE[best["stepwise"]], "pysindy": sparse.SETTINGS[best["pysindy"]]}


def machine():
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines() if platform.system() == "Linux" else []
    cpu = next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), platform.processor())
    return {"cpu": cpu, "threads": os.cpu_count(), "pysindy": importlib.metadata.version("pysindy")}


def main():
    parser = argparse.ArgumentParser()
    for name in ("--hyzer", "--cases", "--out", "--page"):
        parser.add_argument(name, type=pathlib.Path, required=True)
    parser.add_argument("--datasets", type=int, default=5, help="of each effect and strength, of 5; four times as many have no effect")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    load, clock = [os.getloadavg()[0]], time.perf_counter()
    # An effect that is no term of a library by equations is nobody's here.
    cases = [c for c in json.loads((args.cases / "cases.json").read_text()) if c["effect"] is None or c["effect"] in library.TRUE]
    cases = [c for c in cases if not c["noise"] or int(c["name"].rsplit("-", 1)[1]) <= args.datasets * (1 if c["effect"] else 4)]
    # The first of each before the second of any.
    cases.sort(key=lambda c: c["seed"] % 50 if c["effect"] else (c["seed"] + 3) // 4)
    noisy, clean = [c for c in cases if c["noise"]], [c for c in cases if not c["noise"]]

    with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
        windows = windows_of(pool, args.cases, noisy)
        say(f"the peers' smoothing: {windows}, {time.perf_counter() - clock:.0f} s")
        found = []
        jobs = [pool.submit(one, args.hyzer, args.cases, args.out, w, c) for some, w in ((noisy, windows), (clean, {who: peers.CLEAN for who in windows})) for c in some]
        for k, job in enumerate(jobs):
            found.append(job.result())
            if (k + 1) % 20 == 0:
                say(f"  {k + 1} of {len(jobs)} cases, {time.perf_counter() - clock:.0f} s")
    load.append(os.getloadavg()[0])
    verdicts, settings = judged(noisy, found[: len(noisy)])
    without_noise, _ = judged(clean, found[len(noisy) :])
    mine = [f["ours"] for f in found[: len(noisy)]]

    say("in turn against the clock")
    shown = [c for c in noisy if c["name"].endswith("-1")]
    times = clocked(args.hyzer, args.cases, args.out, windows, shown[::4], settings)
    load.append(os.getloadavg()[0])

    results = {"schema": "hyzer.discovery-bench/1", "machine": machine(), "load": load, "windows": windows, "settings": settings}
    results |= {"cases": noisy, "ours": mine, "peers": verdicts, "clean cases": clean, "clean": without_noise, "times": times}
    (args.out / "results.json").write_text(json.dumps(results, indent=1))
    # As it is read back, so that the page can be made from the file alone.
    args.page.write_text(page.text(json.loads((args.out / "results.json").read_text())))
    say(f"{args.page} is written after {time.perf_counter() - clock:.0f} s")


if __name__ == "__main__":
    main()
