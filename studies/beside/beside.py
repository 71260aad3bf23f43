"""Study of what is measured beside the flight: writes docs/studies/beside.md.

    python studies/beside/beside.py --out docs/studies/beside.md [--sets 300] [--further 120] [--only NUMBER] [--keep FOLDER]

Datasets with inputs over time, spins that nobody measured and summaries, simulated by the integrator of this file, are
fitted and diagnosed. Needs NumPy and the package `hyzer`.
"""

import argparse
import csv
import multiprocessing
import tempfile
import time
from pathlib import Path

import numpy as np

import hyzer

G = 9.81
STEP = 1e-3  # of the integration, s
FIRST_FURTHER = 10_000  # number of the first set with a further cause
MAX_ERRORS = 4.0  # standard errors, beyond which a reliable estimate is wrong
INPUT_ERRORS = ["none", "none", "delay", "lag", "bias", "scale", "noise"]

DRONE = """model drone;
param m = 0.5 kg;
param g = 9.81 m/s^2;
coefficient k = 8 N in 0 .. 20;
coefficient c = 0.1 N*s/m in 0 .. 5;
input throttle = 0.7;
input tilt: rad = 0;
frame N;
point drone { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
force weight = -m*g*N.3;
force thrust = k*throttle^2*(cos(tilt)*N.3 + sin(tilt)*N.1);
force drag = -c*velocity;
marker mark in N;
observe mark = position + mark;
"""

BICOPTER = """model bicopter;
param m = 0.4 kg;
param I = 2e-3 kg*m^2;
param l = 0.15 m;
param g = 9.81 m/s^2;
coefficient k = 3.5 N in 0 .. 20;
coefficient c = 0.15 N*s/m in 0 .. 5;
coefficient d = 3e-3 N*m*s in 0 .. 1;
input left = 0.75;
input right = 0.75;
frame N;
frame A = N turned theta about 2;
state x = 0 m;
state z = 2 m;
state theta = 0 rad;
state vx = 0 m/s;
state vz = 0 m/s;
state q = 0 rad/s;
let thrust = k*(left^2 + right^2);
der(x) = vx;
der(z) = vz;
der(theta) = q;
der(vx) = (thrust*sin(theta) - c*vx)/m;
der(vz) = (thrust*cos(theta) - c*vz)/m - g;
der(q) = (l*k*(left^2 - right^2) - d*q)/I;
marker end in A;
observe end = (x, 0, z) in N + in_N(end);
"""

BALL = """model spinning_ball;
param m = 0.145 kg;
param r = 0.0365 m;
param rho = 1.2 kg/m^3;
param g = 9.81 m/s^2;
param area = pi*r^2;
coefficient C_D = 0.35 in 0 .. 3;
coefficient C_M = 0.9 in 0 .. 5;
input omega in N = (0, 0, 0) rad/s;
input wind in N = (0, 0, 0) m/s;
frame N;
point ball { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
let air_velocity = velocity - wind;
let V = norm(air_velocity);
force weight = -m*g*N.3;
force drag = -rho/2*area*C_D*V*air_velocity;
force magnus = rho/2*area*r*C_M*cross(omega, air_velocity);
marker mark in N;
observe mark = position + mark;
"""


def runge_kutta(rate, state, seconds, every, each=None, step=STEP):
    """States every `every` seconds, by classical steps of about `step`; `each(t, h, before, after)` may end the flight."""
    states, steps = [state], round(every / step)
    h = every / steps
    for sample in range(round(seconds / every)):
        for part in range(steps):
            t = sample * every + part * h
            a = rate(t, state)
            b = rate(t + h / 2, state + h / 2 * a)
            c = rate(t + h / 2, state + h / 2 * b)
            d = rate(t + h, state + h * c)
            after = state + h / 6 * (a + 2 * b + 2 * c + d)
            if each is not None and each(t, h, state, after):
                return states
            state = after
        states.append(state)
    return states


