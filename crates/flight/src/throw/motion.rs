//! Motion of the body that a model describes, as a function of the state; compiled from the body that the model
//! declares, or from its claim of one.

use std::cell::RefCell;
use std::f64::consts::TAU;

use codegen::compile::Selection;
use model_spec::model::{
    AuxVariable, ClaimedAttitude, Expr, ExprKind, FlightAxes, Model, Observation, Shape,
};
use model_spec::unit::Unit;
use nalgebra::{Matrix3, Vector3};

use super::ThrowError;
use crate::initial_conditions::Release;
use crate::{BoundModel, CompiledModel, Workspace};

/// Motion of a body at an instant, in the inertial frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// Position of the mass centre, m.
    pub position: Vector3<f64>,
    /// Velocity of the mass centre, m/s.
    pub velocity: Vector3<f64>,
    /// Attitude and angular velocity; `None` for a point mass.
    pub turning: Option<Turning>,
}

/// Attitude and angular velocity of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Turning {
    /// Axes of the body that point ahead, to the left and up at a release without angles, as columns, in the inertial
    /// frame ([`FlightAxes::release`](model_spec::model::FlightAxes::release)).
    pub axes: Matrix3<f64>,
    /// Angular velocity in the inertial frame, rad/s.
    pub rates: Vector3<f64>,
    /// Whether the body flies along the axis of its spin, as an arrow does, and not across it, as a disc does.
    pub is_along: bool,
}

impl Turning {
    /// Axis about which a positive spin of a [`Throw`](super::Throw) turns the other way: up, of a body that flies across
    /// it; backwards, of one that flies along it.
    pub fn axis(&self) -> Vector3<f64> {
        spin_axis(&self.axes, self.is_along)
    }
}

/// Axes of [`Turning::axes`], as columns, in the frame that is fixed in the body.
pub fn release_axes(axes: FlightAxes) -> Matrix3<f64> {
    Matrix3::from_columns(&axes.release().map(|own| Vector3::from(own.vector())))
}

/// See [`Turning::axis`].
pub(super) fn spin_axis(axes: &Matrix3<f64>, is_along: bool) -> Vector3<f64> {
    match is_along {
        true => -axes.column(0),
        false => axes.column(2).into_owned(),
    }
}

/// Motion of a model's body by state and parameters, compiled, to convert throws to states and states to throws.
pub struct ThrownModel {
    pub(super) name: String,
    pub(super) compiled: CompiledModel,
    has_attitude: bool,
    pub(super) is_along: bool,
    /// Axes of [`Turning::axes`], as columns, in the frame that is fixed in the body.
    release_axes: Matrix3<f64>,
    /// Indices of the columns of [`Turning::axes`] that turn with the body: of a mere axis of revolution, that axis.
    pub(super) fixed_axes: Vec<usize>,
    /// Indices of the states on which the motion of the body does not depend, such as those that effects add.
    pub(super) added: Vec<usize>,
    /// Indices of the states that are angles, those of the model's frames among them.
    pub(super) angles: Vec<usize>,
    /// State indices of each quaternion, scalar part first.
    pub(super) quaternions: Vec<[usize; 4]>,
}

/// Number of vectors that describe the motion of a body with attitude: position, velocity, three body axes, angular
/// velocity, three rows of the inertia tensor, three axes of the frame in which the tensor is given.
const VECTORS: usize = 12;

/// Vectors that describe the motion, in the order listed at [`VECTORS`]; for a point mass all but the first two are 0.
pub(super) struct Vectors(pub [Vector3<f64>; VECTORS]);

impl Vectors {
    /// Axes of the body, as columns, in the inertial frame.
    pub fn axes(&self) -> Matrix3<f64> {
        Matrix3::from_columns(&self.0[2..5])
    }

    /// Inertia tensor about the mass centre in inertial axes, kg m².
    pub fn inertia(&self) -> Matrix3<f64> {
        let [.., r1, r2, r3, e1, e2, e3] = self.0;
        e1 * r1.transpose() + e2 * r2.transpose() + e3 * r3.transpose()
    }
}

/// Value of `of` at the state with an offset of one component.
pub(super) fn with_offset<V>(
    state: &mut [f64],
    place: usize,
    offset: f64,
    of: impl FnOnce(&[f64]) -> V,
) -> V {
    let own = state[place];
    state[place] = own + offset;
    let value = of(state);
    state[place] = own;
    value
}

