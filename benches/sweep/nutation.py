"""Whether integrating factors let a step be longer than nutation allows: Lawson's methods on the disc's backhand.

With M a constant matrix over a step, y = exp(-M t) x turns with what M describes, and the Runge-Kutta method sees y alone. M is the
Jacobian at the start of the step, restricted to the rates, to the rates and angles, or whole. Counts are of the method; the
exponentials of M, which are most of the work of the last, come on top.

The Lie-group method (Munthe-Kaas, Appl. Numer. Math. 29, 1999) takes the exact turn instead: the axis n of a body of revolution obeys
dn/dt = (L/I_d) x n, so that n = exp(Theta) n0 with dTheta/dt = dexpinv(Theta, L/I_d), where without a moment Theta grows in proportion to time
however fast it nutates. Positions, velocities and angular momenta L stay in the inertial frame; Theta starts at 0 in each step.
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


def turned(theta, n):
    """exp(Theta) n."""
    angle = np.linalg.norm(theta)
    if angle < 1e-12:
        return n + np.cross(theta, n)
    return n + np.sin(angle) / angle * np.cross(theta, n) + (1 - np.cos(angle)) / angle**2 * np.cross(theta, np.cross(theta, n))


def turning(theta, omega):
    """dTheta/dt = dexpinv(Theta, omega) for dR/dt = omega x R with R = exp(Theta)."""
    angle = np.linalg.norm(theta)
    factor = 1 / 12 if angle < 1e-3 else (1 - 0.5 * angle / np.tan(0.5 * angle)) / angle**2
    return omega - 0.5 * np.cross(theta, omega) + factor * np.cross(theta, np.cross(theta, omega))


class Momenta:
    """The disc with position, velocity and angular momentum in the inertial frame, and the turn of its axis since `axis`."""

    def __init__(self, disc, x):
        self.disc, self.i_a, self.i_d = disc, disc.p[1], disc.p[2]
        b = self.frame(x[6], x[7])
        self.axis = b[:, 2]
        rates = np.array([x[9] * np.cos(x[7]), x[10], x[9] * np.sin(x[7]) + x[11]])
        inertia = np.array([self.i_d, self.i_d, self.i_a])
        self.start = np.concatenate([x[:3], b @ x[3:6], b @ (inertia * rates), np.zeros(3)])

    @staticmethod
    def frame(phi, theta):
        """Axes of B in N."""
        (s, c), (sp, cp) = (np.sin(theta), np.cos(theta)), (np.sin(phi), np.cos(phi))
        return np.array([[c, 0, s], [sp * s, cp, -sp * c], [-cp * s, sp, cp * c]])

    def states(self, y):
        """The disc's states, with gamma = 0."""
        n = turned(y[9:], self.axis)
        phi, theta = np.arctan2(-n[1], n[2]), np.arcsin(n[0])
        b = self.frame(phi, theta)
        p, q, r = b.T @ y[6:9] / np.array([self.i_d, self.i_d, self.i_a])
        phidot = p / np.cos(theta)
        return np.concatenate([y[:3], b.T @ y[3:6], [phi, theta, 0, phidot, q, r - phidot * np.sin(theta)]])

    def f(self, y):
        x = self.states(y)
        dx, b, (s, c) = self.disc.f(x), self.frame(x[6], x[7]), (np.sin(x[7]), np.cos(x[7]))
        frame_rates = np.array([x[9] * c, x[10], x[9] * s])
        velocity = dx[3:6] + np.cross(frame_rates, x[3:6])
        momentum = np.array([self.i_d, self.i_d, self.i_a]) * [x[9] * c, x[10], x[9] * s + x[11]]
        growth = np.array([self.i_d * (dx[9] * c - x[9] * x[10] * s), self.i_d * dx[10]])
        growth = np.append(growth, self.i_a * (dx[9] * s + x[9] * x[10] * c + dx[11]))
        moment = growth + np.cross(frame_rates, momentum)
        return np.concatenate([dx[:3], b @ velocity, b @ moment, turning(y[9:], y[6:9] / self.i_d)])

    def restart(self, y):
        """Measures the turn from where the axis is."""
        self.axis = turned(y[9:], self.axis)
        return np.concatenate([y[:9], np.zeros(3)])


def fly_turning(disc, x, is_tsit5, tolerance):
    """As `fly`, by the Lie-group method."""
    body = Momenta(disc, x)
    y, scale = body.start, np.ones(12)
    # A moment of inertia turns an error of a rate into one of L.
    scale[6:9] = body.i_d
    rows, b, order = ([np.array(row) for row in TSIT5_A], TSIT5_B, 5) if is_tsit5 else ([dop853.A[i, :i] for i in range(12)], dop853.B, 8)
    stages, t, h, steps, rejected = len(b), 0.0, 0.002, 0, 0
    disc.calls, k = 0, np.zeros((len(b) + 1, 12))
    while t < DURATION - 1e-12:
        h = min(h, DURATION - t)
        k[0] = body.f(y)
        for i in range(1, stages):
            k[i] = body.f(y + h * (rows[i] @ k[:i]))
        end = y + h * (b @ k[:stages])
        k[stages] = body.f(end)
        allowed = tolerance * (scale + np.maximum(abs(y), abs(end)))
        if is_tsit5:
            error = h * np.sqrt(np.mean((TSIT5_E @ k / allowed) ** 2))
        else:
            five, three = (np.sum((e @ k / allowed) ** 2) for e in (dop853.E5, dop853.E3))
            error = h * five / np.sqrt(12 * (five + 0.01 * three)) if five > 0 else 0.0
        if error <= 1:
            t, y, steps = t + h, body.restart(end), steps + 1
        else:
            rejected += 1
        h *= min(6, max(0.2, 0.9 * max(error, 1e-10) ** (-1 / order)))
    return steps, rejected, disc.calls, body.states(y)


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
            # gamma does not act on anything and is left out.
            kept = np.arange(12) != 8
            for tolerance in (TOLERANCE, 0.1 * TOLERANCE):
                steps, rejected, calls, end = fly_turning(disc, x, is_tsit5, tolerance)
                error = np.max((abs(end - exact) / np.maximum(1, abs(exact)))[kept])
                factor = f"Lie group, at {tolerance:g}"
                rows.append(f"| {title} | {method} | {factor} | {steps} | {rejected} | {calls} | {error:.1e} |")
    return rows
