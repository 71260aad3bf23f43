//! Measurement equations of all channels for given parameters.

use flight::{BoundModel, ModelObserver};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use crate::channel::ChannelKind;
use crate::marker_observers::{MarkerConditions, MarkerObservers};
use crate::problem::FitProblem;

/// Compiled model with the parameter values of one flight, for evaluating the measurement equations of all channels
/// (markers and sensor quantities).
pub struct ChannelConditions<'a> {
    problem: &'a FitProblem,
    markers: MarkerConditions<'a>,
    instruments: Vec<BoundModel<'a>>,
}

impl<'a> ChannelConditions<'a> {
    /// Creates the evaluation model for a flight from its parameters, given in the order of the compiled model's
    /// parameter vector.
    pub fn new(problem: &'a FitProblem, parameters: &[f64]) -> Self {
        let channels = problem.channels.iter();
        let markers = channels.filter(|own| own.is_marker()).count();
        let instruments = problem.instruments.iter();
        Self {
            problem,
            markers: MarkerConditions::new(&problem.body, parameters, markers),
            instruments: instruments
                .map(|(_, own)| own.bind(parameters.to_vec()))
                .collect(),
        }
    }

    /// Returns evaluators of the measurement equations of all channels (markers and sensor quantities).
    pub fn observers(&self) -> ChannelObservers<'_> {
        ChannelObservers {
            problem: self.problem,
            markers: self.markers.observers(),
            instruments: self.instruments.iter().map(BoundModel::observer).collect(),
        }
    }
}

/// Evaluators of the measurement equations of all channels (markers and sensor quantities): predicted values from state
/// and time.
pub struct ChannelObservers<'a> {
    problem: &'a FitProblem,
    markers: MarkerObservers<'a>,
    instruments: Vec<ModelObserver<'a>>,
}

/// Marker index that is used for a point on the body that is not a marker.
const NO_MARKER: usize = usize::MAX;

