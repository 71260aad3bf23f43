//! Measurement equations of all channels for given parameters.

use flight::{BoundModel, FlightParameters, ModelObserver, ObservationJacobians};
use model_spec::layout::ParamId;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use crate::channel::{Channel, ChannelKind};
use crate::problem::FitProblem;

/// Components of the input `marker_is`, by which effects refer to single markers: component k is 1 for marker k.
const MARKER_IS: [&str; 3] = ["marker_is_x", "marker_is_y", "marker_is_z"];

/// Component of the input `pose_is` by which effects refer to the attitudes of poses: it is 1 for them.
const ATTITUDE_IS: &str = "pose_is_x";

/// Unit vectors along the axes of the body, as points in body components.
const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Compiled models with the parameter values of one flight, for the measurement equations of all channels.
pub struct ChannelConditions<'a> {
    problem: &'a FitProblem,
    /// One model per marker, one for other points of the body, and one for attitudes; or one for all, if no effect refers to
    /// one of them.
    points: Vec<BoundModel<'a>>,
    instruments: Vec<BoundModel<'a>>,
}

impl<'a> ChannelConditions<'a> {
    /// Binds the models to the parameters of a flight, in the order of the compiled model's parameter vector.
    pub fn new(problem: &'a FitProblem, parameters: &FlightParameters) -> Self {
        let layout = problem.body.layout();
        let place = |name: &str| layout.parameter(name).map(ParamId::index);
        let (of_markers, of_attitudes) = (MARKER_IS.map(place), place(ATTITUDE_IS));
        let bound = |seen: Option<ChannelKind>| {
            let mut parameters = parameters.clone();
            for (axis, place) in of_markers.iter().enumerate() {
                if let Some(place) = *place {
                    let is_seen = seen == Some(ChannelKind::Marker(axis));
                    parameters.constants[place] = f64::from(u8::from(is_seen));
                }
            }
            if let Some(place) = of_attitudes {
                let is_seen = seen == Some(ChannelKind::Attitude);
                parameters.constants[place] = f64::from(u8::from(is_seen));
            }
            problem.body.bind(parameters)
        };
        let markers = problem.channels.iter().filter(|own| own.is_marker());
        let each = (0..markers.count()).map(|marker| Some(ChannelKind::Marker(marker)));
        let each = each.chain([None, Some(ChannelKind::Attitude)]);
        let is_any = of_markers
            .iter()
            .chain([&of_attitudes])
            .any(Option::is_some);
        let points = match is_any {
            true => each.map(bound).collect(),
            false => vec![bound(None)],
        };
        let instruments = problem.instruments.iter();
        Self {
            problem,
            points,
            instruments: instruments
                .map(|(_, own)| own.bind(parameters.clone()))
                .collect(),
        }
    }

    /// Returns evaluators of the measurement equations of all channels.
    pub fn observers(&self) -> ChannelObservers<'_> {
        ChannelObservers {
            problem: self.problem,
            points: self.points.iter().map(BoundModel::observer).collect(),
            instruments: self.instruments.iter().map(BoundModel::observer).collect(),
        }
    }
}

/// Evaluators of the measurement equations of all channels: predicted values from state and time.
pub struct ChannelObservers<'a> {
    problem: &'a FitProblem,
    points: Vec<ModelObserver<'a>>,
    instruments: Vec<ModelObserver<'a>>,
}

impl Channel {
    fn residual(&self, predicted: [f64; 3], measured: [f64; 3]) -> [f64; 3] {
        let last = self.components - 1;
        [0, 1, 2].map(|axis| (predicted[axis.min(last)] - measured[axis]) * self.scale)
    }
}

