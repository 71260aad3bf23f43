//! Traversal of the syntax tree, and lookup of its statements.

use std::collections::HashSet;

use super::ast::{
    Body, BodyPartKind, ClaimPartKind, Effect, Equation, Expr, ExprKind, File, Frame, FrameKind,
    ItemKind, Let, Load, Name, Observe, Parameter, State,
};

/// Iterates over the contents of the statements of one kind.
macro_rules! of_kind {
    ($items:expr, $of:ident::$kind:ident) => {
        $items.filter_map(|item| match &item.kind {
            $of::$kind(content) => Some(content),
            _ => None,
        })
    };
}
pub(crate) use of_kind;

impl File {
    /// Name in the statement `model NAME;`; `None` if the file contains no such statement.
    pub(crate) fn model(&self) -> Option<&Name> {
        of_kind!(self.items.iter(), ItemKind::Model).next()
    }

    /// The first rigid body or point mass that the file declares; `None` if it declares none.
    pub(crate) fn body(&self) -> Option<&Body> {
        of_kind!(self.items.iter(), ItemKind::Body).next()
    }

    /// The frames that the file declares, in order.
    pub fn frames(&self) -> impl Iterator<Item = &Frame> {
        of_kind!(self.items.iter(), ItemKind::Frame)
    }

    pub(crate) fn effects(&self) -> impl Iterator<Item = &Effect> {
        of_kind!(self.items.iter(), ItemKind::Effect)
    }

    /// Names of all quantities that the file declares, by its frames and its body too.
    pub(crate) fn declared(&self) -> HashSet<String> {
        let mut names = HashSet::new();
        for item in &self.items {
            names.extend(item.kind.declared().map(|name| name.text.clone()));
            match &item.kind {
                ItemKind::Input(own) => {
                    names.extend(["x", "y", "z"].map(|axis| format!("{}_{axis}", own.name.text)));
                }
                ItemKind::Marker(own) => {
                    names.insert(own.name.text.clone());
                }
                ItemKind::Solve(own) => {
                    names.extend(own.unknowns.iter().map(|unknown| unknown.name.text.clone()));
                }
                ItemKind::Frame(frame) => match &frame.kind {
                    FrameKind::Inertial | FrameKind::Fixed { .. } => {}
                    FrameKind::Turned { angle, .. } => {
                        names.extend([angle.text.clone(), format!("{}dot", angle.text)]);
                    }
                    FrameKind::Quaternion { states, .. } => {
                        names.extend(states.each_ref().map(|state| state.text.clone()));
                    }
                },
                ItemKind::Body(body) => {
                    for part in &body.parts {
                        if let BodyPartKind::Position(states, _)
                        | BodyPartKind::Velocity(states, _)
                        | BodyPartKind::AngularVelocity(states, _) = &part.kind
                        {
                            names.extend(states.each_ref().map(|state| state.text.clone()));
                        }
                    }
                }
                _ => {}
            }
        }
        names
    }
}

/// Function body of [`Expr::children`] and [`Expr::children_mut`], which differ only in the kind of reference.
macro_rules! visit_children {
    ($kind:expr, $visit:expr, $iter:ident) => {
        match $kind {
            ExprKind::Name(_) | ExprKind::Number(_) | ExprKind::Derivative(_) => {}
            ExprKind::Part(of, _)
            | ExprKind::Neg(of)
            | ExprKind::Sum(_, of)
            | ExprKind::Ascribed(of, _) => $visit(of),
            ExprKind::Components(parts, _) => parts.$iter().for_each($visit),
            ExprKind::Binary(_, a, b) => {
                $visit(a);
                $visit(b);
            }
            ExprKind::Call(_, arguments) | ExprKind::Element(_, arguments) => {
                arguments.$iter().for_each($visit)
            }
        }
    };
}

impl Expr {
    /// Calls `visit` on each direct subexpression, from left to right.
    pub fn children<'a>(&'a self, visit: &mut dyn FnMut(&'a Expr)) {
        visit_children!(&self.kind, visit, iter);
    }