class Input:
    """An input over time: samples of sines and steps, and what is between them."""

    def __init__(self, random, seconds, interval, mean, size, interpolation):
        self.times = np.arange(-0.5, seconds + 0.3, interval)
        rates, phases = random.uniform(3, 14, 3), random.uniform(0, 6.28, 3)
        sizes = size * random.dirichlet(np.ones(3))
        steps = size / 2 * random.choice([-1, 1], 8)[np.clip((self.times / 0.35).astype(int) + 2, 0, 7)]
        sines = sum(a * np.sin(w * self.times + p) for a, w, p in zip(sizes, rates, phases))
        self.values = mean + sines + (steps if random.random() < 0.5 else 0)
        self.interpolation = interpolation

    def at(self, t):
        if self.interpolation == "hold":
            return self.values[max(np.searchsorted(self.times, t + 1e-9, side="right") - 1, 0)]
        return np.interp(t, self.times, self.values)


def acting(own, kind, size):
    """The input as it acts, where its record has an error."""
    if kind == "delay":
        return lambda t: own.at(t - size)
    if kind == "lag":
        fine = np.arange(own.times[0], own.times[-1], 2e-4)
        recorded = np.array([own.at(t) for t in fine])
        lagged, follows = np.empty_like(recorded), recorded[0]
        pull = -np.expm1(-2e-4 / size)
        for index, value in enumerate(recorded):
            lagged[index] = follows
            follows += pull * (value - follows)
        return lambda t: np.interp(t, fine, lagged)
    if kind == "bias":
        return lambda t: own.at(t) + size
    if kind == "scale":
        return lambda t: (1 + size) * own.at(t)
    return own.at


def write(path, header, rows):
    with path.open("w", newline="") as file:
        out = csv.writer(file)
        out.writerow(header)
        out.writerows([repr(float(value)) for value in row] for row in rows)


