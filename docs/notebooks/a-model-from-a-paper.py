# %% [markdown]
# # A model from a paper, in ten lines, to verified code
#
# Cohen, Darbois Texier, Quéré and Clanet, *The physics of badminton* (New Journal of Physics 17,
# 063001, 2015), describe the flight of a shuttlecock by weight and drag. This notebook writes that
# model down, checks it, flies it, verifies it, writes its code, and fits it to flights.
#
# Run it in the root of a checkout, with `pip install 'hyzer[pandas,plot]'`.

# %%
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hyzer

# %% [markdown]
# ## The model
#
# Section S and drag coefficient are the paper's: 28 cm² and 0.6, in air of 1.2 kg/m³. The mass of 5
# g is the usual one. A check states what must hold: at terminal velocity, √(2 m g / ρ S C_D), a
# falling shuttlecock does not accelerate.

# %%
TEXT = """
model shuttlecock;
param m = 5 g;  param S = 28e-4 m^2;  param rho = 1.2 kg/m^3;  param g = 9.81 m/s^2;
coefficient C_D = 0.6 in 0 .. 3;
input wind in N = (0, 0, 0) m/s;
frame N;
point shuttlecock { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
let air_velocity = velocity - wind;
force weight = -m*g*N.3;
force drag = -rho*S*C_D/2*norm(air_velocity)*air_velocity;
marker cork in N; observe cork = position + cork;

check "terminal velocity" {
  set vz = -6.975723208794505 m/s;
  expect der(vz) = 0 m/s^2 within 1e-9;
}
"""
started = time.perf_counter()
shuttlecock = hyzer.Model(TEXT)
print(shuttlecock.check())

# %% [markdown]
# A mistake is an error with its place, and what was expected:

# %%
try:
    hyzer.Model(TEXT.replace("norm(air_velocity)*air_velocity", "air_velocity"))
except hyzer.ModelError as error:
    print(error)

# %% [markdown]
# ## Fly it
#
# With so much drag, eight times the speed brings less than three times the range, and the path
# falls steeply.

# %% alt="Paths of a shuttlecock hit at 10, 20, 40 and 80 m/s at 45 degrees, from the side"
_, axes = plt.subplots(layout="constrained", figsize=(7, 3.2))
for speed in (10, 20, 40, 80):
    flight = shuttlecock.fly(hyzer.Release(speed=speed, launch=45, height=1))
    axes.plot(flight["x"], flight["z"], label=f"{speed} m/s: {flight.landing[0]:.1f} m")
axes.set(xlabel="x, m", ylabel="z, m", xlim=(-0.5, 21), aspect="equal")
axes.legend(loc="upper right")

# %% [markdown]
# ## Verify it
#
# Compiled code and derivatives are compared with a reference implementation that evaluates the text
# and shares no code with the compiler.

# %%
verified = hyzer.verify(shuttlecock)
assert verified.outcome == "verified"
print(verified.text())

# %% [markdown]
# The exact Jacobian also agrees with finite differences, as it must:

# %%
x = np.array([0, 0, 1, 20, 1, 15], dtype=float)
J, Jp = shuttlecock.jac(0.0, x)
step = 1e-6
rows = x + step * np.eye(6), x - step * np.eye(6)
differences = (shuttlecock.rhs(0.0, rows[0]) - shuttlecock.rhs(0.0, rows[1])) / (2 * step)
print(f"largest difference: {abs(J - differences.T).max():.1e}")

# %% [markdown]
# ## Code
#
# `hyzer generate` writes the equations with all derivatives as plain Rust without dependencies.

# %%
folder = Path(tempfile.mkdtemp())
(folder / "shuttlecock.hyz").write_text(TEXT)
command = [sys.executable, "-m", "hyzer", "generate", folder / "shuttlecock.hyz", "--out", folder]
subprocess.run(command, check=True, capture_output=True)
code = (folder / "shuttlecock.rs").read_text()
print(
    f"{len(code.splitlines())} lines; from the text to here in {time.perf_counter() - started:.1f} s\n"
)
print("\n".join(code.splitlines()[:12]))

# %% [markdown]
# ## Fit it, and ask whether it is right
#
# No measured flights come with hyzer. These eight are simulated, in a steady wind of 1 m/s along
# the court that nobody noted: the tables have the times and positions alone. Positions have a noise
# of 2 mm; the last two flights are held out.

# %%
shots = [(12, 20), (25, 45), (40, 10), (18, 60)]
releases = [
    hyzer.Release(speed=speed, launch=launch, height=1.2, until=0.8, wind=(1, 0, 0))
    for speed, launch in shots
]
truth = hyzer.Model(TEXT, parameters={"C_D": 0.64})
cork = {"cork": (0, 0, 0)}
made = hyzer.synthesize(truth, releases, markers=cork, noise_sigma=0.002)
data = hyzer.Dataset.from_pandas(made.to_pandas(), markers=cork, held_out=[6, 7])
found = hyzer.diagnose(data, shuttlecock)
found

# %%
assert found.causes == ["stream-wind"]
estimates = found.explanations[0].effects[0].estimates
assert abs(estimates.stream_x.value - 1) < 3 * estimates.stream_x.std_error
estimates.to_pandas()[["value", "std_error", "unit"]]

# %% [markdown]
# Without the wind in the model, the drag coefficient came out wrong as well, with a small standard
# error:

# %%
fits = {"no wind": hyzer.fit(data, shuttlecock), "extended": hyzer.fit(data, found.extended)}
for name, fit in fits.items():
    drag = fit.coefficients.C_D
    print(f"{name:9} C_D = {drag.value:.4f} ± {drag.std_error:.4f}, reliable: {fit.reliable}")

# %% [markdown]
# The name `air_velocity` in the model matters: effects of the [catalogue](../reference/effects.md)
# that concern the air look for it. A model that calls it otherwise gets fewer candidates, and
# `hyzer effects FILE` lists which. The language is described in the
# [reference](../reference/language.md); [write a model](../how-to/write-a-model.md) has bodies that
# turn.
