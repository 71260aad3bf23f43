import numpy as np
from frispy.disc import Disc

disc = Disc(vx=20, vz=3, z=1.2, dgamma=-70)
result, _ = disc.compute_trajectory(flight_time=5, n_times=501)
landed = np.argmax(result["z"] < 0)
print("landing", result["x"][landed])
