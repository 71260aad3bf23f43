//! Traversal of the syntax tree, and lookup of its statements.

use std::collections::HashSet;

use super::ast::{
    Array, Balance, Body, BodyPart, BodyPartKind, Effect, Equation, Expr, ExprKind, File, Frame,
    FrameKind, Function, ImplicitEquation, Item, ItemKind, Let, Limit, Load, Name, Observe,
    Parameter, Solve, State,
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

    /// Whether a load acts on the first body, or on nothing as there is none.
    pub fn is_of_first_body(&self, load: &Load) -> bool {
        match (&load.on, self.body()) {
            (Some(on), Some(body)) => on.text == body.name.text,
            _ => true,
        }
    }

    /// Whether a statement is that of a further body or of a load on it, beside which its equations are written out.
    pub fn is_written_out(&self, item: &Item) -> bool {
        match &item.kind {
            ItemKind::Body(body) => self.body().is_some_and(|first| first.name != body.name),
            ItemKind::Load(load) => !self.is_of_first_body(load),
            _ => false,
        }
    }

    /// The frames that the file declares, in order.
    pub fn frames(&self) -> impl Iterator<Item = &Frame> {
        of_kind!(self.items.iter(), ItemKind::Frame)
    }

    /// Name of the inertial frame; `None` if the file declares none.
    pub(crate) fn inertial(&self) -> Option<&str> {
        let inertial = self.frames().find(|own| own.kind == FrameKind::Inertial);
        inertial.map(|own| own.name.text.as_str())
    }

    /// The definition by `let`, or by a `param` that is computed, of a name.
    pub(crate) fn binding(&self, name: &str) -> Option<&Let> {
        of_kind!(self.items.iter(), ItemKind::Let).find(|own| own.name.text == name)
    }

    /// The effects that the file declares, applied or not.
    pub fn effects(&self) -> impl Iterator<Item = &Effect> {
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
                        if let BodyPartKind::States(states, ..) = &part.kind {
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

/// Iterates over the nodes of a tree, each before its children, without recursion.
pub(crate) fn preorder<'a, T>(
    root: &'a T,
    children: impl Fn(&'a T) -> Vec<&'a T>,
) -> impl Iterator<Item = &'a T> {
    let mut open = vec![root];
    std::iter::from_fn(move || {
        let next = open.pop()?;
        open.extend(children(next).into_iter().rev());
        Some(next)
    })
}

/// Function body of [`Expr::children`] and [`Expr::children_mut`], which differ only in the kind of reference.
macro_rules! children {
    ($kind:expr, $iter:ident) => {
        match $kind {
            ExprKind::Name(_) | ExprKind::Number(_) | ExprKind::Derivative(_) => Vec::new(),
            ExprKind::Part(of, _)
            | ExprKind::Neg(of)
            | ExprKind::Sum(_, of)
            | ExprKind::Ascribed(of, _) => vec![of],
            ExprKind::Components(parts, _) => parts.$iter().collect(),
            ExprKind::Binary(_, a, b) => vec![a, b],
            ExprKind::Call(_, arguments) | ExprKind::Element(_, arguments) => {
                arguments.$iter().collect()
            }
        }
    };
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

/// Function body of [`ItemKind::roots`] and [`ItemKind::roots_mut`], which differ only in the kind of reference.
macro_rules! roots {
    ($kind:expr, $iter:ident, $value:ident, $roots:ident) => {
        match $kind {
            ItemKind::Limit(Limit { value, .. }) => vec![value],
            ItemKind::Balance(Balance { quantity, change }) => vec![quantity, change],
            ItemKind::Frame(Frame {
                kind: FrameKind::Fixed { angle, .. },
                ..
            }) => vec![angle],
            ItemKind::Solve(Solve { equations, .. }) => { equations.$iter() }
                .flat_map(|ImplicitEquation { left, right, .. }| [left, right])
                .collect(),
            ItemKind::Function(Function { lets, value, .. }) => { lets.$iter() }
                .map(|Let { value, .. }| value)
                .chain([value])
                .collect(),
            ItemKind::Body(Body { parts, .. }) | ItemKind::Claim(Body { parts, .. }) => {
                { parts.$iter() }
                    .flat_map(|BodyPart { kind, .. }| match kind {
                        BodyPartKind::Value(value) => vec![value],
                        BodyPartKind::Inertia(own) => {
                            own.rows.$iter().flatten().flatten().collect()
                        }
                        _ => Vec::new(),
                    })
                    .collect()
            }
            ItemKind::Array(Array { statement, .. }) => statement.$roots(),
            other => other.$value().into_iter().collect(),
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

    /// Expressions of a statement that are not part of another one, in order; none of an effect.
    pub fn roots(&self) -> Vec<&Expr> {
        roots!(self, iter, value, roots)
    }

    /// Mutable [`ItemKind::roots`].
    pub fn roots_mut(&mut self) -> Vec<&mut Expr> {
        roots!(self, iter_mut, value_mut, roots_mut)
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
