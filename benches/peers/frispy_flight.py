"""FrisPy 2.0.2: what it flies, how, and how long that takes."""

import statistics
import time

import numpy as np
from frispy.disc import Disc
from frispy.equations_of_motion import EOM

MODEL = {
    "position": "x y z in the inertial frame, z up, m",
    "velocity": "vx vy vz in the inertial frame (not in B), m/s; no wind",
    "attitude": "phi theta gamma, 1-2-3: the same frames A, B as hyzer's; rows of its matrix are b1 b2 b3 in N",
    "axes": "zhat = b3, xhat = unit of the velocity's part in the disc's plane, yhat = zhat x xhat: hyzer's d3 d1 d2",
    "alpha": "-atan(v.zhat / |v in plane|): hyzer's alpha",
    "lift": "(PL0 + PLa alpha) rho A V^2/2 along vhat x yhat",
    "drag": "(PD0 + PDa (alpha - alpha_0)^2) rho A V^2/2 against vhat",
    "moments": {
        "x": "(PTxwx w.xhat + PTxwz w.zhat) rho A d V^2/2 about xhat",
        "y": "(PTy0 + PTywy w.yhat + PTya alpha) rho A d V^2/2 about yhat",
        "z": "PTzwz w.zhat rho A d V^2/2 about b3 (with dynamic pressure, unlike C_Nr)",
    },
    "angular_velocity": "(dphi cos theta, dtheta, dphi sin theta + dgamma) in B, as hyzer's",
    "angular_acceleration": "ddphi, ddtheta, ddgamma are set to the B components of the moment, in N m: the source does not"
    " divide by I_xx or I_zz, has no gyroscopic terms and no terms of the Euler rates; I_xx and I_zz are not used at all",
    "ground": "no event: where z <= 0 every derivative is 0, and the integration goes on to flight_time",
    "diameter": "2 sqrt(A / pi)",
}


def flight(calls=None, **settings):
    """The default disc and release; with `calls`, counts evaluations of its equations."""
    disc = Disc()
    if calls is not None:
        class Counted(EOM):
            def compute_derivatives(self, t, y):
                calls.append(t)
                return super().compute_derivatives(t, y)

        disc.eom_class = Counted
    return disc, *disc.compute_trajectory(**settings)


def landed(disc, result):
    """Time and state at the ground, between its samples; None where it never lands."""
    z = result.y[2]
    below = np.flatnonzero(z <= 0)
    if not len(below):
        return None
    k = int(below[0])
    share = z[k - 1] / (z[k - 1] - z[k])
    between = lambda a: float(a[k - 1] + share * (a[k] - a[k - 1]))
    names = "x y z vx vy vz phi theta gamma dphi dtheta dgamma".split()
    return {"t": between(result.t), **{n: between(row) for n, row in zip(names, result.y)}}


def timed(repeats, note, **settings):
    calls = []
    disc, _, result = flight(calls, **settings)
    landing = landed(disc, result)
    inputs = {k: v for k, v in vars(disc).items() if isinstance(v, (int, float))}
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        flight(**settings)
        times.append(1e3 * (time.perf_counter() - start))
    return {
        "note": note,
        "settings": {k: v if np.isscalar(v) else list(map(float, v)) for k, v in settings.items()},
        "ms_median": statistics.median(times), "ms_min": min(times),
        "evaluations": len(calls), "solver_message": result.message,
        "landing": landing, "end": [float(v) for v in result.y[:, -1]], "t_end": float(result.t[-1]),
        "release_and_disc": inputs, "coefficients": {k: float(v) for k, v in vars(disc.model).items()},
    }  # fmt: skip


def measure(repeats):
    free = timed(1, "to learn when it lands", flight_time=10.0, n_times=1001, max_step=0.01, rtol=1e-9, atol=1e-12)
    end = free["landing"]["t"]
    return {
        "model": MODEL,
        "solver": "scipy solve_ivp, RK45, rtol 1e-3, atol 1e-6 unless set; 100 samples",
        "defaults": timed(repeats, "everything default: flight_time 3 s, the derivative is zero below ground"),
        "to_landing": timed(repeats, "default tolerances, to the time it lands", flight_time=end),
        "to_landing_1e-6": timed(repeats, "rtol 1e-6, atol 1e-9, to the time it lands", flight_time=end, rtol=1e-6, atol=1e-9),
        "to_landing_1e-9": timed(repeats, "rtol 1e-9, atol 1e-12, to the time it lands", flight_time=end, rtol=1e-9, atol=1e-12),
    }
