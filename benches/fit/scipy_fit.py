"""scipy's least_squares with its own compiled right-hand side; every setting that might be the fastest."""

import time

import numpy as np
import scipy.sparse as sparse
from scipy.optimize import least_squares

import flights
from native import NC, NX, WIDTH

# Substeps of a sample's interval: 100 rad/s are followed to a thousandth of the noise.
SUBSTEPS = 2
# A step that takes no more than this part of the sum of squares is the last: a twentieth of a standard error at most.
TOLERANCE = 1e-6
WAYS = {
    "trf, exact Jacobian, sparse, lsmr": dict(method="trf", tr_solver="lsmr", layout="sparse"),
    "trf, exact Jacobian, dense, SVD": dict(method="trf", tr_solver="exact", layout="dense"),
    "dogbox, exact Jacobian, dense": dict(method="dogbox", tr_solver="exact", layout="dense"),
    "dogbox, exact Jacobian, sparse, lsmr": dict(method="dogbox", tr_solver="lsmr", layout="sparse"),
    "lm (MINPACK), exact Jacobian, dense": dict(method="lm", layout="dense"),
    "trf, 2-point Jacobian by its sparsity, lsmr": dict(method="trf", tr_solver="lsmr", layout="2-point"),
}


class TooLong(Exception):
    """A way that is far from the fastest."""


class Problem:
    """Unknowns: the coefficients, then each flight's initial state; all in units of `scale`, so that they are of one size."""

    def __init__(self, lib, data, start, scale):
        self.lib, self.data, self.start, self.scale = lib, data, start, scale
        self.until = np.inf
        flights_, rows = len(data.seen), data.seen[0].size
        self.shape = rows * flights_, NC + NX * flights_
        own = NC + NX * np.arange(flights_)[:, None] + np.arange(NX)
        columns = np.concatenate([np.tile(np.arange(NC), (flights_, 1)), own], axis=1)
        self.indices = np.repeat(columns, rows, axis=0).ravel().astype(np.int32)
        self.indptr = np.arange(0, self.indices.size + 1, WIDTH, dtype=np.int32)
        self.places = np.repeat(np.arange(self.shape[0]), WIDTH) * self.shape[1] + self.indices
        self.full = np.zeros(self.shape)
        self.weigh(np.ones(3))

    def split(self, z):
        if time.perf_counter() > self.until:
            raise TooLong
        x = z * self.scale
        return flights.parameters(x[:NC]), x[NC:].reshape(-1, NX)

    def weigh(self, weights):
        """Lets the axes count by these weights."""
        each = np.tile(weights, self.shape[0] // 3)[:, None]
        self.weights, self.row_scale = each.ravel(), self.scale[self.indices].reshape(-1, WIDTH) * each

    def residuals(self, z):
        return self.lib.residuals(*self.split(z), self.data, SUBSTEPS) * self.weights

    def sparse(self, z):
        values = self.lib.jacobian(*self.split(z), self.data, SUBSTEPS)[1] * self.row_scale
        return sparse.csr_matrix((values.ravel(), self.indices, self.indptr), self.shape)

    def dense(self, z):
        values = self.lib.jacobian(*self.split(z), self.data, SUBSTEPS)[1] * self.row_scale
        # One array for all, since its zeros stay; scipy is done with a Jacobian when it asks for the next.
        self.full.ravel()[self.places] = values.ravel()
        return self.full


def fit(problem, way, longest=np.inf, begin=None):
    """The unknowns where it ends, and how often residuals and Jacobian were computed; given up after so many seconds."""
    problem.until = time.perf_counter() + longest
    settings = dict(WAYS[way])
    layout = settings.pop("layout")
    if layout == "2-point":
        ones = np.ones(problem.indices.size)
        settings["jac_sparsity"] = sparse.csr_matrix((ones, problem.indices, problem.indptr), problem.shape)
    else:
        settings["jac"] = problem.sparse if layout == "sparse" else problem.dense
    settings["ftol"] = TOLERANCE
    # Unknowns of one size leave nothing to scale. They are not counted from the start: from 0 scipy's first trust region would be
    # one standard error wide.
    found = least_squares(problem.residuals, (problem.start if begin is None else begin) / problem.scale, **settings)
    return found.x * problem.scale, f"{found.nfev} residuals, {found.njev} Jacobians"
