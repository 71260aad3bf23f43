import sys

import hyzer

shuttlecock = hyzer.Model("""
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
""")
print("landing", shuttlecock.fly(hyzer.Release(speed=25, launch=45, height=1.2), C_D=0.64).landing[0])

fit = hyzer.fit(sys.argv[1], shuttlecock)
print("C_D", fit.coefficients.C_D.value, fit.coefficients.C_D.std_error)
found = hyzer.diagnose(sys.argv[1], shuttlecock)
print("tells", found.summary)
