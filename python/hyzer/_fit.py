"""Fits and diagnoses."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any

from hyzer import _hyzer
from hyzer._arguments import mapping, names
from hyzer._dataset import Dataset, dataset_of
from hyzer._errors import InputError
from hyzer._model import model_of
from hyzer._progress import Progress, Watching
from hyzer._results import Diagnosis, Fit


def options(
    fixed: Mapping[str, float | None] | Iterable[str] | str = (),
    free: Iterable[str] | str = (),
    priors: Mapping[str, tuple[float, float]] | None = None,
    profiles: Iterable[str] | str = (),
    *,
    unbounded: bool = False,
    trust_data: bool = False,
    threads: int | None = None,
    max_seconds: float | None = None,
) -> dict[str, Any]:
    """Return the options of a fit as the compiled part takes them."""
    held: dict[str, float | None]
    held = mapping(fixed, "fixed") if hasattr(fixed, "items") else dict.fromkeys(names(fixed))
    return {
        "fixed": list(held.items()),
        "free": names(free),
        "priors": [_prior(name, prior) for name, prior in mapping(priors, "priors").items()],
        "profiles": names(profiles),
        "unbounded": unbounded,
        "trust_data": trust_data,
        "threads": threads,
        "max_seconds": max_seconds,
    }


def _prior(name: str, prior: Any) -> tuple[str, Any, Any]:
    parts: list[Any] = (
        [] if isinstance(prior, str) or not hasattr(prior, "__len__") else list(prior)
    )
    if len(parts) != 2:
        raise InputError(
            f"priors: found {prior!r} for {name}, expected a mean and a standard deviation: "
            f"priors={{{name!r}: (mean, sigma)}}"
        )
    return name, *parts


def fit(
    data: str | os.PathLike[str] | Dataset,
    model: str | os.PathLike[str] | _hyzer.Model | None = None,
    *,
    fixed: Mapping[str, float | None] | Iterable[str] | str = (),
    free: Iterable[str] | str = (),
    priors: Mapping[str, tuple[float, float]] | None = None,
    profiles: Iterable[str] | str = (),
    unbounded: bool = False,
    trust_data: bool = False,
    threads: int | None = None,
    max_seconds: float | None = None,
    progress: Progress | bool | None = None,
) -> Fit:
    """Estimate the coefficients of a model from measured flights, with their uncertainty.

    Parameters
    ----------
    data : str, path or Dataset
        A dataset, or its folder.
    model : str, path or Model, optional
        The model; by default that of the dataset.
    fixed : mapping of str to float or None, iterable of str, or str
        Coefficients that are not estimated, with their values, SI; by default those of the model.
    free : iterable of str, or str
        Parameters or components of inputs (`wind_x`) that are estimated beside the coefficients,
        one value for all flights. To estimate one coefficient alone, hold the others by `fixed`.
    priors : mapping of str to (float, float)
        Gaussian priors: mean and standard deviation, SI.
    profiles : iterable of str, or str
        Coefficients whose profile likelihood is computed.
    unbounded : bool
        Ignore the bounds of the model.
    trust_data : bool
        Also use flights whose data seem faulty.
    threads : int, optional
        Number of threads, at most four times that of the processors, which is the bound of a
        larger one; the result does not depend on it.
    max_seconds : float, optional
        Stop after this time with the best estimates so far.
    progress : callable, bool or None
        Called with stage, number done and total. By default a bar in terminals and notebooks;
        `False` for none. An exception of the function cancels the fit.

    Returns
    -------
    Fit

    Raises
    ------
    InputError
        If the dataset or an option is wrong.
    FitError
        If the model cannot be fitted to the flights.
    Cancelled
        After Ctrl-C.

    Examples
    --------
    >>> import hyzer
    >>> fit = hyzer.fit("examples/ball", priors={"C_D": (0.45, 0.1)})
    >>> fit.coefficients.C_D.std_error < 0.1
    True
    >>> fit.fitted.fly("serve", until="ground").ended_by
    'ground'
    """
    asked = options(
        fixed,
        free,
        priors,
        profiles,
        unbounded=unbounded,
        trust_data=trust_data,
        threads=threads,
        max_seconds=max_seconds,
    )
    with Watching(progress) as watch:
        return Fit(_hyzer.fit(dataset_of(data), model_of(model), asked, watch))


def diagnose(
    data: str | os.PathLike[str] | Dataset,
    model: str | os.PathLike[str] | _hyzer.Model | None = None,
    *,
    without: Iterable[str] | str = (),
    fixed: Mapping[str, float | None] | Iterable[str] | str = (),
    free: Iterable[str] | str = (),
    priors: Mapping[str, tuple[float, float]] | None = None,
    trust_data: bool = False,
    threads: int | None = None,
    max_seconds: float | None = None,
    progress: Progress | bool | None = None,
) -> Diagnosis:
    """Test a model for missing effects with measured flights, extend it, and measure the gain.

    Parameters
    ----------
    data : str, path or Dataset
        A dataset, or its folder.
    model : str, path or Model, optional
        The model; by default that of the dataset.
    without : iterable of str, or str
        Effects that are not tested.
    fixed, free, priors, trust_data, threads, max_seconds, progress
        As in `fit`.

    Returns
    -------
    Diagnosis

    Raises
    ------
    InputError, FitError, Cancelled
        As in `fit`.

    Examples
    --------
    >>> import hyzer
    >>> found = hyzer.diagnose("examples/mystery", threads=2)
    >>> found.causes
    ['stall']
    >>> found.extended.effects
    ()
    """
    asked = options(
        fixed, free, priors, trust_data=trust_data, threads=threads, max_seconds=max_seconds
    )
    with Watching(progress) as watch:
        native = _hyzer.diagnose(dataset_of(data), model_of(model), asked, names(without), watch)
        return Diagnosis(native)