/// Unit vectors along the axes of the body, as points in body components.
const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl ChannelObservers<'_> {
    /// Residual of a channel, (predicted − measured) × scale of the channel, at time `t` (s) and state `x`. A scalar
    /// residual is repeated in all three components.
    pub fn residual(&mut self, t: f64, x: &[f64], channel: usize, measured: [f64; 3]) -> [f64; 3] {
        let own = &self.problem.channels[channel];
        let y = match own.kind {
            ChannelKind::Marker(marker) => self.markers.position(t, x, (marker, &own.position)),
            ChannelKind::Position => self.markers.position(t, x, (NO_MARKER, &own.position)),
            ChannelKind::Instrument(index) => {
                let y = self.instruments[index].position(t, x, &own.position);
                if own.components == 1 { [y[0]; 3] } else { y }
            }
            ChannelKind::Attitude => {
                let origin: Vector3<f64> =
                    self.markers.position(t, x, (NO_MARKER, &[0.0; 3])).into();
                let mut at = |axis| {
                    let tip: Vector3<f64> = self.markers.position(t, x, (NO_MARKER, axis)).into();
                    tip - origin
                };
                let predicted = [at(&AXES[0]), at(&AXES[1]), at(&AXES[2])];
                return rotation(measured, predicted).map(|r| r * own.scale).into();
            }
        };
        [0, 1, 2].map(|axis| (y[axis] - measured[axis]) * own.scale)
    }

    /// Residual of a channel, (predicted − measured) × scale of the channel, at time `t` (s) and state `x`. Also writes
    /// the derivatives of the residual into `rows`, one row per axis. `derive` converts the Jacobians with respect to
    /// states and parameters into these rows.
    pub fn linearise(
        &mut self,
        (t, x): (f64, &[f64]),
        channel: usize,
        measured: [f64; 3],
        rows: &mut [Vec<f64>; 3],
        mut derive: impl FnMut(&flight::ObservationJacobians<'_>, &mut [Vec<f64>; 3]),
    ) -> [f64; 3] {
        let own = &self.problem.channels[channel];
        let y = match own.kind {
            ChannelKind::Marker(marker) => {
                let (y, by) = self.markers.linearise(t, x, (marker, &own.position));
                derive(&by, rows);
                y
            }
            ChannelKind::Position => {
                let (y, by) = self.markers.linearise(t, x, (NO_MARKER, &own.position));
                derive(&by, rows);
                y
            }
            ChannelKind::Instrument(index) => {
                let instrument = &mut self.instruments[index];
                let (y, by) = instrument.position_with_jacobians(t, x, &own.position);
                derive(&by, rows);
                if own.components == 1 { [y[0]; 3] } else { y }
            }
            ChannelKind::Attitude => {
                let residual = self.attitude((t, x), measured, rows, derive);
                scale(rows, own.scale);
                return residual.map(|r| r * own.scale).into();
            }
        };
        if own.scale != 1.0 {
            scale(rows, own.scale);
        }
        [0, 1, 2].map(|axis| (y[axis] - measured[axis]) * own.scale)
    }

    /// Returns the attitude residual, rad, and writes its derivatives into `rows`, one row per axis. The residual is
    /// linear in the predicted directions of the body's axes. `derive` converts the Jacobians with respect to states
    /// and parameters into these rows.
    fn attitude(
        &mut self,
        (t, x): (f64, &[f64]),
        measured: [f64; 3],
        rows: &mut [Vec<f64>; 3],
        mut derive: impl FnMut(&flight::ObservationJacobians<'_>, &mut [Vec<f64>; 3]),
    ) -> Vector3<f64> {
        let seen = axes(measured);
        let (origin, by) = self.markers.linearise(t, x, (NO_MARKER, &[0.0; 3]));
        let origin = Vector3::from(origin);
        let mut of_origin = rows.clone();
        derive(&by, &mut of_origin);
        let mut of_axis = rows.clone();
        rows.iter_mut().for_each(|row| row.fill(0.0));
        let mut predicted = [Vector3::zeros(); 3];
        for (k, axis) in AXES.iter().enumerate() {
            let (tip, by) = self.markers.linearise(t, x, (NO_MARKER, axis));
            derive(&by, &mut of_axis);
            predicted[k] = Vector3::from(tip) - origin;
            // Derivative of the direction only: a change of the length of a predicted axis is no rotation.
            let length = predicted[k].norm();
            let direction = predicted[k] / length;
            let across = (Matrix3::identity() - direction * direction.transpose()) / length;
            let half_cross = 0.5 * seen.column(k).cross_matrix() * across;
            for (to, weights) in rows.iter_mut().zip(half_cross.row_iter()) {
                for (from, weight) in weights.iter().enumerate() {
                    let pairs = of_axis[from].iter().zip(&of_origin[from]);
                    for (to, (tip, origin)) in to.iter_mut().zip(pairs) {
                        *to += weight * (tip - origin);
                    }
                }
            }
        }
        rotation(measured, predicted)
    }
}

fn scale(rows: &mut [Vec<f64>; 3], scale: f64) {
    rows.iter_mut().flatten().for_each(|value| *value *= scale);
}

/// Rotation matrix of a rotation vector (rad); its columns are the axes of the body in the inertial frame.
fn axes(rotation: [f64; 3]) -> Matrix3<f64> {
    let turn = UnitQuaternion::from_scaled_axis(Vector3::from(rotation));
    *turn.to_rotation_matrix().matrix()
}

/// Rotation vector, in the inertial frame, from the measured attitude to the predicted directions of the body's axes.
/// Its length is the sine of the rotation angle.
fn rotation(measured: [f64; 3], predicted: [Vector3<f64>; 3]) -> Vector3<f64> {
    let seen = axes(measured);
    let each = predicted.iter().enumerate();
    let sum: Vector3<f64> = each
        .map(|(k, axis)| seen.column(k).cross(axis) / axis.norm())
        .sum();
    0.5 * sum
}
