"""Both peers on one case, with every setting; and the choice of settings by those who know the truth."""

import functools

import numpy as np

import library
import sparse
import stepwise
import tracks

# How the peers may smooth: window in samples and degree.
WINDOWS = {
    "force": [(15, 3), (31, 3), (61, 5), (91, 5), (115, 5)],
    "turn": [(15, 4), (21, 3), (31, 3), (45, 5), (61, 5)],
    "spin": [(31, 3), (61, 3), (91, 3), (115, 3)],
}
# Without noise next to no smoothing is best.
CLEAN = {group: (9, 8) for group in ("light", "force", "turn", "spin")}
# Stepwise: every so manyth sample (smoothed ones resemble their neighbours), and the F that a term needs.
STEPWISE = [(stride, least) for stride in (1, 10, 20) for least in (4.0, 20.0)]
# Without choosing: every sample, and the F of 95 %.
PLAIN = (1, 4.0)


def flights(folder):
    body, tables = tracks.read(folder)
    return [tracks.Flight(body, *table) for table in tables]


def given(name):
    return [library.NAMES.index(term) for term in library.BASE[name]]


@functools.cache
def base(name):
    return frozenset(library.BASE[name])


def beyond(name, columns):
    """The names of the columns that are not the model's own."""
    return [library.NAMES[c] for c in columns if library.NAMES[c] not in base(name)]


def by_steps(equations, setting):
    """Terms chosen beside the model's own, by equation."""
    stride, least = setting
    return {name: beyond(name, stepwise.select(x[::stride], y[::stride], given(name), least)) for name, (x, y) in equations.items()}


def by_sparsity(equations, settings, told=True):
    """The same by pysindy, for each setting; the model's own terms are told, or have to be found too."""
    ready = {name: sparse.prepared(x, y, given(name) if told else []) for name, (x, y) in equations.items()}
    return [{name: beyond(name, sparse.select(r, setting)) for name, r in ready.items()} for setting in settings]


def all_of(folder, windows):
    """Every setting of both peers on one case, each with its own windows."""
    flown = flights(folder)
    of = {who: library.equations(flown, windows[who]) for who in ("stepwise", "pysindy")}
    return {
        "stepwise": [by_steps(of["stepwise"], setting) for setting in STEPWISE],
        "pysindy": by_sparsity(of["pysindy"], sparse.SETTINGS),
        "pysindy, not told": by_sparsity(of["pysindy"], sparse.SETTINGS, told=False),
    }


def smoothed(folder, case):
    """For each window of each group, and each setting of each peer, how many of the group's equations come out right in one case."""
    flown, right = flights(folder), {}
    middle = {"light": tracks.LIGHT, **{group: tried[len(tried) // 2] for group, tried in WINDOWS.items()}}
    truth = {name: [library.TRUE[case["effect"]]] if name == case["site"] else [] for name in library.EQUATIONS}
    for group, tried in WINDOWS.items():
        wanted = [name for name in library.EQUATIONS if library.GROUP[name] == group]
        for window in tried:
            equations = library.equations(flown, {**middle, group: window}, wanted)
            picks = {"stepwise": [by_steps(equations, s) for s in STEPWISE], "pysindy": by_sparsity(equations, sparse.SETTINGS[::2])}
            for who, settings in picks.items():
                right[who, group, window] = [sum(p[name] == truth[name] for name in wanted) for p in settings]
    return right


def windows(each):
    """For each peer the windows under which most equations come out right, at the setting that is best for them."""
    each, best = list(each), {}
    for who in ("stepwise", "pysindy"):
        score = lambda group, window: np.sum([right[who, group, window] for right in each], axis=0).max()
        best[who] = {"light": tracks.LIGHT} | {g: max(tried, key=lambda w: score(g, w)) for g, tried in WINDOWS.items()}
    return best


def judged(case, picks):
    """Whether the true term is there, how many others are, and whether its own equation is just right."""
    true = library.TRUE.get(case["effect"])
    count = sum(map(len, picks.values()))
    found = true is not None and true in picks[case["site"]]
    return {"found": found, "others": count - found, "equation": true is not None and picks[case["site"]] == [true]}


def good(verdict, case):
    return verdict["others"] == 0 and (verdict["found"] or case["effect"] is None)


def best_of_each(case, verdicts):
    """The setting that does best on this case, by the truth."""
    best = max(verdicts, key=lambda v: (v["found"] and v["others"] == 0, v["found"], -v["others"]))
    return best | {"equation": any(v["equation"] for v in verdicts)}


def best_of_all(cases, verdicts):
    """The index of the setting that is right on most cases, with nothing hidden or something."""
    scores = [sum(good(v[k], case) for case, v in zip(cases, verdicts)) for k in range(len(verdicts[0]))]
    return int(np.argmax(scores))
