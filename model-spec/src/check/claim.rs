//! Semantic checks of a claim.

use super::body::zero;
use super::term::Term;
use super::{Checker, Definition};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::layout::depends;
use crate::model::{self, ClaimedAttitude, ClaimedRotation, Expr, ExprKind};
use crate::syntax::ast::{self, BodyClass, BodyPart, BodyPartKind, ItemKind};
use crate::syntax::{lacking, of_kind};
use crate::unit::Unit;

impl<'a> Checker<'a> {
    pub fn claim(&mut self) {
        let file = self.file;
        let mut claims = of_kind!(file.items.iter(), ItemKind::Claim);
        let Some(claim) = claims.next() else { return };
        for other in claims {
            self.second("claim", claim.name.span, other.name.span);
        }
        if let Some(body) = self.declared_body {
            let message = "a claim says what stated equations are about, and this model has a body";
            let fault = Diagnostic::new(Kind::Duplicate, claim.name.span, message)
                .label(body.name.span, "the body, whose equations are derived");
            self.report(fault.help("remove the claim, or the body"));
            return;
        }
        if self.claimed_parts(claim) {
            self.model.claim = self.claimed(claim);
        }
    }

    /// Whether a `claim` block has each required statement once, without `der(…)`; reports violations.
    fn claimed_parts(&mut self, claim: &'a ast::Body) -> bool {
        let before = self.diagnostics.len();
        let mut seen: Vec<(&str, Span)> = Vec::new();
        for part in &claim.parts {
            let word = part.words;
            if let Some(&(_, first)) = seen.iter().find(|s| s.0 == word) {
                self.second(word, first, part.span);
            }
            seen.push((word, part.span));
            let of_point = ["mass", "position", "velocity", "force"].contains(&word);
            if claim.class == BodyClass::Point && !of_point {
                let message = format!("a point has no `{word}`");
                let fault = Diagnostic::new(Kind::Shape, part.span, message);
                self.report(fault.help("write `claim body`, not `claim point`, if it turns"));
            }
            self.without_derivatives(part);
        }
        let has = |word: &str| seen.iter().any(|s| s.0 == word);
        let rigid = claim.class == BodyClass::Rigid;
        let attitude = has("fixed in") || has("axis");
        let needed = [
            ("mass …;", !has("mass")),
            ("position …;", !has("position")),
            ("velocity …;", !has("velocity")),
            ("force …;", !has("force")),
            ("inertia diag(…, …, …) in …;", rigid && !has("inertia")),
            ("fixed in …; (or axis …;)", rigid && !attitude),
            ("angular velocity …;", rigid && !has("angular velocity")),
            ("moment …;", rigid && !has("moment")),
        ];
        let fault = lacking("the claim of", "the claim", &claim.name, &needed);
        fault.into_iter().for_each(|fault| self.report(fault));
        self.diagnostics.len() == before
    }

    fn without_derivatives(&mut self, part: &'a BodyPart) {
        let mut found: Option<(String, Span)> = None;
        for e in part.expressions() {
            self.all_uses(e, &mut |name, is_derivative, span| {
                if is_derivative {
                    found.get_or_insert((name.to_owned(), span));
                }
            });
        }
        if let Some((state, span)) = found {
            self.circular(&format!("der({state})"), span);
        }
    }

    fn circular(&mut self, what: &str, span: Span) {
        let message = format!(
            "`{what}` follows from the equations: a claim made of it would hold whatever they are"
        );
        let fault = Diagnostic::new(Kind::Cycle, span, message);
        self.report(fault.help("state the quantity by the states and parameters"));
    }

    /// Whether `e` uses a variable that depends on `der(…)`; if so, reports it.
    fn is_circular(&mut self, e: &Expr) -> bool {
        let of_equations: Vec<usize> = { self.derivatives.values() }
            .filter_map(|&definition| match self.definitions.get(definition) {
                Some(Definition::Done(index, ..)) => Some(*index),
                _ => None,
            })
            .chain(self.solved.values().copied())
            .collect();
        // Auxiliary variables come after those that they use.
        let mut follows = vec![false; self.model.aux_variables.len()];
        for (i, variable) in self.model.aux_variables.iter().enumerate() {
            follows[i] =
                of_equations.contains(&i) || depends(&variable.value, &follows, &|_| false);
        }
        let follows = |e: &&Expr| matches!(e.kind, ExprKind::AuxVariable(i) if follows[i]);
        let culprit = e.nodes().find(follows);
        if let Some(culprit) = culprit {
            self.circular(&self.text(culprit.span), culprit.span);
        }
        culprit.is_some()
    }

