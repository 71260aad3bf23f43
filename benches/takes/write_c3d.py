"""Writes tables of Vicon Nexus (mm) as C3D files beside them, by ezc3d.

python write_c3d.py TAKE.csv...
"""

import csv
import pathlib
import sys

import ezc3d
import numpy as np


def write(path: pathlib.Path) -> None:
    with path.open(newline="") as file:
        rows = list(csv.reader(file))
    rate = float(rows[1][0])
    labels = [cell.split(":")[-1] for cell in rows[2] if cell]
    samples = rows[5:]
    points = np.full((4, len(labels), len(samples)), np.nan)
    points[3] = 1.0
    for i, row in enumerate(samples):
        for k in range(len(labels)):
            cells = row[2 + 3 * k : 5 + 3 * k]
            if all(cells):
                points[:3, k, i] = [float(cell) for cell in cells]
    c3d = ezc3d.c3d()
    c3d["parameters"]["POINT"]["RATE"]["value"] = [rate]
    c3d["parameters"]["POINT"]["LABELS"]["value"] = labels
    c3d["parameters"]["POINT"]["UNITS"]["value"] = ["mm"]
    c3d["data"]["points"] = points
    c3d.write(str(path.with_suffix(".c3d")))


for name in sys.argv[1:]:
    write(pathlib.Path(name))