def with_inputs(random, folder, is_planar, hidden=None):
    """A drone or a bicopter whose inputs are recorded, one of them with an error or none; with `hidden` both, or in a wind."""
    kind = str(random.choice(INPUT_ERRORS[2:6] if hidden == "two errors" else INPUT_ERRORS))
    kind = "none" if hidden == "wind" else kind
    rate = int(random.choice([20, 50, 100, 200]))
    interpolation = str(random.choice(["linear", "hold"]))
    flights, sigma, seconds, every = int(random.integers(3, 9)), random.uniform(5e-4, 2e-3), 2.0, 0.01
    if is_planar:
        text, names, means, sizes = BICOPTER, ["left", "right"], [0.75, 0.75], [0.006, 0.006]
        truth = {"k": 3.5 * random.uniform(0.97, 1.03), "c": random.uniform(0.1, 0.3), "d": random.uniform(2e-3, 6e-3)}
    else:
        text, names, means, sizes = DRONE, ["throttle", "tilt"], [0.75, 0.0], [0.15, 0.25]
        truth = {"k": 8 * random.uniform(0.9, 1.15), "c": random.uniform(0.05, 0.2)}
    wrong = int(random.integers(2))
    # The scale of a throttle is one with the coefficient of the thrust.
    wrong = 1 if kind == "scale" and not is_planar else wrong
    errors = [("none", 0.0), ("none", 0.0)]
    errors[wrong] = (kind, size_of_error(random, kind, sizes[wrong], is_planar))
    if hidden == "two errors":
        other = str(random.choice([own for own in ("delay", "lag", "bias") if own != kind]))
        errors[1 - wrong] = (other, size_of_error(random, other, sizes[1 - wrong], is_planar))
    wind = random.uniform(1.5, 4) * np.array([*unit(random.normal(size=2)), 0]) if hidden == "wind" else np.zeros(3)
    (folder / "model.hyz").write_text(text)
    markers = [("a", [0.2, 0, 0]), ("b", [-0.2, 0, 0.05])] if is_planar else [("a", [0.0, 0, 0])]
    lines = ['model = "model.hyz"', "[inputs]", f'interpolation = "{interpolation}"']
    for name, at in markers:
        lines += ["[[markers]]", f'name = "{name}"', f"position = {at}"]
    for flight in range(flights):
        inputs = [Input(random, seconds, 1 / rate, m, s, interpolation) for m, s in zip(means, sizes)]
        acts = [acting(own, *error) for own, error in zip(inputs, errors)]
        if is_planar:
            start = np.array([0, 2, random.normal(0, 0.2), random.normal(0, 0.5), random.normal(0, 0.5), 0.0])
            rates = lambda t, s, a=acts: bicopter(s, a[0](t), a[1](t), truth)
            states = runge_kutta(rates, start, seconds, every)
            places = [[planar(s, at) for _, at in markers] for s in states]
        else:
            start = np.concatenate([[0, 0, 5], random.normal(0, 0.7, 3)])
            rates = lambda t, s, a=acts: drone(s, a[0](t), a[1](t), truth, wind)
            states = runge_kutta(rates, start, seconds, every)
            places = [[s[:3]] for s in states]
        noisy = np.array(places) + sigma * random.standard_normal(np.shape(places))
        header = ["t"] + [f"{name}_{axis}" for name, _ in markers for axis in "xyz"]
        rows = [[every * k, *row.ravel()] for k, row in enumerate(noisy)]
        write(folder / f"flight{flight}.csv", header, rows)
        recorded = np.stack([own.values for own in inputs], 1)
        if kind == "noise":
            recorded[:, wrong] += errors[wrong][1] * random.standard_normal(len(recorded))
        table = [[t, *row] for t, row in zip(inputs[0].times, recorded)]
        write(folder / f"inputs{flight}.csv", ["t", *names], table)
        lines += ["[[flights]]", f'file = "flight{flight}.csv"', f'inputs = "inputs{flight}.csv"']
        if flight == flights - 1:
            lines.append('role = "held-out"')
    (folder / "dataset.toml").write_text("\n".join(lines) + "\n")
    about = f"{'bicopter' if is_planar else 'drone'}: {flights} flights, inputs at {rate} Hz ({interpolation})"
    about += "".join(f", {own} of {name} {size:.3g}" for name, (own, size) in zip(names, errors) if own != "none")
    about += f", wind of {np.linalg.norm(wind):.1f} m/s" if hidden == "wind" else ""
    causes = {f"{own}-of-{name}" for name, (own, _) in zip(names, errors) if own not in ("none", "noise")}
    if is_planar and {own for own, _ in errors} == {"scale", "bias"}:
        kind = hidden = ACT_AS_ONE
    return truth, hidden or kind, {"wind"} if hidden == "wind" else causes, about


# The inputs of the bicopter differ by 1 % from their mean, where a scale is a bias; those of both are one with a scale of one
# and the coefficient of the thrust.
ACT_AS_ONE = "two errors that act as one"


def size_of_error(random, kind, size, is_planar):
    """Size of an error of an input whose values vary by `size`."""
    return {
        "delay": random.uniform(0.02, 0.06),
        "lag": random.uniform(0.02, 0.06),
        "bias": size * random.uniform(0.1, 0.3),
        "scale": random.uniform(0.05, 0.15) * (0.1 if is_planar else 1),
        "noise": size * random.uniform(0.05, 0.3),
    }.get(kind, 0.0)


def unit(vector):
    return vector / np.linalg.norm(vector)


def drone(s, throttle, tilt, of, wind):
    thrust = of["k"] * throttle**2
    force = np.array([thrust * np.sin(tilt), 0, thrust * np.cos(tilt)]) - of["c"] * (s[3:] - wind)
    return np.concatenate([s[3:], force / 0.5 - [0, 0, G]])


def bicopter(s, left, right, of):
    thrust, angle = of["k"] * (left**2 + right**2), s[2]
    ax = (thrust * np.sin(angle) - of["c"] * s[3]) / 0.4
    az = (thrust * np.cos(angle) - of["c"] * s[4]) / 0.4 - G
    turn = (0.15 * of["k"] * (left**2 - right**2) - of["d"] * s[5]) / 2e-3
    return np.array([s[3], s[4], s[5], ax, az, turn])


