//! Semantic checks of the body: states, mass, inertia tensor.

use std::collections::HashSet;

use super::elaborate::number;
use super::{Checker, Typed};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{self, Expr, ExprKind, FlightAxes};
use crate::syntax::ast::{self, BodyClass, InitialValues, ItemKind, Name};
use crate::syntax::{Parts, of_kind};
use crate::unit::Unit;

impl<'a> Checker<'a> {
    pub fn body_states(&mut self, body: &'a ast::Body) {
        let (parts, faults) = Parts::of(body);
        faults.into_iter().for_each(|fault| self.report(fault));
        self.parts_of_body = parts.clone();
        let rigid = body.class == BodyClass::Rigid;
        let position = parts.position.map(|(names, frame, initial)| {
            if let Some(other) = self.frame_of(frame).filter(|&f| f != 0) {
                let [first, other] = [0, other].map(|i| self.model.frames[i].name.clone());
                let message = format!(
                    "the position must be given in the inertial frame {first}, not in {other}"
                );
                let fault = Diagnostic::new(Kind::Frame, frame.span, message);
                let fault = fault.help(format!("write `in {first}`"));
                self.report(fault.fix(frame.span, first));
            }
            self.states_of_triple(names, initial, Unit::METRE)
        });
        let velocity = parts
            .velocity
            .map(|(names, _, initial)| self.states_of_triple(names, initial, Unit::SPEED));
        let velocity_frame = parts
            .velocity
            .and_then(|(_, frame, _)| self.frame_of(frame));

        // A frame that is turned by what is declared elsewhere is not of this body.
        let stated: HashSet<&str> = of_kind!(self.file.items.iter(), ItemKind::State)
            .map(|own| own.name.text.as_str())
            .collect();
        let frames: Vec<&ast::Frame> = { self.declared_frames() }
            .filter(|frame| match &frame.kind {
                ast::FrameKind::Inertial => false,
                ast::FrameKind::Fixed { .. } => true,
                ast::FrameKind::Turned { angle, .. } => {
                    let name = angle.text.as_str();
                    let is_declared = self.scope.find(name).is_some();
                    !is_declared && !stated.contains(name) && self.file.binding(name).is_none()
                }
                ast::FrameKind::Quaternion { states, .. } => {
                    !stated.contains(states[0].text.as_str())
                }
            })
            .collect();
        for frame in frames.iter().filter(|_| rigid) {
            match &frame.kind {
                ast::FrameKind::Turned { angle, .. } => {
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
            if let ast::FrameKind::Turned { angle, .. } = &frame.kind {
                self.state(&format!("{}dot", angle.text), angle.span, Unit::RATE, 0.0);
            }
        }
        let angular = parts
            .angular
            .map(|(names, _, initial)| self.states_of_triple(names, initial, Unit::RATE));
        let angular_frame = parts.angular.and_then(|(_, frame, _)| self.frame_of(frame));

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
                let is_constant = matches!(f.kind, ast::FrameKind::Fixed { .. });
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

    /// Declares the states of a vector with their defaults, and returns their indices.
    fn states_of_triple(
        &mut self,
        names: &[Name; 3],
        initial: Option<&InitialValues>,
        unit: Unit,
    ) -> [usize; 3] {
        let values = initial.map_or([0.0; 3], |initial| self.initial_values(initial, unit));
        let mut values = values.into_iter();
        names.each_ref().map(|name| {
            let value = values.next().unwrap_or_default();
            self.state(&name.text, name.span, unit, value)
        })
    }

    /// SI values of the defaults of states, which must be in `unit`.
    fn initial_values(&mut self, initial: &InitialValues, unit: Unit) -> [f64; 3] {
        let Some(measure) = self.measure_or_one(initial.unit.as_ref()) else {
            return [0.0; 3];
        };
        let values = initial.values.each_ref().map(|own| measure.of(own).0);
        if !measure.unit.agrees(unit) && (initial.unit.is_some() || values != [0.0; 3]) {
            let message = format!(
                "these initial values must be in {}, but they are in {}",
                unit.explained(),
                measure.unit.explained()
            );
            self.report(Diagnostic::new(Kind::Unit, initial.span, message));
        }
        values
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
        if let Some(frame) = self.model.rotation().map(|own| own.body_frame) {
            let axes = self.flight_axes(frame, parts.axis, parts.forward);
            if let Some(own) = self.model.body.as_mut().and_then(|b| b.rotation.as_mut()) {
                own.axes = axes.unwrap_or_default();
            }
        }
        if let Some((inertia, span)) = parts.inertia {
            self.inertia(inertia, span);
        }
    }

    /// Checks the mass and the inertia tensor of each body after the first one, whose laws are written out.
    pub fn further_bodies(&mut self) {
        let bodies = of_kind!(self.file.items.iter(), ItemKind::Body).skip(1);
        for body in bodies.collect::<Vec<_>>() {
            let (parts, _) = Parts::of(body);
            if let Some(mass) = parts.mass {
                let earlier = self.diagnostics.len();
                self.constant_of_body(mass, Unit::KILOGRAM, "the mass", false);
                self.replaced(earlier, mass.span);
            }
            let Some((inertia, span)) = parts.inertia else {
                continue;
            };
            let earlier = self.diagnostics.len();
            self.inertia_entries(inertia, span);
            self.replaced(earlier, span);
        }
    }

    /// Drops errors before the place `earlier` that lie in `span` if errors follow: those are of a parameter that stands for
    /// a part of a body, which no file states.
    fn replaced(&mut self, earlier: usize, span: Span) {
        let later = self.diagnostics.split_off(earlier);
        if !later.is_empty() {
            self.diagnostics.retain(|fault| !span.contains(fault.span));
        }
        self.diagnostics.extend(later);
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
            let help = match self.declared_body.is_some() && !signed {
                true => {
                    "use parameters and coefficients only; where it changes, state the equations outright, in a block \
                     `solve { … }`"
                }
                false => "use parameters and coefficients only",
            };
            return self.refuse(Diagnostic::new(Kind::Value, e.span, message).help(help));
        }
        if !signed
            && let Some(value) = self.model.constant(&typed.expr, &|own| own.value)
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
            ExprKind::AuxVariable(i) => self.variables[*i].varies.then_some(e.span),
            _ => e.children().into_iter().find_map(|c| self.varying(c)),
        }
    }
}

/// Literal 0 in place of an entry that the file does not specify.
pub(super) fn zero(span: Span) -> Expr {
    number(0.0, Some((0, 1)), Unit::ONE, span)
}
