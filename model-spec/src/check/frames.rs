//! Semantic checks of the frames of reference, which form a tree rooted at the inertial frame.

use super::body::zero;
use super::scope::Symbol;
use super::term::Term;
use super::{Checker, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, MAX_SHOWN, Span};
use crate::layout::{depending_on, depends};
use crate::model::{self, Expr, ExprKind, FrameKind};
use crate::suggest;
use crate::syntax::ast::{self, Name};

const MAX_FRAMES: usize = 100;

impl<'a> Checker<'a> {
    pub fn declared_frames(&self) -> impl Iterator<Item = &'a ast::Frame> + use<'a> {
        self.file.frames()
    }

    /// Declares the names of all frames in order; reports a frame whose parent is not declared before it.
    pub fn frame_names(&mut self) {
        let mut inertial: Option<&Name> = None;
        for (count, frame) in self.declared_frames().enumerate() {
            if count == MAX_FRAMES {
                let message = format!("a model has at most {MAX_FRAMES} frames");
                self.report(Diagnostic::new(Kind::Limit, frame.name.span, message));
                break;
            }
            let index = self.model.frames.len();
            let parent = match &frame.kind {
                ast::FrameKind::Inertial => {
                    if let Some(first) = inertial
                        && self.scope.frame(&frame.name.text).is_none()
                    {
                        let message =
                            format!("`{}` would be a second inertial frame", frame.name.text);
                        let fault = Diagnostic::new(Kind::Frame, frame.name.span, message)
                            .label(first.span, "the inertial frame")
                            .help(format!(
                                "say how it is turned: `frame {} = {} turned ANGLE about 1;`",
                                frame.name.text, first.text
                            ));
                        self.report(fault);
                    }
                    inertial.get_or_insert(&frame.name);
                    None
                }
                ast::FrameKind::Turned { parent, .. }
                | ast::FrameKind::Fixed { parent, .. }
                | ast::FrameKind::Quaternion { parent, .. } => Some(parent),
            };
            if index == 0 && parent.is_some() {
                let message = "the first frame must be the inertial one";
                let fault = Diagnostic::new(Kind::Frame, frame.name.span, message);
                self.report(fault.help("declare `frame N;` first: at rest, third axis up"));
            } else if let Some(parent) = parent {
                self.parent(parent, &frame.name);
            }
            if self.define_frame(&frame.name, index) {
                // The orientation is set by `frame_kinds`, once states are declared.
                self.model.frames.push(model::Frame {
                    name: frame.name.text.clone(),
                    kind: FrameKind::Inertial,
                    span: frame.name.span,
                });
            }
        }
        if self.model.frames.is_empty() {
            let fault = Diagnostic::new(Kind::Missing, self.heading(), "no frame is declared");
            self.report(fault.help("declare `frame N;`: at rest, third axis up"));
        }
    }

    /// Reports an error if the frame `parent` is not declared before the frame `child`.
    fn parent(&mut self, parent: &Name, child: &Name) {
        if self.scope.frame(&parent.text).is_some() {
            return;
        }
        let later = self.declared_frames().find(|f| f.name.text == parent.text);
        match later {
            Some(later) => {
                let message = format!(
                    "the frame `{}` is turned from `{}`, which is declared after it",
                    child.text, parent.text
                );
                let fault = Diagnostic::new(Kind::Frame, parent.span, message)
                    .label(later.name.span, "declared here");
                self.report(fault.help("declare frames after those they are turned from"));
            }
            None => {
                self.frame_of(parent);
            }
        }
    }

    pub fn frame_kinds(&mut self) {
        for frame in self.declared_frames() {
            let Some(index) = self.scope.frame(&frame.name.text) else {
                continue;
            };
            let kind = match &frame.kind {
                ast::FrameKind::Inertial => Some(FrameKind::Inertial),
                ast::FrameKind::Turned {
                    parent,
                    angle,
                    axis,
                } => self.turned(parent, angle, *axis),
                ast::FrameKind::Fixed {
                    parent,
                    angle,
                    axis,
                } => self.fixed(parent, *axis, angle.span),
                ast::FrameKind::Quaternion { parent, states } => self.by_quaternion(parent, states),
            };
            if let Some(kind) = kind {
                self.model.frames[index].kind = kind;
            }
        }
    }

    /// A frame whose angle [`Checker::constant_angles`] resolves.
    fn fixed(&mut self, parent: &Name, axis: u8, span: Span) -> Option<FrameKind> {
        let parent = self.scope.frame(&parent.text)?;
        let angle = self.model.constant_angles.len();
        self.model.constant_angles.push(zero(span));
        Some(FrameKind::Fixed {
            parent,
            angle,
            axis,
        })
    }

    fn turned(&mut self, parent: &Name, angle: &Name, axis: u8) -> Option<FrameKind> {
        let symbol = self.scope.find(&angle.text);
        if matches!(symbol, Some(Symbol::Param(_) | Symbol::Coefficient(_)))
            || self.file.binding(&angle.text).is_some()
        {
            return self.fixed(parent, axis, angle.span);
        }
        let parent = self.scope.frame(&parent.text)?;
        if symbol.is_some_and(|own| !matches!(own, Symbol::State(_))) {
            self.no_state(angle);
            return None;
        }
        let state = self.frame_state(angle)?;
        let rate = match self.scope.find(&format!("{}dot", angle.text)) {
            Some(Symbol::State(rate)) => Some(rate),
            _ => None,
        };
        Some(FrameKind::Turned {
            parent,
            angle: state,
            rate,
            axis,
        })
    }

