//! Motion of the model's body at a point, in inertial components.

use crate::newton_euler::{newton_euler, state_derivatives};
use crate::physical::{MassProperties, Motion, angular_acceleration, inertia_in_n};
use crate::scalar::Real;
use crate::tree::Tree;
use model_spec::model::{Body, Rotation};
use nalgebra::{Matrix3, Vector3};

impl<T: Real> Tree<'_, T> {
    /// Sum of the forces on the model's body except the weight, divided by its mass, m/s², in inertial components.
    pub(super) fn specific_force(&self) -> Vector3<T> {
        let felt = self.model.forces.iter().filter(|load| !load.is_weight());
        let force = felt.fold(Vector3::zeros(), |sum, load| sum + self.vector(&load.value));
        force / self.scalar(&self.body().mass)
    }

    /// Angular acceleration of the model's body, rad/s², in inertial components.
    pub(super) fn angular_acceleration(&self) -> Vector3<T> {
        let rotation = self.rotation();
        let frame = &self.frames[rotation.inertia_frame];
        let inertia = Matrix3::from_fn(|row, column| self.scalar(&rotation.inertia[row][column]));
        angular_acceleration(
            &inertia_in_n(&frame.axes, &inertia),
            &frame
                .angular_velocity
                .expect("an inertia frame with angular velocity"),
            &self.angular_velocity(),
            &self.total(&self.model.moments),
        )
    }

    /// Mass and inertia tensor of a body of the model at the point.
    pub fn mass_properties(&self, body: &Body) -> MassProperties<T> {
        let rotation = body.rotation.as_ref();
        MassProperties {
            mass: self.scalar(&body.mass),
            inertia: rotation
                .map(|r| Matrix3::from_fn(|row, column| self.scalar(&r.inertia[row][column]))),
        }
    }

    /// Derivative of a state of the body by the time of the flight; a coordinate depends on no load. NaN where the
    /// body's attitude cannot be differentiated.
    pub(super) fn body_rate(&self, state: usize, is_coordinate: bool) -> T {
        let computed = &self.body_rates[usize::from(is_coordinate)];
        let rates = computed.get_or_init(|| self.all_body_rates(is_coordinate));
        rates.get(state).copied().unwrap_or(T::lit(f64::NAN))
    }

    /// Derivatives of all states of the body, without loads for coordinates alone; empty where its attitude cannot be
    /// differentiated.
    fn all_body_rates(&self, is_coordinate: bool) -> Vec<T> {
        let (model, body) = (self.model, self.body());
        let none = Vector3::zeros();
        let motion = match is_coordinate {
            true => Motion {
                force: none,
                moment: none,
                acceleration: none,
                angular_acceleration: none,
            },
            false => {
                let (force, moment) = (self.total(&model.forces), self.total(&model.moments));
                let properties = self.mass_properties(body);
                newton_euler(body, &self.frames, &properties, force, moment)
            }
        };
        let rates = state_derivatives(model, body, &self.point.states, &self.frames, &motion);
        rates.unwrap_or_default()
    }

    pub(super) fn states(&self, indices: [usize; 3]) -> Vector3<T> {
        Vector3::from(indices.map(|i| self.point.states[i]))
    }

    pub(super) fn angular_velocity(&self) -> Vector3<T> {
        self.frames[self.rotation().body_frame]
            .angular_velocity
            .expect("a body frame with angular velocity")
    }

    pub(super) fn rotation(&self) -> &Rotation {
        let rotation = self.body().rotation.as_ref();
        rotation.expect("a body with attitude, by the checker")
    }

    pub(super) fn body(&self) -> &Body {
        self.model.body.as_ref().expect("a body, by the checker")
    }
}
