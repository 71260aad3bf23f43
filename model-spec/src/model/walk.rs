//! Traversal of expressions, all those of a model included; queries about states and source texts of a model.

use super::{Expr, ExprKind, FrameKind, Model, Shape, ValidityLimit};
use crate::location::Span;
use crate::syntax::ast::ItemKind;
use crate::syntax::{of_kind, preorder};
use crate::unit::Unit;

/// Function body of [`Expr::children`] and [`Expr::children_mut`].
macro_rules! children {
    ($kind:expr, $iter:ident) => {{
        use ExprKind as K;
        match $kind {
            K::Number { .. }
            | K::Pi
            | K::Time
            | K::Param(_)
            | K::Coefficient(_)
            | K::Input(_)
            | K::State(_)
            | K::AuxVariable(_)
            | K::Unknown(..)
            | K::Determinacy(_)
            | K::Axis(..)
            | K::Position
            | K::Velocity
            | K::AngularVelocity
            | K::SpecificForce
            | K::AngularAcceleration
            | K::Marker => Vec::new(),
            K::Components(parts) | K::Ratio(parts) => parts.$iter().collect(),
            K::Neg(a)
            | K::Pow(a, _)
            | K::Norm(a)
            | K::Component(a, _)
            | K::Reexpress(a)
            | K::Partial(a, _)
            | K::Direction(a, None)
            | K::Call(_, a) => vec![a],
            K::BodyRate(_, loads) => loads.$iter().collect(),
            K::Rate(a, _, rates) => {
                let mut all: Vec<_> = rates.$iter().collect();
                all.insert(0, a);
                all
            }
            K::Add(a, b)
            | K::Sub(a, b)
            | K::Mul(a, b)
            | K::Div(a, b)
            | K::RealPower(a, b)
            | K::Dot(a, b)
            | K::Cross(a, b)
            | K::Lookup(_, a, b)
            | K::Atan2(a, b)
            | K::Min(a, b)
            | K::Max(a, b)
            | K::Direction(a, Some(b)) => vec![a, b],
        }
    }};
}

/// Function body of [`Model::expressions`] and [`Model::expressions_mut`].
macro_rules! collect_expressions {
    ($model:expr, $iter:ident, $claimed:ident $(, $mutable:tt)?) => {{
        let model = $model;
        let aux_variables = model.aux_variables.$iter();
        let mut all: Vec<_> = aux_variables.map(|own| &$($mutable)? own.value).collect();
        all.extend(model.constant_angles.$iter());
        for body in model.body.$iter() {
            all.push(&$($mutable)? body.mass);
            let rotation = body.rotation.$iter();
            all.extend(rotation.flat_map(|own| own.inertia.$iter().flatten()));
        }
        let loads = model.forces.$iter().chain(model.moments.$iter());
        all.extend(loads.map(|own| &$($mutable)? own.value));
        all.extend(model.equations.$iter().map(|own| &$($mutable)? own.value));
        for own in model.systems.$iter() {
            all.extend(own.equations.$iter().chain(own.constraints.$iter()));
        }
        for own in model.balances.$iter() {
            all.extend([&$($mutable)? own.quantity, &$($mutable)? own.change]);
        }
        all.extend(model.claim.$iter().flat_map(|claim| claim.$claimed()));
        all.extend(model.observation.$iter().map(|own| &$($mutable)? own.value));
        all.extend(model.clock.$iter().map(|own| &$($mutable)? own.value));
        all.extend(model.limits.$iter().map(|own| &$($mutable)? own.value));
        all
    }};
}

impl Expr {
    /// Iterates over the expression and all its subexpressions, each before its own subexpressions.
    pub fn nodes(&self) -> impl Iterator<Item = &Expr> {
        preorder(self, Expr::children)
    }

    /// Direct subexpressions, from left to right.
    pub fn children(&self) -> Vec<&Expr> {
        children!(&self.kind, iter)
    }

    /// Mutable [`Expr::children`].
    pub fn children_mut(&mut self) -> Vec<&mut Expr> {
        children!(&mut self.kind, iter_mut)
    }

