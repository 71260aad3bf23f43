"""pysindy: sequentially thresholded least squares on the terms of one equation, its left side given as the derivative."""

import logging
import warnings

import numpy as np
import pysindy

warnings.filterwarnings("ignore")
logging.disable(logging.WARNING)

# Thresholds on columns of length 1 against a left side of length 1, and the ridge parameter: none, and the package's default.
SETTINGS = [(float(threshold), alpha) for alpha in (0.0, 0.05) for threshold in np.geomspace(0.02, 5.0, 21)]


def without(columns, left, given):
    """Both with the given columns projected out, so that least squares on what is left has them in it."""
    if not given:
        return columns, left
    basis, _ = np.linalg.qr(columns[:, given])
    take = lambda x: x - basis @ (basis.T @ x)
    return take(columns), take(left)


def prepared(columns, left, given):
    """Columns and left side of length 1, as the triangle that gives the same least squares; those given are projected out, and left out."""
    rest = [c for c in range(columns.shape[1]) if c not in given]
    columns, left = without(columns, left, list(given))
    columns, scale = columns[:, rest], np.linalg.norm(columns[:, rest], axis=0)
    basis, triangle = np.linalg.qr(columns / scale)
    return rest, triangle, basis.T @ left / np.linalg.norm(left)


def select(ready, setting):
    """Columns that pysindy keeps."""
    rest, columns, left = ready
    threshold, alpha = setting
    found = pysindy.STLSQ(threshold=threshold, alpha=alpha).fit(columns, left[:, None])
    return [rest[c] for c in np.flatnonzero(found.coef_[0])]
