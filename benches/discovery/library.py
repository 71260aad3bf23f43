"""The terms that the peers choose from: the same for each of the six equations, the true ones among them."""

import numpy as np

import tracks

EQUATIONS = ("lift", "drag", "side", "roll", "pitch", "spin")
# By which window the left side of an equation is smoothed.
GROUP = {"lift": "force", "drag": "force", "side": "force", "roll": "turn", "pitch": "turn", "spin": "spin"}
# The model's own terms.
BASE = {"lift": ("1", "alpha"), "drag": ("1", "alpha^2"), "side": (), "roll": ("r", "p1"), "pitch": ("alpha", "p2"), "spin": ("r",)}
# The term that each effect is.
TRUE = {
    "stall": "max(alpha - 8 deg, 0)^2",
    "lift_by_spin": "|S|",
    "ground_effect": "exp(-(z/0.5)^2)",
    "zero_lift_drag_angle": "alpha",
    "drag_by_spin": "|S|",
    "drag_by_reynolds": "log V",
    "side_force_by_spin": "S",
    "side_force_by_spin_and_angle": "S alpha",
    "rolling_moment_by_angle": "alpha",
    "rolling_moment_by_spin_ratio": "S",
    "rolling_moment_at_low_angle": "S low(alpha)",
    "constant_pitching_moment": "1",
    "cubic_pitching_moment": "alpha^3",
    "pitching_moment_by_spin": "|S|",
    "quadratic_spin_down": "r |r|",
    "spin_down_by_pressure": "V r",
    "spin_down_by_angle": "alpha r",
}


def terms(s):
    """Every term along a flight."""
    alpha, speed, r, p1, p2, z = (s[k] for k in ("alpha", "speed", "r", "p1", "p2", "height"))
    ratio = r * tracks.D / (2 * speed)
    low = (1 - np.tanh((alpha - np.radians(10)) / np.radians(2))) / 2
    log = np.log(speed / 14)
    return {
        "1": np.ones_like(alpha),
        "alpha": alpha,
        "alpha^2": alpha**2,
        "alpha^3": alpha**3,
        "max(alpha - 8 deg, 0)^2": np.maximum(alpha - np.radians(8), 0) ** 2,
        "S": ratio,
        "|S|": np.abs(ratio),
        "S alpha": ratio * alpha,
        "|S| alpha": np.abs(ratio) * alpha,
        "S low(alpha)": ratio * low,
        "r": r,
        "alpha r": alpha * r,
        "r |r|": r * np.abs(r),
        "V r": speed * r,
        "p1": p1,
        "p2": p2,
        "alpha p1": alpha * p1,
        "alpha p2": alpha * p2,
        "log V": log,
        "log V alpha": log * alpha,
        "z": z,
        "exp(-(z/0.5)^2)": np.exp(-((z / 0.5) ** 2)),
    }


NAMES = tuple(terms({k: np.ones(1) for k in ("alpha", "speed", "r", "p1", "p2", "height")}))


def equations(flights, windows, wanted=EQUATIONS):
    """For each equation the matrix of its terms and its left side, over all flights; terms are smoothed as the left side is."""
    rows = {name: ([], []) for name in wanted}
    for flight in flights:
        columns, loads = np.column_stack(list(terms(flight.signals(windows)).values())), flight.loads(windows)
        inner = slice(tracks.EDGE, -tracks.EDGE)
        smooth = {group: tracks.slope(columns, flight.dt, windows[group])[inner] for group in {GROUP[name] for name in wanted}}
        for name in wanted:
            rows[name][0].append(smooth[GROUP[name]])
            rows[name][1].append(loads[name][inner])
    return {name: (np.vstack(left), np.concatenate(right)) for name, (left, right) in rows.items()}
