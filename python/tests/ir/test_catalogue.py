"""Every effect of the catalogue, on a model that it goes with."""

from __future__ import annotations

import subprocess

import numpy as np
import pytest

from conftest import ROOT, document, error, points, program
from hyzer.ir import to_numpy

EFFECTS = sorted(path.stem for path in (ROOT / "model-spec" / "effects").glob("*.hyz"))


@pytest.mark.parametrize("effect", EFFECTS)
def test_an_effect_is_exported_and_agrees_with_the_tape(effect: str) -> None:
    case = next(
        (model, effect)
        for model in ("disc", "disc_quaternion", "ball")
        if not subprocess.run(
            [program("--bin", "hyzer"), "export", model, "--ir", "--with", effect],
            capture_output=True,
            check=False,
        ).returncode
    )
    model, at = to_numpy(document(case)), points(case, 100)
    assert model.ir.effects == (effect,)
    assert error(at.expected["dx"], model.rhs(at.t, at.x, at.p)) <= 1e-12
    if at.expected["y"].size:
        assert error(at.expected["y"], model.observe(at.t, at.x, at.p, at.marker)) <= 1e-12


def test_names_units_and_defaults_are_those_of_the_model() -> None:
    ir = to_numpy(document(("ball",))).ir
    assert (ir.model, ir.effects) == ("ball", ())
    assert [(state.name, state.unit) for state in ir.states[2:4]] == [("z", "m"), ("vx", "m/s")]
    drag = next(parameter for parameter in ir.parameters if parameter.coefficient)
    assert (drag.name, drag.unit, drag.value, drag.bounds) == ("C_D", "1", 0.45, (0.0, 3.0))
    assert ir.inputs[0].parameters == ("wind_x", "wind_y", "wind_z")
    assert (ir.quantities[8].name, ir.quantities[8].unit) == ("V", "m/s")
    assert np.isclose(to_numpy(ir).quantities(0, [0, 0, 0, 3, 4, 0])["V"], 5)
