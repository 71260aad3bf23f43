"""Study of a table-tennis ball whose spin nobody measured: writes docs/studies/tt3d.md.

    python studies/tt3d/tt3d.py RECORDINGS --out docs/studies/tt3d.md

RECORDINGS is a folder with tables of cogsys-tuebingen/tt3d. Needs NumPy and the package `hyzer`.
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np

import hyzer

TEMPLATE = """model = "ball"
[[markers]]
name = "ball"
position = [0.0, 0.0, 0.0]
"""
SPIN = "lift_by_unknown_spin"
EVERY = 3  # one of so many arcs is held out


def arcs(recordings):
    """The free flights of the recordings, every third one held out."""
    with tempfile.TemporaryDirectory() as folder:
        template = Path(folder) / "template.toml"
        template.write_text(TEMPLATE)
        about = {"length": "m", "time": "s", "up": "+z", "markers": template}
        takes = sorted(recordings.glob("*.csv"))
        count = len(hyzer.Dataset.import_takes(takes, **about))
        held_out = range(EVERY - 1, count, EVERY)
        return hyzer.Dataset.import_takes(takes, held_out=held_out, **about)


def fitted(data, *effects):
    """Median residual of the fitted arcs, m, and the drag coefficient with its standard error."""
    fit = hyzer.fit(data, hyzer.Model("ball", effects=effects))
    flights = [own for own in fit.to_dict()["flights"] if own["outcome"] == "fitted"]
    drag = fit.coefficients["C_D"]
    return np.median([own["residual_rms"]["marker"]["value"] for own in flights]), drag, fit


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("recordings", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    data = arcs(options.recordings)
    rows = []
    for title, effects in [("gravity and drag", []), ("with the lift of an unknown spin of each arc", [SPIN])]:
        median, drag, fit = fitted(data, *effects)
        error = drag.std_error_cluster_robust or drag.std_error
        interval = [drag.value - 1.96 * error, drag.value + 1.96 * error]
        rows.append(f"| {title} | {1e3 * median:.2f} | {drag.value:.3f} ± {error:.3f} | {interval[0]:.3f} to {interval[1]:.3f} |")
    told = hyzer.diagnose(data)
    found = told.to_dict()
    gain = found["predictive_gain"]
    after = [own["rms_after_m"] for own in found["flights"] if own["role"] == "fit" and own["rms_after_m"] is not None]
    tests = sorted(found["tests"], key=lambda own: -own["z"])[:5]
    options.out.write_text(
        PAGE.format(
            arcs=len(data),
            fitted=len([own for own in found["flights"] if own["role"] == "fit"]),
            held_out=gain["flights"],
            rows="\n".join(rows),
            names=" + ".join(effect.name for effect in told.explanations[0].effects),
            verdict=f"{str(told.verdict).lower()}, {'reliable' if told.reliable else 'not to be relied on'}",
            cautions="; ".join(told.cautions) or "none",
            tests="\n".join(f"| `{own['name']}` | {own['z']:.0f} | {own['site']} |" for own in tests),
            after=1e3 * np.median(after),
            improved=gain["improved"],
            percent=100 * gain["improved"] / gain["flights"],
            before_m=1e3 * gain["median_before_m"],
            after_m=1e3 * gain["median_after_m"],
        )
    )


PAGE = """# Rallies of two amateurs, the spin never measured

<!-- Written by studies/tt3d/tt3d.py; do not edit. -->

69 recordings of rallies (cogsys-tuebingen/tt3d at a2ef524), a table-tennis ball by several cameras at 179 Hz; hits and bounces are not marked. Import cuts
them to {arcs} arcs of free flight; {fitted} are fitted, every third one is held out. The model is `ball`: gravity and drag. Mass and radius are presumed (2.7 g,
20 mm).

| | median rms of the fitted arcs, mm | `C_D` | 95 % |
|---|---|---|---|
{rows}

Errors are by arc. SpinDOE's balls, whose spin was measured, have `C_D` 0.538 ± 0.011 with lift by the spin
([real-data](real-data-table-tennis-balls.md)); both suppose the same mass.

`hyzer diagnose` names `{names}`: {verdict}. What it says against it: {cautions}. With it the median of the fitted arcs is {after:.2f} mm. {improved} of
{held_out} held-out arcs ({percent:.0f} %) are predicted better: the initial state and the spin are fitted to the first 30 %, the rest is predicted; the median
error falls from {before_m:.1f} to {after_m:.1f} mm. The largest of the score tests, of one effect at a time:

| effect | z | acts on |
|---|---|---|
{tests}

No effect that is the same in all arcs comes near: without the spin, the lift has another direction in each.
"""

if __name__ == "__main__":
    main()
