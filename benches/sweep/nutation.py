"""Whether integrating factors let a step be longer than nutation allows: Lawson's methods on the disc's backhand.

With M a constant matrix over a step, y = exp(-M t) x turns with what M describes, and the Runge-Kutta method sees y alone. M is the
Jacobian at the start of the step, restricted to the rates, to the rates and angles, or whole. Counts are of the method; the
exponentials of M, which are most of the work of the last, come on top.
"""

import ctypes

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as dop853
from scipy.linalg import expm

TSIT5_A = [
    [],
    [0.161],
    [-0.008480655492356989, 0.335480655492357],
    [2.8971530571054935, -6.359448489975075, 4.3622954328695815],
    [5.325864828439257, -11.748883564062828, 7.4955393428898365, -0.09249506636175525],
    [5.86145544294642, -12.92096931784711, 8.159367898576159, -0.071584973281401, -0.028269050394068383],
]
TSIT5_B = np.array([0.09646076681806523, 0.01, 0.4798896504144996, 1.379008574103742, -3.290069515436081, 2.324710524099774])
TSIT5_C = [0, 0.161, 0.327, 0.9, 0.9800255409045097, 1.0]
TSIT5_E = [-0.001780011052225777, -0.0008164344596567469, 0.007880878010261995, -0.1447110071732629, 0.5823571654525552]
TSIT5_E = np.array([*TSIT5_E, -0.45808210592918697, 0.015151515151515152])
FACTORS = {"none": [], "the rates": [9, 10, 11], "rates and angles": [6, 7, 8, 9, 10, 11], "all": list(range(12))}
DURATION, TOLERANCE = 2.0, 1e-6


class Disc:
    def __init__(self, library, parameters):
        self.rate, self.calls = library.disc_rate, 0
        self.p, self.prepared = np.array(parameters, dtype=float), np.zeros(22)
        library.disc_prepare.argtypes = [ctypes.c_void_p] * 2
        library.disc_prepare(self.p.ctypes.data, self.prepared.ctypes.data)

    def f(self, x):
        self.calls += 1
        x, dx = np.ascontiguousarray(x), np.zeros(12)
        self.rate(x.ctypes.data, self.p.ctypes.data, self.prepared.ctypes.data, dx.ctypes.data)
        return dx

    def jacobian(self, x):
        """By central differences, whose evaluations are not counted: ours would be the model's own f_jac."""
        calls, columns = self.calls, []
        for i in range(12):
            step = np.zeros(12)
            step[i] = 1e-6 * max(1, abs(x[i]))
            columns.append((self.f(x + step) - self.f(x - step)) / (2 * step[i]))
        self.calls = calls
        return np.array(columns).T


def fly(disc, x, is_tsit5, block, tolerance):
    """Steps, rejected steps, evaluations and the state at the end."""
    if is_tsit5:
        rows, b, c, order = [np.array(row) for row in TSIT5_A], TSIT5_B, TSIT5_C, 5
    else:
        rows, b, c, order = [dop853.A[i, :i] for i in range(12)], dop853.B, dop853.C[:12], 8
    stages, t, h, steps, rejected, m = len(b), 0.0, 0.002, 0, 0, None
    disc.calls, k = 0, np.zeros((len(b) + 1, 12))
    while t < DURATION - 1e-12:
        h = min(h, DURATION - t)
        if m is None:
            m = np.zeros((12, 12))
            if block:
                at = np.ix_(block, block)
                m[at] = disc.jacobian(x)[at]
        turn = (lambda s: expm(s * h * m)) if block else (lambda s: np.eye(12))
        k[0] = disc.f(x) - m @ x
        for i in range(1, stages):
            y = turn(c[i]) @ (x + h * (rows[i] @ k[:i]))
            k[i] = turn(-c[i]) @ (disc.f(y) - m @ y)
        whole = turn(1.0)
        end = whole @ (x + h * (b @ k[:stages]))
        k[stages] = turn(-1.0) @ (disc.f(end) - m @ end)
        scale = tolerance * (1 + np.maximum(abs(x), abs(end)))
        if is_tsit5:
            error = h * np.sqrt(np.mean((whole @ (TSIT5_E @ k) / scale) ** 2))
        else:
            five, three = (np.sum((whole @ (e @ k) / scale) ** 2) for e in (dop853.E5, dop853.E3))
            error = h * five / np.sqrt(12 * (five + 0.01 * three)) if five > 0 else 0.0
        if error <= 1:
            t, x, steps, m = t + h, end, steps + 1, None
        else:
            rejected += 1
        h *= min(6, max(0.2, 0.9 * max(error, 1e-10) ** (-1 / order)))
    return steps, rejected, disc.calls, x


def table(library, parameters, backhand):
    """The rows of the page."""
    calm = np.array(backhand, dtype=float)
    calm[9:11] = 0
    releases = [("the backhand", np.array(backhand, dtype=float)), ("without rates across its axis", calm)]
    disc, rows = Disc(library, parameters), []
    for title, x in releases:
        exact = fly(disc, x, False, [], 1e-12)[3]
        for is_tsit5, method in [(True, "Tsit5"), (False, "DOP853")]:
            for factor, block in FACTORS.items():
                steps, rejected, calls, end = fly(disc, x, is_tsit5, block, TOLERANCE)
                error = np.max(abs(end - exact) / np.maximum(1, abs(exact)))
                rows.append(f"| {title} | {method} | {factor} | {steps} | {rejected} | {calls} | {error:.1e} |")
    return rows
