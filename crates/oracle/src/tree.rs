//! The tree oracle: a model's own vector tree, evaluated with vectors in inertial components.
//!
//! Every vector is turned into inertial components the moment it appears; to express it in another frame
//! then changes nothing, and a component is a scalar product with an axis.

use crate::frames::{Placed, place_real};
use crate::point::Point;
use crate::scalar::{Real, call};
use model_spec::model::{Body, Expr, ExprKind, Load, Model, Shape};
use nalgebra::Vector3;

/// A number, or a vector in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<T> {
    /// A number.
    Scalar(T),
    /// A vector in inertial components.
    Vector(Vector3<T>),
}

/// A model at a point, with its named quantities evaluated.
pub struct Tree<'a, T> {
    /// The model.
    pub model: &'a Model,
    /// Where it is evaluated.
    pub point: &'a Point<T>,
    /// Its frames there.
    pub frames: Vec<Placed<T>>,
    /// Its named quantities there.
    pub lets: Vec<Value<T>>,
}

impl<'a, T: Real> Tree<'a, T> {
    /// Places the frames and evaluates the named quantities in their order.
    pub fn new(model: &'a Model, point: &'a Point<T>) -> Self {
        Self::overriding(model, point, &[])
    }

    /// The same with some named quantities, by index, at values of one's own.
    pub fn overriding(model: &'a Model, point: &'a Point<T>, given: &[(usize, Value<T>)]) -> Self {
        let frames = place_real(model, &point.states);
        let mut tree = Self {
            model,
            point,
            frames,
            lets: Vec::with_capacity(model.aux_variables.len()),
        };
        for (index, named) in model.aux_variables.iter().enumerate() {
            let own = given
                .iter()
                .find(|(i, _)| *i == index)
                .map(|(_, value)| *value);
            let value = own.unwrap_or_else(|| tree.value(&named.value));
            tree.lets.push(value);
        }
        tree
    }

    /// A scalar expression.
    ///
    /// # Panics
    /// If it is a vector, which the checker does not let through.
    pub fn scalar(&self, e: &Expr) -> T {
        match self.value(e) {
            Value::Scalar(s) => s,
            Value::Vector(_) => panic!("the checker lets no vector stand for a number"),
        }
    }

    /// A vector expression, in inertial components.
    ///
    /// # Panics
    /// If it is a number, which the checker does not let through.
    pub fn vector(&self, e: &Expr) -> Vector3<T> {
        match self.value(e) {
            Value::Vector(v) => v,
            Value::Scalar(_) => panic!("the checker lets no number stand for a vector"),
        }
    }

    /// The sum of forces or moments, in inertial components.
    pub fn total(&self, loads: &[Load]) -> Vector3<T> {
        loads
            .iter()
            .fold(Vector3::zeros(), |sum, load| sum + self.vector(&load.value))
    }

    /// Seconds of flight that pass in a second of the clock.
    pub fn clock(&self) -> T {
        let stated = self.model.clock.as_ref();
        stated.map_or_else(|| T::lit(1.0), |clock| self.scalar(&clock.value))
    }

    /// Any expression.
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
            K::AuxVariable(i) => self.lets[*i],
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
            K::AngularVelocity => {
                let rotation = self
                    .body()
                    .rotation
                    .as_ref()
                    .expect("the checker wants a body that turns");
                Vector(
                    self.frames[rotation.body_frame]
                        .turning
                        .expect("a frame fixed in a body turns"),
                )
            }
            K::Marker => {
                let marker = self
                    .model
                    .marker
                    .as_ref()
                    .expect("the checker wants a marker");
                Vector(self.frames[marker.frame].axes * self.point.marker)
            }
            K::Components(parts) => {
                let [a, b, c] = &**parts;
                let parts = Vector3::new(self.scalar(a), self.scalar(b), self.scalar(c));
                match e.shape {
                    Shape::Vector(frame) => Vector(self.frames[frame].axes * parts),
                    Shape::Scalar => panic!("three components are a vector"),
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
                (Scalar(a), Scalar(b)) => Scalar(a * b),
                (Scalar(s), Vector(v)) | (Vector(v), Scalar(s)) => Vector(v * s),
                (Vector(_), Vector(_)) => panic!("the checker multiplies no vectors"),
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
                    panic!("a number has no components")
                };
                Scalar(
                    self.frames[frame]
                        .axes
                        .column(usize::from(*axis) - 1)
                        .dot(&self.vector(a)),
                )
            }
            K::Reexpress(a) => self.value(a),
            K::Call(function, a) => Scalar(call(*function, self.scalar(a))),
            K::Atan2(y, x) => Scalar(self.scalar(y).atan2(self.scalar(x))),
            K::Min(a, b) => {
                let (a, b) = (self.scalar(a), self.scalar(b));
                Scalar(if b.re() < a.re() { b } else { a })
            }
            K::Max(a, b) => {
                let (a, b) = (self.scalar(a), self.scalar(b));
                Scalar(if b.re() > a.re() { b } else { a })
            }
        }
    }

    fn states(&self, indices: [usize; 3]) -> Vector3<T> {
        Vector3::from(indices.map(|i| self.point.states[i]))
    }

    fn body(&self) -> &'a Body {
        self.model.body.as_ref().expect("the checker wants a body")
    }
}

/// Length; 0 with derivative 0 at the zero vector.
pub fn norm<T: Real>(v: &Vector3<T>) -> T {
    v.dot(v).sqrt()
}
