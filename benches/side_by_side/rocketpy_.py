import numpy as np
from rocketpy import Environment, Flight, PointMassMotor, PointMassRocket

M, S = 0.005, 28e-4
environment = Environment(gravity=9.81)
environment.set_atmospheric_model("custom_atmosphere", temperature=294, pressure=101325)
motor = PointMassMotor(thrust_source=0, dry_mass=1e-6, propellant_initial_mass=1e-9, burn_time=0.001)
shuttlecock = PointMassRocket(np.sqrt(S / np.pi), M, 0, 0.64, 0.64, weathercock_coeff=100)
shuttlecock.add_motor(motor, position=0)
speed = 25 * np.sqrt(0.5)
turned = [np.cos(np.pi / 8), 0, np.sin(np.pi / 8), 0]  # along the velocity
flight = Flight(shuttlecock, environment, rail_length=0.001, simulation_mode="3 DOF",
    initial_solution=[0, 0, 0, 1.2, speed, 0, speed, *turned, 0, 0, 0])
print("landing", flight.x_impact)
