"""Shapes, inputs and mistakes in the arguments of the functions."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from typing import Any

import jax
import numpy as np
import pandas as pd
import pytest
import xarray as xr

from conftest import document, points
from hyzer.ir import IrError, read, to_casadi, to_jax, to_numpy, to_sympy

BALL = ("ball",)


def test_axes_before_the_last_are_broadcast() -> None:
    model, at = to_numpy(document(BALL)), points(BALL)
    x, p = at.x[:6].reshape(2, 3, 6), at.p[:3]
    dx = model.rhs(0.0, x, p)
    j, jp = model.jac(np.zeros((2, 1)), x, p)
    assert (dx.shape, j.shape, jp.shape) == ((2, 3, 6), (2, 3, 6, 6), (2, 3, 6, 11))
    one = model.rhs(0.0, x[1, 2], p[2])
    np.testing.assert_allclose(dx[1, 2], one, rtol=1e-14)
    assert model.rhs(0.0, x[:0], p).shape == (0, 3, 6)
    assert model.rhs(0.0, x[:1, :1], p[:1]).shape == (1, 1, 6)


@pytest.mark.parametrize("of", [to_numpy, to_jax])
def test_labelled_arrays_are_taken_by_name(of: Any) -> None:
    model, x = of(document(BALL)), np.array([0.0, 1.0, 2.0, 10.0, 3.0, -4.0])
    expected = model.rhs(0.0, x)
    series = pd.Series(x, index=model.states)
    frame = pd.DataFrame([x, 2 * x], columns=model.states)
    array = xr.DataArray([x], dims=("flight", "state"), coords={"state": list(model.states)})
    back = list(reversed(model.states))
    for given in (series, series[back], frame[back], array.sel(state=back)):
        found = np.atleast_2d(model.rhs(0.0, given))[0]
        np.testing.assert_array_equal(found, expected)
    np.testing.assert_array_equal(model.rhs(0.0, pd.Series(x)), expected)
    wrong = series.rename({model.states[0]: "other"})
    with pytest.raises(ValueError, match="x: found the labels other"):
        model.rhs(0.0, wrong)
    wind = pd.Series([1.0, 2.0, 3.0], index=["wind_z", "wind_y", "wind_x"])
    by_name = model.rhs(0.0, x, wind=wind)
    np.testing.assert_array_equal(by_name, model.rhs(0.0, x, wind=[3, 2, 1]))


@pytest.mark.parametrize("of", [to_numpy, to_jax])
def test_values_by_name_go_by_their_keys(of: Any) -> None:
    model, x = of(document(BALL)), np.array([0.0, 1.0, 2.0, 10.0, 3.0, -4.0])
    p = np.array(model.p0)
    p[model.parameters.index("C_D")] = 0.3
    expected = model.rhs(0.0, x, p)
    named = dict(reversed(list(zip(model.states, x, strict=True))))
    np.testing.assert_array_equal(model.rhs(0.0, named, {"C_D": 0.3}), expected)
    several = {**named, "vx": np.array([10.0, 11.0])}
    np.testing.assert_array_equal(model.rhs(0.0, several, {"C_D": 0.3})[0], expected)
    rows = [pd.Series(named), pd.Series(named).sort_index()]
    np.testing.assert_array_equal(model.rhs(0.0, rows, p), [expected, expected])
    with pytest.raises(ValueError, match="x: found the names x, expected x, y, z"):
        model.rhs(0.0, {"x": 0.0})
    with pytest.raises(ValueError, match="p: found the names C_DD, expected some of"):
        model.rhs(0.0, x, {"C_DD": 0.3})


def test_casadi_takes_labels() -> None:
    model = to_casadi(document(BALL))
    states = [state.name for state in model.ir.states]
    x = pd.Series([0.0, 1.0, 2.0, 10.0, 3.0, -4.0], index=states)
    expected = np.array(model.rhs(0, x.to_numpy(), model.p0))
    for given in (x, x[::-1], dict(x[::-1])):
        np.testing.assert_array_equal(np.array(model.rhs(0, given, model.p0)), expected)
        named = model.rhs(t=0, x=given, p={})["dx"]
        np.testing.assert_array_equal(np.array(named), expected)
    casadi = pytest.importorskip("casadi")
    symbol = casadi.MX.sym("x", 6)
    of_symbol = casadi.Function("f", [symbol], [model.rhs(0, symbol, model.p0)])
    np.testing.assert_array_equal(np.array(of_symbol(x.to_numpy())), expected)
    frame = pd.DataFrame([x, 2 * x])[states[::-1]]
    several = np.array(model.rhs(0, frame, model.p0))
    np.testing.assert_array_equal(several[:, :1], expected)
    with pytest.raises(ValueError, match="x: found the labels other"):
        model.rhs(0, x.rename({"x": "other"}), model.p0)
    copied = pickle.loads(pickle.dumps(model.rhs))
    np.testing.assert_array_equal(np.array(copied(0, x.to_numpy(), model.p0)), expected)


@pytest.mark.parametrize("of", [to_numpy, to_jax])
def test_an_input_replaces_its_components(of: Any) -> None:
    model, x = of(document(BALL)), [0, 0, 1, 10, 0, 0]
    at_rest = model.rhs(0.0, x, wind=[10, 0, 0])
    np.testing.assert_allclose(at_rest, [10, 0, 0, 0, 0, -9.81])
    p = np.array(model.p0)
    p[model.parameters.index("wind_x")] = 10
    np.testing.assert_array_equal(model.rhs(0.0, x, p), at_rest)
    assert model.rhs(0.0, x, wind=np.zeros((5, 3))).shape == (5, 6)


@pytest.mark.parametrize("of", [to_numpy, to_jax])
def test_mistakes_are_told(of: Any) -> None:
    model = of(document(BALL))
    with pytest.raises(ValueError, match=r"x: found an array of shape \(5,\), expected .*6.*vz"):
        model.rhs(0.0, np.zeros(5))
    with pytest.raises(ValueError, match="p: found an array of shape"):
        model.rhs(0.0, np.zeros(6), 1.0)
    with pytest.raises(ValueError, match="marker: found an array of shape"):
        model.observe(0.0, np.zeros(6), marker=np.zeros(2))
    with pytest.raises(TypeError, match="'wnd', expected one of: wind, omega"):
        model.rhs(0.0, np.zeros(6), wnd=np.zeros(3))


def test_a_model_without_observation_or_inputs_says_so() -> None:
    import conftest

    model = to_numpy(document((conftest.ZOO,)))
    with pytest.raises(ValueError, match="zoo has no observation"):
        model.observe(0.0, model.x0)
    with pytest.raises(TypeError, match="expected one of: none"):
        model.rhs(0.0, model.x0, wind=0)


def test_infinity_is_a_number() -> None:
    model = to_numpy(document(("disc",)))
    with np.errstate(all="ignore"):
        assert not np.isfinite(model.rhs(0.0, [1e300] * 12)).all()
        assert np.isnan(model.rhs(0.0, [np.nan] * 12)).any()


def test_singular_points_have_their_stated_values() -> None:
    model = to_jax(document(BALL))
    at_rest = np.zeros(6)
    np.testing.assert_array_equal(jax.jacfwd(model.rhs, 1)(0.0, at_rest)[3:, 3:], np.zeros((3, 3)))
    np.testing.assert_array_equal(model.jac(0.0, at_rest)[0][3:, 3:], np.zeros((3, 3)))


def test_kind_and_schema_are_checked() -> None:
    with pytest.raises(ValueError, match="kind: found 'DM'"):
        to_casadi(document(BALL), "DM")  # type: ignore[arg-type]
    for function in (read, to_numpy, to_jax, to_casadi, to_sympy):
        with pytest.raises(IrError, match=r"schema: found .hyzer[.]ir/2., expected"):
            function({**document(BALL), "schema": "hyzer.ir/2"})


def test_jax_of_32_bits_is_refused() -> None:
    jax.config.update("jax_enable_x64", False)
    try:
        with pytest.raises(RuntimeError, match="jax_enable_x64"):
            to_jax(document(BALL))
    finally:
        jax.config.update("jax_enable_x64", True)


@pytest.mark.parametrize("package", ["numpy", "jax", "casadi", "sympy"])
def test_a_package_is_imported_when_it_is_asked_for(package: str, tmp_path: Any) -> None:
    (tmp_path / f"{package}.py").write_text("raise ImportError('it is absent')")
    code = (
        f"import sys; sys.path[:0] = [{str(tmp_path)!r}]\n"
        f"sys.path += {sys.path!r}\n"
        "import json, hyzer.ir\n"
        "others = {'numpy', 'jax', 'casadi', 'sympy'} & set(sys.modules)\n"
        "assert not others, others\n"
        f"hyzer.ir.to_{package}(json.loads(sys.stdin.read()))"
    )
    command = [sys.executable, "-c", code]
    text = json.dumps(document(BALL))
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    assert f"hyzer.ir.to_{package} needs the package {package}" in done.stderr, done.stderr
    assert f"pip install {package}" in done.stderr
