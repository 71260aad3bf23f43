"""From marker tracks to the six coefficients and what they depend on: poses, smoothing, loads."""

import csv
import tomllib

import numpy as np
from scipy.signal import savgol_filter

# The parameters of the built-in disc, which the datasets leave as they are, SI.
M, I_A, I_D, D, AREA, RHO, G = 0.175, 0.00235, 0.00122, 0.269, 0.057, 1.23, 9.7935
# Noise of the poses is taken off a little before products are made of them, and edges of the flights are left out.
LIGHT, EDGE = (7, 3), 6


def read(folder):
    """Times, markers in the body, and positions [sample, marker, axis] of each flight."""
    manifest = tomllib.loads((folder / "dataset.toml").read_text())
    body = np.array([m["position"] for m in manifest["markers"]])
    flights = []
    for entry in manifest["flights"]:
        with open(folder / entry["file"]) as file:
            rows = np.array(list(csv.reader(file))[1:], dtype=float)
        flights.append((rows[:, 0], rows[:, 1:].reshape(len(rows), -1, 3)))
    return body, flights


def poses(body, seen):
    """Mass centre and rotation of every frame (Kabsch)."""
    middle, centre = body.mean(axis=0), seen.mean(axis=1)
    cross = np.einsum("mi,kmj->kij", body - middle, seen - centre[:, None])
    u, _, vt = np.linalg.svd(cross)
    vt[:, 2] *= np.linalg.det(np.swapaxes(u @ vt, 1, 2))[:, None]
    turn = np.swapaxes(u @ vt, 1, 2)
    return centre - turn @ middle, turn


def phase(turn):
    """The angle turned about the disc's own axis, summed up from frame to frame."""
    step = np.einsum("kji,kjl->kil", turn[:-1], turn[1:])
    cosine = np.clip((np.trace(step, axis1=1, axis2=2) - 1) / 2, -1, 1)
    angle = np.arccos(cosine)
    about = (step[:, 1, 0] - step[:, 0, 1]) / 2
    return np.concatenate([[0], np.cumsum(about * angle / np.maximum(np.sin(angle), 1e-9))])


def slope(values, dt, window, order=0):
    """A derivative by Savitzky and Golay: window in samples and degree of the polynomial."""
    return savgol_filter(values, *window, deriv=order, delta=dt, axis=0)


def dot(a, b):
    return np.sum(a * b, axis=1)


def frame(velocity, axis):
    """d1, d2 and d3, as the models have them."""
    axis = axis / np.linalg.norm(axis, axis=1, keepdims=True)
    forward = velocity - dot(velocity, axis)[:, None] * axis
    forward /= np.linalg.norm(forward, axis=1, keepdims=True)
    return forward, np.cross(axis, forward), axis


class Flight:
    """A flight as its poses tell it."""

    def __init__(self, body, times, seen):
        self.dt = (times[-1] - times[0]) / (len(times) - 1)
        self.place, self.turn = poses(body, seen)
        self.phase = phase(self.turn)

    def signals(self, windows):
        """What the coefficients may depend on, with each quantity smoothed as it bears: the windows of force, turn and spin."""
        velocity = slope(self.place, self.dt, windows["force"], 1)
        axis, turning = (slope(self.turn[:, :, 2], self.dt, windows["light"], order) for order in (0, 1))
        d1, d2, d3 = frame(velocity, axis)
        omega = np.cross(d3, turning)
        return {
            "alpha": np.arctan2(-dot(velocity, d3), dot(velocity, d1)),
            "speed": np.linalg.norm(velocity, axis=1),
            "r": slope(self.phase, self.dt, windows["spin"], 1),
            "p1": dot(omega, d1),
            "p2": dot(omega, d2),
            "height": slope(self.place, self.dt, windows["force"])[:, 2],
        }

    def loads(self, windows):
        """Left sides: C_L, C_D, C_Y, the moments about d1 and d2 over q A d, and the moment about d3 in N m."""
        velocity, gain = (slope(self.place, self.dt, windows["force"], order) for order in (1, 2))
        _, d2, d3 = frame(velocity, slope(self.turn[:, :, 2], self.dt, windows["force"]))
        speed = np.linalg.norm(velocity, axis=1)
        stream = RHO * speed**2 / 2 * AREA
        force = M * (gain + [0, 0, G])
        along = velocity / speed[:, None]
        axis, turning, bending = (slope(self.turn[:, :, 2], self.dt, windows["turn"], order) for order in (0, 1, 2))
        e1, e2, e3 = frame(velocity, axis)
        r = slope(self.phase, self.dt, windows["spin"], 1)
        moment = I_D * np.cross(e3, bending) + I_A * r[:, None] * turning
        return {
            "lift": dot(force, np.cross(along, d2)) / stream,
            "drag": -dot(force, along) / stream,
            "side": dot(force, d2) / stream,
            "roll": dot(moment, e1) / (stream * D),
            "pitch": dot(moment, e2) / (stream * D),
            "spin": I_A * slope(self.phase, self.dt, windows["spin"], 2),
        }
