"""Values and derivatives of each library against the tape, at 1,000 states."""

from __future__ import annotations

from typing import Any

import casadi
import jax
import numpy as np
import pytest
import sympy

from conftest import CASES, Points, document, entries, error, name_of, points
from hyzer.ir import to_casadi, to_jax, to_numpy, to_sympy

every_case = pytest.mark.parametrize("case", CASES, ids=name_of)

differentiated = pytest.mark.parametrize(
    "case", [CASES[0], CASES[1], CASES[3], CASES[-1]], ids=name_of
)


def outputs(model: Any, at: Points, compiled: Any = lambda function: function) -> dict[str, Any]:
    """Return the outputs of all functions, as the tape returns them."""
    point = at.t, at.x, at.p
    j, jp = compiled(model.jac)(*point)
    found = {"dx": compiled(model.rhs)(*point)}
    found["j"] = entries(at.ir, "jacobian", "j", j)
    found["jp"] = entries(at.ir, "jacobian", "jp", jp)
    if at.expected["y"].size:
        found["y"] = compiled(model.observe)(*point, at.marker)
        names = ("dy_dx", "dy_dp", "dy_dmarker")
        derivatives = compiled(model.observe_jac)(*point, at.marker)
        for name, dense in zip(names, derivatives, strict=True):
            found[name] = entries(at.ir, "observe_jacobian", name, dense)
    quantities = compiled(model.quantities)(*point)
    found["q"] = np.stack([quantities[part.name] for part in at.ir.quantities], axis=-1)
    bounds = [limit.bound for limit in at.ir.limits]
    found["l"] = np.asarray(compiled(model.limits)(*point)) + bounds
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
    assert_agree(outputs(to_jax(document(case)), at, jax.jit), at)


@every_case
@pytest.mark.parametrize("kind", ["SX", "MX"])
def test_casadi_agrees_with_the_tape(case: tuple[str, ...], kind: Any) -> None:
    at, model = points(case), to_casadi(document(case), kind)
    arguments = at.t[None], at.x.T, at.p.T
    j, jp = (by_state(matrix, len(at.t)) for matrix in model.jac(*arguments))
    found = {"dx": np.array(model.rhs(*arguments)).T}
    found["j"] = entries(at.ir, "jacobian", "j", j)
    found["jp"] = entries(at.ir, "jacobian", "jp", jp)
    found["y"] = np.array(model.observe(*arguments, at.marker.T)).T.reshape(at.expected["y"].shape)
    found["q"] = np.array(model.quantities(*arguments)).T
    bounds = [limit.bound for limit in at.ir.limits]
    found["l"] = np.array(model.limits(*arguments)).T.reshape(len(at.t), -1) + bounds
    assert_agree(found, at)


def by_state(matrix: Any, states: int) -> Any:
    """Return the matrices that CasADi returns side by side, one per state."""
    return np.stack(np.split(np.array(matrix), states, axis=1))


@every_case
def test_sympy_agrees_with_the_tape(case: tuple[str, ...]) -> None:
    at, model = points(case), to_sympy(document(case))
    columns = [at.t, *at.x.T, *at.p.T, *at.marker.T]

    def values(expressions: Any) -> Any:
        function = sympy.lambdify([*model.symbols.values()], [*expressions], cse=True)
        rows = [np.broadcast_to(row, at.t.shape) for row in function(*columns)]
        return np.array(rows).reshape(-1, len(at.t)).T

    with np.errstate(all="ignore"):  # NumPy evaluates all pieces.
        found = {"dx": values(model.rhs.values()), "y": values(model.observe.values())}
        for name, matrix in zip(("j", "jp"), model.jac, strict=True):
            (output,) = [o for o in at.ir.functions["jacobian"].outputs if o.name == name]
            found[name] = values([matrix[place] for place in output.entries or ()])
        found["q"] = values(model.quantities.values())
        found["l"] = values(model.limits.values()) + [limit.bound for limit in at.ir.limits]
    assert_agree(found, at)


@differentiated
def test_derivatives_by_jax_are_those_of_the_model(case: tuple[str, ...]) -> None:
    at, model = points(case), to_jax(document(case))
    j, jp = jax.jit(model.jac)(at.t, at.x, at.p)
    by_x = jax.jit(jax.vmap(jax.jacfwd(model.rhs, argnums=1)))(at.t, at.x, at.p)
    by_p = jax.jit(jax.vmap(jax.jacrev(model.rhs, argnums=2)))(at.t, at.x, at.p)
    rows = len(at.t)
    assert error(np.reshape(j, (rows, -1)), np.reshape(by_x, (rows, -1))) < 1e-11
    assert error(np.reshape(jp, (rows, -1)), np.reshape(by_p, (rows, -1))) < 1e-11


@differentiated
def test_second_derivatives_by_casadi_are_those_by_jax(case: tuple[str, ...]) -> None:
    at, model, other = points(case, 20), to_casadi(document(case)), to_jax(document(case))
    weights = np.linspace(1, 2, len(model.x0))
    t, x, p = (
        casadi.SX.sym("t"),
        casadi.SX.sym("x", len(model.x0)),
        casadi.SX.sym("p", len(model.p0)),
    )
    hessian = casadi.Function(
        "h", [t, x, p], [casadi.hessian(casadi.dot(weights, model.rhs(t, x, p)), x)[0]]
    )
    second = jax.jit(jax.vmap(jax.hessian(lambda *a: weights @ other.rhs(*a), argnums=1)))
    expected = np.asarray(second(at.t, at.x, at.p))
    found = np.array([np.array(hessian(*row)) for row in zip(at.t, at.x, at.p, strict=True)])
    assert error(expected.reshape(20, -1), found.reshape(20, -1)) < 1e-10