def planar(s, at):
    sine, cosine = np.sin(s[2]), np.cos(s[2])
    return [s[0] + cosine * at[0] + sine * at[2], at[1], s[1] - sine * at[0] + cosine * at[2]]


def ball(t, s, omega, of):
    v, area = s[3:] - of.get("wind", 0), np.pi * 0.0365**2
    speed = np.linalg.norm(v)
    drag = of["C_D"] * (1 + of.get("drag by speed", 0) * (speed / 35 - 1))
    lift = of["C_M"] * (1 + of.get("lift by speed", 0) * (speed / 35 - 1)) * np.exp(-t * of.get("spin decay", 0))
    force = 0.6 * area * (-drag * speed * v + 0.0365 * lift * np.cross(omega, v))
    return np.concatenate([s[3:], force / 0.145 - [0, 0, G]])


def hidden_in_ball(random, is_hidden, other):
    """What the model of a ball lacks: `other`, or, where that is none, the drag by speed or nothing."""
    if other is None:
        return {"drag by speed": random.choice([-1, 1]) * random.uniform(0.4, 0.8)} if is_hidden else {}
    if other == "wind":
        return {other: random.uniform(2, 5) * np.array([*unit(random.normal(size=2)), 0])}
    return {other: random.uniform(0.4, 0.8)}


def described(hidden):
    """Kind, causes and description of what is hidden in flights of a ball."""
    if not hidden:
        return "none", set(), ""
    [(name, size)] = hidden.items()
    return name, {SITES[name]}, f", {name} {np.linalg.norm(size) if name == 'wind' else size:+.2f}"


def with_spins(random, folder, other=None):
    """Throws of a ball whose spin is unknown, or measured with an error; with a hidden drag by speed, or `other`."""
    is_measured, is_hidden = random.random() < 0.5, random.random() < 0.3
    is_measured = is_measured or other in ("lift by speed", "spin decay")
    truth = {"C_D": random.uniform(0.25, 0.45), "C_M": random.uniform(0.7, 1.1)}
    if not is_measured:
        truth["C_M"] = 0.9
    hidden = hidden_in_ball(random, is_hidden, other)
    flights, rate, sigma = int(random.integers(8, 25)), int(random.choice([100, 200])), random.uniform(1e-3, 3e-3)
    (folder / "model.hyz").write_text(BALL)
    lines = ['model = "model.hyz"', "[[markers]]", 'name = "c"', "position = [0.0, 0.0, 0.0]"]
    if not is_measured:
        lines.insert(1, 'unknown = ["omega"]')
    for flight in range(flights):
        speed, up, around = random.uniform(18, 42), random.uniform(0, 0.6), random.normal(0, 0.2)
        v = speed * np.array([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)])
        omega = random.normal(0, 100, 3)
        states = runge_kutta(lambda t, s: ball(t, s, omega, truth | hidden), np.concatenate([[0, 0, 1.5], v]), 0.9, 1 / rate)
        places = np.array([s[:3] for s in states]) + sigma * random.standard_normal((len(states), 3))
        write(folder / f"flight{flight}.csv", ["t", "c_x", "c_y", "c_z"], [[k / rate, *p] for k, p in enumerate(places)])
        lines += ["[[flights]]", f'file = "flight{flight}.csv"']
        if flight >= flights - 2:
            lines.append('role = "held-out"')
        if is_measured:
            told = omega + 15 * random.standard_normal(3)
            lines.append(f"known = {{ omega = {[round(w, 6) for w in told.tolist()]}, omega_sigma = [15.0, 15.0, 15.0] }}")
    (folder / "dataset.toml").write_text("\n".join(lines) + "\n")
    spin = "measured to 15 rad/s" if is_measured else "unknown"
    about = f"ball: {flights} flights, {rate} Hz, {sigma * 1e3:.1f} mm, spin {spin}"
    kind, causes, told = described(hidden)
    return truth, kind, causes, about + told


