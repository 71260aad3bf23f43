//! Vector tree of a model, evaluated in inertial components.
//!
//! Every vector is converted to inertial components as soon as it is evaluated. Expressing it in another frame then has
//! no effect, and a component is a scalar product with an axis.

mod body;

use crate::frames::{PlacedFrame, place_frames};
use crate::point::Point;
use crate::scalar::{Infinitesimals, Interpolant, Real, Surface, call};
use crate::system::{Solved, eliminate};
use model_spec::layout::{depending_on_unknown, depends_on_accelerations, needed};
use model_spec::model::{Expr, ExprKind, Function, Load, Model, Shape, Table};
use nalgebra::Vector3;
use std::cell::OnceCell;

/// Value of an expression: scalar or vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<T> {
    /// Value of a scalar expression.
    Scalar(T),
    /// Value of a vector expression, in inertial components.
    Vector(Vector3<T>),
}

/// Direct evaluation of a model's vector expressions at a point: the frames and auxiliary variables of the model, with
/// all vectors in inertial components.
pub struct Tree<'a, T> {
    /// Model that is evaluated.
    pub model: &'a Model,
    /// Point at which the model is evaluated.
    pub point: &'a Point<T>,
    /// Axes and angular velocity of each frame of the model at the point, in the order of the model's frames.
    pub frames: Vec<PlacedFrame<T>>,
    /// Values of the model's auxiliary variables at the point, in the order of the model.
    pub aux_variables: Vec<Value<T>>,
    /// Unknowns of the model's systems, and how well their equations determine them.
    unknowns: Vec<Vec<T>>,
    determinacies: Vec<f64>,
    /// Interpolated tables, each once it is read.
    tables: Vec<OnceCell<Lookup<'a>>>,
    /// Derivatives of the states of the body by its laws, with loads and without, once they are asked for.
    body_rates: [OnceCell<Vec<T>>; 2],
    /// Number of the infinitesimals that are in use, by derivatives around this evaluation.
    level: usize,
}

