"""The page docs/studies/benchmarks-fit.md, from the results alone."""

# The bars: our share of a peer's time, agreement in standard errors, and how much the time of a flight may vary.
SHARE, AGREE, CONSTANT = 1 / 50, 0.2, 1.3

HEAD = """# Benchmarks of the fit

`python3 benches/fit/run.py` makes this page: the programs fit the same simulated flights in turn, round after round; medians.
On {cpu}, {threads} threads, {gcc}, {rustc}. The machine was shared with other work: load {load} at the beginning, after the rounds and at the end.
Ratios count for more than seconds.{quick}

The flights: a disc, 20 flights of 1 s, three markers at 120 Hz, white noise of 1.5 mm on each coordinate, throws of all kinds, simulated by the
other programs' own compiled equations. Unknown are 8 coefficients, the same for all flights, and each flight's 12 initial states: 248.

"""

PROBLEM, JOB = "the same problem", "the same job"

SAME_PROBLEM = """## The same problem: the least squares alone

All solve one least-squares problem from the same unknowns: 3 standard errors (of each unknown by itself) from the solution, the noise known, white and
alike on all axes, no outliers. Reading, building and compiling are not counted. Ours is `Fitted::solve_from` in a process that is kept
running ({note}); it ends where a step promises less than 0.001 of the sum of squares. Its solution is {apart:.3f} standard errors from that of all of
`hyzer fit`, which weighs by the noise that it estimates.

"""

SAME_JOB = """
## The same job: from the markers to the coefficients

All begin with the coefficients of the model's file and the markers. Ours is all of `hyzer fit` but reading files, the tests of lack of fit and the report: screening, starts from the
markers alone, outliers, the noise of each axis and its correlation, the fit ({steps} steps), standard errors. The peers are given our starts
at each sample; they solve with equal weights, then with those of the residuals along each axis, without outliers, correlation or standard errors.

"""

UNEQUAL = """
## All of ours beside the peers' bare solve

All of `hyzer fit`, as in the second table, over the peers' times in the first.

"""

WHAT = """
SciPy's residuals and exact sensitivities are compiled C (SymPy's code, gcc -O3 -march=native -ffast-math, OpenMP over flights), Runge–Kutta of order 4 with two steps
a sample, 0.5 µm from exact. CasADi: the same equations and steps, multiple shooting, IPOPT, Gauss-Newton Hessian JᵀJ with exact sparse Jacobians, `map` over
intervals on all threads, no scaling or bounds. Unknowns are in units of our standard errors for both. In the second table ours left out {outliers} of 7260 marker positions as outliers.
"""


def verdict(holds):
    return "holds" if holds else "**missed**"


def seconds(t):
    return f"{t * 1e3:.1f} ms" if t < 1 else f"{t:.2f} s"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


OURS = {
    (PROBLEM, "ours"): "**hyzer, the least squares alone**",
    (PROBLEM, "ours, one thread"): "the same on one thread",
    (JOB, "ours"): "**hyzer fit**",
    (JOB, "ours, process"): "the same, the whole process with its files",
    (JOB, "ours, one thread"): "hyzer fit --threads 1",
}


def median(results, what, who):
    return next((m for m in results["medians"] if m["what"] == what and m["who"] == who), None)


def contestants(results, what, than=None):
    """One case's table; `than` is the case that ours is taken from where it is another."""
    base = median(results, than or what, "ours")
    trials = {tuple(label): r for r in results["tried"] for label in r.get("chosen", [])}
    rows = []
    mine = sorted((m for m in results["medians"] if m["what"] == what), key=lambda m: not m["who"].startswith("ours"))
    for m in [m for m in mine if not (than and m["who"].startswith("ours"))]:
        trial = trials.get((m["who"], what))
        name = OURS.get((what, m["who"])) or f"{m['who']}: {trial['way']} ({trial['note']})"
        row = [name, seconds(m["wall"]), " – ".join(map(seconds, m["spread"])), f"{m['wall'] / base['wall']:.2f}", seconds(m["cpu"]), f"{m['cpu'] / base['cpu']:.2f}"]
        rows.append(row + ([] if than else [f"{trial['apart']:.4f}" if trial else ""]))
    for peer in results["missing"]:
        rows.append([peer, "missing: not installed"])
    head = ["who", "median", "least – most", "median over ours", "processor time", "that over ours", "greatest difference of a coefficient, std errors"]
    return table(head[:-1] if than else head, rows)


