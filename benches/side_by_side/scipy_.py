import sys
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

M, S, RHO, G = 0.005, 28e-4, 1.2, 9.81


def rhs(t, x, drag):
    v = x[3:]
    a = -RHO * S * drag / (2 * M) * np.linalg.norm(v) * v
    return np.concatenate([v, a - [0, 0, G]])


def ground(t, x, drag):
    return x[2]


ground.terminal = True
speed = 25 * np.sqrt(0.5)
flight = solve_ivp(rhs, (0, 10), [0, 0, 1.2, speed, 0, speed], args=(0.64,), events=ground, rtol=1e-9)
print("landing", flight.y[0, -1])

flights = [np.genfromtxt(f, delimiter=",", names=True) for f in sorted(Path(sys.argv[1]).glob("*.csv"))[:6]]
flights = [(f["t"], np.stack([f["cork_x"], f["cork_y"], f["cork_z"]])) for f in flights]


def residuals(p):
    parts = []
    for k, (t, seen) in enumerate(flights):
        x0 = p[1 + 6 * k : 7 + 6 * k]
        flown = solve_ivp(rhs, (t[0], t[-1]), x0, args=(p[0],), t_eval=t, rtol=1e-8, atol=1e-8)
        parts.append((seen - flown.y[:3]).ravel())
    return np.concatenate(parts)


start = [0.6]
for t, seen in flights:
    start += [*seen[:, 0], *((seen[:, 3] - seen[:, 0]) / (t[3] - t[0]))]
fit = least_squares(residuals, start)
rms = np.sqrt(np.mean(fit.fun**2))
error = rms * np.sqrt(np.linalg.inv(fit.jac.T @ fit.jac)[0, 0])
print("C_D", fit.x[0], error)
print(f"tells RMS residual {1000 * rms:.1f} mm")
