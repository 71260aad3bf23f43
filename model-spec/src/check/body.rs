//! Semantic checks of the body: states, mass, inertia tensor.

use super::elaborate::node;
use super::{Checker, Typed};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{self, Expr, ExprKind, FlightAxes, Shape};
use crate::syntax::ast::{self, BodyClass, BodyPartKind, Name};
use crate::unit::Unit;

/// Statements in the block of a body, each at most once.
#[derive(Clone, Default)]
pub(super) struct Parts<'a> {
    mass: Option<&'a ast::Expr>,
    inertia: Option<(&'a ast::Inertia, Span)>,
    pub fixed: Option<&'a Name>,
    position: Option<(&'a [Name; 3], &'a Name)>,
    velocity: Option<(&'a [Name; 3], &'a Name)>,
    pub angular: Option<(&'a [Name; 3], &'a Name)>,
    angular_velocity_frame: Option<&'a Name>,
    axis: Option<&'a ast::Expr>,
    forward: Option<&'a ast::Expr>,
}

impl<'a> Checker<'a> {
    pub fn body_states(&mut self, body: &'a ast::Body) {
        let parts = self.parts(body);
        self.missing_parts(body, &parts);
        self.parts_of_body = parts.clone();
        let rigid = body.class == BodyClass::Rigid;
        let triple = |c: &mut Self, names: &[Name; 3], unit| {
            names
                .each_ref()
                .map(|n| c.state(&n.text, n.span, unit, 0.0))
        };
        let position = parts.position.map(|(names, frame)| {
            if let Some(other) = self.frame_of(frame).filter(|&f| f != 0) {
                let [first, other] = [0, other].map(|i| self.model.frames[i].name.clone());
                let message = format!(
                    "the position must be given in the inertial frame {first}, not in {other}"
                );
                let fault = Diagnostic::new(Kind::Frame, frame.span, message);
                let fault = fault.help(format!("write `in {first}`"));
                self.report(fault.fix(frame.span, first));
            }
            triple(self, names, Unit::METRE)
        });
        let velocity = parts
            .velocity
            .map(|(names, _)| triple(self, names, Unit::SPEED));
        let velocity_frame = parts.velocity.and_then(|(_, frame)| self.frame_of(frame));

        let frames: Vec<&ast::Frame> = { self.declared_frames() }
            .filter(|frame| frame.kind != ast::FrameKind::Inertial)
            .collect();
        for frame in frames.iter().filter(|_| rigid) {
            match &frame.kind {
                ast::FrameKind::Turned { angle, .. } if self.constant_angle(angle).is_none() => {
                    self.state(&angle.text, angle.span, Unit::RADIAN, 0.0);
                }
                ast::FrameKind::Quaternion { states, .. } => {
                    for (i, name) in states.iter().enumerate() {
                        let value = if i == 0 { 1.0 } else { 0.0 };
                        self.state(&name.text, name.span, Unit::ONE, value);
                    }
                }
                _ => {}
            }
        }
        for frame in frames.iter().filter(|_| rigid) {
            if let ast::FrameKind::Turned { angle, .. } = &frame.kind
                && self.constant_angle(angle).is_none()
            {
                self.state(&format!("{}dot", angle.text), angle.span, Unit::RATE, 0.0);
            }
        }
        let angular = parts
            .angular
            .map(|(names, _)| triple(self, names, Unit::RATE));
        let angular_frame = parts.angular.and_then(|(_, frame)| self.frame_of(frame));

        let rotation = if rigid {
            let body_frame = parts.fixed.and_then(|f| self.frame_of(f));
            let inertia_frame = parts.inertia.and_then(|(i, _)| self.frame_of(&i.frame));
            let (Some(body_frame), Some(inertia_frame)) = (body_frame, inertia_frame) else {
                return;
            };
            // An undeclared frame has already been reported.
            let angular_velocity_frame =
                parts.angular_velocity_frame.and_then(|f| self.frame_of(f));
            Some(model::Rotation {
                body_frame,
                angular_velocity_frame: angular_velocity_frame.unwrap_or(inertia_frame),
                inertia_frame,
                inertia: std::array::from_fn(|_| std::array::from_fn(|_| zero(body.name.span))),
                angular_velocity: angular.zip(angular_frame),
                axes: FlightAxes::default(),
            })
        } else {
            let moving = |f: &&&ast::Frame| {
                let is_constant = match &f.kind {
                    ast::FrameKind::Fixed { .. } => true,
                    ast::FrameKind::Turned { angle, .. } => self.constant_angle(angle).is_some(),
                    _ => false,
                };
                // Errors of the first frame and duplicate names have already been reported.
                !is_constant
                    && self
                        .scope
                        .frame(&f.name.text)
                        .is_some_and(|i| i > 0 && self.model.frames[i].span == f.name.span)
            };
            if let Some(frame) = frames.iter().find(moving) {
                let message = format!(
                    "a point does not turn: nothing determines how the frame `{}` moves",
                    frame.name.text
                );
                let fault = Diagnostic::new(Kind::Missing, frame.name.span, message);
                self.report(fault.help("declare a `body` with moments of inertia"));
            }
            None
        };
        let (Some(position), Some(velocity), Some(velocity_frame)) =
            (position, velocity, velocity_frame)
        else {
            return;
        };
        self.model.body = Some(model::Body {
            name: body.name.text.clone(),
            mass: zero(body.name.span),
            position,
            velocity,
            velocity_frame,
            rotation,
            span: body.name.span,
        });
    }

