import sys
from pathlib import Path

import numpy as np
import pysindy as ps

flights, times = [], []
for file in sorted(Path(sys.argv[1]).glob("*.csv"))[:6]:
    table = np.genfromtxt(file, delimiter=",", names=True)
    seen = np.stack([table["cork_x"], table["cork_y"], table["cork_z"]], axis=1)
    smooth = ps.SmoothedFiniteDifference(smoother_kws={"window_length": 15})
    flights.append(smooth(seen, table["t"])[7:-7])
    times.append(table["t"][7:-7])

library = ps.CustomLibrary(
    library_functions=[lambda: 1, lambda u, v, w: np.sqrt(u**2 + v**2 + w**2) * u,
                       lambda u, v, w: np.sqrt(u**2 + v**2 + w**2) * v,
                       lambda u, v, w: np.sqrt(u**2 + v**2 + w**2) * w, lambda u: u],
    function_names=[lambda: "1", lambda u, v, w: "V u", lambda u, v, w: "V v",
                    lambda u, v, w: "V w", lambda u: u],
)
model = ps.SINDy(
    optimizer=ps.STLSQ(threshold=0.02),
    feature_library=library,
    differentiation_method=ps.SmoothedFiniteDifference(smoother_kws={"window_length": 15}),
)
model.fit(flights, t=times, feature_names=["u", "v", "w"])
model.print()