/// Interpolated table of a model.
#[derive(Clone)]
enum Lookup<'a> {
    One(Interpolant<'a>),
    Two(Surface<'a>),
}

impl<'a> Lookup<'a> {
    fn new(table: &'a Table) -> Self {
        match table.arguments.len() {
            1 => Lookup::One(Interpolant::new(table)),
            _ => Lookup::Two(Surface::new(table)),
        }
    }
}

impl<'a, T: Real> Tree<'a, T> {
    /// Evaluates the frames and auxiliary variables of a model at a point.
    pub fn new(model: &'a Model, point: &'a Point<T>) -> Self {
        Self::overriding(model, point, &[])
    }

    /// Evaluates a model at a point; auxiliary variables listed in `given` have the values stated there, as pairs
    /// (index of the auxiliary variable, value), instead of those computed from their definitions.
    pub fn overriding(model: &'a Model, point: &'a Point<T>, given: &[(usize, Value<T>)]) -> Self {
        let (mut unknowns, mut determinacies) = (Vec::new(), Vec::new());
        for _ in &model.systems {
            let solved = solved(model, point, given, &unknowns);
            unknowns.push(solved.unknowns);
            determinacies.push(solved.determinacy);
        }
        let tree = Self::evaluated(model, point, given, unknowns);
        Self {
            determinacies,
            ..tree
        }
    }

    /// Evaluates at a point what some expressions of a model depend on. Unknowns of its systems, which are not solved for,
    /// are zero.
    pub fn without_unknowns(model: &'a Model, point: &'a Point<T>, of: &[&Expr]) -> Self {
        let systems = model.systems.iter();
        let zeros = systems.map(|own| vec![T::zero(); own.unknowns.len()]);
        let mut tree = Self::unevaluated(model, point, zeros.collect(), 0);
        tree.evaluate_for(of);
        tree
    }

    /// Evaluates the auxiliary variables on which expressions depend; all others are zero.
    fn evaluate_for(&mut self, of: &[&Expr]) {
        let model = self.model;
        for (named, is_needed) in model.aux_variables.iter().zip(needed(model, of)) {
            let value = match is_needed {
                true => self.value(&named.value),
                false => Value::Scalar(T::zero()),
            };
            self.aux_variables.push(value);
        }
    }

    /// Evaluates a model at a point for unknowns of its systems; they need not fulfil their equations.
    pub(crate) fn evaluated(
        model: &'a Model,
        point: &'a Point<T>,
        given: &[(usize, Value<T>)],
        unknowns: Vec<Vec<T>>,
    ) -> Self {
        let mut tree = Self::unevaluated(model, point, unknowns, 0);
        let of_motion = depends_on_accelerations(model);
        let mut stated = vec![None; model.aux_variables.len()];
        for (index, value) in given {
            stated[*index] = Some(*value);
        }
        for (index, named) in model.aux_variables.iter().enumerate() {
            let value = match stated[index] {
                Some(value) => value,
                // Computed below, once everything that the loads depend on is known.
                None if of_motion[index] => Value::Scalar(T::zero()),
                None => tree.value(&named.value),
            };
            tree.aux_variables.push(value);
        }
        for (index, named) in model.aux_variables.iter().enumerate() {
            if of_motion[index] && stated[index].is_none() {
                tree.aux_variables[index] = tree.value(&named.value);
            }
        }
        tree
    }

    /// A model at a point, without its auxiliary variables.
    fn unevaluated(
        model: &'a Model,
        point: &'a Point<T>,
        unknowns: Vec<Vec<T>>,
        level: usize,
    ) -> Self {
        let mut tree = Self {
            model,
            point,
            frames: Vec::new(),
            aux_variables: Vec::with_capacity(model.aux_variables.len()),
            unknowns,
            determinacies: Vec::new(),
            tables: vec![OnceCell::new(); model.tables.len()],
            body_rates: [OnceCell::new(), OnceCell::new()],
            level,
        };
        let angles: Vec<&Expr> = model.constant_angles.iter().collect();
        tree.evaluate_for(&angles);
        let angles: Vec<T> = angles.iter().map(|angle| tree.scalar(angle)).collect();
        tree.aux_variables.clear();
        tree.frames = place_frames(model, point, &angles);
        tree
    }

    /// Derivative of an expression in the direction that `direct` gives to the point, as factors of an infinitesimal.
    fn differentiated(
        &self,
        of: &Expr,
        direct: impl FnOnce(&mut Point<T::Jet>, T::Jet),
    ) -> Value<T> {
        let mut point = self.point.map(T::jet);
        direct(&mut point, T::Jet::epsilon(self.level));
        let unknowns = jets(&self.unknowns);
        let mut tree = Tree::unevaluated(self.model, &point, unknowns, self.level + 1);
        tree.evaluate_for(&[of]);
        let part = |value: T::Jet| T::of_jet(value.coefficient(self.level));
        tree.value(of).map(part)
    }

    fn table(&self, index: usize) -> &Lookup<'a> {
        self.tables[index].get_or_init(|| Lookup::new(&self.model.tables[index]))
    }

    /// Evaluates a scalar expression of the model at the point.
    pub fn scalar(&self, e: &Expr) -> T {
        match self.value(e) {
            Value::Scalar(s) => s,
            Value::Vector(_) => panic!("a scalar expression, by the checker"),
        }
    }

    /// Evaluates a vector expression of the model at the point, in inertial components.
    pub fn vector(&self, e: &Expr) -> Vector3<T> {
        match self.value(e) {
            Value::Vector(v) => v,
            Value::Scalar(_) => panic!("a vector expression, by the checker"),
        }
    }

    /// Sum of the forces or moments in `loads`, in inertial components, N or N·m.
    pub fn total(&self, loads: &[Load]) -> Vector3<T> {
        loads
            .iter()
            .fold(Vector3::zeros(), |sum, load| sum + self.vector(&load.value))
    }

    /// Seconds of true time per second of recorded time at the point; 1 unless the model declares a clock.
    pub fn clock(&self) -> T {
        let stated = self.model.clock.as_ref();
        stated.map_or_else(|| T::lit(1.0), |clock| self.scalar(&clock.value))
    }

    /// Evaluates a scalar or vector expression of the model at the point; vectors are in inertial components.
    pub fn value(&self, e: &Expr) -> Value<T> {
        use ExprKind as K;
        use Value::{Scalar, Vector};
        let lit = |v: f64| Scalar(T::lit(v));
        match &e.kind {
            K::Number { value, .. } => lit(*value),
            K::Pi => lit(std::f64::consts::PI),
            K::Time => Scalar(self.point.time),
            K::Param(i) => Scalar(self.point.params[*i]),
            K::Coefficient(i) => Scalar(self.point.coefficients[*i]),
            K::Input(i) => {
                Vector(self.frames[self.model.inputs[*i].frame].axes * self.point.inputs[*i])
            }
            K::State(i) => Scalar(self.point.states[*i]),
            K::AuxVariable(i) => self.aux_variables[*i],
            K::Unknown(system, k) => Scalar(self.unknowns[*system][*k]),
            K::Rate(of, states, rates) => {
                let rates: Vec<T> = rates.iter().map(|rate| self.scalar(rate)).collect();
                let seconds = T::one() / self.clock();
                self.differentiated(of, |point, epsilon| {
                    point.time += seconds.jet() * epsilon;
                    for (state, rate) in states.iter().zip(rates) {
                        point.states[*state] += rate.jet() * epsilon;
                    }
                })
            }
            K::BodyRate(state, loads) => Scalar(self.body_rate(*state, loads.is_empty())),
            K::Partial(of, state) => {
                self.differentiated(of, |point, epsilon| point.states[*state] += epsilon)
            }
            K::Determinacy(system) => lit(self.determinacies.get(*system).copied().unwrap_or(1.0)),
            K::Axis(frame, axis) => Vector(
                self.frames[*frame]
                    .axes
                    .column(usize::from(*axis) - 1)
                    .into_owned(),
            ),
            K::Position => Vector(self.states(self.body().position)),
            K::Velocity => {
                let body = self.body();
                Vector(self.frames[body.velocity_frame].axes * self.states(body.velocity))
            }
            K::AngularVelocity => Vector(self.angular_velocity()),
            K::SpecificForce => Vector(self.specific_force()),
            K::AngularAcceleration => Vector(self.angular_acceleration()),
            K::Marker => {
                let marker = self
                    .model
                    .marker
                    .as_ref()
                    .expect("a marker, by the checker");
                Vector(self.frames[marker.frame].axes * self.point.marker)
            }
            K::Components(parts) => {
                let [a, b, c] = &**parts;
                let parts = Vector3::new(self.scalar(a), self.scalar(b), self.scalar(c));
                match e.shape {
                    // The axes of the inertial frame are those in which everything is.
                    Shape::Vector(0) => Vector(parts),
                    Shape::Vector(frame) => Vector(self.frames[frame].axes * parts),
                    Shape::Scalar => panic!("components of a vector, by the checker"),
                }
            }
            K::Neg(a) => match self.value(a) {
                Scalar(a) => Scalar(-a),
                Vector(a) => Vector(-a),
            },
            K::Add(a, b) => match self.value(a) {
                Scalar(a) => Scalar(a + self.scalar(b)),
                Vector(a) => Vector(a + self.vector(b)),
            },
            K::Sub(a, b) => match self.value(a) {
                Scalar(a) => Scalar(a - self.scalar(b)),
                Vector(a) => Vector(a - self.vector(b)),
            },
            K::Mul(a, b) => match (self.value(a), self.value(b)) {
                (Scalar(a), Scalar(b)) => Scalar(product(a, b)),
                (Scalar(s), Vector(v)) | (Vector(v), Scalar(s)) => {
                    Vector(v.map(|part| product(part, s)))
                }
                (Vector(_), Vector(_)) => panic!("at most one vector factor, by the checker"),
            },
            K::Div(a, b) => {
                let b = self.scalar(b);
                match self.value(a) {
                    Scalar(a) => Scalar(a / b),
                    Vector(a) => Vector(a / b),
                }
            }
            K::Ratio(parts) => {
                let [a, b, otherwise] = &**parts;
                let divisor = self.scalar(b);
                if divisor.re() == 0.0 {
                    self.value(otherwise)
                } else {
                    Scalar(self.scalar(a) / divisor)
                }
            }
            K::Pow(a, doubled) => {
                let a = self.scalar(a);
                Scalar(if doubled % 2 == 0 {
                    a.powi(doubled / 2)
                } else {
                    a.sqrt().powi(*doubled)
                })
            }
            K::RealPower(a, b) => {
                let (a, b) = (self.scalar(a), self.scalar(b));
                let above = call(Function::Step, a);
                Scalar(above * (b * call(Function::Log, a)).exp())
            }
            K::Dot(a, b) => Scalar(self.vector(a).dot(&self.vector(b))),
            K::Cross(a, b) => Vector(self.vector(a).cross(&self.vector(b))),
            K::Norm(a) => Scalar(norm(&self.vector(a))),
            K::Direction(a, otherwise) => {
                let v = self.vector(a);
                let length = norm(&v);
                match otherwise {
                    _ if length.re() != 0.0 => Vector(v / length),
                    Some(otherwise) => self.value(otherwise),
                    None => Vector(Vector3::zeros()),
                }
            }
            K::Component(a, axis) => {
                let Shape::Vector(frame) = a.shape else {
                    panic!("a component of a vector, by the checker")
                };
                let (column, of) = (usize::from(*axis) - 1, self.vector(a));
                Scalar(match frame {
                    0 => of[column],
                    _ => self.frames[frame].axes.column(column).dot(&of),
                })
            }
            K::Reexpress(a) => self.value(a),
            K::Call(Function::Table(index), a) => match self.table(*index) {
                Lookup::One(curve) => Scalar(self.scalar(a).interpolated(curve, 0)),
                Lookup::Two(_) => panic!("a table of one argument, by the checker"),
            },
            K::Lookup(index, a, b) => match self.table(*index) {
                Lookup::One(_) => panic!("a table of two arguments, by the checker"),
                Lookup::Two(surface) => {
                    let (a, b) = (self.scalar(a), self.scalar(b));
                    Scalar(a.on_surface(b, surface, [0, 0]))
                }
            },
            K::Call(function, a) => Scalar(call(*function, self.scalar(a))),
            K::Atan2(y, x) => Scalar(self.scalar(y).atan2(self.scalar(x))),
            K::Min(a, b) => {
                let (a, b) = (self.scalar(a), self.scalar(b));
                Scalar(if a.re() < b.re() { a } else { b })
            }
            K::Max(a, b) => {
                let (a, b) = (self.scalar(a), self.scalar(b));
                Scalar(if a.re() > b.re() { a } else { b })
            }
        }
    }
}

