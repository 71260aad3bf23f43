"""Compares the positions that `takes` reads from C3D files with those of ezc3d, and prints a table.

    python -m venv ENV && ENV/bin/pip install ezc3d
    cargo build --release -p hyzer-dataset --example points
    ENV/bin/python benches/takes/ezc3d.py FOLDER

Where the two differ, the table has the median step of a coordinate between two frames in each reading: of a file that is
read at the wrong places it is as large as the recorded room. Exit status 1: they differ, and the reading of `takes` is not
the smoother one by far.
"""

import argparse
import csv
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
POINTS = ROOT / "target" / "release" / "examples" / "points"
UNITS = {"mm": 1e-3, "cm": 1e-2, "m": 1.0}
# ezc3d computes in float32: 1e-6 of the largest coordinate, and a step of the last digit.
RELATIVE = 1e-6
# Ratio of the steps beyond which one reading is the right one.
SMOOTHER = 0.1

READ = """
import sys, ezc3d, numpy
file = ezc3d.c3d(sys.argv[1])
point = file["parameters"]["POINT"]
unit = point["UNITS"]["value"] if "UNITS" in point else []
print(unit[0].strip() if len(unit) else "")
labels = [label.strip() for label in point["LABELS"]["value"]]
data = file["data"]["points"][:3]
named = [i for i in range(data.shape[1]) if i < len(labels) and labels[i]]
for number, place in enumerate(named):
    for frame in range(data.shape[2]):
        x, y, z = data[:, place, frame]
        if numpy.isfinite([x, y, z]).all():
            print(number, frame, x, y, z, sep=",")
"""


def ours(points, file):
    """Positions in m by point and frame, or the reason for none."""
    run = subprocess.run([points, file, "mm"], capture_output=True, text=True)
    if run.returncode:
        return run.stderr.strip().split(": ", 1)[-1]
    rows = csv.reader(run.stdout.splitlines()[1:])
    return {(int(p), int(f)): (float(x), float(y), float(z)) for p, f, x, y, z in rows}


def theirs(file):
    """The same of ezc3d, in a process of its own: it ends some files with a signal."""
    run = subprocess.run([sys.executable, "-c", READ, file], capture_output=True, text=True)
    if run.returncode:
        lines = run.stderr.strip().splitlines()
        return lines[-1] if lines else f"signal {-run.returncode}"
    unit, *rows = run.stdout.splitlines()
    # A unit that was cut short: the beginning of a name.
    scale = UNITS.get(unit.lower(), 1.0 if unit.lower().startswith("met") else 1e-3)
    positions = {}
    for row in rows:
        p, f, *xyz = row.split(",")
        positions[int(p), int(f)] = tuple(scale * float(x) for x in xyz)
    return positions


def step(positions):
    """Median step of a coordinate between two frames, m."""
    steps = [
        abs(x - y)
        for (point, frame), xyz in positions.items()
        for x, y in zip(xyz, positions.get((point, frame + 1), ()))
    ]
    return statistics.median(steps) if steps else 0.0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--points", type=pathlib.Path, default=POINTS)
    options = parser.parse_args()
    failed = False
    print(f"{'file':44} {'positions':>9} {'seen by one':>11} {'greatest difference, m':>22}")
    for file in sorted(options.folder.iterdir()):
        if file.suffix.lower() != ".c3d":
            continue
        a, b = ours(options.points, file), theirs(file)
        if isinstance(a, str) or isinstance(b, str):
            both = [f"takes: {a}"] * isinstance(a, str) + [f"ezc3d: {b}"] * isinstance(b, str)
            print(f"{file.name:44} {'; '.join(both)}")
            continue
        alone = len(a.keys() ^ b.keys())
        common = a.keys() & b.keys()
        apart = max((abs(x - y) for key in common for x, y in zip(a[key], b[key])), default=0.0)
        size = max((abs(x) for key in common for x in a[key]), default=0.0)
        steps = ""
        if alone > 0 or apart > RELATIVE * size:
            steps = f"   steps {step(a):.1e} m (takes), {step(b):.1e} m (ezc3d)"
            failed |= step(a) > SMOOTHER * step(b)
        print(f"{file.name:44} {len(common):9} {alone:11} {apart:22.1e}{steps}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
