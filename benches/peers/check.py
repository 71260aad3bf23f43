"""Do the peers' functions say the same, and is it mechanics?"""

import ctypes

import numpy as np

POINTER = ctypes.POINTER(ctypes.c_double)
TOLERANCE = 1e-12


def dense(function, rows, J, Jp):
    """f (n, 12), J (n, 12, 12), Jp (n, 12, 18) from a compiled function; what it does not give is zero."""
    size = 12 + len(J) + len(Jp)
    out = np.empty(size)
    f, j, jp = np.empty((len(rows), 12)), np.zeros((len(rows), 12, 12)), np.zeros((len(rows), 12, 18))
    rj, rp = np.array(J, int).reshape(-1, 2), np.array(Jp, int).reshape(-1, 2)
    for k, row in enumerate(np.ascontiguousarray(rows)):
        out[:] = np.nan
        x, p = row[:12].copy(), row[12:].copy()
        function(x.ctypes.data_as(POINTER), p.ctypes.data_as(POINTER), out.ctypes.data_as(POINTER))
        f[k] = out[:12]
        j[k][rj[:, 0], rj[:, 1]] = out[12 : 12 + len(J)]
        jp[k][rp[:, 0], rp[:, 1]] = out[12 + len(J) :]
    return f, j, jp


def worst(a, b, rows, scale):
    """Largest difference, each row of f, J and Jp scaled by that row's magnitude.

    A component of f is a sum that may cancel: its magnitude is that of its largest first-order share, |J x| or |Jp p|.
    """
    x, p = np.abs(rows[:, None, :12]), np.abs(rows[:, None, 12:])
    sj, sp = np.abs(scale[1]).max(2), np.abs(scale[2]).max(2)
    sf = np.maximum(np.abs(scale[0]), np.maximum((np.abs(scale[1]) * x).max(2), (np.abs(scale[2]) * p).max(2)))
    parts = [np.abs(a[0] - b[0]) / (sf + 1e-300)]
    parts += [np.abs(u - v).max(2) / (s + 1e-300) for u, v, s in zip(a[1:], b[1:], (sj, sp))]
    return [float(np.max(part)) for part in parts]


def loads(row):
    """Force and moment in N, from vectors alone."""
    x, p = row[:12], row[12:]
    m, _, _, d, A, rho, g, L0, La, D0, Da, Ma, Mq, Rr, Nr = p[:15]
    R = frame(x)
    air = R @ x[3:6] - p[15:]
    d3 = R[:, 2]
    flat = air - (air @ d3) * d3
    d1 = flat / np.linalg.norm(flat)
    d2 = np.cross(d3, d1)
    alpha = np.arctan2(-(air @ d3), air @ d1)
    q = rho * (air @ air) / 2 * A
    omega = R @ spin(x)
    stream = air / np.linalg.norm(air)
    F = q * (L0 + La * alpha) * np.cross(stream, d2) - q * (D0 + Da * alpha**2) * stream - [0, 0, m * g]
    r = omega @ d3
    M = q * d * ((Rr * r + Mq * (omega @ d1)) * d1 + (Ma * alpha + Mq * (omega @ d2)) * d2) + Nr * r * d3
    return F, M


def frame(x):
    s1, c1, s2, c2 = np.sin(x[6]), np.cos(x[6]), np.sin(x[7]), np.cos(x[7])
    return np.array([[c2, 0 * s1, s2], [s2 * s1, c1, -c2 * s1], [-s2 * c1, s1, c2 * c1]])


def spin(x):
    return np.array([x[9] * np.cos(x[7]), x[10], x[9] * np.sin(x[7]) + x[11]])


def mechanics(f, rows):
    """Worst relative miss of d(momentum)/dt = force and d(angular momentum)/dt = moment, by complex step along f."""
    miss = 0.0
    for rates, row in zip(f, rows):
        x, p, h = row[:12], row[12:], 1e-40
        z = x + 1j * h * rates
        R = frame(z)
        v, H = R @ z[3:6], R @ (np.array([p[2], p[2], p[1]]) * spin(z))
        F, M = loads(row)
        xdot = frame(x) @ x[3:6]
        for got, want in ((v.imag / h * p[0], F), (H.imag / h, M), (rates[:3], xdot), (rates[6:9], x[9:12])):
            miss = max(miss, np.abs(got - want).max() / np.abs(want).max())
    return float(miss)