impl<'a> ChannelObservers<'a> {
    fn observer(&mut self, kind: ChannelKind) -> &mut ModelObserver<'a> {
        let last = self.points.len() - 1;
        match kind {
            ChannelKind::Instrument(index) => &mut self.instruments[index],
            ChannelKind::Marker(marker) => &mut self.points[marker.min(last)],
            ChannelKind::Attitude => &mut self.points[last],
            // Summaries are no measurements at a time, and are evaluated by themselves.
            ChannelKind::Position | ChannelKind::Summary(_) => {
                &mut self.points[last.saturating_sub(1)]
            }
        }
    }

    /// Residual, (predicted − measured) × scale, at time `t` (s) and state `x`. A scalar residual is repeated three times.
    pub fn residual(&mut self, t: f64, x: &[f64], channel: usize, measured: [f64; 3]) -> [f64; 3] {
        let problem = self.problem;
        let own = &problem.channels[channel];
        let observer = self.observer(own.kind);
        if own.kind == ChannelKind::Attitude {
            let mut at = |point| Vector3::from(observer.position(t, x, point));
            let origin = at(&[0.0; 3]);
            let predicted = AXES.each_ref().map(|axis| at(axis) - origin);
            return rotation(measured, predicted).map(|r| r * own.scale).into();
        }
        own.residual(observer.position(t, x, &own.position), measured)
    }

    /// Predicted value of a channel other than an attitude, with its Jacobians with respect to states and parameters.
    pub fn observe(
        &mut self,
        t: f64,
        x: &[f64],
        channel: usize,
    ) -> ([f64; 3], ObservationJacobians<'_>) {
        let own = &self.problem.channels[channel];
        self.observer(own.kind)
            .position_with_jacobians(t, x, &own.position)
    }

    /// Residual as that of [`residual`](Self::residual). Also writes its derivatives into `rows`, one row per axis;
    /// `derive` converts the Jacobians with respect to states and parameters into these rows.
    pub fn linearise(
        &mut self,
        (t, x): (f64, &[f64]),
        channel: usize,
        measured: [f64; 3],
        rows: &mut [Vec<f64>; 3],
        mut derive: impl FnMut(&ObservationJacobians<'_>, &mut [Vec<f64>; 3]),
    ) -> [f64; 3] {
        let own = &self.problem.channels[channel];
        let residual = if own.kind == ChannelKind::Attitude {
            let residual = self.attitude((t, x), measured, rows, derive);
            residual.map(|r| r * own.scale).into()
        } else {
            let (y, by) = self.observe(t, x, channel);
            derive(&by, rows);
            own.residual(y, measured)
        };
        if own.scale != 1.0 {
            let values = rows.iter_mut().flatten();
            values.for_each(|value| *value *= own.scale);
        }
        residual
    }

    /// Attitude residual, rad, which is linear in the predicted directions of the body's axes; writes its derivatives
    /// into `rows`.
    fn attitude(
        &mut self,
        (t, x): (f64, &[f64]),
        measured: [f64; 3],
        rows: &mut [Vec<f64>; 3],
        mut derive: impl FnMut(&ObservationJacobians<'_>, &mut [Vec<f64>; 3]),
    ) -> Vector3<f64> {
        let observer = self.observer(ChannelKind::Attitude);
        let seen = axes(measured);
        let (mut of_origin, mut of_axis) = (rows.clone(), rows.clone());
        let (origin, by) = observer.position_with_jacobians(t, x, &[0.0; 3]);
        derive(&by, &mut of_origin);
        rows.iter_mut().for_each(|row| row.fill(0.0));
        let mut predicted = [Vector3::zeros(); 3];
        for (k, axis) in AXES.iter().enumerate() {
            let (tip, by) = observer.position_with_jacobians(t, x, axis);
            derive(&by, &mut of_axis);
            predicted[k] = Vector3::from(tip) - Vector3::from(origin);
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

/// Rotation matrix of a rotation vector (rad); its columns are the axes of the body in the inertial frame.
fn axes(rotation: [f64; 3]) -> Matrix3<f64> {
    let turn = UnitQuaternion::from_scaled_axis(Vector3::from(rotation));
    *turn.to_rotation_matrix().matrix()
}

/// Rotation vector, inertial frame, from the measured attitude to the predicted axes; its length is the sine of the
/// angle.
fn rotation(measured: [f64; 3], predicted: [Vector3<f64>; 3]) -> Vector3<f64> {
    let seen = axes(measured);
    let each = predicted.iter().enumerate();
    let sum: Vector3<f64> = each
        .map(|(k, axis)| seen.column(k).cross(axis) / axis.norm())
        .sum();
    0.5 * sum
}
