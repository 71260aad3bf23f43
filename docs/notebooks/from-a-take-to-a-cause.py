# %% [markdown]
# # From a recording to a named cause
#
# Ten throws of a disc were recorded by motion capture, one C3D file each. This notebook imports
# them, fits a model, finds out that the model is wrong and where, and simulates the extended model.
#
# Run it in the root of a checkout, with `pip install 'hyzer[pandas,plot]' ezc3d`.

# %%
import tempfile
from pathlib import Path

import ezc3d
import numpy as np

import hyzer

# %% [markdown]
# ## The recording
#
# No measured recording comes with hyzer. This cell writes the simulated flights of
# `examples/mystery` as a laboratory would deliver them: C3D, in mm, with NaN where a marker was
# hidden. With recordings of your own, skip it.

# %%
takes = Path(tempfile.mkdtemp())
markers = ["m1", "m2", "m3"]
for number, frame in enumerate(hyzer.Dataset.read("examples/mystery").to_pandas().values(), 1):
    seen = np.stack([frame[[f"{m}_{axis}" for m in markers]].to_numpy().T for axis in "xyz"])
    points = np.concatenate([1000 * seen, np.ones_like(seen[:1])])
    c3d = ezc3d.c3d()
    c3d["parameters"]["POINT"]["RATE"]["value"] = [120]
    c3d["parameters"]["POINT"]["UNITS"]["value"] = ["mm"]
    c3d["parameters"]["POINT"]["LABELS"]["value"] = markers
    c3d["data"]["points"] = points
    c3d.write(str(takes / f"take{number:02}.c3d"))

# %% [markdown]
# ## Import
#
# C3D states units and rate. It does not state which axis points up, so `up` does. The template is a
# TOML file with the positions of the markers on the disc, and with its mass and moments of inertia;
# without a template the positions are estimated from the throws. Every decision is reported.

# %%
data = hyzer.Dataset.import_takes(
    sorted(takes.glob("*.c3d")), up="+z", markers="examples/mystery/dataset.toml"
)
print(data, data.decisions.split("\n", 1)[1].split("\n/")[0], sep="\n")

# %% [markdown]
# ## Fit
#
# `disc` is the model of Hubbard and Hummel (2000). A fit of its eight coefficients runs without an
# initial guess.

# %%
fit = hyzer.fit(data, "disc")
fit

# %% [markdown]
# The first lines are the reasons not to rely on these numbers: the residuals are several times the
# noise. The standard errors are small all the same. They hold only if the model is right.

# %% alt="RMS residual of each flight in metres: from 2 to 20 millimetres, where the noise is 1.5 millimetres"
fit.plot()

# %% [markdown]
# ## Diagnose

# %%
found = hyzer.diagnose(data, "disc")
found

# %% [markdown]
# One effect explains the misfit. In the model, lift grows in proportion to the angle of attack; in
# these flights it does not. The figure shows the lift coefficient over the angle of attack, before
# and after.

# %% alt="Lift coefficient over the angle of attack: a straight line before the diagnosis, a curve that bends down above 8 degrees after it"
found.plot()

# %% [markdown]
# The truth is in `examples/mystery/truth.toml`, which none of these functions reads: `stall` with
# `C_Ls = 4`.

# %%
estimate = found.explanations[0].effects[0].estimates
estimate.to_pandas()[["value", "std_error", "unit"]]

# %%
assert found.causes == ["stall"]
assert abs(estimate.C_Ls.value - 4) < 3 * estimate.C_Ls.std_error

# %% [markdown]
# ## What did it gain?
#
# Each flight is predicted from its first part by a model that was fitted to other flights.

# %%
gain = found.predictive_gain
print(f"RMS prediction error: {1000 * gain.rms_before_m:.1f} mm before,", end=" ")
print(f"{1000 * gain.rms_after_m:.1f} mm after, noise {1000 * gain.noise_m:.1f} mm")

# %% [markdown]
# ## Use the extended model
#
# It is a model like any other: checked, verified against an independent implementation, and with
# exact derivatives.

# %%
extended = found.extended
print(hyzer.verify(extended, cases=50).outcome)
before, after = fit.fitted.fly("backhand"), extended.fly("backhand")
print("landing, m:", before.landing.round(2), "before,", after.landing.round(2), "after")

# %% [markdown]
# `after.view()` shows the flight in three dimensions, and `found.save("found")` writes the report
# as a page.
#
# What a diagnosis cannot do: it chooses among the [effects of the
# catalogue](../reference/effects.md), and those that you [add](../how-to/add-an-effect.md). If none
# of them explains the misfit, the verdict is `unattributed`.