def with_summaries(random, folder, other=None):
    """Shots of a ball of which a row tells the release and the landing; with a hidden drag by speed, or `other`."""
    is_hidden = random.random() < 0.35
    truth = {"C_D": random.uniform(0.25, 0.45), "C_M": random.uniform(0.7, 1.1)}
    hidden = hidden_in_ball(random, is_hidden, other)
    shots = int(random.integers(20, 61))
    sigmas = {"speed": 0.2, "launch": 0.005, "heading": 0.005, "spin": 5.0, "spin_axis": 0.02}
    of_outcome = {"carry": 0.5, "side": 0.4, "apex_height": 0.2, "hang_time": 0.05, "landing_angle": 0.01}
    units = {"speed": "m/s", "launch": "rad", "heading": "rad", "spin": "rad/s", "spin_axis": "rad", "carry": "m",
             "side": "m", "apex_height": "m", "hang_time": "s", "landing_angle": "rad"}
    rows = []
    for _ in range(shots):
        release = {"speed": random.uniform(22, 42), "launch": random.uniform(0.2, 0.8), "heading": random.normal(0, 0.1),
                   "spin": random.uniform(80, 300), "spin_axis": random.normal(0, 0.15)}
        around, up = release["heading"], release["launch"]
        v = release["speed"] * np.array([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)])
        # Backspin is about the axis to the left of the launch; positive tilt turns the flight to the right.
        across = np.array([np.sin(around), -np.cos(around), 0])
        above = np.cross(across, v / np.linalg.norm(v))
        omega = release["spin"] * (np.cos(release["spin_axis"]) * across - np.sin(release["spin_axis"]) * above)
        omega = -omega if np.dot(np.cross(omega, v), [0, 0, 1]) < 0 else omega
        end = {}

        def landed(t, h, before, after):
            if before[5] >= 0 > after[5]:
                part = before[5] / (before[5] - after[5])
                end["apex_height"] = before[2] + part * (after[2] - before[2]) + 0 * h
            if after[2] >= 0:
                return False
            part = before[2] / (before[2] - after[2])
            at = before + part * (after - before)
            end.update(carry=np.hypot(at[0], at[1]), side=-at[1], hang_time=t + part * h)
            end["landing_angle"] = np.arctan2(-at[5], np.hypot(at[3], at[4]))
            return True

        runge_kutta(lambda t, s: ball(t, s, omega, truth | hidden), np.concatenate([[0, 0, 0], v]), 20, 0.01, landed, 5e-3)
        told = {name: value + sigmas[name] * random.standard_normal() for name, value in release.items()}
        told |= {name: end[name] + sigma * random.standard_normal() for name, sigma in of_outcome.items()}
        rows.append([told[name] for name in units])
    (folder / "model.hyz").write_text(BALL)
    write(folder / "shots.csv", list(units), rows)
    held_out = list(range(shots - 3, shots + 1))
    lines = ['model = "model.hyz"', "[[summaries]]", 'file = "shots.csv"', f"held_out = {held_out}", "[summaries.columns]"]
    for name, unit in units.items():
        sigma = (sigmas | of_outcome)[name]
        lines.append(f'"{name}" = {{ is = "{name}", unit = "{unit}", sigma = {sigma} }}')
    (folder / "dataset.toml").write_text("\n".join(lines) + "\n")
    kind, causes, told = described(hidden)
    return truth, kind, causes, f"shots: {shots} rows{told}"


# Sites of what is hidden in flights of a ball.
SITES = {"drag by speed": "drag", "lift by speed": "lift", "spin decay": "lift", "wind": "wind"}

KINDS = [
    ("inputs", lambda random, folder: with_inputs(random, folder, False)),
    ("inputs", lambda random, folder: with_inputs(random, folder, True)),
    ("inputs", lambda random, folder: with_inputs(random, folder, False)),
    ("spins", with_spins),
    ("summaries", with_summaries),
]
# Further causes, in sets of their own.
FURTHER = [
    ("inputs", lambda random, folder: with_inputs(random, folder, False, "two errors")),
    ("inputs", lambda random, folder: with_inputs(random, folder, True, "two errors")),
    ("inputs", lambda random, folder: with_inputs(random, folder, False, "wind")),
    *(("spins", lambda random, folder, own=own: with_spins(random, folder, own)) for own in ("wind", "lift by speed", "spin decay")),
    *(("summaries", lambda random, folder, own=own: with_summaries(random, folder, own)) for own in ("wind", "lift by speed")),
]


