"""The page docs/studies/discovery-peers.md, from the results alone."""

import collections
import statistics

import library
import ours

WHO = {
    "PSE": "stepwise with PSE, every sample, F of 4",
    "PSE, best": "stepwise with PSE, its best settings",
    "pysindy, one": "pysindy, its best threshold over all",
    "pysindy, each": "pysindy, its best threshold of each case",
    "pysindy, not told": "the same, the model's terms not told",
}

HEAD = """# Diagnoses compared with other programs

`python3 benches/discovery/run.py{option}` makes this page. Flights of a disc have one seeded effect that the model does not know, and each program is asked
what is missing: `hyzer diagnose`, pysindy {pysindy} (sequentially thresholded least squares), and stepwise regression with predicted squared error
(PSE; Klein and Morelli, *Aircraft System Identification*).

**The cases.** {effects} aerodynamic effects of the disc, each weak and strong, {seeds} {datasets} each, and {nulls} datasets with nothing hidden: 20 flights of 1 s, three markers
at 120 Hz, white noise of 1.5 mm. The oracle simulates the flights. All effects act on one of the six
loads in the disc's frame.

**What each is given.** `hyzer diagnose`: the folder with the marker tracks, and nothing else. The other programs cannot read tracks, and were helped:

- poses by Kabsch, derivatives by Savitzky and Golay, and the six coefficients in the frame of the stream, with the true mass, inertia, air and gravity, no wind;
- for each the smoothing windows with which most equations come out right (samples, degree):
  stepwise {stepwise_windows}; pysindy {pysindy_windows};
- a library of {terms} terms for each equation, every hidden one in its exact form;
- the model's own terms, as certain;
- settings chosen by the truth: of pysindy the threshold and ridge parameter that are right most often over all cases, or for each case those that are best. Stepwise: the F of 95 %, or the stride and F that are right most often ({stepwise}).

A program is *right* if it picks the true term in the right equation, and nothing else in any of the six. `hyzer` is right if its verdict is that one effect.
*Among others* means that a program takes other terms too, and that `hyzer` lists the effect as one of several explanations.

"""

FOR = """
## What each is for

pysindy finds whole equations of motion without a model, and stepwise regression is for aircraft whose accelerations are measured; here the task is one small term beside a known model, for which `hyzer`
was made. Its catalogue was made by the same people as the cases. A regression has to differentiate the tracks twice, and treats what smoothing leaves as independent noise; a fit of trajectories does neither.
"""


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" + "|---:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def of(count, total):
    return f"{count} of {total}"


def hidden(results, size):
    """The tools on the cases of a strength."""
    index = [k for k, case in enumerate(results["cases"]) if case["size"] == size]
    total, rows = len(index), []
    words = collections.Counter(ours.judged(results["cases"][k], results["ours"][k])[0] for k in index)
    several = [len(results["ours"][k]["causes"]) for k in index if ours.judged(results["cases"][k], results["ours"][k])[0] == "among"]
    wrong = sum(words[w] for w in ("wrong", "wrong set", "joined", "outside"))
    others = f"{statistics.median(several) - 1:g}" if several else "–"
    rows.append(["**hyzer diagnose**", of(words["exact"], total), of(words["among"], total), others, of(wrong, total), of(words["none"], total), "–"])
    for who, verdicts in results["peers"].items():
        some = [verdicts[k] for k in index]
        right = sum(v["found"] and v["others"] == 0 for v in some)
        among = [v["others"] for v in some if v["found"] and v["others"] > 0]
        wrong = sum(not v["found"] and v["others"] > 0 for v in some)
        silent = sum(not v["found"] and v["others"] == 0 for v in some)
        others = f"{statistics.median(among):g}" if among else "–"
        rows.append([WHO[who], of(right, total), of(len(among), total), others, of(wrong, total), of(silent, total), of(sum(v["equation"] for v in some), total)])
    return table(["who", "right", "among others", "how many others, median", "only wrong ones", "nothing found", "its own equation right, whatever the five others say"], rows)


def sets(results):
    """What `hyzer` lists, as it is judged in its own page."""
    rows = []
    for size in ("strong", "weak"):
        index = [k for k, case in enumerate(results["cases"]) if case["size"] == size]
        words = collections.Counter(ours.judged(results["cases"][k], results["ours"][k])[0] for k in index)
        sizes = [len(results["ours"][k]["causes"]) for k in index if results["ours"][k]["causes"]]
        counts = [words["exact"] + words["among"], words["exact"], words["wrong"], words["joined"], words["wrong set"], words["outside"], words["none"]]
        rows.append([size, *(of(count, len(index)) for count in counts), f"{statistics.mean(sizes):.2f}" if sizes else "–"])
    head = ["", "truth in the set", "alone in it", "one cause, and wrong", "only joined with another effect", "several, all wrong", "unattributed, with terms of its own", "adequate", "size of a set, mean"]
    return table(head, rows)


