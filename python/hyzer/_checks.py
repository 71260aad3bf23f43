"""Verification of models, and what a change of a model changes."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, cast

from hyzer import _hyzer
from hyzer._analyses import Report
from hyzer._model import model_of
from hyzer._release import Release

if TYPE_CHECKING:
    from hyzer._analyses import AnyModel, AnyRelease


class Verification(Report):
    """Result of the independent checks of a model. Attributes are the keys of its JSON.

    Attributes
    ----------
    outcome : str
        `verified`, `not_verified` or `refuted`.
    rows : Rows
        Each check with its verdict.
    """

    _shown = "rows"


class Difference(Report):
    """What a change of a model changes. Attributes are the keys of its JSON.

    Attributes
    ----------
    changed : bool
        Whether any derivative, observation or limit is another function.
    rows : Rows
        Each row with what differs.
    """

    _shown = "rows"

    def _about(self) -> str:
        models = self["models"]
        return f"{models['old']} and {models['new']}"


def verify(
    model: AnyModel, *, cases: int = 200, seed: int = 1, mutants: bool = False
) -> Verification:
    """Run every independent check of a model against a reference implementation.

    Parameters
    ----------
    model : str, path or Model
        The model.
    cases : int
        Number of random points of each check.
    seed : int
        Seed of the points.
    mutants : bool
        Also count the mutants of the model that the checks refuse.

    Returns
    -------
    Verification

    Examples
    --------
    >>> import hyzer
    >>> hyzer.verify("ball", cases=20).outcome
    'verified'
    """
    of = cast(_hyzer.Model, model_of(model))
    return Verification(_hyzer.verify(of, cases, seed, mutants))


def diff(
    old: AnyModel, new: AnyModel, *, releases: AnyRelease | Iterable[AnyRelease] = ()
) -> Difference:
    """Compare two models: statements, derivatives (exactly), operation counts, landings.

    Parameters
    ----------
    old, new : str, path or Model
        The models; those given by name, path or text may have units that disagree.
    releases : release or iterable of releases
        Flown with both, as in `Model.fly`.

    Returns
    -------
    Difference

    Examples
    --------
    >>> import hyzer
    >>> hyzer.diff("disc", hyzer.Model("disc", effects=["wind"])).changed
    True
    """
    models = [m if isinstance(m, _hyzer.Model) else os.fspath(m) for m in (old, new)]
    name = old.name if isinstance(old, _hyzer.Model) else "disc"
    texts = [release.texts(name) for release in Release.several(releases)]
    return Difference(_hyzer.diff(models[0], models[1], texts))
