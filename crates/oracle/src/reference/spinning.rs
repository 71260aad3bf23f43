//! Loads and accelerations of a body of revolution in an air stream, common to disc and discus.
//!
//! Formulated with vectors, independent of the models' formulas: lift acts along v × d2, drag against the velocity,
//! and the accelerations follow from the momenta in the inertial frame.

use crate::physical::{Load, MassProperties, Physical};
use crate::scalar::Real;
use crate::tree::norm;
use nalgebra::{Matrix3, Vector3};

/// Motion of a body of revolution relative to the air, in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stream<T> {
    /// Velocity of the body relative to the air in inertial components, m/s.
    pub through_air: Vector3<T>,
    /// Airspeed, m/s.
    pub speed: T,
    /// Magnitude of the velocity relative to the air, projected onto the plane normal to the axis of symmetry, m/s.
    pub in_plane: T,
    /// Component of the velocity relative to the air along the axis of the body, m/s.
    pub axial_velocity: T,
    /// Unit vector along the axis of symmetry (axis 3 of the body frame), in inertial components.
    pub normal: Vector3<T>,
    /// Unit vector d1, in inertial components: direction of the velocity relative to the air, projected onto the plane
    /// normal to the axis of symmetry; 0 if the projection is 0.
    pub d1: Vector3<T>,
    /// Unit vector d2 = n × d1, to the left of d1, with the axis of symmetry n, in inertial components; 0 if `d1` is 0.
    pub d2: Vector3<T>,
    /// Spin: component of the angular velocity along the axis of symmetry, rad/s.
    pub spin: T,
    /// Angular velocity less the spin about the axis of symmetry, inertial, rad/s; 0 if `d1` is 0.
    pub transverse_rate: Vector3<T>,
}

/// Coefficients of a body of revolution in air; dimensionless, except `damping` and `spin_down`.
pub(super) struct Coefficients<T> {
    pub lift: T,
    pub drag: T,
    /// Coefficient of the rolling moment about d1, the forward direction normal to the axis of symmetry. The moment is
    /// the coefficient times dynamic pressure × area × diameter.
    pub roll: T,
    pub pitch: T,
    /// Coefficient of the damping moment per rad/s of the angular velocity normal to the body axis, s; negative if the
    /// moment damps. The moment is coefficient × angular velocity × dynamic pressure × area × diameter.
    pub damping: T,
    /// Moment about the body axis per rad/s of spin, N·m·s, negative if it slows the spin, at any airspeed.
    pub spin_down: T,
}

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
    /// Motion of the body in the state `body` relative to air of the velocity `wind`, m/s, in inertial components.
    pub fn new(body: &Physical<T>, wind: Vector3<T>) -> Self {
        let normal = body.attitude.axis(3);
        let through_air = body.velocity - wind;
        let axial_velocity = through_air.dot(&normal);
        let planar = through_air - normal * axial_velocity;
        let in_plane = norm(&planar);
        let no_forward = in_plane.re() == 0.0;
        let d1 = if no_forward {
            Vector3::zeros()
        } else {
            planar / in_plane
        };
        let spin = body.angular_velocity.dot(&normal);
        let transverse_rate = if no_forward {
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
            axial_velocity,
            normal,
            d1,
            d2,
            spin,
            transverse_rate,
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

    pub fn load(&self, s: &Stream<T>, c: &Coefficients<T>) -> Load<T> {
        // ρ A / 2, to be multiplied by V for each force along a vector that itself has the length V.
        let half = self.density * self.area / T::lit(2.0);
        let lift = s.through_air.cross(&s.d2) * (half * s.speed * c.lift);
        let drag = -s.through_air * (half * s.speed * c.drag);
        let weight = Vector3::new(T::zero(), T::zero(), -self.mass * self.gravity);
        let force = lift + drag + weight;

        let lever = half * s.speed * s.speed * self.diameter;
        let aerodynamic = s.d1 * c.roll + s.d2 * c.pitch + s.transverse_rate * c.damping;
        let moment = aerodynamic * lever + s.normal * (c.spin_down * s.spin);
        Load { force, moment }
    }
}
