//! What screening asks of the model of a body.

use flight::CompiledModel;
use model_spec::model::Model;

use crate::Flight;
use crate::pose::RigidMotion;
use crate::pose_points::PosePoints;

/// The body whose flights are screened.
pub trait Body: Sync {
    /// The model, whose inertia, gravity and axes are compared with the recordings.
    fn model(&self) -> &Model;

    /// The compiled model.
    fn compiled(&self) -> &CompiledModel;

    /// Values of all parameters in the order of the compiled model, SI.
    fn parameters(&self) -> &[f64];

    /// The points that show its pose.
    fn points(&self) -> &PosePoints;

    /// Whether positions are measured.
    fn sees_positions(&self) -> bool;

    /// Of each of [`marker_pairs`](super::marker_pairs), whether its distance is the same in every state and for every value
    /// of a coefficient.
    fn rigid_pairs(&self) -> Vec<bool>;

    /// The states in which the body moves so in a flight; `None` where there is none.
    fn states(&self, flight: &Flight, motions: &[RigidMotion]) -> Vec<Option<Vec<f64>>>;
}
