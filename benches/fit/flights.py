"""Made flights of a disc, seeded, in the layout that `hyzer fit` reads."""

import json
import shutil
from dataclasses import dataclass

import numpy as np

import native

MARKS = np.array([[0.1, 0.0, 0.01], [-0.05, 0.0866, 0.01], [-0.04, -0.08, 0.01]])
SIGMA, RATE = 0.0015, 120.0
BODY = {"m": 0.175, "I_a": 0.00235, "I_d": 0.00122, "d": 0.269, "A": 0.057, "rho": 1.23, "g": 9.7935}
# Not the values in the model's file, which the fit starts from.
TRUTH = {"C_L0": 0.15, "C_La": 2.8, "C_D0": 0.1, "C_Da": 1.6, "C_Ma": -0.3, "C_Mq": -0.008, "C_Rr": -0.0006, "C_Nr": -5e-5}
# So fine that it is exact beside the noise: 100 rad/s are followed to 1e-9 of their size.
FINE = 25


@dataclass
class Data:
    """Flights with the truth that they were made of; `seen[flight, sample, marker, axis]`, m."""

    seen: np.ndarray
    starts: np.ndarray
    interval: float = 1 / RATE
    sigma: float = SIGMA
    marks: np.ndarray = None


def parameters(coefficients=None):
    values = BODY | (TRUTH if coefficients is None else dict(zip(native.COEFFICIENTS, coefficients)))
    return np.array([values.get(name, 0.0) for name in native.disc.PARAMETERS])


def starts(count, random):
    """Throws of all kinds: slow and fast, flat and leaning, to both sides, wobbling by up to 2 rad/s."""
    even = lambda low, high: random.uniform(low, high, count)
    speed, climb, nose = even(9, 18), even(-0.05, 0.25), even(-0.08, 0.3)
    spin = even(35, 65) * np.where(even(0, 1) < 0.25, 1, -1)
    phi, theta = even(-0.4, 0.4), -(climb + nose)
    zero = np.zeros(count)
    x = [zero, zero, even(1, 1.8), speed * np.cos(nose), even(-1, 1), -speed * np.sin(nose)]
    x += [phi, theta, even(-3.1, 3.1), even(-2, 2), even(-2, 2), spin]
    return np.stack(x, axis=1)


def make(lib, count, duration, seed):
    random = np.random.default_rng(seed)
    x = starts(count, random)
    samples = round(duration * RATE) + 1
    flown = lib.fly(parameters(), x, samples, 1 / RATE, FINE)
    seen = lib.markers(flown, MARKS)
    seen += random.normal(0, SIGMA, seen.shape)
    return Data(seen, x, marks=MARKS)


def write(data, folder):
    """A folder with `dataset.toml` and a table per flight, where it is not there yet."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    lines = ['model = "disc"', "[parameters]"] + [f"{n} = {v}" for n, v in BODY.items()]
    for k, place in enumerate(data.marks):
        lines += ["[[markers]]", f'name = "m{k + 1}"', f"position = {json.dumps(list(place))}"]
    head = "t," + ",".join(f"m{k + 1}_{axis}" for k in range(len(data.marks)) for axis in "xyz")
    times = np.arange(data.seen.shape[1]) * data.interval
    row = "%.9f" + ",%.7f" * (3 * len(data.marks))
    form = "\n".join([row] * len(times))
    for flight, seen in enumerate(data.seen):
        name = f"flight{flight + 1:05}.csv"
        lines += ["[[flights]]", f'file = "{name}"']
        table = np.column_stack([times, seen.reshape(len(times), -1)])
        (folder / name).write_text(head + "\n" + form % tuple(table.ravel()) + "\n")
    (folder / "dataset.toml").write_text("\n".join(lines) + "\n")
