//! Vectors of a body's motion as compiled functions of state and parameters, with their Jacobians.

use codegen::Layout;
use codegen::compile::Selection;
use model_spec::model::{Expr, ExprKind, Model, Observation, Shape};
use model_spec::unit::Unit;

use super::motion::{is_revolution, vectors};
use crate::CompiledModel;

/// Vector of the motion of a body, in the inertial frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionVector {
    /// Position of the mass centre, m.
    Position,
    /// Velocity of the mass centre, m/s.
    Velocity,
    /// Angular velocity, rad/s; of a point mass its vector `spin`, or else `omega`.
    Spin,
    /// Axis of the body that points up at a release without angles.
    Axis,
    /// Axis of the body that points ahead.
    FirstAxis,
    /// Angular momentum about the mass centre, kg m²/s.
    Momentum,
}

/// Names of the vectors of a point mass that are its spin, the first that it has.
const SPINS: [&str; 2] = ["spin", "omega"];

impl MotionVector {
    /// Compiles a model that observes this vector in place of a marker, or `None` if the motion has no such vector.
    pub fn compile(self, model: &Model) -> Option<CompiledModel> {
        let mut own = model.clone();
        own.forces.clear();
        own.moments.clear();
        own.observation = Some(Observation {
            name: "motion".to_owned(),
            value: self.of(model)?,
            span: Default::default(),
        });
        let parameters = (0..Layout::new(model).parameters.len()).collect();
        Some(CompiledModel::compiled_for(
            &own,
            &Selection::Only(parameters),
        ))
    }

    fn of(self, model: &Model) -> Option<Expr> {
        let all = vectors(model)?;
        let place = match self {
            Self::Position => 0,
            Self::Velocity => 1,
            Self::FirstAxis if is_revolution(model) => return None,
            Self::FirstAxis => 2,
            Self::Axis => 4,
            Self::Spin => return all.get(5).cloned().or_else(|| spin_of_point(model)),
            Self::Momentum => return momentum(&all),
        };
        all.get(place).cloned()
    }
}

/// The spin of a point mass: a vector of the model, or one of its inputs.
fn spin_of_point(model: &Model) -> Option<Expr> {
    let vector = |kind, frame| Expr {
        kind,
        shape: Shape::Vector(frame),
        unit: Unit::RATE,
        span: Default::default(),
    };
    let of_variable = |name: &str| {
        let mut all = model.aux_variables.iter();
        let index = all.position(|own| own.name == name && own.value.unit == Unit::RATE)?;
        match model.aux_variables[index].value.shape {
            Shape::Vector(frame) => Some(vector(ExprKind::AuxVariable(index), frame)),
            Shape::Scalar => None,
        }
    };
    let of_input = |name: &str| {
        let index = model.inputs.iter().position(|own| own.name == name)?;
        Some(vector(ExprKind::Input(index), model.inputs[index].frame))
    };
    SPINS
        .iter()
        .find_map(|name| of_variable(name).or_else(|| of_input(name)))
}

/// Angular momentum: the sum over the axes of the inertia tensor of axis times row of the tensor times angular velocity.
fn momentum(all: &[Expr]) -> Option<Expr> {
    let [_, _, _, _, _, rates, r1, r2, r3, e1, e2, e3] = all else {
        return None;
    };
    let boxed = |of: &Expr| Box::new(of.clone());
    let part = |row: &Expr, axis: &Expr| {
        let along = Expr {
            kind: ExprKind::Dot(boxed(row), boxed(rates)),
            shape: Shape::Scalar,
            ..row.clone()
        };
        Expr {
            kind: ExprKind::Mul(Box::new(along), boxed(axis)),
            ..row.clone()
        }
    };
    let sum = |a: Expr, b: Expr| Expr {
        kind: ExprKind::Add(Box::new(a.clone()), Box::new(b)),
        ..a
    };
    Some(sum(sum(part(r1, e1), part(r2, e2)), part(r3, e3)))
}