def bars(results):
    rows = []
    pairings = [("the least squares alone, both", PROBLEM, PROBLEM), ("the same job, both", JOB, JOB), ("all of hyzer fit, their least squares alone", JOB, PROBLEM)]
    for peer, name in (("casadi", "CasADi"), ("scipy", "SciPy")):
        for pairing, mine, theirs in pairings:
            bar = f"20 flights in at most 1/50 of {name}: {pairing}"
            if m := median(results, theirs, peer):
                ratio = median(results, mine, "ours")["wall"] / m["wall"]
                rows.append([bar, f"1/{1 / ratio:.1f}" if ratio < 1 else f"{ratio:.2f} times", verdict(ratio <= SHARE)])
            else:
                rows.append([bar, "not measured: the peer is missing or did not agree", "**open**"])
    agree = [r["apart"] for r in results["tried"] if "chosen" in r]
    if agree:
        rows.append([f"the same coefficients, within {AGREE} standard errors", f"{max(agree):.4f}", verdict(max(agree) <= AGREE)])
    scaled = results["scaling"]
    second = [r for r in scaled if r["duration"] == 1.0]
    for what, key in (("time", "total"), ("processor time", "cpu")):
        each = [r[key] / r["flights"] for r in second]
        ratio = max(each) / min(each)
        full = max(r["flights"] for r in second) >= 2000
        span = f"{second[0]['flights']} to {second[-1]['flights']:,} flights"
        rows.append([f"{what} of a flight constant to 30 %, {span}", f"{ratio:.2f}", verdict(ratio <= CONSTANT) if full else "**open** (--quick)"])
    (_, _, slopes) = growth(second)
    if len(slopes) > 1:
        ratio = slopes[-1] / slopes[0]
        rows.append(["memory grows only with the data: bytes a flight more, many flights over few", f"{ratio:.2f}", verdict(ratio <= CONSTANT)])
    many = [r for r in scaled if r["flights"] >= 10000]
    rows += [["10,000 flights of 2 s fitted on this machine", f"{r['total']:.0f} s, {r['memory'] / 1e9:.2f} GB", "holds"] for r in many]
    if not many:
        rows.append(["10,000 flights of 2 s fitted on this machine", "not measured (--quick)", "**open**"])
    return table(["bar", "measured", ""], rows)


def growth(rows):
    """Flights, memory, and bytes for each flight more between neighbouring rows."""
    pairs = list(zip(rows, rows[1:]))
    return rows, [r["memory"] for r in rows], [(b["memory"] - a["memory"]) / (b["flights"] - a["flights"]) for a, b in pairs]


def scaling(results):
    rows = []
    for r in results["scaling"]:
        each = 1e3 / r["flights"]
        rows.append([f"{r['flights']:,} of {r['duration']:g} s", seconds(r["total"]), f"{r['total'] * each:.2f} ms", f"{r['cpu'] * each:.1f} ms", seconds(r["wall"]),
                     f"{r['memory'] / 1e6:.0f} MB", f"{r['data'] / 1e6:.1f} MB", f"{r['files'] / 1e6:.0f} MB", r["steps"], f"{r['from_truth']:.1f}"])
    head = ["flights", "fit", "of a flight", "processor time of a flight", "with reading and writing", "peak memory", "data as numbers", "files", "steps", "farthest from the truth, std errors"]
    return table(head, rows)


def tried(results):
    rows = []
    for r in results["tried"]:
        time = seconds(r["wall"]) if "wall" in r else ""
        cpu = seconds(r["cpu"]) if "cpu" in r else ""
        apart = f"{r['apart']:.4f}" if "apart" in r else ""
        rows.append([r["peer"], r["what"], r["way"], time, cpu, r.get("note") or f"no result: {r['failed']}", apart])
    return table(["peer", "what", "way", "time", "processor time", "", "difference, std errors"], rows)


def text(results):
    load = ", ".join(f"{value:.1f}" for value in results["load"])
    quick = " These are figures of a quick run." if results["quick"] else ""
    page = HEAD.format(**results["machine"], load=load, quick=quick)
    page += SAME_PROBLEM.format(**results["alone"]) + contestants(results, PROBLEM)
    page += SAME_JOB.format(**results) + contestants(results, JOB)
    page += UNEQUAL + contestants(results, PROBLEM, than=JOB)
    page += WHAT.format(**results)
    page += "\n## The bars\n\n" + bars(results)
    page += "\n## More flights\n\nOurs alone: up to 2,000 flights in five rounds, of which the fastest counts; more once.\n\n" + scaling(results)
    page += "\n## The peers' ways\n\nEach three times, those over 2 s once; the fastest of each case that agrees with ours went into the rounds.\n\n" + tried(results)
    return page