def run(number, keep=None):
    """One dataset: what it has, how it is fitted, and what the diagnosis says."""
    kinds = KINDS if number < FIRST_FURTHER else FURTHER
    group, make = kinds[number % len(kinds)]
    random = np.random.default_rng([8, number])
    with tempfile.TemporaryDirectory() as made:
        folder = Path(keep or made)
        folder.mkdir(parents=True, exist_ok=True)
        truth, kind, causes, about = make(random, folder)
        found = {"number": number, "group": group, "dataset": about, "kind": kind}
        fixed = {"C_M": 0.9} if "spin unknown" in about else {}
        begin = time.process_time()
        try:
            fit = hyzer.fit(folder, fixed=fixed, threads=1)
        except hyzer.Error as error:
            return found | {"fit": "no result", "why": str(error).splitlines()[0][:150]}
        found["fit, s"] = time.process_time() - begin
        errors = {}
        for name, value in truth.items():
            own = fit.coefficients[name]
            if name not in fixed and own.std_error:
                errors[name] = abs(own.value - value) / own.std_error
        worst = max(errors, key=errors.get)
        found |= {"worst": worst, "error": errors[worst], "inside": sum(e < 1.96 for e in errors.values()), "of": len(errors)}
        found |= {"fit": "reliable" if fit.reliable else "not reliable", "why": "; ".join(fit.cautions)[:200]}
        if kind != "none" or number % 3 == 0:
            begin = time.process_time()
            told = hyzer.diagnose(folder, fixed=fixed, threads=1)
            found["diagnosis, s"] = time.process_time() - begin
            found |= judged(told, kind, causes)
        return found


def judged(told, kind, causes):
    """What a diagnosis says, and whether it is right: an explanation has the effects or sites `causes`, all of them."""
    sets = [[effect.name for effect in own.effects] for own in told.explanations]
    says = f"{told.verdict}: " + " | ".join(" + ".join(names) for names in sets[:4])
    if not told.reliable:
        says += "; not reliable"
    found = [{word for effect in own.effects for word in (effect.name, effect.site)} for own in told.explanations]
    is_named = any(causes & own if kind == ACT_AS_ONE else causes <= own for own in found)
    verdict = str(told.verdict).lower()
    if kind in ("none", "noise"):
        judgement = "wrong cause" if verdict == "identified" else "right"
    elif verdict == "identified":
        judgement = "right" if is_named else "wrong cause"
    elif verdict in ("adequate", "negligible"):
        judgement = "nothing found"
    else:
        judgement = "in the set" if is_named else "not named"
    return {"diagnosis": says, "judgement": judgement}


def percent(part, whole):
    return f"{100 * part / whole:.1f} % ({part} of {whole})" if whole else "–"


