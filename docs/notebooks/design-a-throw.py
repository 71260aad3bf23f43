# %% [markdown]
# # Design a throw, and its spread
#
# Which throw lands on a point 30 m ahead and 5 m to the left? And where do the attempts land, if no
# throw is exactly as intended?
#
# Run it in the root of a checkout, with `pip install 'hyzer[pandas,plot]'`.

# %%
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import hyzer

disc = hyzer.Model("disc")
target = (30, 5, 0)

# %% [markdown]
# ## The throw
#
# `scatter` states how far throws differ from what was intended, as standard deviations. These are
# assumptions, not measurements of a thrower.

# %%
scatter = {"speed": 0.4, "heading": 1.0, "launch": 1.0, "nose": 1.0, "hyzer": 2.0, "spin": 30}
bounds = {"speed": [14.0, 24.0], "spin": [400, 900], "scatter": scatter}
hit = hyzer.design(disc, "hit", target=target, bounds=bounds, samples=1000)
print(hit.text())

# %% [markdown]
# The text lists what one unit of each number changes at the landing. It also warns: the landing is
# not linear in the numbers within this scatter, so that the ellipse to first order is wrong.
#
# ## A throw with less spread
#
# The goal `hit` takes, of all throws that land at the target, the one nearest the middle of the
# bounds. The goal `spread` takes the one whose landings scatter least:

# %%
least = hyzer.design(disc, "spread", target=target, bounds=bounds, samples=1000)
assert hit.feasible and least.feasible
throws = {"hit": hit, "spread": least}
pd.DataFrame({goal: found.throw.to_dict() for goal, found in throws.items()})

# %% [markdown]
# It is a fast, flat throw, tilted the other way.
#
# ## The spread, checked
#
# A sweep flies 2,000 attempts at both throws, with random numbers of its own.

# %%
landings = {}
for goal, found in throws.items():
    vary = {name: {"sd": float(sd)} for name, sd in scatter.items()}
    plan = {"model": "disc", "until": "ground", "flights": 2000, "vary": vary}
    plan["throw"] = found.throw.to_dict()
    landings[goal] = hyzer.sweep(plan).to_pandas()[["landing_x", "landing_y"]]

# %% alt="Landing points of 2,000 attempts at both throws: a bent cloud of some 20 m for the goal hit, a patch of 3 m for the goal spread"
_, axes = plt.subplots(layout="constrained", figsize=(6, 6))
for goal, points in landings.items():
    axes.plot(points.landing_x, points.landing_y, ".", markersize=3, alpha=0.4, label=goal)
axes.plot(*target[:2], "k+", markersize=14, label="target")
axes.set(xlabel="x, m", ylabel="y, m", aspect="equal")
axes.legend(loc="lower left")

# %%
away = {
    goal: np.hypot(points.landing_x - target[0], points.landing_y - target[1])
    for goal, points in landings.items()
}
table = pd.DataFrame(away).describe(percentiles=[0.5, 0.9]).loc[["50%", "90%"]].round(2)
assert table.loc["50%", "spread"] < 0.5 * table.loc["50%", "hit"]
table.rename_axis("distance from the target, m")

# %% [markdown]
# ## Look at it
#
# `disc.fly(least.release).view()` shows the flight in three dimensions; here are both from above.

# %% alt="Paths of both throws from above: the goal hit curves from the left, the goal spread from the right"
_, axes = plt.subplots(layout="constrained", figsize=(7, 3.5))
for goal, found in throws.items():
    flight = disc.fly(found.release)
    axes.plot(flight["x"], flight["y"], label=f"{goal}, {flight.duration:.1f} s")
axes.plot(*target[:2], "k+", markersize=14)
axes.set(xlabel="x, m", ylabel="y, m", aspect="equal")
axes.legend()

# %% [markdown]
# What this cannot do: the numbers are as right as the model and its coefficients. For a disc of
# your own, [fit](../how-to/fit-your-flights.md) it first, and design with `fit.fitted`; a sweep
# also takes the uncertainty of the coefficients ([sweep plans](../reference/sweep.md)).
