//! What an effect acts in: the body in its stream, and the constants of the law.

use crate::physical::Physical;
use crate::reference::Law;
use crate::reference::spinning::Stream;
use crate::scalar::Real;
use nalgebra::Vector3;

/// The body in its stream.
pub struct Scene<'a, T> {
    law: Law,
    constants: &'a [T],
    /// Where it is and how it moves.
    pub at: &'a Physical<T>,
    /// Time since release.
    pub time: T,
    /// Spin of a ball, which is known from elsewhere.
    pub omega: Vector3<T>,
    pub(super) stream: Stream<T>,
}

impl<'a, T: Real> Scene<'a, T> {
    /// A body in air that moves at `air`; constants in the order of the law.
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

    /// A constant of the law.
    ///
    /// # Panics
    /// Where the law has none of that name: an effect is put to its own laws alone.
    pub fn constant(&self, name: &str) -> T {
        let place = self.law.constants().iter().position(|n| *n == name);
        self.constants[place.expect("a constant of the law")]
    }

    /// Angle from the plane of the disc to its velocity, positive when the air comes from below.
    pub fn alpha(&self) -> T {
        (-self.stream.climb).atan2(self.stream.in_plane)
    }

    /// Speed through the air.
    pub fn speed(&self) -> T {
        self.stream.speed
    }

    /// Velocity through the air.
    pub fn through_air(&self) -> Vector3<T> {
        self.stream.through_air
    }

    /// The body's axis.
    pub fn normal(&self) -> Vector3<T> {
        self.stream.normal
    }

    /// Forward and to the left, in the plane of the disc.
    pub fn forward_and_left(&self) -> [Vector3<T>; 2] {
        [self.stream.d1, self.stream.d2]
    }

    /// Spin about the axis.
    pub fn spin(&self) -> T {
        self.stream.spin
    }

    /// Speed of the rim by the spin, over the speed; 0 where it hangs in the air.
    pub fn spin_ratio(&self) -> T {
        if self.speed().re() == 0.0 {
            return T::zero();
        }
        let rim = self.stream.spin * self.constant("d") / T::lit(2.0);
        rim / self.speed()
    }

    /// A force by its coefficient in the stream, along `direction`.
    pub fn pressed(&self, coefficient: T, direction: Vector3<T>) -> Vector3<T> {
        let half = self.constant("rho") * self.constant("A") / T::lit(2.0);
        direction * (half * coefficient * self.speed() * self.speed())
    }

    /// A moment by its coefficient in the stream, about `axis`; its lever is the diameter.
    pub fn turned(&self, coefficient: T, axis: Vector3<T>) -> Vector3<T> {
        self.pressed(coefficient, axis) * self.constant("d")
    }

    /// Lift by its coefficient: along v × d2, at a right angle to the stream.
    pub fn lifted(&self, coefficient: T) -> Vector3<T> {
        self.pressed(coefficient, self.against_stream(self.stream.d2))
    }

    /// Drag by its coefficient: against the velocity.
    pub fn dragged(&self, coefficient: T) -> Vector3<T> {
        let half = self.constant("rho") * self.constant("A") / T::lit(2.0);
        -self.through_air() * (half * coefficient * self.speed())
    }

    /// The direction of the velocity × `axis`.
    fn against_stream(&self, axis: Vector3<T>) -> Vector3<T> {
        if self.speed().re() == 0.0 {
            return Vector3::zeros();
        }
        self.through_air().cross(&axis) / self.speed()
    }
}