def page(found):
    """The page, and the table of every dataset."""
    clean = [own for own in found if own["kind"] == "none" and "of" in own]
    right = [own for own in clean if own["fit"] == "reliable"]
    wrong = [own for own in found if own["fit"] == "reliable" and own["error"] > MAX_ERRORS]
    errors = [own for own in found if own["kind"] in ("delay", "lag", "bias", "scale") and "judgement" in own]
    hidden = [own for own in found if own["kind"] == "drag by speed" and "judgement" in own]
    further = sorted({(own["group"], own["kind"]) for own in found if own["number"] >= FIRST_FURTHER})
    told = [own for own in found if "judgement" in own]
    noise = [own for own in found if own["kind"] == "noise"]
    named = lambda sets: [own for own in sets if own.get("judgement") in ("right", "in the set")]
    slow = [own for own in found if max(own.get("fit, s", 0), own.get("diagnosis, s", 0)) > 20]

    def row(what, bar, value):
        return f"| {what} | {bar} | {value} |"

    lines = [
        "# What is measured beside the flight",
        "",
        "<!-- Written by studies/beside/beside.py; do not edit. -->",
        "",
        f"{len(found)} datasets, simulated by the integrator of `studies/beside/beside.py`: a drone and a bicopter whose inputs are recorded at",
        "20 to 200 Hz (linear or held between samples), right or with a delay, a lag, a bias, a wrong scale or noise; a ball whose spin is unknown, or",
        "measured to 15 rad/s; shots of which a row tells release and landing, both with errors. In some the drag changes with the speed; in sets of",
        "their own both inputs have an error, there is a wind, the lift changes with the speed, or the spin decays.",
        "",
        "| criterion | required | measured |",
        "|---|---|---|",
        row("95 % intervals that hold the truth, nothing wrong", "93 to 97 %", percent(sum(o["inside"] for o in clean), sum(o["of"] for o in clean))),
    ]
    for group in ("inputs", "spins", "summaries"):
        own = [o for o in clean if o["group"] == group]
        lines.append(row(f"of these, {group}", "", percent(sum(o["inside"] for o in own), sum(o["of"] for o in own))))
    lines += [
        row("right fits that are called unreliable", "at most 3 %", percent(len(clean) - len(right), len(clean))),
        row(f"reliable fits with an estimate off by more than {MAX_ERRORS:.0f} standard errors", "", percent(len(wrong), len(found))),
        row("errors of inputs named, alone or in the set", "97 %", percent(len(named(errors)), len(errors))),
        row("hidden drag by speed named, alone or in the set", "97 %", percent(len(named(hidden)), len(hidden))),
        *(row(f"{group}: hidden {kind} named, alone or in the set", "97 %",
              percent(len(named([o for o in found if (o["group"], o["kind"]) == (group, kind)])),
                      sum((o["group"], o["kind"]) == (group, kind) for o in found))) for group, kind in further),
        row("a wrong cause named alone", "at most 0.5 %", percent(sum(o["judgement"] == "wrong cause" for o in told), len(told))),
        row("noisy inputs: reliable and wrong", "", percent(sum(o in wrong for o in noise), len(noise))),
        row("longer than 20 s", "0", str(len(slow))),
        "",
        "An estimate counts as inside its interval within 1.96 standard errors, where it has one. In sets with a spin that is unknown `C_M` is held, as no flight tells the two",
        "apart. Causes are judged by the error of the input, by name, and by the site for the drag. Two errors of a bicopter act as one if",
        "one is a scale and one a bias, as its inputs differ by 1 % from their mean: either of them is right.",
        "",
        "Table: [beside-every-dataset.csv](beside-every-dataset.csv).",
        "",
    ]
    return "\n".join(lines)


COLUMNS = ["number", "group", "dataset", "fit", "worst", "error", "inside", "of", "why", "diagnosis", "judgement", "fit, s", "diagnosis, s"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path)
    parser.add_argument("--sets", type=int, default=300)
    parser.add_argument("--further", type=int, default=120, help="number of sets with further causes")
    parser.add_argument("--only", type=int, help="one dataset, printed")
    parser.add_argument("--keep", type=Path, help="folder for the dataset of --only")
    given = parser.parse_args()
    if given.only is not None:
        for name, value in run(given.only, given.keep).items():
            print(f"{name}: {value}")
        return
    numbers = [*range(given.sets), *range(FIRST_FURTHER, FIRST_FURTHER + given.further)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        found = []
        for own in pool.imap(run, numbers):
            found.append(own)
            print(own["number"], own["dataset"], own["fit"], own.get("judgement", ""), flush=True)
    text = page(found)
    print(text)
    if given.out:
        given.out.write_text(text)
        with given.out.with_name(given.out.stem + "-every-dataset.csv").open("w", newline="") as file:
            out = csv.DictWriter(file, COLUMNS, extrasaction="ignore")
            out.writeheader()
            for own in found:
                out.writerow({k: f"{v:.3g}" if isinstance(v, float) else v for k, v in own.items()})


if __name__ == "__main__":
    main()
