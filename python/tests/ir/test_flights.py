"""Flights of 3 s, and their gradients, by other solvers against those of hyzer."""

from __future__ import annotations

import csv
import subprocess
from pathlib import Path
from typing import Any

import casadi
import diffrax
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from conftest import document, hyzer, program
from hyzer.ir import to_casadi, to_jax, to_numpy

DISC = [-0.903, 0.633, 0.913, 13.1, 0.41, -2.78, -0.07, -0.2, 0.0, -14.9, 1.48, -54.3]
RELEASES = {
    "disc": DISC,
    "discus": [0.0, 0.0, 1.8, 24.0, 0.0, -4.0, 0.0, -0.4, 0.0, 0.0, 0.0, -35.0],
    "disc_quaternion": [0, 0, 1.5, 14, 0.5, 1, np.cos(0.1), 0, -np.sin(0.1), 0, 1, -0.5, -50],
    "ball": [0.0, 0.0, 0.3, 0.3, -5.6, 2.2],
}
SECONDS = 3.0


def flown(model: str, folder: Path) -> tuple[Any, Any]:
    """Return the times and states of a flight by the program."""
    names = [state["name"] for state in document((model,))["states"]]
    initial = [f"{name} = {float(v)}" for name, v in zip(names, RELEASES[model], strict=True)]
    release = folder / "release.toml"
    lines = [f'model = "{model}"', f"duration = {SECONDS}", "[initial]", *initial]
    release.write_text("\n".join(lines))
    options = "--rate", "50", "--tolerance", "1e-13", "--out", str(folder / "flight")
    hyzer("simulate", model, "--release", str(release), *options)
    with (folder / "flight/trajectory.csv").open() as file:
        rows = np.array([[float(cell) for cell in row] for row in list(csv.reader(file))[1:]])
    return rows[:, 0], rows[:, 1:]


@pytest.mark.parametrize("model", RELEASES)
def test_scipy_flies_to_the_same_place(model: str, tmp_path: Path) -> None:
    times, expected = flown(model, tmp_path)
    own = to_numpy(document((model,)))
    flight = solve_ivp(own.rhs, (0, SECONDS), expected[0], "DOP853", times, rtol=1e-13, atol=1e-13)
    assert np.max(np.abs(flight.y.T[:, :3] - expected[:, :3])) < 1e-8


def test_an_implicit_solver_takes_the_jacobian(tmp_path: Path) -> None:
    times, expected = flown("disc", tmp_path)
    disc = to_numpy(document(("disc",)))
    until = times <= 0.5
    flight = solve_ivp(
        disc.rhs,
        (0, times[until][-1]),
        expected[0],
        "Radau",
        times[until],
        jac=lambda t, x: disc.jac(t, x)[0],
        rtol=1e-8,
        atol=1e-8,
    )
    assert np.max(np.abs(flight.y.T[:, :3] - expected[until, :3])) < 1e-6


def sensitivities(model: str, x0: Any, p: Any) -> tuple[Any, Any]:
    """Return the state after the flight, and its derivatives by initial states and parameters."""
    own = program("-p", "hyzer-flight", "--example", "sensitivities")
    text = " ".join(map(repr, [*map(float, x0), *map(float, p)]))
    command = [str(own), model, str(SECONDS)]
    done = subprocess.run(command, input=text, check=True, capture_output=True, text=True)
    rows = np.array([[float(word) for word in line.split()] for line in done.stdout.splitlines()])
    return rows[:, 0], rows[:, 1:]


def relative(expected: Any, found: Any) -> float:
    """Return the largest difference relative to the largest derivative by the same variable."""
    size = np.maximum(np.max(np.abs(expected), axis=0), 1.0)
    return float(np.max(np.abs(np.asarray(found) - expected) / size))


@pytest.mark.parametrize("model", ["disc", "ball"])
def test_gradients_by_jax_are_the_sensitivities(model: str) -> None:
    own = to_jax(document((model,)))
    x0 = jnp.asarray(RELEASES[model], dtype=float)

    def end(x0: Any, p: Any) -> Any:
        solution = diffrax.diffeqsolve(
            diffrax.ODETerm(own.rhs),
            diffrax.Dopri8(),
            0.0,
            SECONDS,
            1e-4,
            x0,
            args=p,
            stepsize_controller=diffrax.PIDController(rtol=1e-12, atol=1e-12),
            adjoint=diffrax.ForwardMode(),
            max_steps=100_000,
        )
        return solution.ys[-1]

    by_x, by_p = jax.jit(jax.jacfwd(end, argnums=(0, 1)))(x0, own.p0)
    _, expected = sensitivities(model, x0, own.p0)
    assert relative(expected, np.column_stack([by_x, by_p])) < 1e-9


@pytest.mark.parametrize("model", ["disc", "ball"])
def test_gradients_by_casadi_are_the_sensitivities(model: str) -> None:
    own = to_casadi(document((model,)))
    t, x, p = casadi.SX.sym("t"), casadi.SX.sym("x", len(own.x0)), casadi.SX.sym("p", len(own.p0))
    problem = {"t": t, "x": x, "p": p, "ode": own.rhs(t, x, p)}
    options = {"reltol": 1e-14, "abstol": 1e-14, "max_num_steps": 1_000_000}
    flight = casadi.integrator("flight", "cvodes", problem, 0.0, SECONDS, options)
    x0, p0 = casadi.MX.sym("x0", len(own.x0)), casadi.MX.sym("p0", len(own.p0))
    end = flight(x0=x0, p=p0)["xf"]
    gradient = casadi.Function("gradient", [x0, p0], [casadi.jacobian(end, casadi.vertcat(x0, p0))])
    _, expected = sensitivities(model, RELEASES[model], own.p0)
    assert relative(expected, gradient(RELEASES[model], own.p0)) < 1e-9
