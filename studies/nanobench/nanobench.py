"""Study of a quadrotor's path by its motors: writes docs/studies/nanobench.md from the recordings of NanoBench.

    python3 studies/nanobench/nanobench.py RECORDINGS --hyzer PROGRAM --out docs/studies/nanobench.md

RECORDINGS is a folder with the tables of syediu/nanobench-iros2026. Needs NumPy.
"""

import argparse
import copy
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
HELD_OUT = ["B2_circle_medium_rep1", "B3_figure8_fast_rep1", "B5_helix_fast_rep1", "B10_lissajous_fast_rep1"]
LEFT_OUT = ["B6_linear_ramp_rep1", "B6_linear_ramp_rep2"]  # near the ground, or hovering
MOTORS = ["m1", "m2", "m3", "m4"]
G = 9.81
LAGS = [f"lag_of_{motor}" for motor in MOTORS]
WINDOW = 0.1  # half of it, s: accelerations are those of parabolas through it
ARC, EVERY = 0.6, 1.8  # length of the fitted arcs, and time from one to the next, s
BEFORE = 0.35  # time of the inputs before an arc, s
AHEAD = 0.5  # time of the open-loop predictions, s


class Recording:
    """A recording between take-off and landing, and its accelerations."""

    def __init__(self, path):
        table = np.genfromtxt(path, delimiter=",", skip_header=1)
        commands = table[:, 14:18] / 65535
        start = table[np.argmax(commands.mean(1) > 0.2), 0]
        air = np.flatnonzero((table[:, 3] > 0.35) & (commands.mean(1) > 0.2))
        kept = slice(air[0] + 60, air[-1] - 60)
        table, commands = table[kept], commands[kept]
        self.name = path.stem
        self.t, self.position, self.attitude = table[:, 0], table[:, 1:4], table[:, 4:8]
        self.commands, self.voltage, self.rates = commands, table[:, 18], table[:, 11:14]
        self.running = self.t - start
        self.velocity, self.acceleration = self.differentiated()

    def differentiated(self):
        """Velocity and acceleration at each sample; NaN where samples are missing."""
        velocity, acceleration = np.full((2, len(self.t), 3), np.nan)
        for i, now in enumerate(self.t):
            low, high = np.searchsorted(self.t, [now - WINDOW - 1e-6, now + WINDOW + 1e-6])
            s = self.t[low:high] - now
            if len(s) == 21:
                parabola = np.stack([np.ones_like(s), s, s * s / 2], 1)
                fitted = np.linalg.lstsq(parabola, self.position[low:high], rcond=None)[0]
                velocity[i], acceleration[i] = fitted[1], fitted[2]
        return velocity, acceleration

    def axes(self):
        w, x, y, z = self.attitude.T
        first = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], 1)
        second = np.stack([2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)], 1)
        third = np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], 1)
        return first, second, third


def smooth(values):
    """Values over time as a parabola through the window sees them: the weights of its second derivative."""
    s = np.arange(-10, 11) / 10
    weights = (1 - s**2) ** 2
    return np.apply_along_axis(np.convolve, 0, values, weights / weights.sum(), "same")


def lagged(t, u, tau):
    """Response to straight lines between samples."""
    if tau <= 1e-9:
        return u
    out = u.copy()
    for i in range(1, len(t)):
        dt = t[i] - t[i - 1]
        slope = (u[i] - u[i - 1]) / dt
        out[i] = u[i] - tau * slope + (out[i - 1] - u[i - 1] + tau * slope) * np.exp(-dt / tau)
    return out


def of_model(own, c):
    """Acceleration by crazyflie.hyz with the coefficients `c`, without what depends on the velocity; and that by the velocity."""
    taus = [c.get(f"k_lag_of_{motor}", 0.0) for motor in MOTORS]
    commands = np.stack([lagged(own.t, own.commands[:, k], taus[k]) for k in range(4)], 1)
    first, second, third = own.axes()
    by_voltage = (own.voltage / 3.5) ** c["by_voltage"]
    fade = 1 - c["fade"] * (1 - np.exp(-own.running / 20))
    thrust = c["k_T"] * (commands ** c["by_command"]).sum(1) * by_voltage * fade / 0.035
    direction = third + c["lean_1"] * first + c["lean_2"] * second
    pull = thrust[:, None] * direction - [0, 0, G]
    along = np.einsum("ij,ik->ijk", third, third)
    turning = commands.sum(1)[:, None, None] / 0.035
    drag = -turning * (c["k_D"] * (np.eye(3) - along) + c["k_I"] * along)
    return pull, drag


