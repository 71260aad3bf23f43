"""The page docs/benchmarks-fit.md, from the results alone."""

# The bars: our share of a peer's time, agreement in standard errors, and how much the time of a flight may vary.
SHARE, AGREE, CONSTANT = 1 / 50, 0.2, 1.3

HEAD = """# Benchmarks of the fit

`python3 benches/fit/run.py` makes this page: it has the peers and us fit the same made flights, in turn, round after round, and takes medians.
On {cpu}, {threads} threads, {gcc}, {rustc}. The machine was shared with other work: load {load} at the beginning, after the rounds and at the end.
So ratios count for more than seconds, and processor time is given beside.{quick}

The flights: a disc, 20 flights of 1 s, three markers at 120 Hz, white noise of 1.5 mm on each coordinate, throws of all kinds; made by the
peers' own compiled equations with steps of 0.3 ms, so that no line of ours is in the data. Unknown are 8 coefficients, the same for all flights, and each flight's 12 initial states: 248.

"""

WHAT = """
What is timed. Ours: all of `hyzer fit` but reading files and writing the report: starts from the markers alone, coefficients from the model's file,
outliers, the noise and its correlation, the fit ({steps} steps), standard errors, residuals. The peers: the solution of the least-squares problem
alone, from a start 3 standard errors (of each unknown by itself) around our solution, with the noise known; to build the problem and to compile it is free.
scipy's residuals and exact sensitivities are compiled C (SymPy's code, gcc -O3 -march=native -ffast-math, OpenMP over flights), Runge–Kutta of order 4 with two steps
a sample, which is 0.5 µm from exact (rms; the worst 5 µm). CasADi: the same equations and steps, multiple shooting, Gauss-Newton Hessian JᵀJ with exact sparse Jacobians, `map` over
intervals on all threads, no scaling or bounds to slow IPOPT down, tolerance 1e-4 in units of standard errors. Nobody eliminated the flights' own unknowns by hand for a peer:
that would be a least-squares program of its own. Where all peers agree with each other and differ a little from us, the reason is the weights: ours estimates the noise
of each axis and its correlation in time, and leaves outliers out ({outliers} of 7260 marker positions here); theirs weigh all alike.
"""


def verdict(holds):
    return "holds" if holds else "**missed**"


def seconds(t):
    return f"{t * 1e3:.1f} ms" if t < 1 else f"{t:.2f} s"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def contestants(results):
    medians, base = results["medians"], results["medians"]["ours"]
    labels = {"ours": "**hyzer fit**", "ours, process": "hyzer fit, the whole process with its files", "ours, one thread": "hyzer fit --threads 1"}
    chosen = {label: r for r in results["tried"] for label in r.get("chosen", [])}
    rows = []
    for who, m in medians.items():
        trial = chosen.get(who)
        name = labels.get(who) or f"{who}: {trial['way']} ({trial['note']})"
        spread = f"{seconds(m['spread'][0])} – {seconds(m['spread'][1])}"
        apart = f"{trial['apart']:.3f}" if trial else ""
        rows.append([name, seconds(m["wall"]), spread, f"{m['wall'] / base['wall']:.2f}", seconds(m["cpu"]), f"{m['cpu'] / base['cpu']:.2f}", apart])
    for peer in results["missing"]:
        rows.append([peer, "missing: not installed", "", "", "", "", ""])
    return table(["who", "median", "least – most", "median over ours", "processor time", "that over ours", "greatest difference of a coefficient, std errors"], rows)


def bars(results):
    medians, rows = results["medians"], []
    mine = medians["ours"]["wall"]
    for peer, name in (("casadi", "CasADi with IPOPT, multiple shooting, Gauss-Newton"), ("scipy", "scipy's least_squares, compiled right-hand side")):
        if peer in medians:
            ratio = mine / medians[peer]["wall"]
            rows.append([f"20 flights in at most 1/50 of {name}", f"1/{1 / ratio:.1f}" if ratio < 1 else f"{ratio:.2f} times", verdict(ratio <= SHARE)])
        else:
            rows.append([f"20 flights in at most 1/50 of {name}", "not measured: the peer is missing or did not agree", "**open**"])
    agree = [r["apart"] for r in results["tried"] if "chosen" in r]
    if agree:
        rows.append([f"the same coefficients, within {AGREE} standard errors", f"{max(agree):.3f}", verdict(max(agree) <= AGREE)])
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
        apart = f"{r['apart']:.3f}" if "apart" in r else ""
        rows.append([r["peer"], r["way"], time, cpu, r.get("note") or f"no result: {r['failed']}", apart])
    return table(["peer", "way", "time", "processor time", "", "difference, std errors"], rows)


def text(results):
    load = ", ".join(f"{value:.1f}" for value in results["load"])
    quick = " These are figures of a quick run." if results["quick"] else ""
    page = HEAD.format(**results["machine"], load=load, quick=quick)
    page += "## 20 flights of 1 s\n\n" + contestants(results) + WHAT.format(**results)
    page += "\n## The bars\n\n" + bars(results)
    page += "\n## More flights\n\nOurs alone, one run each (the fastest of three up to 200 flights).\n\n" + scaling(results)
    page += "\n## The peers' ways\n\nEach once; the fastest that agrees went into the rounds.\n\n" + tried(results)
    return page