    fn claimed(&mut self, claim: &'a ast::Body) -> Option<model::Claim> {
        let part = |word: &str| claim.parts.iter().find(|p| p.words == word);
        let [mass] = part("mass")?.expressions()[..] else {
            return None;
        };
        let mass = self.constant_of_body(mass, Unit::KILOGRAM, "the mass", false);
        let mut vector = |word: &str, what: &str, unit: Unit| {
            let [e] = part(word)?.expressions()[..] else {
                return None;
            };
            self.claimed_vector(e, what, unit)
        };
        let position = vector("position", "the position", Unit::METRE);
        let velocity = vector("velocity", "the velocity", Unit::SPEED);
        let force = vector("force", "the force", Unit::NEWTON);
        let rotation = match claim.class {
            BodyClass::Point => None,
            BodyClass::Rigid => {
                let omega = vector("angular velocity", "the angular velocity", Unit::RATE);
                let moment = vector("moment", "the moment", Unit::NEWTON_METRE);
                let inertia = self.claimed_inertia(part("inertia")?);
                let attitude = part("fixed in").or(part("axis"))?;
                let (inertia_frame, inertia) = inertia?;
                let attitude = self.claimed_attitude(attitude, inertia_frame, &inertia)?;
                let [spin, forward] = ["axis", "forward"]
                    .map(|word| part(word).and_then(|own| own.expressions().first().copied()));
                let (ClaimedAttitude::Frame(frame) | ClaimedAttitude::Axis(frame, _)) = attitude;
                let axes = self.flight_axes(frame, spin, forward)?;
                if let (ClaimedAttitude::Axis(..), true) = (attitude, axes.states_forward)
                    && !axes.is_along()
                {
                    let span = part("forward")?.span;
                    let message =
                        "no frame is fixed in this body, so that only its axis can point ahead";
                    let fault = Diagnostic::new(Kind::Frame, span, message);
                    return self.refuse(fault.help(
                        "state the frame that is `fixed in` the body, or leave out `forward`",
                    ));
                }
                Some(ClaimedRotation {
                    attitude,
                    axes,
                    inertia_frame,
                    inertia,
                    angular_velocity: omega?,
                    moment: moment?,
                })
            }
        };
        Some(model::Claim {
            name: claim.name.text.clone(),
            mass: mass?,
            position: position?,
            velocity: velocity?,
            force: force?,
            rotation,
        })
    }

    fn claimed_vector(&mut self, e: &'a ast::Expr, what: &str, unit: Unit) -> Option<Expr> {
        let (typed, _) = self.vector(e, &format!("{what} of the claim"))?;
        let rule = format!("{what} of the claim must be in {}", unit.explained());
        self.must_be(&typed, &Term::known(unit), &rule);
        (!self.is_circular(&typed.expr)).then_some(typed.expr)
    }

    fn claimed_inertia(&mut self, part: &'a BodyPart) -> Option<(usize, [[Expr; 3]; 3])> {
        let BodyPartKind::Inertia(inertia) = &part.kind else {
            return None;
        };
        let frame = self.frame_of(&inertia.frame);
        let entries = self.inertia_entries(inertia, part.span);
        Some((frame?, entries?))
    }

    fn claimed_attitude(
        &mut self,
        part: &'a BodyPart,
        inertia_frame: usize,
        inertia: &[[Expr; 3]; 3],
    ) -> Option<ClaimedAttitude> {
        match &part.kind {
            BodyPartKind::Frame(name) => {
                let frame = self.frame_of(name)?;
                self.steady_inertia(inertia, frame, inertia_frame, part.span);
                Some(ClaimedAttitude::Frame(frame))
            }
            BodyPartKind::Value(e) => {
                let (typed, _) = self.vector(e, "the axis of the claim")?;
                let ExprKind::Axis(frame, axis) = typed.expr.kind else {
                    let message = "the axis of a claim is an axis of a frame, such as `B.3`";
                    return self.refuse(Diagnostic::new(Kind::Shape, e.span, message));
                };
                if frame != inertia_frame || !super::attitude::is_symmetric(inertia, axis) {
                    let name = self.model.frames[frame].name.clone();
                    let message = format!(
                        "a body with `axis {name}.{axis}` is one of revolution about it: its moments of inertia are given in {name} and are equal about the other two axes"
                    );
                    let fault = Diagnostic::new(Kind::Frame, part.span, message);
                    return self
                        .refuse(fault.help("else state the frame that is `fixed in` the body"));
                }
                Some(ClaimedAttitude::Axis(frame, axis))
            }
            BodyPartKind::Inertia(_) | BodyPartKind::States(..) => None,
        }
    }

    /// Entries of an inertia tensor, kg m²; reports entries that are invalid, not symmetric, or those of no body.
    pub fn inertia_entries(
        &mut self,
        inertia: &ast::Inertia,
        span: Span,
    ) -> Option<[[Expr; 3]; 3]> {
        let earlier = self.diagnostics.len();
        let mut rows: [[Option<Expr>; 3]; 3] = Default::default();
        for (i, row) in inertia.rows.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let what = "a moment of inertia";
                rows[i][j] = match entry {
                    None => Some(zero(span)),
                    Some(e) => self.constant_of_body(e, Unit::INERTIA, what, i != j),
                };
            }
        }
        let [
            [Some(a), Some(b), Some(c)],
            [Some(d), Some(e), Some(f)],
            [Some(g), Some(h), Some(i)],
        ] = rows
        else {
            return None;
        };
        let matrix = [[a, b, c], [d, e, f], [g, h, i]];
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            if !matrix[i][j].same(&matrix[j][i]) {
                let (a, b) = (self.text(matrix[i][j].span), self.text(matrix[j][i].span));
                let message = format!(
                    "moments of inertia are symmetric, but row {} column {} is `{a}` and row {} column {} is `{b}`",
                    i + 1,
                    j + 1,
                    j + 1,
                    i + 1
                );
                return self.refuse(Diagnostic::new(Kind::Value, span, message));
            }
        }
        let fault = self.model.tensor_fault(&matrix, &|own| own.value);
        if let Some(fault) = fault.filter(|_| self.diagnostics.len() == earlier) {
            self.report(Diagnostic::new(Kind::Value, span, fault));
        }
        Some(matrix)
    }
}