impl ThrownModel {
    /// Compiles the motion of a model's body.
    pub fn new(model: &Model) -> Result<ThrownModel, ThrowError> {
        let name = model.name.clone();
        let Some(vectors) = vectors(model) else {
            return Err(ThrowError::NoBody(name));
        };
        let axes = model
            .flight_axes()
            .map_or_else(Default::default, |own| own.1);
        let is_along = axes.is_along();
        let mut own = model.clone();
        // The motion at an instant depends on neither loads nor the observation.
        own.forces.clear();
        own.moments.clear();
        own.observation = None;
        let span = model
            .body
            .as_ref()
            .map_or_else(Default::default, |b| b.span);
        own.aux_variables
            .extend(vectors.iter().enumerate().map(|(k, value)| AuxVariable {
                span,
                ..AuxVariable::new(format!("motion__{k}"), value.clone())
            }));
        Ok(ThrownModel {
            name,
            compiled: CompiledModel::compiled_for(&own, &Selection::Only(Vec::new())),
            has_attitude: vectors.len() == VECTORS,
            is_along,
            release_axes: release_axes(axes),
            fixed_axes: match is_revolution(model) {
                true => vec![if is_along { 0 } else { 2 }],
                false => vec![0, 1, 2],
            },
            added: model.added_states(),
            angles: model.angle_states(),
            quaternions: model.quaternions().collect(),
        })
    }

    /// Whether the body has an attitude; false for a point mass.
    pub fn has_attitude(&self) -> bool {
        self.has_attitude
    }

    /// Axes of the frame that is fixed in the body, as columns, in the inertial frame; of a mere axis of revolution, of
    /// the frame of that axis.
    pub fn frame_axes(&self, turning: &Turning) -> Matrix3<f64> {
        turning.axes * self.release_axes.transpose()
    }

    /// Parameter vector for a release, in the order of the model's [`Layout`](codegen::Layout).
    pub fn release_parameters(&self, release: &Release) -> Vec<f64> {
        self.compiled.release_parameters(release).constants
    }

    /// Motion of the body for parameter values in the order of the model's [`Layout`](codegen::Layout).
    pub fn bind(&self, parameters: &[f64]) -> BoundMotion<'_> {
        let quantities = vec![0.0; self.compiled.layout().quantities.len()];
        BoundMotion {
            model: self,
            bound: self.compiled.bind(parameters.to_vec()),
            scratch: RefCell::new((Workspace::default(), Vec::new(), quantities)),
        }
    }

    /// Shifts angles to within half a turn of 0, and scales quaternions to length 1 with a scalar part of at least 0.
    pub fn normalise(&self, state: &mut [f64]) {
        for &angle in &self.angles {
            state[angle] -= TAU * (state[angle] / TAU).round();
        }
        for quaternion in &self.quaternions {
            let length = quaternion
                .iter()
                .map(|i| state[*i].powi(2))
                .sum::<f64>()
                .sqrt();
            let sign = if state[quaternion[0]] < 0.0 {
                -1.0
            } else {
                1.0
            };
            quaternion.iter().for_each(|i| state[*i] *= sign / length);
        }
    }
}

/// Copy of the model that observes, instead of a marker, the speed over the ground (m/s), the spin as in a
/// [`Throw`](super::Throw) (rpm; 0 for a point mass), and 0; `None` without a body.
pub fn speed_and_spin(model: &Model) -> Option<Model> {
    let vectors = vectors(model)?;
    let scalar = |kind| Expr {
        kind,
        shape: Shape::Scalar,
        unit: Unit::ONE,
        span: Default::default(),
    };
    let number = |value| scalar(ExprKind::Number { value, exact: None });
    let boxed = |of: &Expr| Box::new(of.clone());
    let speed = scalar(ExprKind::Norm(boxed(&vectors[1])));
    let spin = match vectors.get(5) {
        Some(rates) => {
            let (_, axes) = model.flight_axes()?;
            let (axis, sign) = match axes.is_along() {
                true => (&vectors[2], 1.0),
                false => (&vectors[4], -1.0),
            };
            let about = scalar(ExprKind::Dot(boxed(rates), boxed(axis)));
            let rpm = number(sign / super::RPM);
            scalar(ExprKind::Mul(Box::new(rpm), Box::new(about)))
        }
        None => number(0.0),
    };
    let value = Expr {
        shape: Shape::Vector(0),
        ..scalar(ExprKind::Components(Box::new([speed, spin, number(0.0)])))
    };
    let mut own = model.clone();
    own.forces.clear();
    own.moments.clear();
    own.observation = Some(Observation {
        name: "speed_and_spin".to_owned(),
        value,
        span: Default::default(),
    });
    Some(own)
}

/// Motion of a model's body with bound parameter values.
pub struct BoundMotion<'m> {
    pub(super) model: &'m ThrownModel,
    bound: BoundModel<'m>,
    /// Scratch memory, and the auxiliary variables, of which the last are the vectors of the motion.
    scratch: RefCell<(Workspace, Vec<f64>, Vec<f64>)>,
}

