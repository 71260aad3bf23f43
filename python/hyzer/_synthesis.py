"""Datasets made of simulated flights."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from hyzer import _hyzer
from hyzer._arguments import mapping
from hyzer._dataset import Dataset
from hyzer._model import Model, model_of
from hyzer._release import Release

if TYPE_CHECKING:
    from hyzer._analyses import AnyModel, AnyRelease


def synthesize(
    model: AnyModel,
    releases: AnyRelease | Sequence[AnyRelease],
    *,
    flights: int = 8,
    held_out: int = 0,
    spread: float = 0.1,
    duration: float | None = None,
    rate: float = 120.0,
    markers: Mapping[str, Iterable[float]] | None = None,
    noise_sigma: float = 0.0015,
    noise_ar1: float = 0.0,
    outliers: float = 0.0,
    outlier_size: float = 0.05,
    dropouts: float = 0.0,
    seed: int = 1,
) -> Dataset:
    """Make a dataset: simulate releases of a model, observe its markers, add noise.

    Parameters
    ----------
    model : str, path or Model
        The model.
    releases : release or sequence of releases
        Flown in turn, as in `Model.fly`.
    flights, held_out : int
        Number of flights, and of those that are held out, the last ones.
    spread : float
        Standard deviation of the initial states but the position, as a fraction.
    duration : float, optional
        Duration of each flight, s; by default that of its release.
    rate : float
        Samples per second.
    markers : mapping of str to sequence of 3 floats, optional
        Positions of the markers in the body frame, m.
    noise_sigma, noise_ar1 : float
        Standard deviation of the noise along each axis, m, and its lag-1 autocorrelation.
    outliers, outlier_size, dropouts : float
        Fraction of outliers, their standard deviation, m, and fraction of missing points.
    seed : int
        Seed of all random numbers.

    Returns
    -------
    Dataset

    Examples
    --------
    >>> import hyzer
    >>> data = hyzer.synthesize("disc", "backhand", flights=3, duration=0.5)
    >>> len(data), hyzer.fit(data, "disc").coefficients.C_D0.unit
    (3, '1')
    """
    of = model_of(model) or Model("disc")
    texts = [release.texts(of.name) for release in Release.several(releases)]
    asked = {
        "flights": flights,
        "held_out": held_out,
        "spread": spread,
        "duration": duration,
        "rate": rate,
        "markers": [(name, list(at)) for name, at in mapping(markers, "markers").items()],
        "noise_sigma": noise_sigma,
        "noise_ar1": noise_ar1,
        "outliers": outliers,
        "outlier_size": outlier_size,
        "dropouts": dropouts,
        "seed": seed,
    }
    return Dataset(_hyzer.synthesize(of, texts, asked))