def of_regression(own):
    """Columns of a linear regression: thrust by commands and voltage along the measured axis, and the velocity."""
    third = own.axes()[2]
    total, squares, voltage = own.commands.sum(1), (own.commands**2).sum(1), own.voltage - 3.5
    along = [total, squares, total * voltage, squares * voltage, voltage, np.ones_like(voltage)]
    along = [third * own[:, None] for own in along]
    part = np.einsum("ij,ik->ijk", third, third)
    return along, [np.broadcast_to(np.eye(3), part.shape) - part, part]


def determined(recordings, predicted):
    """R² of the acceleration along x, y and z, and of all samples, over the recordings together."""
    left, total = np.zeros(3), np.zeros(3)
    each = []
    for own in recordings:
        residual = own.acceleration - smooth(predicted(own))
        good = np.isfinite(residual).all(1)
        good[:10] = good[-10:] = False
        residual, seen = residual[good], own.acceleration[good]
        parts = (residual**2).sum(0), ((seen - seen.mean(0)) ** 2).sum(0)
        left, total = left + parts[0], total + parts[1]
        each.append(1 - parts[0] / parts[1])
    return 1 - left / total, each


def ahead(recordings, pull_and_drag):
    """Root mean square of the distance after AHEAD seconds, m, from the measured position and velocity."""
    squares = []
    for own in recordings:
        pull, drag = pull_and_drag(own)
        count = round(AHEAD / 0.01)
        for start in range(10, len(own.t) - count - 10, 25):
            times = own.t[start : start + count + 1]
            velocity, place = own.velocity[start].copy(), own.position[start].copy()
            if np.isnan(velocity).any() or abs(times[-1] - times[0] - AHEAD) > 0.02:
                continue
            for i in range(start, start + count):
                dt = own.t[i + 1] - own.t[i]
                a = 0.5 * (pull[i] + pull[i + 1]) + drag[i] @ velocity
                place += velocity * dt + a * dt * dt / 2
                velocity += a * dt
            squares.append(((place - own.position[start + count]) ** 2).sum())
    return float(np.sqrt(np.mean(squares)))


def write_arcs(recordings, folder):
    folder.mkdir()
    (folder / "crazyflie.hyz").write_text((HERE / "crazyflie.hyz").read_text())
    manifest = ['model = "crazyflie.hyz"', "[[markers]]", 'name = "c"', "position = [0.0, 0.0, 0.0]"]
    for own in recordings:
        for number, start in enumerate(np.arange(own.t[0] + BEFORE, own.t[-1] - ARC, EVERY)):
            kept = (own.t >= start - 1e-6) & (own.t <= start + ARC + 1e-6)
            given = (own.t >= start - BEFORE) & (own.t <= start + ARC + 0.02)
            if kept.sum() < 58 or np.diff(own.t[given]).max() > 0.035:
                continue
            file = f"{own.name}-{number:02}"
            path = np.column_stack([own.t, own.position])[kept]
            table = [own.t, own.attitude, own.commands, own.voltage, own.running]
            inputs = np.column_stack(table)[given]
            write = lambda name, head, rows: np.savetxt(folder / name, rows, "%.7g", ",", header=head, comments="")
            write(f"{file}.csv", "t,c_x,c_y,c_z", path)
            write(f"{file}-inputs.csv", "t,q0,q1,q2,q3,m1,m2,m3,m4,voltage,running", inputs)
            manifest += ["[[flights]]", f'file = "{file}.csv"', f'inputs = "{file}-inputs.csv"']
    (folder / "dataset.toml").write_text("\n".join(manifest) + "\n")
    return sum(line == "[[flights]]" for line in manifest)


def fitted(program, folder, out, effects):
    with_effects = [word for effect in effects for word in ("--with", effect)]
    subprocess.run([program, "fit", folder, "--out", out, *with_effects], stdout=subprocess.DEVNULL, check=False)
    return json.loads((out / "report.json").read_text())


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("recordings", type=Path)
    parser.add_argument("--hyzer", default="hyzer")
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    files = [path for path in sorted(options.recordings.glob("*.csv")) if path.stem not in LEFT_OUT]
    recordings = [Recording(path) for path in files]
    held_out = [own for own in recordings if own.name in HELD_OUT]
    others = [own for own in recordings if own.name not in HELD_OUT]
    with tempfile.TemporaryDirectory() as folder:
        arcs = write_arcs(others, Path(folder) / "arcs")
        reports = {
            name: fitted(options.hyzer, Path(folder) / "arcs", Path(folder) / name, effects)
            for name, effects in [("plain", []), ("lag", LAGS)]
        }
    rows = []
    for name, title in [("lag", "model, with the lag of each motor"), ("plain", "model, motors without lag")]:
        c = {key: own["value"] for key, own in reports[name]["coefficients"].items()}

        def acceleration(own, c=c):
            pull, drag = of_model(own, c)
            return pull + np.einsum("ijk,ik->ij", drag, np.nan_to_num(own.velocity))

        score, each = determined(held_out, acceleration)
        rows.append((title, score, each, ahead(held_out, lambda own, c=c: of_model(own, c))))
    rows.append(regression(others, held_out))
    scores, by_flight = turning(others, held_out)
    of_lag = {key: own["value"] for key, own in reports["lag"]["coefficients"].items()}
    ahead_too = with_attitude_ahead(held_out, by_flight, of_lag)
    options.out.write_text(page(arcs, len(others), reports, rows, (scores, ahead_too)))