    /// Resolves the angles by which frames are turned for a whole flight.
    pub fn constant_angles(&mut self) {
        for frame in self.declared_frames() {
            let index = self.scope.frame(&frame.name.text);
            let kind = index.map(|index| self.model.frames[index].kind);
            let Some(FrameKind::Fixed { angle, .. }) = kind else {
                continue;
            };
            let resolved = match &frame.kind {
                ast::FrameKind::Fixed { angle, .. } => self.constant_angle(angle),
                ast::FrameKind::Turned { angle, .. } => {
                    self.constant_angle(&ast::Expr::name(&angle.text, angle.span))
                }
                _ => None,
            };
            if let Some(resolved) = resolved {
                self.model.constant_angles[angle] = resolved;
            }
        }
    }

    fn constant_angle(&mut self, angle: &ast::Expr) -> Option<Expr> {
        let typed = self.scalar(angle, "an angle by which a frame is turned")?;
        if let UnitOf::Term(term) = &typed.unit
            && !self.is_angle(&self.text(angle.span), angle.span, term)
        {
            return None;
        }
        // The components of a vector depend on the frames.
        let is_vector = |kind: &ExprKind| matches!(kind, ExprKind::Components(_));
        let of_vectors = depending_on(&self.model, is_vector);
        let rule = if self.varying(&typed.expr).is_some() {
            "may change during a flight"
        } else if depends(&typed.expr, &of_vectors, &is_vector) {
            "depends on a vector"
        } else {
            return Some(typed.expr);
        };
        let message = format!("`{}` turns a frame, but it {rule}", self.text(angle.span));
        let fault = Diagnostic::new(Kind::Value, angle.span, message);
        self.refuse(fault.help(
            "turn the frame by a state, or by an expression of numbers, parameters and coefficients",
        ))
    }

    fn by_quaternion(&mut self, parent: &Name, states: &[Name; 4]) -> Option<FrameKind> {
        let parent = self.scope.frame(&parent.text)?;
        let found = states.each_ref().map(|s| self.frame_state(s));
        let [a, b, c, d] = found;
        Some(FrameKind::Quaternion {
            parent,
            states: [a?, b?, c?, d?],
        })
    }

    fn frame_state(&mut self, name: &Name) -> Option<usize> {
        let Some(Symbol::State(index)) = self.scope.find(&name.text) else {
            // If there is a body, the errors of its statements have already been reported.
            if self.declared_body.is_none() {
                self.no_state(name);
            }
            return None;
        };
        let term = self.states[index].clone();
        self.is_angle(&name.text, name.span, &term).then_some(index)
    }

    /// Whether the unit of what turns a frame is that of an angle; reports another one.
    fn is_angle(&mut self, text: &str, span: Span, term: &Term) -> bool {
        let Some(unit) = self.units.resolve(term).unit() else {
            return true;
        };
        if !unit.is_pure() {
            let message = format!(
                "`{text}` turns a frame and must be an angle (rad) or a pure number, but it is {}",
                self.described(term)
            );
            let mut fault = Diagnostic::new(Kind::Unit, span, message);
            if let Some(declared) = self.scope.place(text) {
                fault = fault.label(declared, format!("in {}", unit.explained()));
            }
            self.report(fault);
        }
        unit.is_pure()
    }

    pub fn no_state(&mut self, name: &Name) {
        // A state whose name is taken has been reported.
        if self.model.states.iter().any(|own| own.name == name.text) {
            return;
        }
        // Errors that are not shown need no suggestions.
        let is_shown = self.reported.len() < MAX_SHOWN;
        let count = if is_shown { usize::MAX } else { 0 };
        let states = self.model.states.iter().take(count);
        let states: Vec<String> = states.map(|s| s.name.clone()).collect();
        let declared = self.scope.place(&name.text);
        let message = match declared {
            Some(_) => format!("`{}` is not a state", name.text),
            None => format!("there is no state `{}`", name.text),
        };
        let mut fault = Diagnostic::new(Kind::Name, name.span, message);
        if self.is_reported(&fault) {
            return self.report(fault);
        }
        if let Some(declared) = declared {
            fault = fault.label(declared, "declared here");
        }
        fault = match suggest::nearest(&name.text, states.iter().map(String::as_str)) {
            Some(near) => fault.suggest(near),
            None if self.declared_body.is_none() && states.is_empty() => {
                let state = format!("`state {} = 0 …;`, with its unit", name.text);
                fault.help(format!(
                    "declare a `body`, whose attitude it is; or {state}"
                ))
            }
            None if self.declared_body.is_none() || states.len() > self.of_body => fault.help(
                format!("declare it: `state {} = 0 …;`, with its unit", name.text),
            ),
            None if states.is_empty() => fault,
            None => fault.note(format!("the states are {}", states.join(", "))),
        };
        self.report(fault);
    }

    /// Frames on the path from `from`, included, to the inertial frame, omitted.
    pub fn chain(&self, from: usize) -> Vec<usize> {
        let mut chain = Vec::new();
        let mut at = from;
        // Parents precede children, but a faulty file may contain a cycle.
        while at != 0 && chain.len() <= self.model.frames.len() {
            chain.push(at);
            at = self.model.frames[at].kind.parent().unwrap_or(0);
        }
        chain
    }
}
