"""Each operation at ordinary and at singular points: value and derivatives, by each library."""

from __future__ import annotations

from math import atan, atan2, pi
from typing import Any

import casadi
import jax
import numpy as np
import pytest

from hyzer.ir import to_casadi, to_jax, to_numpy, to_sympy
from hyzer.ir._document import ARITY

A, B = "x0", "x1"
STATES = [{"name": name, "unit": "1", "value": 0.0} for name in ("a", "b")]
TABLE = {"name": "T", "knots": [0, 1], "cubics": [[1, 1, 0, 0], [1, 1, 1, 0], [4, 0, 0, 0]]}
SMOOTH = [3, 1, 0, 0, 2, 1, *[0] * 10]
CELLS = [[1, *[0] * 15], [2, *[0] * 15], [0, 0, 0, 0, 1, *[0] * 11], SMOOTH]
TABLE_OF_TWO = {"name": "U", "knots": [0], "second_knots": [1], "bicubics": CELLS}

POINTS: list[tuple[list[Any], tuple[float, float], float, tuple[float, float]]] = [
    (["neg", A], (2, 0), -2, (-1, 0)),
    (["recip", A], (2, 0), 0.5, (-0.25, 0)),
    (["recip_or_zero", A], (2, 0), 0.5, (-0.25, 0)),
    (["recip_or_zero", A], (0, 0), 0, (0, 0)),
    (["recip_or_zero", A], (1e-80, 0), 0, (0, 0)),
    (["nonzero", A], (2, 0), 1, (0, 0)),
    (["nonzero", A], (0, 0), 0, (0, 0)),
    (["nonzero", A], (-1e-80, 0), 0, (0, 0)),
    (["sign", A], (-2, 0), -1, (0, 0)),
    (["sign", A], (0, 0), 0, (0, 0)),
    (["sign", A], (2, 0), 1, (0, 0)),
    (["step", A], (0, 0), 0, (0, 0)),
    (["step", A], (2, 0), 1, (0, 0)),
    (["abs", A], (-2, 0), 2, (-1, 0)),
    (["abs", A], (0, 0), 0, (0, 0)),
    (["sqrt", A], (4, 0), 2, (0.25, 0)),
    (["sqrt", A], (0, 0), 0, (0, 0)),
    (["sqrt", A], (-1, 0), 0, (0, 0)),
    (["log", A], (2, 0), np.log(2), (0.5, 0)),
    (["log", A], (0, 0), 0, (0, 0)),
    (["log", A], (-1, 0), 0, (0, 0)),
    (["sin", A], (1, 0), np.sin(1), (np.cos(1), 0)),
    (["cos", A], (1, 0), np.cos(1), (-np.sin(1), 0)),
    (["exp", A], (1, 0), np.exp(1), (np.exp(1), 0)),
    (["tanh", A], (1, 0), np.tanh(1), (1 - np.tanh(1) ** 2, 0)),
    (["asin", A], (0.6, 0), np.arcsin(0.6), (1.25, 0)),
    (["asin", A], (1, 0), pi / 2, (0, 0)),
    (["asin", A], (-1, 0), -pi / 2, (0, 0)),
    (["asin", A], (2, 0), pi / 2, (0, 0)),
    (["asin", A], (-2, 0), -pi / 2, (0, 0)),
    (["atan2", A, B], (1, -2), atan2(1, -2), (-0.4, -0.2)),
    (["atan2", A, B], (0, -1), pi, (-1, 0)),
    (["atan2", A, B], (0, 0), 0, (0, 0)),
    (["atan2", A, 2], (1, 0), atan(0.5), (0.4, 0)),
    (["add", A, B], (2, 3), 5, (1, 1)),
    (["sub", A, B], (2, 3), -1, (1, -1)),
    (["mul", A, B], (2, 3), 6, (3, 2)),
    (["div", A, B], (3, 2), 1.5, (0.5, -0.75)),
    (["min", A, B], (1, 2), 1, (1, 0)),
    (["min", A, B], (1, 1), 1, (0, 1)),
    (["max", A, B], (1, 2), 2, (0, 1)),
    (["max", A, B], (1, 1), 1, (0, 1)),
    (["mul_add", A, B, 4], (2, 3), 10, (3, 2)),
    (["mul_sub", A, B, 4], (2, 3), 2, (3, 2)),
    (["neg_mul_add", A, B, 4], (2, 3), -2, (-3, -2)),
    (["if_zero", A, B, 4], (0, 3), 3, (0, 1)),
    (["if_zero", A, B, 4], (1e-80, 3), 3, (0, 1)),
    (["if_zero", A, B, 4], (1, 3), 4, (0, 0)),
    (["table", 0, A], (-1, 0), 0, (1, 0)),
    (["table", 0, A], (0, 0), 1, (1, 0)),
    (["table", 0, A], (0.5, 0), 1.75, (2, 0)),
    (["table", 0, A], (1, 0), 4, (0, 0)),
    (["table", 0, A], (5, 0), 4, (0, 0)),
    (["table_of_two", 1, A, B], (-1, 0), 1, (0, 0)),
    (["table_of_two", 1, A, B], (-1, 1), 2, (0, 0)),
    (["table_of_two", 1, A, B], (2, 0), 2, (1, 0)),
    (["table_of_two", 1, A, B], (2, 3), 13, (4, 3)),
]
every_point = pytest.mark.parametrize(("statement", "x", "value", "slopes"), POINTS)


