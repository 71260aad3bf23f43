//! What a disc and a discus have in common: a body of revolution in a stream, and how it answers.
//!
//! Written with vectors and without the models' formulas: the lift acts along v × d2, the drag against
//! the velocity, and the body answers by its momenta in the inertial frame.

use crate::dynamics::MassProperties;
use crate::physical::{Motion, Physical};
use crate::rigid::{angular_acceleration, inertia_in_n};
use crate::scalar::Real;
use crate::tree::norm;
use nalgebra::{Matrix3, Vector3};

/// A body of revolution in a stream.
pub(crate) struct Stream<T> {
    /// Velocity through the air.
    pub through_air: Vector3<T>,
    /// Its length.
    pub speed: T,
    /// Its part in the plane of the body, as a length.
    pub in_plane: T,
    /// Its part along the axis of the body.
    pub climb: T,
    /// The body's axis.
    pub normal: Vector3<T>,
    /// Forward, in the plane of the body; nothing where there is no velocity in it.
    pub d1: Vector3<T>,
    /// To the left.
    pub d2: Vector3<T>,
    /// Spin about the axis.
    pub spin: T,
    /// The rest of the angular velocity, as far as it is split along d1 and d2.
    pub tumbling: Vector3<T>,
}

/// Coefficients of the forces and moments on it.
pub(super) struct Coefficients<T> {
    pub lift: T,
    pub drag: T,
    /// Moments about d1 and d2, as coefficients.
    pub roll: T,
    pub pitch: T,
    /// Damping of the rates about d1 and d2.
    pub damping: T,
    /// Moment about the axis by spin, without the stream.
    pub spin_down: T,
}

/// Mass, sizes and surroundings.
#[derive(Clone, Copy)]
pub(super) struct Body<T> {
    pub mass: T,
    pub axial: T,
    pub diametral: T,
    pub diameter: T,
    pub area: T,
    pub density: T,
    pub gravity: T,
}

impl<T: Real> Stream<T> {
    pub fn new(body: &Physical<T>, wind: Vector3<T>) -> Self {
        let normal = body.attitude.axis(3);
        let through_air = body.velocity - wind;
        let climb = through_air.dot(&normal);
        let flat = through_air - normal * climb;
        let in_plane = norm(&flat);
        let nothing = in_plane.re() == 0.0;
        let d1 = if nothing {
            Vector3::zeros()
        } else {
            flat / in_plane
        };
        let spin = body.angular_velocity.dot(&normal);
        let tumbling = if nothing {
            Vector3::zeros()
        } else {
            body.angular_velocity - normal * spin
        };
        let speed = norm(&through_air);
        let d2 = normal.cross(&d1);
        Self {
            through_air,
            speed,
            in_plane,
            climb,
            normal,
            d1,
            d2,
            spin,
            tumbling,
        }
    }
}

impl<T: Real> Body<T> {
    pub fn inertia(&self) -> Matrix3<T> {
        Matrix3::from_diagonal(&Vector3::new(self.diametral, self.diametral, self.axial))
    }

    pub fn mass_properties(&self) -> MassProperties<T> {
        MassProperties {
            mass: self.mass,
            inertia: Some(self.inertia()),
        }
    }

    pub fn motion(&self, at: &Physical<T>, s: &Stream<T>, c: &Coefficients<T>) -> Motion<T> {
        // ρ A / 2, to be multiplied by V for each force along a vector that itself has the length V.
        let half = self.density * self.area / T::lit(2.0);
        let lift = s.through_air.cross(&s.d2) * (half * s.speed * c.lift);
        let drag = -s.through_air * (half * s.speed * c.drag);
        let weight = Vector3::new(T::zero(), T::zero(), -self.mass * self.gravity);
        let force = lift + drag + weight;

        let lever = half * s.speed * s.speed * self.diameter;
        let of_stream = s.d1 * c.roll + s.d2 * c.pitch + s.tumbling * c.damping;
        let moment = of_stream * lever + s.normal * (c.spin_down * s.spin);

        let inertia = inertia_in_n(&at.attitude.matrix(), &self.inertia());
        let omega = at.angular_velocity;
        Motion {
            force,
            moment,
            acceleration: force / self.mass,
            angular_acceleration: angular_acceleration(&inertia, &omega, &omega, &moment),
        }
    }
}