/// Product of two scalars; 0 where one is 0 with derivative 0, as a switch that is off, and the other overflows.
fn product<T: Real>(a: T, b: T) -> T {
    let vanishes = |a: T, b: T| a.is_zero() && b.re().is_infinite();
    if vanishes(a, b) || vanishes(b, a) {
        return T::zero();
    }
    a * b
}

/// Euclidean norm of a vector; 0 with derivative 0 at the zero vector.
pub fn norm<T: Real>(v: &Vector3<T>) -> T {
    v.dot(v).sqrt()
}

/// Values of unknowns, as numbers with derivatives.
fn jets<T: Real>(unknowns: &[Vec<T>]) -> Vec<Vec<T::Jet>> {
    let lifted = |own: &Vec<T>| own.iter().map(|value| value.jet()).collect();
    unknowns.iter().map(lifted).collect()
}

/// Solves a system of a model at a point: its equations are evaluated with an infinitesimal for their coefficients;
/// `known` has the unknowns of the systems before it.
/// What does not depend on an unknown is evaluated once, and not for each of them.
fn solved<T: Real>(
    model: &Model,
    point: &Point<T>,
    given: &[(usize, Value<T>)],
    known: &[Vec<T>],
) -> Solved<T> {
    let own = known.len();
    let system = &model.systems[own];
    let mut unknowns = known.to_vec();
    let rest = model.systems.iter().skip(own);
    unknowns.extend(rest.map(|later| vec![T::zero(); later.unknowns.len()]));
    let without = Tree::evaluated(model, point, given, unknowns.clone());
    let values = system.equations.iter().map(|e| without.value(e));
    let constants = values.flat_map(Value::components);

    let point = point.map(T::jet);
    let unknowns = jets(&unknowns);
    let coefficient = |value: T::Jet| T::of_jet(value.coefficient(T::Jet::UNKNOWN));
    let column = |k: usize| -> Vec<T> {
        let (variables, equations) = depending_on_unknown(model, own, k);
        let fixed = without.aux_variables.iter().enumerate();
        let fixed: Vec<(usize, Value<T::Jet>)> = fixed
            .filter(|(index, _)| !variables[*index] || given.iter().any(|(i, _)| i == index))
            .map(|(index, value)| (index, value.map(T::jet)))
            .collect();
        let mut unknowns = unknowns.clone();
        unknowns[own][k] += T::Jet::epsilon(T::Jet::UNKNOWN);
        let tree = Tree::evaluated(model, &point, &fixed, unknowns);
        let own = system.equations.iter().zip(equations);
        let coefficients = own.flat_map(|(e, depends)| match (depends, e.shape) {
            (true, _) => tree.value(e).map(coefficient).components(),
            (false, Shape::Scalar) => vec![T::zero()],
            (false, Shape::Vector(_)) => vec![T::zero(); 3],
        });
        coefficients.collect()
    };
    let columns: Vec<Vec<T>> = (0..system.unknowns.len()).map(column).collect();
    let rows = constants.enumerate().map(|(row, rest)| {
        let coefficients = columns.iter().map(|column| column[row]);
        coefficients.chain([-rest]).collect()
    });
    eliminate(rows.collect())
}

impl<T: Real> Value<T> {
    fn map<U: Real>(self, change: impl Fn(T) -> U) -> Value<U> {
        match self {
            Value::Scalar(value) => Value::Scalar(change(value)),
            Value::Vector(value) => Value::Vector(Vector3::from_fn(|k, _| change(value[k]))),
        }
    }

    /// The scalar, or the components of the vector.
    pub fn components(self) -> Vec<T> {
        match self {
            Value::Scalar(value) => vec![value],
            Value::Vector(value) => value.iter().copied().collect(),
        }
    }
}