    /// Calls `visit` with a mutable reference to each direct subexpression, from left to right.
    pub fn children_mut(&mut self, visit: &mut dyn FnMut(&mut Expr)) {
        visit_children!(&mut self.kind, visit, iter_mut);
    }
}

/// Function body of [`ItemKind::array_name`] and [`ItemKind::array_name_mut`].
macro_rules! array_name {
    ($kind:expr) => {
        match $kind {
            ItemKind::Parameter(Parameter { name, .. })
            | ItemKind::State(State { name, .. })
            | ItemKind::Let(Let { name, .. })
            | ItemKind::Load(Load { name, .. })
            | ItemKind::Equation(Equation { state: name, .. }) => Some(name),
            _ => None,
        }
    };
}

impl ItemKind {
    /// Name of a statement that may be one for each element of an array; `None` for other kinds of statement.
    pub(crate) fn array_name(&self) -> Option<&Name> {
        array_name!(self)
    }

    /// Mutable [`ItemKind::array_name`].
    pub(crate) fn array_name_mut(&mut self) -> Option<&mut Name> {
        array_name!(self)
    }
}

/// Function body of [`ItemKind::value`] and [`ItemKind::value_mut`], which differ only in the kind of reference.
macro_rules! value {
    ($kind:expr) => {
        match $kind {
            ItemKind::Let(Let { value, .. })
            | ItemKind::Load(Load { value, .. })
            | ItemKind::Equation(Equation { value, .. })
            | ItemKind::Observe(Observe { value, .. })
            | ItemKind::Clock(value) => Some(value),
            _ => None,
        }
    };
}

impl ItemKind {
    /// Right-hand side of a `let`, load, equation, observation or clock statement; `None` for other kinds of statement.
    pub fn value(&self) -> Option<&Expr> {
        value!(self)
    }

    /// Mutable [`ItemKind::value`].
    pub fn value_mut(&mut self) -> Option<&mut Expr> {
        value!(self)
    }

    /// Calls `visit` with each expression of a statement that is evaluated during a flight.
    pub(crate) fn expressions_mut(&mut self, visit: &mut dyn FnMut(&mut Expr)) {
        if let Some(value) = self.value_mut() {
            return visit(value);
        }
        match self {
            ItemKind::Limit(limit) => visit(&mut limit.value),
            ItemKind::Solve(solve) => solve.sides_mut().for_each(visit),
            ItemKind::Balance(own) => {
                visit(&mut own.quantity);
                visit(&mut own.change);
            }
            ItemKind::Array(array) => array.statement.expressions_mut(visit),
            ItemKind::Function(function) => {
                function
                    .lets
                    .iter_mut()
                    .for_each(|own| visit(&mut own.value));
                visit(&mut function.value);
            }
            ItemKind::Claim(claim) => {
                for part in &mut claim.parts {
                    match &mut part.kind {
                        ClaimPartKind::Inertia(inertia) => {
                            inertia
                                .rows
                                .iter_mut()
                                .flatten()
                                .flatten()
                                .for_each(&mut *visit);
                        }
                        ClaimPartKind::Value(value) => visit(value),
                        _ => {}
                    }
                }
            }
            _ => {}
        }
    }

    /// Class of a statement that an effect may replace, as in messages, and its name; a clock has none.
    pub(crate) fn class_and_name(&self) -> (&'static str, Option<&Name>) {
        match self {
            ItemKind::Let(own) => ("quantity", Some(&own.name)),
            ItemKind::Load(own) => (own.class.keyword(), Some(&own.name)),
            ItemKind::Clock(_) => ("the clock", None),
            ItemKind::Equation(own) => ("equation for", Some(&own.state)),
            ItemKind::Observe(own) => ("observation", Some(&own.name)),
            _ => ("", None),
        }
    }

    /// Name that a parameter, state, `let` or input statement declares; `None` for other kinds of statement.
    pub(crate) fn declared(&self) -> Option<&Name> {
        match self {
            ItemKind::Parameter(own) => Some(&own.name),
            ItemKind::State(own) => Some(&own.name),
            ItemKind::Let(own) => Some(&own.name),
            ItemKind::Input(own) => Some(&own.name),
            ItemKind::Array(own) => own.statement.declared(),
            _ => None,
        }
    }
}