def model_of(statement: list[Any]) -> dict[str, Any]:
    """Return a model with two states; the derivative of the first is the statement."""

    def function(statements: list[Any], **outputs: Any) -> dict[str, Any]:
        parts = [{"name": name, **output} for name, output in outputs.items()]
        return {"inputs": ["x"] if statements else [], "statements": statements, "outputs": parts}

    def zero(*shape: int) -> dict[str, Any]:
        return {"shape": list(shape), "values": [0.0] * shape[0] if len(shape) == 1 else []}

    def matrix(*shape: int) -> dict[str, Any]:
        return {**zero(*shape), "entries": []}

    names = ("schema", "version", "model")
    lists = ("effects", "parameters", "inputs", "marker", "quantities", "limits")
    empty: dict[str, list[Any]] = {name: [] for name in lists}
    jacobians = {"dy_dx": matrix(0, 2), "dy_dp": matrix(0, 0), "dy_dmarker": matrix(0, 0)}
    functions = {
        "prepare": function([], prepared=zero(0)),
        "rhs": function([statement], dx={"shape": [2], "values": ["s0", 0.0]}),
        "jacobian": function([], dx=zero(2), j=matrix(2, 2), jp=matrix(2, 0)),
        "observe": function([], y=zero(0)),
        "observe_jacobian": function([], y=zero(0), **jacobians),
        "quantities": function([], q=zero(0)),
        "limits": function([], l=zero(0)),
    }
    head = dict(zip(names, ("hyzer.ir/1", "0", "operation"), strict=True))
    return {
        **head,
        **empty,
        "states": STATES,
        "tables": [TABLE, TABLE_OF_TWO],
        "functions": functions,
    }


def test_every_operation_is_among_the_points() -> None:
    assert {statement[0] for statement, *_ in POINTS} == set(ARITY)


@every_point
def test_numpy(statement: list[Any], x: Any, value: float, slopes: Any) -> None:
    model = to_numpy(model_of(statement))
    assert model.rhs(0.0, x)[0] == pytest.approx(value, rel=1e-15, abs=0)
    np.testing.assert_allclose(model.rhs(0.0, [x, x])[:, 0], value, rtol=1e-15)


@every_point
def test_jax(statement: list[Any], x: Any, value: float, slopes: Any) -> None:
    model, x = to_jax(model_of(statement)), np.array(x, dtype=float)
    np.testing.assert_allclose(model.rhs(0.0, x)[0], value, rtol=1e-15)
    np.testing.assert_allclose(jax.jacfwd(model.rhs, 1)(0.0, x)[0], slopes, rtol=1e-14)
    np.testing.assert_allclose(jax.jacrev(model.rhs, 1)(0.0, x)[0], slopes, rtol=1e-14)


@every_point
@pytest.mark.parametrize("kind", ["SX", "MX"])
def test_casadi(statement: list[Any], x: Any, value: float, slopes: Any, kind: Any) -> None:
    model = to_casadi(model_of(statement), kind)
    symbol = casadi.MX.sym("x", 2)
    result = model.rhs(0, symbol, [])[0]
    function = casadi.Function("f", [symbol], [result, casadi.jacobian(result, symbol)])
    found, gradient = (np.array(part).ravel() for part in function(x))
    np.testing.assert_allclose(found, [value], rtol=1e-15)
    np.testing.assert_allclose(gradient, slopes, rtol=1e-14)


@every_point
def test_sympy(statement: list[Any], x: Any, value: float, slopes: Any) -> None:
    if 0 < abs(x[0]) < 1e-75:
        pytest.skip("what is negligible is 0 in SymPy")
    model = to_sympy(model_of(statement))
    at = dict(zip((model.symbols["a"], model.symbols["b"]), x, strict=True))
    assert float(model.rhs["a"].subs(at)) == pytest.approx(value, rel=1e-14, abs=1e-15)
