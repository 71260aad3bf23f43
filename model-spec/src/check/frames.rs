//! Semantic checks of the frames of reference, which form a tree rooted at the inertial frame.

use super::Checker;
use super::scope::Symbol;
use super::term::Term;
use crate::diagnostic::{Diagnostic, Kind, MAX_SHOWN};
use crate::model::{self, ConstantAngle, FrameKind};
use crate::suggest;
use crate::syntax::ast::{self, Name, Quantity};

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
                } => self.fixed(parent, angle, *axis),
                ast::FrameKind::Quaternion { parent, states } => self.by_quaternion(parent, states),
            };
            if let Some(kind) = kind {
                self.model.frames[index].kind = kind;
            }
        }
    }

    /// The constant or coefficient by which a frame is turned; `None` for a state.
    pub fn constant_angle(&self, angle: &Name) -> Option<ConstantAngle> {
        match self.scope.find(&angle.text)? {
            Symbol::Param(index) => Some(ConstantAngle::Param(index)),
            Symbol::Coefficient(index) => Some(ConstantAngle::Coefficient(index)),
            _ => None,
        }
    }

    fn fixed(&mut self, parent: &Name, angle: &Quantity, axis: u8) -> Option<FrameKind> {
        let parent = self.scope.frame(&parent.text)?;
        let measure = self.measure_or_one(angle.unit.as_ref())?;
        if !measure.unit.is_pure() {
            let message = format!(
                "a frame is turned by an angle (rad) or a pure number, but {angle} is in {}",
                measure.unit.explained()
            );
            return self.refuse(Diagnostic::new(Kind::Unit, angle.span, message));
        }
        Some(FrameKind::Fixed {
            parent,
            angle: ConstantAngle::Number(measure.of(&angle.number).0),
            axis,
        })
    }

    fn turned(&mut self, parent: &Name, angle: &Name, axis: u8) -> Option<FrameKind> {
        let parent = self.scope.frame(&parent.text)?;
        if let Some(computed) = self.file.binding(&angle.text) {
            let message = format!("`{}` turns a frame, but it is computed", angle.text);
            let fault = Diagnostic::new(Kind::Frame, angle.span, message)
                .label(computed.name.span, "computed here");
            return self.refuse(fault.help(
                "turn the frame by a state, a number, or a `param` or `coefficient` with a number of its own",
            ));
        }
        if let Some(constant) = self.constant_angle(angle) {
            let term = match constant {
                ConstantAngle::Param(index) if self.model.params[index].varies => {
                    let message = format!(
                        "`{}` turns a frame, but it may change during a flight",
                        angle.text
                    );
                    let fault = Diagnostic::new(Kind::Value, angle.span, message);
                    return self.refuse(fault.help("turn the frame by a state or a constant"));
                }
                ConstantAngle::Param(index) => self.params[index].clone(),
                ConstantAngle::Coefficient(index) => self.coefficients[index].clone(),
                ConstantAngle::Number(_) => Term::one(),
            };
            return self.is_angle(angle, &term).then_some(FrameKind::Fixed {
                parent,
                angle: constant,
                axis,
            });
        }
        if let Some(symbol) = self.scope.find(&angle.text)
            && !matches!(symbol, Symbol::State(_))
        {
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
        self.is_angle(name, &term).then_some(index)
    }

    /// Whether the unit of a name that turns a frame is that of an angle; reports another one.
    fn is_angle(&mut self, name: &Name, term: &Term) -> bool {
        if let Some(unit) = self.units.resolve(term).unit()
            && !unit.is_pure()
        {
            let message = format!(
                "`{}` turns a frame and must be an angle (rad) or a pure number, but it is {}",
                name.text,
                self.described(term)
            );
            let mut fault = Diagnostic::new(Kind::Unit, name.span, message);
            if let Some(declared) = self.scope.place(&name.text) {
                fault = fault.label(declared, format!("in {}", unit.explained()));
            }
            self.report(fault);
            return false;
        }
        true
    }

    pub fn no_state(&mut self, name: &Name) {
        // A state whose name is taken has been reported.
        if self.model.states.iter().any(|own| own.name == name.text) {
            return;
        }
        // Errors that are not shown need no suggestions.
        let is_shown = self.diagnostics.len() < MAX_SHOWN;
        let count = if is_shown { usize::MAX } else { 0 };
        let states = self.model.states.iter().take(count);
        let states: Vec<String> = states.map(|s| s.name.clone()).collect();
        let declared = self.scope.place(&name.text);
        let message = match declared {
            Some(_) => format!("`{}` is not a state", name.text),
            None => format!("there is no state `{}`", name.text),
        };
        let mut fault = Diagnostic::new(Kind::Name, name.span, message);
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