def regression(others, held_out):
    def columns(own):
        along, by_velocity = of_regression(own)
        moved = [np.einsum("ijk,ik->ij", part, np.nan_to_num(own.velocity)) for part in by_velocity]
        return np.stack(along + moved, 2)

    seen, rows = [], []
    for own in others:
        all_columns = columns(own)
        smoothed = np.stack([smooth(all_columns[:, :, k]) for k in range(all_columns.shape[2])], 2)
        good = np.isfinite(own.acceleration).all(1)
        good[:10] = good[-10:] = False
        seen.append((own.acceleration[good] + [0, 0, G]).ravel())
        rows.append(smoothed[good].reshape(-1, smoothed.shape[2]))
    weights = np.linalg.lstsq(np.concatenate(rows), np.concatenate(seen), rcond=None)[0]
    score, each = determined(held_out, lambda own: columns(own) @ weights - [0, 0, G])

    def pull_and_drag(own):
        along, by_velocity = of_regression(own)
        pull = np.stack(along, 2) @ weights[: len(along)] - [0, 0, G]
        return pull, sum(part * weight for part, weight in zip(by_velocity, weights[len(along) :]))

    return "linear regression", score, each, ahead(held_out, pull_and_drag)


def turning(others, held_out):
    """A regression of the angular acceleration on commands, their squares and rates: its R² for the held-out flights, and
    the angular accelerations that it predicts for each of these without what depends on the rates, and that."""

    def both(recordings):
        seen, rows = [], []
        for own in recordings:
            columns = [own.commands, own.commands**2, np.ones((len(own.t), 1)), own.rates]
            change = np.gradient(smooth(own.rates), own.t, axis=0)
            seen.append(change[20:-20])
            rows.append(smooth(np.concatenate(columns, 1))[20:-20])
        return np.concatenate(seen), np.concatenate(rows)

    seen, rows = both(others)
    weights = np.linalg.lstsq(rows, seen, rcond=None)[0]
    seen, rows = both(held_out)
    left = ((seen - rows @ weights) ** 2).sum(0)
    of_commands = [np.concatenate([own.commands, own.commands**2, np.ones((len(own.t), 1))], 1) for own in held_out]
    by_flight = [(columns @ weights[:-3], weights[-3:]) for columns in of_commands]
    return 1 - left / ((seen - seen.mean(0)) ** 2).sum(0), by_flight


def turned(attitude, rates, dt):
    """Quaternion after turning by body rates for dt."""
    angle = np.linalg.norm(rates) * dt
    axis = rates / max(np.linalg.norm(rates), 1e-12)
    w, v = np.cos(angle / 2), np.sin(angle / 2) * axis
    q0, q = attitude[0], attitude[1:]
    return np.concatenate([[q0 * w - q @ v], q0 * v + w * q + np.cross(q, v)])


def with_attitude_ahead(held_out, by_flight, c):
    """After AHEAD seconds of open loop from a measured state: root mean square angle of the attitude, degrees, and R² of
    the acceleration meanwhile along x, y and z."""
    rows = []
    ways = [
        ("attitude of the start, held", False, False),
        ("rates of the start, held", True, False),
        ("regression of the angular acceleration", True, True),
    ]
    for title, turns, accelerates in ways:
        angles, left, total = [], np.zeros(3), np.zeros(3)
        for own, (change, by_rates) in zip(held_out, by_flight):
            seen, predicted = [], []
            rates_seen = smooth(own.rates)
            for start in range(20, len(own.t) - 80, 60):
                kept = slice(start, start + round(AHEAD / 0.01) + 1)
                if own.t[kept][-1] - own.t[start] > AHEAD + 0.02 or np.isnan(own.acceleration[kept]).any():
                    continue
                attitude, rates, path = own.attitude[start], rates_seen[start] * turns, []
                for i in range(kept.start, kept.stop):
                    path.append(attitude)
                    dt = own.t[i + 1] - own.t[i]
                    attitude = turned(attitude, rates, dt)
                    if accelerates:
                        rates = rates + dt * (change[i] + rates @ by_rates)
                off = abs(np.clip(path[-1] @ own.attitude[kept.stop - 1], -1, 1))
                angles.append(np.degrees(2 * np.arccos(off)))
                flown = copy.copy(own)
                flown.attitude = own.attitude.copy()
                flown.attitude[kept] = path
                pull, drag = of_model(flown, c)
                acceleration = pull + np.einsum("ijk,ik->ij", drag, np.nan_to_num(own.velocity))
                predicted.append(acceleration[kept])
                seen.append(own.acceleration[kept])
            seen, predicted = np.concatenate(seen), np.concatenate(predicted)
            left, total = left + ((seen - predicted) ** 2).sum(0), total + ((seen - seen.mean(0)) ** 2).sum(0)
        rows.append((title, np.sqrt(np.mean(np.square(angles))), 1 - left / total))
    return rows