    fn parts(&mut self, body: &'a ast::Body) -> Parts<'a> {
        let mut parts = Parts::default();
        let mut seen: Vec<(&str, Span)> = Vec::new();
        for part in &body.parts {
            let word = part.words;
            if let Some(&(_, first)) = seen.iter().find(|s| s.0 == word) {
                self.second(word, first, part.span);
                continue;
            }
            seen.push((word, part.span));
            let turning = !matches!(word, "mass" | "position" | "velocity");
            if turning && body.class == BodyClass::Point {
                let message = format!("a point has no `{word}`");
                let fault = Diagnostic::new(Kind::Shape, part.span, message);
                self.report(fault.help("declare it as `body`, not as `point`, if it turns"));
                continue;
            }
            match (word, &part.kind) {
                ("axis", BodyPartKind::Value(axis)) => parts.axis = Some(axis),
                ("forward", BodyPartKind::Value(axis)) => parts.forward = Some(axis),
                (_, BodyPartKind::Value(mass)) => parts.mass = Some(mass),
                (_, BodyPartKind::Inertia(own)) => parts.inertia = Some((own, part.span)),
                ("fixed in", BodyPartKind::Frame(frame)) => parts.fixed = Some(frame),
                (_, BodyPartKind::Frame(frame)) => parts.angular_velocity_frame = Some(frame),
                (_, BodyPartKind::States(names, frame)) => {
                    let own = match word {
                        "position" => &mut parts.position,
                        "velocity" => &mut parts.velocity,
                        _ => &mut parts.angular,
                    };
                    *own = Some((names, frame));
                }
            }
        }
        parts
    }

    fn missing_parts(&mut self, body: &ast::Body, parts: &Parts<'_>) {
        let rigid = body.class == BodyClass::Rigid;
        let inertia = "inertia diag(…, …, …) in …;";
        let needed = [
            ("mass …;", parts.mass.is_none()),
            (inertia, rigid && parts.inertia.is_none()),
            ("fixed in …;", rigid && parts.fixed.is_none()),
            ("position (x, y, z) in N;", parts.position.is_none()),
            ("velocity (u, v, w) in …;", parts.velocity.is_none()),
        ];
        self.lacking("the body", "the body", &body.name, &needed);
    }

    /// Reports missing statements of the block `name`, which `what` precedes in the message; `owner` is to have them.
    pub fn lacking(&mut self, what: &str, owner: &str, name: &Name, needed: &[(&str, bool)]) {
        let missing: Vec<&str> = needed.iter().filter(|n| n.1).map(|n| n.0).collect();
        if missing.is_empty() {
            return;
        }
        let lacks = super::scope::listed(&missing);
        let message = format!("{what} `{}` lacks {lacks}", name.text);
        let fault = Diagnostic::new(Kind::Missing, name.span, message);
        self.report(fault.help(format!("add what is missing to the block of {owner}")));
    }

    /// Checks the mass, inertia tensor and attitude of the declared body; all names must have been declared before.
    pub fn body(&mut self) {
        let Some(body) = self.declared_body else {
            return;
        };
        let parts = self.parts_of_body.clone();
        if let Some(mass) = parts.mass {
            let expr = self.constant_of_body(mass, Unit::KILOGRAM, "the mass", false);
            if let (Some(expr), Some(made)) = (expr, self.model.body.as_mut()) {
                made.mass = expr;
            }
        }
        if body.class == BodyClass::Point {
            return;
        }
        self.attitude(body, &parts);
        let rotation = { self.model.body.as_ref() }.and_then(|own| own.rotation.as_ref());
        if let Some(frame) = rotation.map(|own| own.body_frame) {
            let axes = self.flight_axes(frame, parts.axis, parts.forward);
            if let Some(own) = self.model.body.as_mut().and_then(|b| b.rotation.as_mut()) {
                own.axes = axes.unwrap_or_default();
            }
        }
        if let Some((inertia, span)) = parts.inertia {
            self.inertia(inertia, span);
        }
    }

    /// Resolves a mass or an inertia entry, which messages call `what`; reports one that can vary or, unless `signed`,
    /// is not positive.
    pub fn constant_of_body(
        &mut self,
        e: &ast::Expr,
        unit: Unit,
        what: &str,
        signed: bool,
    ) -> Option<Expr> {
        let typed: Typed = self.scalar(e, what)?;
        let rule = format!("{what} must be in {}", unit.pretty());
        self.must_be(&typed, &super::term::Term::known(unit), &rule);
        if let Some(culprit) = self.varying(&typed.expr) {
            let message = format!(
                "{what} must not change during a flight, but `{}` does",
                self.text(culprit)
            );
            return self.refuse(
                Diagnostic::new(Kind::Value, e.span, message)
                    .help("use parameters and coefficients only"),
            );
        }
        if !signed
            && let Some(value) = self.value(&typed.expr)
            && (value <= 0.0 || value.is_nan())
        {
            let message = format!(
                "{what} must be positive, but `{}` is {value} by default",
                self.text(e.span)
            );
            let mut fault = Diagnostic::new(Kind::Value, e.span, message);
            if let ExprKind::Param(i) = typed.expr.kind {
                fault = fault.label(self.model.params[i].span, "declared here");
            }
            self.report(fault);
        }
        Some(typed.expr)
    }

    /// Source span of the first subexpression whose value can change during a flight; `None` if there is none.
    pub fn varying(&self, e: &Expr) -> Option<Span> {
        match &e.kind {
            ExprKind::Time
            | ExprKind::State(_)
            | ExprKind::Input(_)
            | ExprKind::Axis(..)
            | ExprKind::Position
            | ExprKind::Velocity
            | ExprKind::AngularVelocity
            | ExprKind::SpecificForce
            | ExprKind::AngularAcceleration
            | ExprKind::BodyRate(..)
            | ExprKind::Marker => Some(e.span),
            ExprKind::Param(i) => self.model.params[*i].varies.then_some(e.span),
            ExprKind::AuxVariable(i) => self.varies[*i].then_some(e.span),
            _ => {
                let mut found = None;
                e.children(&mut |c| found = found.or_else(|| self.varying(c)));
                found
            }
        }
    }

    /// Value at the default parameters, SI; `None` for operations other than + − * /.
    fn value(&self, e: &Expr) -> Option<f64> {
        Some(match &e.kind {
            ExprKind::Number { value, .. } => *value,
            ExprKind::Param(i) => self.model.params[*i].value,
            ExprKind::Coefficient(i) => self.model.coefficients[*i].value,
            ExprKind::Neg(a) => -self.value(a)?,
            ExprKind::Add(a, b) => self.value(a)? + self.value(b)?,
            ExprKind::Sub(a, b) => self.value(a)? - self.value(b)?,
            ExprKind::Mul(a, b) => self.value(a)? * self.value(b)?,
            ExprKind::Div(a, b) => self.value(a)? / self.value(b)?,
            _ => return None,
        })
    }
}

/// Literal 0 in place of an entry that the file does not specify.
pub(super) fn zero(span: Span) -> Expr {
    let exact = Some((0, 1));
    let value = 0.0;
    node(ExprKind::Number { value, exact }, Shape::Scalar, span)
}