impl BoundMotion<'_> {
    /// Default state vector of the model.
    pub fn default_state(&self) -> Vec<f64> {
        self.model.compiled.layout().default_states()
    }

    /// Whether a state is within the model's limits of validity.
    pub fn is_within_limits(&self, state: &[f64]) -> bool {
        self.bound.observer().is_within_limits(0.0, state)
    }

    /// Motion of the body at a state.
    pub fn motion(&self, state: &[f64]) -> Motion {
        let vectors = self.vectors(state);
        Motion {
            position: vectors.0[0],
            velocity: vectors.0[1],
            turning: self.model.has_attitude.then(|| Turning {
                axes: vectors.axes(),
                rates: vectors.0[5],
                is_along: self.model.is_along,
            }),
        }
    }

    /// Inertia tensor about the mass centre in inertial axes at a state, kg m²; `None` for a point mass.
    pub fn inertia(&self, state: &[f64]) -> Option<Matrix3<f64>> {
        let has_attitude = self.model.has_attitude;
        has_attitude.then(|| self.vectors(state).inertia())
    }

    /// Differences of the motion at a state from `wanted`, by component; those of velocity relative to the wanted speed
    /// or 1 m/s, those of angular velocity to the wanted rate or 1 rad/s.
    pub fn differences(&self, state: &[f64], wanted: &Motion) -> Vec<f64> {
        let found = self.motion(state);
        let speed = wanted.velocity.norm().max(1.0);
        let mut all = vec![
            found.position - wanted.position,
            (found.velocity - wanted.velocity) / speed,
        ];
        if let (Some(found), Some(wanted)) = (&found.turning, &wanted.turning) {
            let rate = wanted.rates.norm().max(1.0);
            all.push((found.rates - wanted.rates) / rate);
            let fixed = self.model.fixed_axes.iter();
            all.extend(fixed.map(|&k| found.axes.column(k) - wanted.axes.column(k)));
        }
        all.iter().flat_map(|v| [v.x, v.y, v.z]).collect()
    }

    pub(super) fn vectors(&self, state: &[f64]) -> Vectors {
        let (workspace, parameters, quantities) = &mut *self.scratch.borrow_mut();
        let at = self.bound.at(0.0, state, parameters);
        self.bound.functions().quantities(at, workspace, quantities);
        let count = if self.model.has_attitude { VECTORS } else { 2 };
        let own = quantities[quantities.len() - 3 * count..].chunks_exact(3);
        let mut vectors = [Vector3::zeros(); VECTORS];
        for (vector, own) in vectors.iter_mut().zip(own) {
            *vector = Vector3::from_column_slice(own);
        }
        Vectors(vectors)
    }
}

/// Whether the model defines only the axis of a body of revolution, without a frame that rotates with the body.
pub(super) fn is_revolution(model: &Model) -> bool {
    let claim = model.claim.as_ref().filter(|_| model.body.is_none());
    let rotation = claim.and_then(|claim| claim.rotation.as_ref());
    rotation.is_some_and(|own| matches!(own.attitude, ClaimedAttitude::Axis(..)))
}

/// Expressions of the vectors that describe the motion, in the inertial frame and in the order of [`VECTORS`].
pub(super) fn vectors(model: &Model) -> Option<Vec<Expr>> {
    let vector = |kind, frame, unit| Expr {
        kind,
        shape: Shape::Vector(frame),
        unit,
        span: Default::default(),
    };
    let in_inertial = |value: &Expr| match value.shape {
        Shape::Vector(0) => value.clone(),
        _ => Expr {
            kind: ExprKind::Reexpress(Box::new(value.clone())),
            shape: Shape::Vector(0),
            ..value.clone()
        },
    };
    let axis = |frame, axis| in_inertial(&vector(ExprKind::Axis(frame, axis), frame, Unit::ONE));
    let flight_axes = model.flight_axes();
    let release_axes = flight_axes.into_iter().flat_map(|(frame, axes)| {
        axes.release().map(|own| {
            let along = axis(frame, own.number);
            match own.is_opposite {
                false => along,
                true => vector(ExprKind::Neg(Box::new(along)), 0, Unit::ONE),
            }
        })
    });
    let tensor = |rows: &[[Expr; 3]; 3], frame| {
        let row = |parts: &[Expr; 3]| {
            let parts = ExprKind::Components(Box::new(parts.clone()));
            in_inertial(&vector(parts, frame, Unit::INERTIA))
        };
        let frame_axes = [1, 2, 3].map(|k| axis(frame, k));
        rows.iter().map(row).chain(frame_axes).collect::<Vec<_>>()
    };
    if let Some(body) = &model.body {
        let velocity = vector(ExprKind::Velocity, body.velocity_frame, Unit::SPEED);
        let mut all = vec![
            vector(ExprKind::Position, 0, Unit::METRE),
            in_inertial(&velocity),
        ];
        if let Some(rotation) = &body.rotation {
            all.extend(release_axes);
            let frame = rotation.angular_velocity_frame;
            all.push(in_inertial(&vector(
                ExprKind::AngularVelocity,
                frame,
                Unit::RATE,
            )));
            all.extend(tensor(&rotation.inertia, rotation.inertia_frame));
        }
        return Some(all);
    }
    let claim = model.claim.as_ref()?;
    let mut all = vec![in_inertial(&claim.position), in_inertial(&claim.velocity)];
    let Some(rotation) = &claim.rotation else {
        return Some(all);
    };
    all.extend(release_axes);
    all.push(in_inertial(&rotation.angular_velocity));
    all.extend(tensor(&rotation.inertia, rotation.inertia_frame));
    Some(all)
}