def nulls(results):
    index = [k for k, case in enumerate(results["cases"]) if case["effect"] is None]
    alarms = [results["ours"][k]["verdict"] != "adequate" for k in index]
    listed = [len(results["ours"][k]["causes"]) for k in index]
    rows = [["**hyzer diagnose**", of(sum(alarms), len(index)), f"{statistics.mean(listed):.2g}"]]
    for who, verdicts in results["peers"].items():
        if who in ("pysindy, each", "pysindy, not told"):
            rows.append([WHO[who], "a threshold chosen by the truth is silent", "–"])
            continue
        counts = [verdicts[k]["others"] for k in index]
        rows.append([WHO[who], of(sum(c > 0 for c in counts), len(index)), f"{statistics.mean(counts):.2g}"])
    return table(["who", "datasets in which something is found", "terms found in a dataset, mean"], rows)


def clean(results):
    rows, total = [], len(results["clean cases"])
    for who, verdicts in results["clean"].items():
        counts = [sum(v["found"] and v["others"] == 0 for v in verdicts), sum(v["found"] for v in verdicts), sum(v["equation"] for v in verdicts)]
        rows.append([WHO[who], *(of(count, total) for count in counts)])
    return table(["who", "right", "right or among others", "its own equation right"], rows)


def effects(results):
    rows = []
    for effect in library.TRUE:
        row = [effect.replace("_", "-")]
        for size in ("weak", "strong"):
            index = [k for k, case in enumerate(results["cases"]) if case["effect"] == effect and case["size"] == size]
            words = [ours.judged(results["cases"][k], results["ours"][k])[0] for k in index]
            row.append(f"{words.count('exact')} + {words.count('among')}")
            for who in ("PSE, best", "pysindy, one", "pysindy, each"):
                some = [results["peers"][who][k] for k in index]
                right = sum(v["found"] and v["others"] == 0 for v in some)
                row.append(f"{right} + {sum(v['found'] for v in some) - right}")
        rows.append(row)
    short = ["hyzer", "PSE, best", "pysindy, over all", "pysindy, each case"]
    return table(["effect", *(f"{size}: {who}" for size in ("weak", "strong") for who in short)], rows)


def times(results):
    rows, clock = [], results["times"]
    names = {
        "ours": "**hyzer diagnose**, from tracks to the report",
        "process": "hyzer diagnose, the whole process with its files",
        "stepwise": "stepwise with PSE, from tracks to terms",
        "pysindy": "pysindy at one threshold, from tracks to terms",
        "before stepwise": "of that poses, smoothing, loads, library (numpy)",
    }
    for who, name in names.items():
        values, ratios = [r[who] for r in clock], [r[who] / r["ours"] for r in clock]
        rows.append([name, f"{statistics.median(values):.2f} s", f"{min(values):.2f} – {max(values):.2f} s", f"{statistics.median(ratios):.2f}"])
    return table(["who", "median", "least – most", "over ours, case by case, median"], rows)


def text(results):
    cases = results["cases"]
    seeds = sum(c["size"] == "weak" for c in cases) // len(library.TRUE)
    stride, least = results["settings"]["stepwise"]
    windows = {f"{who}_windows": ", ".join(f"{name} {tuple(w)}" for name, w in some.items() if name != "light") for who, some in results["windows"].items()}
    page = HEAD.format(
        pysindy=results["machine"]["pysindy"],
        option="" if seeds == 5 else f" --datasets {seeds}",
        effects=len(library.TRUE),
        seeds=seeds,
        datasets="dataset" if seeds == 1 else "datasets",
        nulls=sum(c["effect"] is None for c in cases),
        **windows,
        terms=len(library.NAMES),
        stepwise=f"every {stride}th sample, F of {least:g}" if stride > 1 else f"every sample, F of {least:g}",
    )
    for size in ("strong", "weak"):
        page += f"## A {size} effect is seeded\n\n" + hidden(results, size) + "\n"
    page += "## The sets of `hyzer diagnose`\n\n" + sets(results)
    page += "\n## No effect is seeded\n\n" + nulls(results)
    page += "\n## The peers on tracks without noise\n\nOne dataset of each effect and strength, with hardly any smoothing.\n\n" + clean(results)
    page += f"\n## By effect\n\nOf {seeds} each: right + among others.\n\n" + effects(results)
    load = ", ".join(f"{value:.1f}" for value in results["load"])
    page += "\n## Time of a case\n\nIn turn, case by case, on {cpu}, {threads} threads; the machine was shared with other work (load {load} at the beginning, before these and at the end). ".format(**results["machine"], load=load)
    page += "`hyzer` uses all threads and does the whole diagnosis; the others do one regression with settings known beforehand, on one thread.\n\n" + times(results)
    return page + FOR
