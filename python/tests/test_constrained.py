"""Constrained bodies against Lagrange's equations, derived by SymPy and integrated by SciPy."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hyzer

sympy: Any = pytest.importorskip("sympy")
integrate: Any = pytest.importorskip("scipy.integrate")

GALLERY = Path(__file__).parents[2] / "examples" / "gallery"
SECONDS = 10.0
TIMES = np.linspace(0.0, SECONDS, 101)
TOLERANCE = 1e-9

PENDULUM = """model weights_on_rods;
param m_1 = 1 kg;
param m_2 = 0.6 kg;
param l_1 = 1 m;
param l_2 = 0.7 m;
param g = 9.81 m/s^2;
frame N;
point upper { mass m_1; position (x, y, z) in N; velocity (u, v, w) in N; }
point lower { mass m_2; position (x_2, y_2, z_2) in N; velocity (u_2, v_2, w_2) in N; }
let rod = position_of_lower - position;
force weight = -m_1*g*N.3;
force weight on lower = -m_2*g*N.3;
solve rods {
  unknown S: N;
  unknown T: N;
  constraint norm(position) = l_1 within 1 mm;
  constraint norm(rod) = l_2 within 1 mm;
}
force inner = -S*unit(position) + T*unit(rod);
force outer on lower = -T*unit(rod);
"""

TOP = """model top_on_its_tip;
param m = 0.1 kg;
param l = 4 cm;
param I = 8e-5 kg*m^2;
param I_3 = 6e-5 kg*m^2;
param g = 9.81 m/s^2;
frame N;
frame C = N by quaternion (q0, q1, q2, q3);
body top {
  mass m; inertia diag(I, I, I_3) in C; fixed in C; axis C.3;
  position (x, y, z) in N; velocity (u, v, w) in C; angular velocity (p, q, r) in C;
}
let of_tip = velocity - l*cross(angular_velocity, C.3);
force weight = -m*g*N.3;
force floor = R;
moment floor = -l*cross(C.3, R);
solve floor {
  unknown R: vector N in C;
  constraint of_tip.1 = 0 within 1 mm/s;
  constraint of_tip.2 = 0 within 1 mm/s;
  constraint of_tip.3 = 0 within 1 mm/s;
}
"""

Numbers = Sequence[float]


class Lagrangian:
    """Motion by a Lagrange function of `count` coordinates and their rates, with loads."""

    def __init__(self, count: int) -> None:
        self.q = sympy.symbols(f"q:{count}")
        self.qd = sympy.symbols(f"qd:{count}")

    def velocity(self, place: Any) -> Any:
        """Rate of a vector of the coordinates."""
        return place.jacobian(self.q) * sympy.Matrix(self.qd)

    def flown(self, function: Any, loads: Sequence[tuple[Any, Any]], start: Numbers) -> Any:
        """Coordinates and rates at `TIMES`; each load is a force and the place where it acts."""
        q, qd = sympy.Matrix(self.q), sympy.Matrix(self.qd)
        momenta = sympy.Matrix([function]).jacobian(qd)
        forces = sympy.Matrix([function]).jacobian(q).T - momenta.jacobian(q) * qd
        for force, place in loads:
            forces += place.jacobian(q).T * force
        of_state = sympy.lambdify([*q, *qd], [momenta.jacobian(qd), forces], cse=True)
        count = len(self.q)

        def rates(_: float, state: Any) -> Any:
            masses, force = of_state(*state)
            return np.concatenate([state[count:], np.linalg.solve(masses, force)[:, 0]])

        solved = integrate.solve_ivp(
            rates, (0.0, SECONDS), start, "DOP853", TIMES, rtol=3e-14, atol=1e-14
        )
        assert solved.success
        return solved.y

    def values(self, expressions: Sequence[Any], flown: Any) -> Any:
        """Values of expressions along a motion, a row for each."""
        of_state = sympy.lambdify([*self.q, *self.qd], list(expressions), cse=True)
        return np.array([of_state(*state) for state in flown.T]).T


def dot(a: Any, b: Any) -> Any:
    return (a.T * b)[0]


def weights() -> tuple[Lagrangian, Any, list[Any]]:
    """Lagrange function of the two weights, in angles of both rods, and their places."""
    system = Lagrangian(2)
    rods = [sympy.Matrix([sympy.sin(angle), 0, -sympy.cos(angle)]) for angle in system.q]
    places = [rods[0], rods[0] + rods[1] * sympy.Float("0.7")]
    masses = [1, sympy.Float("0.6")]
    energies = [
        m * dot(system.velocity(r), system.velocity(r)) / 2 - m * sympy.Float("9.81") * r[2]
        for m, r in zip(masses, places, strict=True)
    ]
    return system, sum(energies), places


def fly(model: str | Path, states: dict[str, float]) -> Any:
    model = model if isinstance(model, str) else str(model)
    return hyzer.Model(model).fly(states, SECONDS, rate=10.0, tolerance=1e-13)


def assert_same(flight: Any, names: Sequence[str], expected: Any) -> None:
    assert np.allclose(flight.t, TIMES, atol=1e-12)
    for name, values in zip(names, expected, strict=True):
        size = max(1.0, float(np.abs(values).max()))
        assert np.abs(flight[name] - values).max() < TOLERANCE * size, name


ANGLES = np.radians([40.0, 20.0])


def test_a_double_pendulum_in_angles() -> None:
    system, function, _ = weights()
    expected = system.flown(function, [], [*ANGLES, 0.0, 0.0])
    names = ["theta_1", "theta_2", "omega_1", "omega_2"]
    start = dict(zip(names, [*ANGLES, 0.0, 0.0], strict=True))
    assert_same(fly(GALLERY / "double_pendulum.hyz", start), names, expected)


def test_a_double_pendulum_of_points_on_rods() -> None:
    system, function, places = weights()
    start = [*ANGLES, 0.5, -1.0]
    expected = system.flown(function, [], start)
    of_points = [*places[0], *places[1]]
    of_points += [*system.velocity(places[0]), *system.velocity(places[1])]
    expected = system.values(of_points, expected)
    names = ["x", "y", "z", "x_2", "y_2", "z_2", "u", "v", "w", "u_2", "v_2", "w_2"]
    flight = fly(PENDULUM, dict(zip(names, expected[:, 0], strict=True)))
    assert_same(flight, names, expected)


def top(inertia: float, axial: float) -> tuple[Lagrangian, Any]:
    """Lagrange function of a top in Euler's angles, by its moments of inertia about the tip."""
    system = Lagrangian(3)
    (_, theta, _), (phidot, thetadot, psidot) = system.q, system.qd
    spin = psidot + phidot * sympy.cos(theta)
    kinetic = inertia / 2 * (thetadot**2 + (phidot * sympy.sin(theta)) ** 2) + axial / 2 * spin**2
    return system, kinetic - 0.1 * 9.81 * 0.04 * sympy.cos(theta)


