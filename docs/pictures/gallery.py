#!/usr/bin/env python3
"""Draws the flights of examples/gallery into docs/pictures/gallery, and lists them in examples/gallery/README.md.

    python3 docs/pictures/gallery.py target/release/hyzer

The releases are those of the test tests/integration/gallery.rs. The program flies them; the paths are those of its
trajectory.csv. Run in the root of the repository.
"""

import csv
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

MODELS = Path("examples/gallery")
PICTURES = Path("docs/pictures/gallery")
WIDTH, HEIGHT = 320, 200
LEFT, RIGHT, TOP, BOTTOM = 44, 12, 12, 34
POINTS = 120
RATE = 200
COLOURS = ["#1f6f8b", "#c0562f"]


def releases():
    """Name, states at the release, `omega` and duration of each flight of the test."""
    text = Path("tests/integration/gallery.rs").read_text(encoding="utf-8")
    spin = re.search(r"const SPIN: \[f64; 3\] = \[(.*?)\]", text).group(1)
    case = r'^    \("(\w+)", &\[(.*)\], (?:\[([^\]]*)\]|SPIN), ([\d.]+)\),$'
    for name, states, omega, seconds in re.findall(case, text, re.M):
        states = {state: float(value) for state, value in re.findall(r'\("(\w+)", ([-\d.]+)\)', states)}
        omega = "0, 0, 0" if omega == "0.0; 3" else omega or spin
        yield name, states, omega, float(seconds)


