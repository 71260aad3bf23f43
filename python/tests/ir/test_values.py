"""Values and derivatives of each library against the tape, at 1,000 states."""

from __future__ import annotations

from typing import Any

import jax
import numpy as np
import pytest

from conftest import CASES, Points, document, entries, error, name_of, points
from hyzer.ir import to_jax, to_numpy

every_case = pytest.mark.parametrize("case", CASES, ids=name_of)


def outputs(model: Any, at: Points) -> dict[str, Any]:
    """Return the outputs of all functions, as the tape returns them."""
    j, jp = model.jac(at.t, at.x, at.p)
    found = {"dx": model.rhs(at.t, at.x, at.p)}
    found["j"] = entries(at.ir, "jacobian", "j", j)
    found["jp"] = entries(at.ir, "jacobian", "jp", jp)
    if at.expected["y"].size:
        found["y"] = model.observe(at.t, at.x, at.p, at.marker)
        names = ("dy_dx", "dy_dp", "dy_dmarker")
        derivatives = model.observe_jac(at.t, at.x, at.p, at.marker)
        for name, dense in zip(names, derivatives, strict=True):
            found[name] = entries(at.ir, "observe_jacobian", name, dense)
    quantities = model.quantities(at.t, at.x, at.p)
    found["q"] = np.stack([quantities[part.name] for part in at.ir.quantities], axis=-1)
    found["l"] = model.limits(at.t, at.x, at.p) + [limit.bound for limit in at.ir.limits]
    return found


def assert_agree(found: dict[str, Any], at: Points) -> None:
    for name, values in found.items():
        assert error(at.expected[name], values) <= 1e-12, name


@every_case
def test_numpy_agrees_with_the_tape(case: tuple[str, ...]) -> None:
    at = points(case)
    assert_agree(outputs(to_numpy(document(case)), at), at)


@every_case
def test_jax_agrees_with_the_tape(case: tuple[str, ...]) -> None:
    at = points(case)
    assert_agree(outputs(to_jax(document(case)), at), at)