def test_a_top_in_eulers_angles() -> None:
    system, function = top(2.4e-4, 8e-5)
    start = [0.0, np.radians(30.0), 0.0, 0.0, 0.0, 200.0]
    names = ["phi", "theta", "psi", "phidot", "thetadot", "psidot"]
    flight = fly(GALLERY / "spinning_top.hyz", dict(zip(names, start, strict=True)))
    assert_same(flight, names, system.flown(function, [], start))


def test_a_top_whose_tip_is_held() -> None:
    system, function = top(8e-5 + 0.1 * 0.04**2, 6e-5)
    start = [0.0, np.radians(30.0), 0.0, 1.0, 0.5, 80.0]
    flown = system.flown(function, [], start)
    (phi, theta, _), (phidot, _, psidot) = system.q, system.qd
    sin, cos = sympy.sin, sympy.cos
    centre = sympy.Matrix([sin(theta) * sin(phi), -sin(theta) * cos(phi), cos(theta)]) * 0.04
    spin = psidot + phidot * cos(theta)
    expected = system.values([*centre, spin], flown)
    half = start[1] / 2
    p, q, r = 0.5, np.sin(start[1]), 80.0 + np.cos(start[1])
    states = {"q0": np.cos(half), "q1": np.sin(half), "q2": 0.0, "q3": 0.0}
    states |= {"p": p, "q": q, "r": r, "u": 0.04 * q, "v": -0.04 * p, "w": 0.0}
    states |= dict(zip(["x", "y", "z"], expected[:3, 0], strict=True))
    assert_same(fly(TOP, states), ["x", "y", "z", "r"], expected)


def line(alpha: Any, beta: Any) -> Any:
    """Unit vector at angles from axis 1 towards 3, and from there towards 2."""
    cos, sin = sympy.cos, sympy.sin
    return sympy.Matrix([cos(beta) * cos(alpha), sin(beta), cos(beta) * sin(alpha)])


def test_a_kite_on_a_line() -> None:
    system = Lagrangian(2)
    n = line(*system.q)
    r, v = 20 * n, system.velocity(20 * n)
    air = sympy.Matrix([8, 0, 0]) - v
    speed = sympy.sqrt(dot(air, air))
    pressure = sympy.Float("1.2") * sympy.Float("0.3") / 2 * speed
    across = n - dot(n, air) / speed**2 * air
    load = pressure * (sympy.Float("0.8") * across * speed + sympy.Float("0.2") * air)
    function = sympy.Float("0.4") * (dot(v, v) / 2 - sympy.Float("9.81") * r[2])
    start = [np.arctan2(12.0, 16.0), 0.0, 0.0, 3.0 / 20.0]
    expected = system.values([*r, *v], system.flown(function, [(load, r)], start))
    names = ["x", "y", "z", "vx", "vy", "vz"]
    states = dict(zip(names, expected[:, 0], strict=True))
    assert_same(fly(GALLERY / "tethered_kite.hyz", states), names, expected)


def test_a_parachute_with_payload() -> None:
    system = Lagrangian(5)
    canopy = sympy.Matrix(system.q[:3])
    payload = canopy + 6 * line(*system.q[3:])
    function: Any = 0
    loads = []
    for place, mass, area in [(canopy, "1.4", 7), (payload, "8", "0.05")]:
        v, m = system.velocity(place), sympy.Float(mass)
        air = sympy.Matrix([3, 0, 0]) - v
        drag = sympy.Float("1.2") / 2 * sympy.Float(area) * sympy.sqrt(dot(air, air)) * air
        function += m * dot(v, v) / 2 - m * sympy.Float("9.81") * place[2]
        loads.append((drag, place))
    start = [0.0, 0.0, 100.0, np.arctan2(-4.8, 3.6), 0.0, 0.0, 1.0, -5.0, 0.0, 0.0]
    flown = system.flown(function, loads, start)
    of_points = [*canopy, *payload, *system.velocity(canopy), *system.velocity(payload)]
    expected = system.values(of_points, flown)
    of_canopy, of_payload = (["x", "y", "z"], ["vx", "vy", "vz"]), "_p"
    names = [
        *of_canopy[0],
        *(name + of_payload for name in of_canopy[0]),
        *of_canopy[1],
        *(name + of_payload for name in of_canopy[1]),
    ]
    states = dict(zip(names, expected[:, 0], strict=True))
    assert_same(fly(GALLERY / "parachute_payload.hyz", states), names, expected)
