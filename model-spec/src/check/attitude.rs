//! Checks of a body's inertia tensor and of the chain of frames that describes its attitude.

use super::Checker;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{BodyAxis, Expr, ExprKind, FlightAxes, FrameKind};
use crate::syntax::{Parts, ast};

impl Checker<'_> {
    /// Axes in flight of a body in which a frame is fixed, by what its block states; `None`, with an error reported, if
    /// they are not axes of that frame.
    pub fn flight_axes(
        &mut self,
        frame: usize,
        spin: Option<&ast::Expr>,
        forward: Option<&ast::Expr>,
    ) -> Option<FlightAxes> {
        let mut stated = |e: Option<&ast::Expr>, word: &str| match e {
            Some(e) => self.body_axis(frame, e, word).map(Some),
            None => Some(None),
        };
        let (spin, forward) = (stated(spin, "axis"), stated(forward, "forward"));
        Some(FlightAxes::new(spin?, forward?))
    }

    /// The axis of `frame` that `word` states, such as `C.1` or `-C.3`.
    fn body_axis(&mut self, frame: usize, e: &ast::Expr, word: &str) -> Option<BodyAxis> {
        let (typed, _) = self.vector(e, &format!("`{word}`"))?;
        let (stated, is_opposite) = match &typed.expr.kind {
            ExprKind::Neg(inner) => (&inner.kind, true),
            kind => (kind, false),
        };
        match *stated {
            ExprKind::Axis(own, number) if own == frame => Some(BodyAxis {
                number,
                is_opposite,
            }),
            _ => {
                let name = self.model.frames[frame].name.clone();
                let message = format!(
                    "`{word}` is an axis of the frame {name}, which moves with the body, but this is `{}`",
                    self.text(e.span)
                );
                let fault = Diagnostic::new(Kind::Frame, e.span, message);
                self.refuse(fault.help(format!("write `{word} {name}.1;`, or `-{name}.1`")))
            }
        }
    }

    /// Checks the entries of the inertia tensor (constant, kg m², symmetric) and stores them in the model.
    pub fn inertia(&mut self, inertia: &ast::Inertia, span: Span) {
        let Some(matrix) = self.inertia_entries(inertia, span) else {
            return;
        };
        let rotation = self.model.rotation();
        if let Some((body, frame)) = rotation.map(|r| (r.body_frame, r.inertia_frame)) {
            self.steady_inertia(&matrix, body, frame, inertia.frame.span);
        }
        if let Some(rotation) = self.model.body.as_mut().and_then(|b| b.rotation.as_mut()) {
            rotation.inertia = matrix;
        }
    }

    /// Reports an inertia tensor whose components in the frame `frame` would change with time. They are constant if
    /// `frame` is the body-fixed frame `body`, or differs from it only by rotations about axes of inertial symmetry.
    pub fn steady_inertia(
        &mut self,
        inertia: &[[Expr; 3]; 3],
        body: usize,
        frame: usize,
        span: Span,
    ) {
        let chain = self.chain(body);
        let name = |i: usize| self.model.frames[i].name.clone();
        let Some(steps) = chain.iter().chain([&0]).position(|&f| f == frame) else {
            let message = format!(
                "the frame {} does not move with the body, which is fixed in {}",
                name(frame),
                name(body)
            );
            let help = format!("give the moments of inertia in {}", name(body));
            self.report(Diagnostic::new(Kind::Frame, span, message).help(help));
            return;
        };
        for &step in &chain[..steps] {
            let about = match self.model.frames[step].kind {
                FrameKind::Fixed { .. } => continue,
                FrameKind::Turned { axis, .. } if is_symmetric(inertia, axis) => continue,
                FrameKind::Turned { axis, .. } => format!(
                    "the body turns in it about axis {axis}, about which these moments are not symmetric"
                ),
                _ => "the body turns in it".to_owned(),
            };
            let message = format!(
                "moments of inertia in {} would change with time: {about}",
                name(frame)
            );
            let turns = format!("{} turns here", name(step));
            let fault = Diagnostic::new(Kind::Frame, span, message)
                .label(self.model.frames[step].span, turns);
            let help = format!("give them in {}, the frame fixed in the body", name(body));
            self.report(fault.help(help));
            return;
        }
    }

    /// Checks that three rotations about different axes, or one quaternion, lead to the body, through every frame. With
    /// a quaternion, the body must have states of its angular velocity.
    pub fn attitude(&mut self, body: &ast::Body, parts: &Parts<'_>) {
        let Some(rotation) = self.model.rotation() else {
            return;
        };
        let (body_frame, angular) = (rotation.body_frame, rotation.angular_velocity);
        let chain = self.chain(body_frame);
        // What turns such a frame has been reported.
        let is_faulty = |i: &usize| *i > 0 && self.model.frames[*i].kind == FrameKind::Inertial;
        if chain.iter().any(is_faulty) {
            return;
        }
        let name = |i: usize| self.model.frames[i].name.clone();
        let is_fixed = |i: &usize| matches!(self.model.frames[*i].kind, FrameKind::Fixed { .. });
        if let Some(&fixed) = chain.iter().rev().find(|i| is_fixed(i)) {
            let message = format!(
                "the frame {} is turned by a constant and cannot lie between {} and the body's frame {}",
                name(fixed),
                name(0),
                name(body_frame)
            );
            let place = self.model.frames[fixed].span;
            self.report(Diagnostic::new(Kind::Frame, place, message));
            return;
        }
        // Frames that are turned by declared states have equations of their own.
        let is_stated = |i: &usize| match self.model.frames[*i].kind {
            FrameKind::Turned { angle, .. } => angle >= self.of_body,
            FrameKind::Quaternion { states, .. } => states[0] >= self.of_body,
            _ => false,
        };
        let mut frames = 1..self.model.frames.len();
        let is_loose =
            |i: &usize| !chain.contains(i) && !is_fixed(i) && !is_stated(i) && !is_faulty(i);
        if let Some(loose) = frames.find(is_loose) {
            let message = format!(
                "nothing determines how the frame {} moves: it does not lie between {} and the body's frame {}",
                name(loose),
                name(0),
                name(body_frame)
            );
            let place = self.model.frames[loose].span;
            self.report(Diagnostic::new(Kind::Frame, place, message));
            return;
        }
        let axis = |&f: &usize| match self.model.frames[f].kind {
            FrameKind::Turned { axis, .. } => Some(axis),
            _ => None,
        };
        let axes: Vec<Option<u8>> = chain.iter().rev().map(axis).collect();
        match axes[..] {
            [None] => {
                let fixed = parts.fixed.map_or(body.name.span, |f| f.span);
                match (angular, parts.angular) {
                    (None, None) => {
                        let message = "where the attitude is a quaternion the angular velocity has states of its own";
                        let help = format!(
                            "add `angular velocity (p, q, r) in {};` to the body",
                            name(body_frame)
                        );
                        self.report(Diagnostic::new(Kind::Missing, fixed, message).help(help));
                    }
                    (Some((_, frame)), Some((_, written, _))) if frame != body_frame => {
                        let message = format!(
                            "the angular velocity must be given in the body's own frame {}",
                            name(body_frame)
                        );
                        let help = format!("write `in {}`", name(body_frame));
                        self.report(Diagnostic::new(Kind::Frame, written.span, message).help(help));
                    }
                    _ => {}
                }
            }
            [Some(a), Some(b), Some(c)] => {
                if a == b || b == c {
                    let message = "two turns in a row about one axis are one turn";
                    let help =
                        "turn about three axes such as 1, 2, 3, each different from the one before";
                    let second = chain[usize::from(a == b)];
                    let place = self.model.frames[second].span;
                    self.report(Diagnostic::new(Kind::Frame, place, message).help(help));
                } else if let Some((names, ..)) = parts.angular {
                    let message = "where the attitude is by angles their rates are states, and the angular velocity follows from them";
                    let fault = Diagnostic::new(Kind::Duplicate, names[0].span, message);
                    self.report(fault.help("remove `angular velocity`"));
                }
            }
            _ => {
                let turns = axes.len();
                let message = format!(
                    "a free body turns in three ways, but from {} to {} there {} {turns} turn{}",
                    name(0),
                    name(body_frame),
                    if turns == 1 { "is" } else { "are" },
                    if turns == 1 { "" } else { "s" },
                );
                let fixed = parts.fixed.map_or(body.name.span, |f| f.span);
                let help =
                    "declare three frames, each turned from the one before, or one `by quaternion`";
                self.report(Diagnostic::new(Kind::Frame, fixed, message).help(help));
            }
        }
    }
}

/// Whether an inertia tensor is diagonal, with equal moments about the axes other than `axis`.
pub(super) fn is_symmetric(inertia: &[[Expr; 3]; 3], axis: u8) -> bool {
    let k = usize::from(axis) - 1;
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let off = [(0, 1), (0, 2), (1, 2)]
        .iter()
        .all(|&(a, b)| is_zero(&inertia[a][b]));
    off && inertia[i][i].same(&inertia[j][j])
}

fn is_zero(e: &Expr) -> bool {
    matches!(e.kind, ExprKind::Number { value: 0.0, .. })
}