    /// Whether two expressions are structurally equal; source spans are ignored.
    pub fn same(&self, other: &Expr) -> bool {
        use ExprKind as K;
        let kinds = match (&self.kind, &other.kind) {
            (K::Number { value: a, .. }, K::Number { value: b, .. }) => {
                a == b && self.unit.agrees(other.unit)
            }
            (K::Param(a), K::Param(b))
            | (K::Coefficient(a), K::Coefficient(b))
            | (K::Input(a), K::Input(b))
            | (K::State(a), K::State(b))
            | (K::AuxVariable(a), K::AuxVariable(b))
            | (K::Determinacy(a), K::Determinacy(b)) => a == b,
            (K::Unknown(s, a), K::Unknown(t, b)) => s == t && a == b,
            (K::Partial(_, a), K::Partial(_, b)) => a == b,
            (K::Axis(f, a), K::Axis(g, b)) => f == g && a == b,
            (K::Pow(_, a), K::Pow(_, b)) => a == b,
            (K::Component(_, a), K::Component(_, b)) => a == b,
            (K::Call(f, _), K::Call(g, _)) => f == g,
            (K::Lookup(f, ..), K::Lookup(g, ..)) => f == g,
            (a, b) => std::mem::discriminant(a) == std::mem::discriminant(b),
        };
        if !kinds || self.shape != other.shape {
            return false;
        }
        let (ours, theirs) = (self.children(), other.children());
        ours.len() == theirs.len() && ours.iter().zip(theirs).all(|(a, b)| a.same(b))
    }
}

impl Expr {
    /// Numerator and denominator of a number or a quotient of numbers; `None` for other expressions.
    pub fn rational(&self) -> Option<(i64, i64)> {
        match &self.kind {
            ExprKind::Number { exact, .. } => *exact,
            ExprKind::Neg(a) => a.rational().map(|(above, below)| (-above, below)),
            ExprKind::Div(a, b) => {
                let ((a, b), (c, d)) = (a.rational()?, b.rational()?);
                Some((a.checked_mul(d)?, b.checked_mul(c)?))
            }
            _ => None,
        }
    }
}

impl Model {
    /// All expressions that are not part of another expression: definitions of the auxiliary variables, then
    /// angles of frames, mass and entries of the inertia tensor, loads, equations, those of systems with their constraints,
    /// claimed balances, `claim` block, observation, rate of the clock, validity limits.
    pub fn expressions(&self) -> Vec<&Expr> {
        collect_expressions!(self, iter, expressions)
    }

    /// Mutable [`Model::expressions`].
    pub fn expressions_mut(&mut self) -> Vec<&mut Expr> {
        collect_expressions!(self, iter_mut, expressions_mut, mut)
    }

    /// Angles of frames, loads, equations, observation, clock, limits and claim: what each is, its name in messages, and its expression with
    /// the span of the statement.
    pub(crate) fn statements(&self) -> Vec<(&'static str, &str, &Expr, Span)> {
        let angles = self.constant_angles.iter();
        let mut all: Vec<_> = angles.map(|e| ("an angle", "turned", e, e.span)).collect();
        for load in self.forces.iter().chain(&self.moments) {
            all.push(("a force or moment", &*load.name, &load.value, load.span));
        }
        for own in &self.equations {
            let state = &*self.states[own.state].name;
            all.push(("a stated equation", state, &own.value, own.span));
        }
        for own in &self.systems {
            let equations = own.equations.iter();
            all.extend(equations.map(|e| ("an equation", &*own.title, e, e.span)));
        }
        for own in &self.balances {
            let parts = [&own.quantity, &own.change].into_iter();
            all.extend(parts.map(|e| ("a claim", "claim", e, own.span)));
        }
        if let Some(own) = &self.observation {
            all.push(("an observation", &*own.name, &own.value, own.span));
        }
        if let Some(own) = &self.clock {
            all.push(("the clock", "clock", &own.value, own.span));
        }
        for own in &self.limits {
            all.push(("a limit", "limit", &own.value, own.span));
        }
        if let Some(claim) = &self.claim {
            let expressions = claim.expressions().into_iter();
            all.extend(expressions.map(|e| ("a claim", &*claim.name, e, e.span)));
        }
        all
    }

    /// Whether the model has a parameter of this name that is computed from others and cannot be set.
    pub fn is_computed(&self, name: &str) -> bool {
        let own = self.tree.binding(name);
        own.is_some_and(|own| own.is_constant)
    }