def flown(program, name, states, omega, seconds, folder):
    """Columns of the flight's trajectory, and the units of the states."""
    path = MODELS / f"{name}.hyz"
    model = json.loads(subprocess.run([program, "export", path, "--ir"], check=True, capture_output=True).stdout)
    initial = {state["name"]: state["value"] for state in model["states"]} | states
    lines = [f'model = "{path.resolve()}"', f"duration = {seconds}"]
    if any(own["name"] == "omega" for own in model["inputs"]):
        lines += ["[known]", f"omega = [{omega}]"]
    lines += ["[initial]"] + [f"{state} = {float(value)!r}" for state, value in initial.items()]
    release = folder / "release.toml"
    release.write_text("\n".join(lines) + "\n", encoding="utf-8")
    out = folder / name
    command = [program, "simulate", "--release", release, "--rate", str(RATE), "--out", out]
    subprocess.run(command, check=True, capture_output=True)
    with open(out / "trajectory.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    columns = {key: [float(row[key]) for row in rows] for key in rows[0]}
    return columns, {state["name"]: state["unit"] for state in model["states"]}


def shown(columns, units):
    """Label of the horizontal axis, and for each curve its label and its points; and whether both axes have one scale."""
    extents = {name: max(columns[name]) - min(columns[name]) for name in ("x", "y", "z", "range", "height") if name in columns}
    chosen = sorted(sorted(extents, key=extents.get)[-2:], key=list(extents).index)
    states = [name for name in columns if name in units]
    if len(chosen) == 2 and extents[chosen[0]] > 1e-3 * extents[chosen[1]]:
        across, up = chosen
        return f"{across}, m", [(f"{up}, m", columns[across], columns[up])], True
    heights = [name for name in states if name in ("z", "h", "height")]
    chosen = heights or states[:2]
    curves = [(f"{name}, {units[name]}", columns["t"], columns[name]) for name in chosen]
    return "t, s", curves, False


def steps(low, high):
    """Round numbers, at most four, from low to high."""
    span = high - low
    for size in (m * 10.0**e for e in range(-6, 7) for m in (1, 2, 5)):
        if span / size <= 4:
            first = -(-low // size)
            return [size * (first + k) for k in range(int((high - first * size) / size + 1e-9) + 1)]
    return []


def drawing(name, across, curves, is_equal):
    """The figure as SVG."""
    xs = [x for _, row, _ in curves for x in row]
    ys = [y for _, _, row in curves for y in row]
    wide, high = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM
    spans = [max(max(own) - min(own), 1e-3 * max(map(abs, own)), 1e-6) for own in (xs, ys)]
    middle = [(max(own) + min(own)) / 2 for own in (xs, ys)]
    if is_equal and spans[0] < 6 * spans[1] and spans[1] < 6 * spans[0]:
        scale = max(spans[0] / wide, spans[1] / high)
        spans = [scale * wide, scale * high]
    lows = [m - s / 2 for m, s in zip(middle, spans)]

    def place(x, y):
        return LEFT + wide * (x - lows[0]) / spans[0], TOP + high * (1 - (y - lows[1]) / spans[1])

    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" '
        f'font-family="sans-serif" font-size="10"><title>Flight of {name}</title>',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>',
    ]
    for x in steps(lows[0], lows[0] + spans[0]):
        at = place(x, lows[1])[0]
        lines.append(f'<path d="M{at:.1f} {TOP}V{TOP + high}" stroke="#e4e4e4"/>')
        lines.append(f'<text x="{at:.1f}" y="{TOP + high + 12}" text-anchor="middle">{x:.6g}</text>')
    for y in steps(lows[1], lows[1] + spans[1]):
        at = place(lows[0], y)[1]
        lines.append(f'<path d="M{LEFT} {at:.1f}H{LEFT + wide}" stroke="#e4e4e4"/>')
        lines.append(f'<text x="{LEFT - 4}" y="{at + 3:.1f}" text-anchor="end">{y:.6g}</text>')
    lines.append(f'<text x="{LEFT + wide}" y="{HEIGHT - 6}" text-anchor="end">{across}</text>')
    for k, (label, row, values) in enumerate(curves):
        step = max(1, len(row) // POINTS)
        chosen = sorted({*range(0, len(row), step), len(row) - 1})
        points = [place(row[i], values[i]) for i in chosen]
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        lines.append(f'<path d="{path}" fill="none" stroke="{COLOURS[k]}" stroke-width="1.5"/>')
        x, y = points[0]
        lines.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="{COLOURS[k]}"/>')
        lines.append(f'<text x="{LEFT + 90 * k}" y="{HEIGHT - 6}" fill="{COLOURS[k]}">{label}</text>')
    return "\n".join(lines) + "\n</svg>\n"


def heading(name):
    """First line of a model's documentation, and the rest, with its source."""
    lines = (MODELS / f"{name}.hyz").read_text(encoding="utf-8").splitlines()
    doc = [line[3:].strip() for line in lines if line.startswith("//!")]
    return doc[0].rstrip("."), " ".join(line for line in doc[1:] if line)


def main():
    program = Path(sys.argv[1]).resolve()
    PICTURES.mkdir(exist_ok=True)
    entries = []
    with tempfile.TemporaryDirectory() as folder:
        for name, states, omega, seconds in releases():
            columns, units = flown(program, name, states, omega, seconds, Path(folder))
            across, curves, is_equal = shown(columns, units)
            (PICTURES / f"{name}.svg").write_text(drawing(name, across, curves, is_equal), encoding="utf-8")
            title, source = heading(name)
            what = " and ".join(label.split(",")[0] for label, _, _ in curves)
            alt = f"{name}: {what} over {across.split(',')[0]}, {seconds:g} s"
            entries.append(
                f"## [{name}]({name}.hyz)\n\n{title}. {source}\n\n![{alt}](../../docs/pictures/gallery/{name}.svg)\n"
            )
    text = (
        "# Models of papers\n\nEach is a model file of at most 60 lines with its source, and a flight of it: a dot where it begins. `hyzer check`,\n"
        "`hyzer verify` and `hyzer simulate` take the path of a file. The pictures are made by `docs/pictures/gallery.py`.\n\n"
    )
    (MODELS / "README.md").write_text(text + "\n".join(entries), encoding="utf-8")


if __name__ == "__main__":
    main()