def page(arcs, flights, reports, rows, attitude):
    number = lambda value: f"{value:.3f}".replace("-", "−")
    lines = [HEAD.format(arcs=arcs, flights=flights)]
    lines += ["| | x | y | z | after 0.5 s |", "|---|---|---|---|---|"]
    for title, score, _, distance in rows:
        lines.append(f"| {title} | " + " | ".join(number(own) for own in score) + f" | {1e3 * distance:.1f} mm |")
    lines += ["", "R² of each held-out flight, x, y and z:", "", "| | " + " | ".join(HELD_OUT) + " |", "|---|---|---|---|---|"]
    order = sorted(HELD_OUT, key=lambda name: name + ".csv")
    for title, _, each, _ in rows:
        by_name = dict(zip(order, each))
        cells = (" ".join(number(own) for own in by_name[name]) for name in HELD_OUT)
        lines.append(f"| {title} | " + " | ".join(cells) + " |")
    lines += ["", "## Coefficients", "", "| | value | standard error, by flight | unit |", "|---|---|---|---|"]
    for name, own in reports["lag"]["coefficients"].items():
        error = own.get("std_error_cluster_robust") or own["std_error"]
        lines.append(f"| `{name}` | {own['value']:.5g} | {error:.2g} | {own['unit']} |".replace("-", "−").replace("e−0", "e-0"))
    cautions = " ".join(reports["lag"]["cautions"])
    scores, ahead_too = attitude
    scores = ", ".join(number(own) for own in scores)
    table = "\n".join(
        f"| {title} | {angle:.1f}° | " + " | ".join(number(own) for own in score) + " |" for title, angle, score in ahead_too
    )
    lines += ["", "All four motors are commanded nearly alike, so that their lags are hardly told apart."]
    lines += ["", f"What the fit says of itself: {cautions}.", TAIL.format(scores=scores, table=table)]
    return "\n".join(lines)


HEAD = """# A quadrotor's path by its motors

NanoBench (syediu/nanobench-iros2026, arXiv 2603.09908) has flights of a Crazyflie 2.1: position and attitude by motion capture, the commands of the four
motors and the voltage of the battery, at 100 Hz. [The model](../../studies/nanobench/crazyflie.hyz) is a point mass with the measured attitude as an
input over time, and thrust along the measured axis by commands, voltage and time since the start. It was fitted to the positions of {arcs} arcs of 0.6 s from
{flights} flights; four other flights are held out. `studies/nanobench/nanobench.py` writes this page.

The form of the model (the exponents, the lean of the thrust, the fade while the motors warm up) was chosen by regressions that were scored on these four flights too, and one
of them, with a gap in its samples, was replaced by another. The figures below are therefore not those of flights that nobody had looked at; the coefficients come from
the other flights alone.

## Held-out flights

R² of the acceleration, over the four flights together, with attitude as measured: the tracks are differentiated by parabolas through 0.2 s, and predictions
are seen through the same window. Beside it, how far the predicted position is off after 0.5 s from the measured position and velocity, root mean
square. The linear regression is of the same accelerations on the commands, their squares, the voltage, the products of these, and the velocity.
"""

TAIL = """
## The attitude predicted too

A regression of the angular accelerations of the held-out flights about the axes 1, 2 and 3 on the logged commands, their squares and the rates has an R² of
{scores}. From the measured attitude and rates, after 0.5 s of open loop, and the acceleration of the model with lag on the way, with that attitude:

| attitude by | off, rms | x | y | z |
|---|---|---|---|---|
{table}

The last two are worse than the attitude held: a controller holds the attitude by small differences between the motors, faster than the log, whose four commands are
nearly alike. The rates of the gyroscope turn the measured attitude to 3° in 0.5 s, so that they are not the reason. With the attitude predicted no R² of this
page is reached; the published models, from the same inputs, have −0.26. The vertical acceleration of single flights,
some of which hardly vary, is below 0.85.
"""

if __name__ == "__main__":
    main()