    /// Source text of a span, with each run of whitespace replaced by one space; empty if the span is invalid.
    pub fn text(&self, span: Span) -> String {
        let source = self.sources.get(usize::from(span.source));
        let raw = source.and_then(|s| s.text.get(span.range())).unwrap_or("");
        raw.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// States whose initial values the data of a flight may omit: with a body, all but those of its motion, otherwise
    /// those that effects add and those that stand for unknown quantities.
    pub fn added_states(&self) -> Vec<usize> {
        let of_effects = |state: &usize| {
            self.effects
                .iter()
                .any(|e| e.states.iter().any(|own| own.index == *state))
        };
        let unknown = self.unknown_states();
        let is_unknown = |state: &usize| unknown.iter().any(|(_, own)| own == state);
        let stated = self.equations.iter().map(|e| e.state);
        stated
            .filter(|state| self.body.is_some() || of_effects(state) || is_unknown(state))
            .collect()
    }

    /// States of the bodies after the first one, whose equations are written out.
    pub fn states_of_further_bodies(&self) -> Vec<usize> {
        let items = self.tree.items.iter().filter(|item| item.is_of_body());
        let names: Vec<&str> = of_kind!(items, ItemKind::State)
            .map(|own| own.name.text.as_str())
            .collect();
        let states = self.states.iter().enumerate();
        let own = states.filter(|(_, state)| names.contains(&state.name.as_str()));
        own.map(|(index, _)| index).collect()
    }

    /// Indices into [`Model::states`] of the angles: those by which frames are turned, then other states with the unit
    /// rad that the model itself states, such as a heading.
    pub fn angle_states(&self) -> Vec<usize> {
        let turned = self.frames.iter().filter_map(|frame| match frame.kind {
            FrameKind::Turned { angle, .. } => Some(angle),
            _ => None,
        });
        let mut angles: Vec<usize> = turned.collect();
        let added = self.added_states();
        let is_angle = |state: &usize| self.states[*state].unit == Unit::RADIAN;
        let stated =
            (0..self.states.len()).filter(|state| is_angle(state) && !added.contains(state));
        angles.extend(
            stated
                .filter(|state| !angles.contains(state))
                .collect::<Vec<_>>(),
        );
        angles
    }

    /// Indices into [`Model::states`] of the coordinates of the body's place in the inertial frame, the height last: those
    /// that a body declares, or that a claim names as components of its position; else the states `x`, `y` and `z`.
    pub fn place(&self) -> [Option<usize>; 3] {
        if let Some(body) = &self.body {
            return body.position.map(Some);
        }
        let claimed = self.claim.as_ref().map(|claim| &claim.position);
        let claimed = claimed.filter(|position| position.shape == Shape::Vector(0));
        [0, 1, 2].map(|axis| {
            let component = claimed.and_then(|position| match &position.kind {
                ExprKind::Components(components) => Some(&components[axis].kind),
                _ => None,
            });
            match component {
                Some(ExprKind::State(state)) => Some(*state),
                _ => (self.states.iter()).position(|own| own.name == ["x", "y", "z"][axis]),
            }
        })
    }

    /// Indices into [`Model::states`] of each quaternion of norm 1 that orients a frame, scalar part first.
    pub fn quaternions(&self) -> impl Iterator<Item = [usize; 4]> {
        self.frames.iter().filter_map(|frame| match frame.kind {
            FrameKind::Quaternion { states, .. } => Some(states),
            _ => None,
        })
    }

    /// Limits but those that hold the constraints of blocks `solve`: the equations of motion hold beyond these.
    pub fn limits_of_validity(&self) -> impl Iterator<Item = &ValidityLimit> {
        let is_of_constraint = |limit: &ValidityLimit| {
            let mut systems = self.systems.iter();
            systems.any(|own| own.span != limit.span && own.span.contains(limit.span))
        };
        self.limits
            .iter()
            .filter(move |limit| !is_of_constraint(limit))
    }

    /// Whether the limit was added by the checker to avoid gimbal lock rather than stated in the model's file.
    pub fn is_automatic(&self, limit: &ValidityLimit) -> bool {
        self.frames.iter().any(|f| f.span == limit.span)
    }
}
