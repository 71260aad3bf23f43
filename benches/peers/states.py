"""Random states and parameters of discs in flight, the same for every check and timing."""

import numpy as np

CENTRE_P = [0.175, 0.00235, 0.00122, 0.269, 0.057, 1.23, 9.7935,
            0.188, 2.37, 0.15, 1.24, -0.38, -0.005, -0.0004, -3.4e-5, 1.0, -1.5, 0.4]  # fmt: skip
REACH_X = [10, 10, 5, 15, 8, 4, 0.8, 0.8, 6.3, 8, 8, 60]


def draw(n, seed=1):
    """n rows of 12 states and 18 parameters."""
    rng = np.random.default_rng(seed)
    x = rng.uniform(-1, 1, (n, 12)) * REACH_X
    p = np.array(CENTRE_P) * rng.uniform(0.7, 1.3, (n, 18))
    return np.hstack([x, p])
