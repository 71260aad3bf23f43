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


class Counted(EOM):
    """Counts evaluations."""

    calls = 0

    def compute_derivatives(self, t, y):
        Counted.calls += 1
        return super().compute_derivatives(t, y)


class Groundless(EOM):
    """Without the stop below the ground, so that an event can find it; nothing else depends on z."""

    def compute_derivatives(self, t, y):
        return super().compute_derivatives(t, np.concatenate((y[:2], [1.0], y[3:])))


def fly(eom_class=EOM, **settings):
    """The default disc and release."""
    disc = Disc(eom_class=eom_class)
    return disc, disc.compute_trajectory(**settings)[1]


def landing():
    """Time and state at the ground, to ten digits."""
    ground = lambda t, y: y[2]
    ground.terminal = True
    _, result = fly(Groundless, flight_time=10.0, events=ground, rtol=1e-11, atol=1e-13)
    names = "x y z vx vy vz phi theta gamma dphi dtheta dgamma".split()
    return {"t": float(result.t_events[0][0]), **dict(zip(names, map(float, result.y_events[0][0])))}


def timed(repeats, note, **settings):
    Counted.calls = 0
    _, result = fly(Counted, **settings)
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        fly(**settings)
        times.append(1e3 * (time.perf_counter() - start))
    return {
        "note": note, "settings": settings, "ms_median": statistics.median(times), "ms_min": min(times),
        "evaluations": Counted.calls, "t_end": float(result.t[-1]), "end": [float(v) for v in result.y[:, -1]],
    }  # fmt: skip


def measure(repeats):
    disc, landed = Disc(), landing()
    end = landed["t"]
    return {
        "model": MODEL,
        "solver": "scipy solve_ivp, RK45, rtol 1e-3, atol 1e-6 unless set; 100 samples",
        "release_and_disc": {k: v for k, v in vars(disc).items() if isinstance(v, (int, float))},
        "coefficients": {k: float(v) for k, v in vars(disc.model).items()},
        "landing": landed,
        "defaults": timed(repeats, "everything default: flight_time 3 s, the derivative is zero below ground"),
        "to_landing": timed(repeats, "default tolerances, to the time it lands", flight_time=end),
        "to_landing_1e-6": timed(repeats, "to the time it lands", flight_time=end, rtol=1e-6, atol=1e-9),
        "to_landing_1e-9": timed(repeats, "to the time it lands", flight_time=end, rtol=1e-9, atol=1e-12),
    }


if __name__ == "__main__":
    import json

    print(json.dumps(measure(31)))
