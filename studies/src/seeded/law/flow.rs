//! State of a body in the air, and constants of its law: the arguments of an effect.

use nalgebra::Vector3;
use oracle::Law;
use oracle::Physical;
use oracle::Stream;
use oracle::scalar::Real;

/// State of a body relative to the air, with the constants of its law of motion.
pub struct Flow<'a, T> {
    law: Law,
    constants: &'a [T],
    /// Physical state of the body.
    pub at: &'a Physical<T>,
    /// Time since release, s.
    pub time: T,
    /// Measured angular velocity of a ball in inertial components, rad/s; 0 for bodies whose attitude is a state.
    pub omega: Vector3<T>,
    pub(super) stream: Stream<T>,
}

impl<'a, T: Real> Flow<'a, T> {
    /// Combines the physical state of a body with the velocity `air` of the surrounding air, m/s; `constants` are in
    /// the order of [`Law::constants`].
    pub fn new(
        law: Law,
        constants: &'a [T],
        at: &'a Physical<T>,
        air: Vector3<T>,
        time: T,
        omega: Vector3<T>,
    ) -> Self {
        Self {
            law,
            constants,
            at,
            time,
            omega,
            stream: Stream::new(at, air),
        }
    }

    /// Value of the constant `name` of the law of motion.
    ///
    /// # Panics
    /// If the law has no such constant. An effect of the table cannot cause this, since its list
    /// [`Effect::laws`](super::Effect::laws) contains only laws with the constants that the effect uses.
    pub fn constant(&self, name: &str) -> T {
        let place = self.law.constants().iter().position(|n| *n == name);
        self.constants[place.expect("a constant of the law")]
    }

    /// Angle of attack, rad, positive if the air meets the body from below.
    pub fn alpha(&self) -> T {
        (-self.stream.axial_velocity).atan2(self.stream.in_plane)
    }

    /// Airspeed, m/s.
    pub fn speed(&self) -> T {
        self.stream.speed
    }

    /// Velocity of the body relative to the air, m/s, in inertial components.
    pub fn through_air(&self) -> Vector3<T> {
        self.stream.through_air
    }

    /// Unit vector along the axis of symmetry of the body, in inertial components.
    pub fn normal(&self) -> Vector3<T> {
        self.stream.normal
    }

    /// Unit vectors normal to the axis of symmetry: d1 along the projection of the velocity relative to the air
    /// (forward), d2 to the left of d1.
    pub fn forward_and_left(&self) -> [Vector3<T>; 2] {
        [self.stream.d1, self.stream.d2]
    }

    /// Spin about the axis of symmetry, rad/s.
    pub fn spin(&self) -> T {
        self.stream.spin
    }

    /// Advance ratio r d/(2 V) with the spin r, the diameter d and the airspeed V, dimensionless; 0 without airspeed.
    pub fn advance_ratio(&self) -> T {
        if self.speed().re() == 0.0 {
            return T::zero();
        }
        let rim = self.stream.spin * self.constant("d") / T::lit(2.0);
        rim / self.speed()
    }

    /// Force q A C along the unit vector `direction`, N, where q is the dynamic pressure, A the area of the body and C
    /// the given coefficient. Vectors are in inertial components.
    pub fn pressure_force(&self, coefficient: T, direction: Vector3<T>) -> Vector3<T> {
        let half = self.constant("rho") * self.constant("A") / T::lit(2.0);
        direction * (half * coefficient * self.speed() * self.speed())
    }

    /// Moment q A d C about the unit vector `axis`, N·m, where q is the dynamic pressure, A the area and d the diameter
    /// of the body, and C the given coefficient. Vectors are in inertial components.
    pub fn pressure_moment(&self, coefficient: T, axis: Vector3<T>) -> Vector3<T> {
        self.pressure_force(coefficient, axis) * self.constant("d")
    }

    /// Lift force for the lift coefficient `coefficient`, N, in inertial components. It acts along v × d2, where v is
    /// the velocity relative to the air, and d2 the unit vector to the left, normal to the axis of symmetry and to v.
    pub fn lift(&self, coefficient: T) -> Vector3<T> {
        self.pressure_force(coefficient, self.across_flow(self.stream.d2))
    }

    /// Drag force for the drag coefficient `coefficient`, N, in inertial components; it acts against the velocity
    /// relative to the air.
    pub fn drag(&self, coefficient: T) -> Vector3<T> {
        let half = self.constant("rho") * self.constant("A") / T::lit(2.0);
        -self.through_air() * (half * coefficient * self.speed())
    }

    /// Cross product (v / V) × `axis`, where v is the velocity relative to the air and V its magnitude; 0 if V is 0.
    fn across_flow(&self, axis: Vector3<T>) -> Vector3<T> {
        if self.speed().re() == 0.0 {
            return Vector3::zeros();
        }
        self.through_air().cross(&axis) / self.speed()
    }
}
