import sys
from pathlib import Path

import casadi as ca
import numpy as np

M, S, RHO, G = 0.005, 28e-4, 1.2, 9.81
x, drag, h = ca.SX.sym("x", 6), ca.SX.sym("C_D"), ca.SX.sym("h")
v = x[3:]
a = -RHO * S * drag / (2 * M) * ca.norm_2(v) * v - ca.vertcat(0, 0, G)
f = ca.Function("f", [x, drag], [ca.vertcat(v, a)])
k1 = f(x, drag)
k2 = f(x + h / 2 * k1, drag)
k3 = f(x + h / 2 * k2, drag)
k4 = f(x + h * k3, drag)
step = ca.Function("step", [x, drag, h], [x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)])

speed = 25 * np.sqrt(0.5)
state = before = ca.DM([0, 0, 1.2, speed, 0, speed])
while state[2] > 0:
    before, state = state, step(state, 0.64, 0.001)
share = before[2] / (before[2] - state[2])
print("landing", float(before[0] + share * (state[0] - before[0])))

problem = ca.Opti()
C_D = problem.variable()
problem.set_initial(C_D, 0.6)
residuals = []
for file in sorted(Path(sys.argv[1]).glob("*.csv"))[:6]:
    table = np.genfromtxt(file, delimiter=",", names=True)
    t = table["t"]
    seen = np.stack([table["cork_x"], table["cork_y"], table["cork_z"]])
    x0 = problem.variable(6)
    problem.set_initial(x0, [*seen[:, 0], *((seen[:, 3] - seen[:, 0]) / (t[3] - t[0]))])
    state = x0
    residuals.append(seen[:, 0] - state[:3])
    for k, dt in enumerate(np.diff(t)):
        state = step(step(state, C_D, dt / 2), C_D, dt / 2)
        residuals.append(seen[:, k + 1] - state[:3])
residuals = ca.vertcat(*residuals)
problem.minimize(1e6 * ca.sumsqr(residuals))
problem.solver("ipopt", {"print_time": False, "expand": True}, {"print_level": 0, "sb": "yes"})
solution = problem.solve()
left = solution.value(residuals)
rms = np.sqrt(np.mean(left**2))
jacobian = solution.value(ca.jacobian(residuals, problem.x)).toarray()
error = rms * np.sqrt(np.linalg.inv(jacobian.T @ jacobian)[0, 0])
print("C_D", solution.value(C_D), error)
print(f"tells RMS residual {1000 * rms:.1f} mm")
