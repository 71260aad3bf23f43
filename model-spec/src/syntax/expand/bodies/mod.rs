//! Bodies after the first one: their states, and Newton's and Euler's laws for them as stated equations.
//!
//! The equations of the first body are those of the model. The statements of the others stay, each followed by the
//! statements that it stands for; these are made anew whenever a file is expanded, so that effects may add loads.

mod statements;

use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::{
    Body, BodyClass, Expanded, Expr, File, Frame, FrameKind, Item, ItemKind, Load, LoadClass, Name,
    Quantity, Template,
};
use crate::syntax::body_parts::Triple;
use crate::syntax::{Parts, of_kind};
use crate::unit::Unit;
use statements::{Statement, Statements, expression};
use std::sync::Arc;

use super::unroll::added;

/// Whether bodies after the first one are not written out yet.
pub(super) fn is_needed(file: &File) -> bool {
    let bodies = file.items.iter().enumerate();
    let mut bodies = bodies.filter(|(_, item)| matches!(item.kind, ItemKind::Body(_)));
    bodies.next();
    bodies.any(|(at, _)| !file.items.get(at + 1).is_some_and(Item::is_of_body))
}

/// Writes out the bodies after the first one, and returns the errors.
pub(super) fn write_out(file: &mut File) -> Vec<Diagnostic> {
    file.items.retain(|item| !item.is_of_body());
    let bodies: Vec<Body> = of_kind!(file.items.iter(), ItemKind::Body)
        .cloned()
        .collect();
    let mut faults = unknown_bodies(file, &bodies);
    let Some((first, others)) = bodies.split_first() else {
        return faults;
    };
    let mut made = Vec::new();
    for body in others {
        if let Some(other) = bodies
            .iter()
            .take_while(|own| *own != body)
            .find(|own| own.name.text == body.name.text)
        {
            let message = format!("there are two bodies `{}`", body.name.text);
            let fault = Diagnostic::new(Kind::Duplicate, body.name.span, message);
            faults.push(
                fault
                    .label(other.name.span, "the first")
                    .help("rename one of them"),
            );
            continue;
        }
        match Laws::of(file, body) {
            Ok(laws) => made.push((&body.name, laws.statements())),
            Err(own) => faults.extend(own),
        }
    }
    if !faults.is_empty() {
        return faults;
    }
    let items = std::mem::take(&mut file.items);
    for item in items {
        let statements = match &item.kind {
            ItemKind::Body(body) if body.name != first.name => {
                made.iter().find(|(name, _)| **name == body.name)
            }
            _ => None,
        };
        let Some((_, statements)) = statements else {
            file.items.push(item);
            continue;
        };
        let written = Item {
            expanded: None,
            ..item
        };
        let kinds = statements.iter().map(|(own, _)| own.kind.clone());
        let from = Arc::new(Template {
            expanded: std::iter::once(written.kind.clone()).chain(kinds).collect(),
            written: written.clone(),
        });
        let all = std::iter::once((written, None)).chain(statements.iter().cloned());
        file.items.extend(all.map(|(own, call)| Item {
            expanded: Some(Expanded {
                from: Arc::clone(&from),
                call,
            }),
            ..own
        }));
    }
    faults
}

/// Errors of loads on bodies that are not declared.
fn unknown_bodies(file: &File, bodies: &[Body]) -> Vec<Diagnostic> {
    let loads = of_kind!(file.items.iter(), ItemKind::Load);
    let on = loads.filter_map(|load| load.on.as_ref());
    let is_known = |name: &Name| bodies.iter().any(|body| body.name.text == name.text);
    let unknown = on.filter(|name| !bodies.is_empty() && !is_known(name));
    let names = || bodies.iter().map(|body| body.name.text.as_str());
    let fault = |name: &Name| {
        let message = format!("there is no body `{}`", name.text);
        Diagnostic::new(Kind::Name, name.span, message).did_you_mean(&name.text, names())
    };
    unknown.map(fault).collect()
}

/// What the laws of a body are made of.
struct Laws<'f> {
    body: &'f Body,
    inertial: &'f str,
    mass: &'f Expr,
    position: Triple<'f>,
    velocity: Triple<'f>,
    attitude: Option<Attitude<'f>>,
    /// Loads on the body, with their statements.
    loads: Vec<(&'f Load, &'f Item)>,
}

/// Attitude of a body that turns.
struct Attitude<'f> {
    frame: &'f str,
    quaternion: &'f [Name; 4],
    angular_velocity: Triple<'f>,
    inertia: &'f [[Option<Expr>; 3]; 3],
}

impl<'f> Laws<'f> {
    fn of(file: &'f File, body: &'f Body) -> Result<Self, Vec<Diagnostic>> {
        let (parts, mut faults) = Parts::of(body);
        let inertial = file
            .frames()
            .find(|frame| frame.kind == FrameKind::Inertial);
        // A model without frames is refused by the checks.
        let inertial = inertial.map_or("N", |frame| frame.name.text.as_str());
        let own = |kind, span, message: String, help: &str| {
            let message = format!("{message}, as `{}` is not the first body", body.name.text);
            Diagnostic::new(kind, span, message).help(help.to_owned())
        };
        let only_of_first = [
            ("axis", parts.axis.map(|e| e.span)),
            ("forward", parts.forward.map(|e| e.span)),
            (
                "angular velocity in",
                parts.angular_velocity_frame.map(|f| f.span),
            ),
        ];
        for (words, span) in only_of_first {
            faults.extend(span.map(|span| {
                own(
                    Kind::Frame,
                    span,
                    format!("`{words}` has no meaning here"),
                    "remove it",
                )
            }));
        }
        let attitude = match body.class {
            BodyClass::Point => None,
            BodyClass::Rigid => match attitude(file, &parts, inertial) {
                Ok(attitude) => attitude,
                Err((span, message, help)) => {
                    faults.push(own(Kind::Frame, span, message, &help));
                    None
                }
            },
        };
        let fixed = attitude.as_ref().map_or(inertial, |own| own.frame);
        for (triple, frames) in [
            (parts.position, [inertial; 2]),
            (parts.velocity, [inertial, fixed]),
        ] {
            let Some((_, frame, _)) =
                triple.filter(|(_, frame, _)| !frames.contains(&frame.text.as_str()))
            else {
                continue;
            };
            let message = format!("`{}` cannot be the frame of these components", frame.text);
            faults.push(own(
                Kind::Frame,
                frame.span,
                message,
                &format!("write `in {inertial}`"),
            ));
        }
        let (Some(mass), Some(position), Some(velocity)) =
            (parts.mass, parts.position, parts.velocity)
        else {
            return Err(faults);
        };
        let items = file.items.iter();
        let loads = items.filter_map(|item| match &item.kind {
            ItemKind::Load(load) if load.is_on(&body.name.text) => Some((load, item)),
            _ => None,
        });
        let loads: Vec<(&Load, &Item)> = loads.collect();
        let is_moment = |(load, _): &&(&Load, &Item)| load.class == LoadClass::Moment;
        if let (BodyClass::Point, Some((moment, _))) = (body.class, loads.iter().find(is_moment)) {
            let message = format!(
                "a point has no moments, but this one acts on `{}`",
                body.name.text
            );
            let fault = Diagnostic::new(Kind::Shape, moment.name.span, message);
            faults.push(fault.help("declare it as `body`, not as `point`, if it turns"));
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        Ok(Self {
            body,
            inertial,
            mass,
            position,
            velocity,
            attitude,
            loads,
        })
    }
}

/// Attitude of a body that turns, `None` if parts of it are missing; an error with its place, message and help.
fn attitude<'f>(
    file: &'f File,
    parts: &Parts<'f>,
    inertial: &str,
) -> Result<Option<Attitude<'f>>, (Span, String, String)> {
    let (Some(fixed), Some((inertia, _))) = (parts.fixed, parts.inertia) else {
        return Ok(None);
    };
    let frame = &fixed.text;
    let by_quaternion =
        format!("declare `frame {frame} = {inertial} by quaternion (e0, e1, e2, e3);`");
    let found = file.frames().find(|own| own.name.text == *frame);
    let quaternion = found.and_then(|Frame { kind, .. }| match kind {
        FrameKind::Quaternion { parent, states } if parent.text == inertial => Some(states),
        _ => None,
    });
    let Some(quaternion) = quaternion else {
        let message = format!("the attitude must be a quaternion from {inertial} to {frame}");
        return Err((fixed.span, message, by_quaternion));
    };
    let Some(angular_velocity) = parts.angular.filter(|(_, own, _)| own.text == *frame) else {
        let message = format!("the angular velocity must have states, with components in {frame}");
        return Err((
            fixed.span,
            message,
            format!("add `angular velocity (p, q, r) in {frame};` with states of its own"),
        ));
    };
    if inertia.frame.text != *frame {
        let message = format!("the moments of inertia must be given in {frame}");
        return Err((inertia.frame.span, message, format!("write `in {frame}`")));
    }
    Ok(Some(Attitude {
        frame,
        quaternion,
        angular_velocity,
        inertia: &inertia.rows,
    }))
}

impl Laws<'_> {
    fn statements(&self) -> Vec<Statement> {
        let (own, span) = (&self.body.name.text, self.body.name.span);
        let mut made = Statements::at(span);
        made.states(self.position, Unit::METRE);
        made.states(self.velocity, Unit::SPEED);
        made.constant(format!("mass_of_{own}"), Unit::KILOGRAM, self.mass.clone());
        made.vector(format!("position_of_{own}"), self.position);
        made.vector(format!("velocity_of_{own}"), self.velocity);
        for (load, item) in &self.loads {
            made.load(own, load, item);
        }
        let force = self.sum(LoadClass::Force, &self.velocity.1.text);
        made.quantity(format!("force_on_{own}"), Unit::NEWTON, force);
        let velocity = format!("in_{}(velocity_of_{own})", self.inertial);
        let carried = match &self.attitude {
            Some(attitude) if attitude.frame == self.velocity.1.text => {
                format!(" - cross(angular_velocity_of_{own}, velocity_of_{own})")
            }
            _ => String::new(),
        };
        for k in 0..3 {
            made.equation(&self.position.0[k], &format!("({velocity}).{}", k + 1));
            let law = format!("(force_on_{own}/mass_of_{own}{carried}).{}", k + 1);
            made.equation(&self.velocity.0[k], &law);
        }
        let mut energy = format!("mass_of_{own}*dot(velocity_of_{own}, velocity_of_{own})/2");
        let mut power = format!("dot(force_on_{own}, velocity_of_{own})");
        if let Some(attitude) = &self.attitude {
            self.turn(attitude, &mut made);
            energy += &format!(" + dot(angular_momentum_of_{own}, angular_velocity_of_{own})/2");
            power += &format!(" + dot(moment_on_{own}, angular_velocity_of_{own})");
            made.claim(
                &format!("angular_momentum_of_{own}"),
                &format!("moment_on_{own}"),
            );
        }
        made.claim(&energy, &power);
        made.list
    }

    /// Euler's equations and those of the quaternion.
    fn turn(&self, attitude: &Attitude<'_>, made: &mut Statements) {
        let (own, frame) = (&self.body.name.text, attitude.frame);
        let [p, q, r] = attitude
            .angular_velocity
            .0
            .each_ref()
            .map(|name| name.text.as_str());
        let [a, b, c, d] = attitude
            .quaternion
            .each_ref()
            .map(|name| name.text.as_str());
        for (name, value) in attitude.quaternion.iter().zip(["1", "0", "0", "0"]) {
            made.state(name, Quantity::new(value, None, name.span));
        }
        made.states(attitude.angular_velocity, Unit::RATE);
        made.vector(
            format!("angular_velocity_of_{own}"),
            attitude.angular_velocity,
        );
        let is_diagonal = attitude.inertia.iter().flatten().flatten().count() == 3;
        for (i, row) in attitude.inertia.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                if let Some(entry) = entry {
                    let name = format!("{own}__I_{}{}", i + 1, j + 1);
                    made.constant(name, Unit::INERTIA, entry.clone());
                }
            }
        }
        let entry = |i: usize, j: usize| format!("{own}__I_{i}{j}");
        let row = |i: usize| match is_diagonal {
            true => format!("{}*{}", entry(i, i), [p, q, r][i - 1]),
            false => format!(
                "{}*{p} + {}*{q} + {}*{r}",
                entry(i, 1),
                entry(i, 2),
                entry(i, 3)
            ),
        };
        let momentum = format!("({}, {}, {}) in {frame}", row(1), row(2), row(3));
        made.formula(format!("angular_momentum_of_{own}"), &momentum, false);
        made.quantity(
            format!("moment_on_{own}"),
            Unit::NEWTON_METRE,
            self.sum(LoadClass::Moment, frame),
        );
        let left = format!(
            "moment_on_{own} - cross(angular_velocity_of_{own}, angular_momentum_of_{own})"
        );
        made.formula(format!("{own}__torque"), &left, true);
        // Cofactors of the symmetric tensor, over its determinant.
        let cofactor = |i: usize, j: usize| {
            let next = |k: usize| k % 3 + 1;
            let (a, b, c, d) = (next(i), next(next(i)), next(j), next(next(j)));
            format!(
                "({}*{} - {}*{})",
                entry(a, c),
                entry(b, d),
                entry(a, d),
                entry(b, c)
            )
        };
        if !is_diagonal {
            let terms = [1, 2, 3].map(|j| format!("{}*{}", entry(1, j), cofactor(1, j)));
            made.formula(format!("{own}__det"), &terms.join(" + "), true);
            made.positive(
                &format!("{own}__det"),
                format!("the inertia tensor of {own} is not positive definite"),
            );
        }
        for (k, name) in attitude.angular_velocity.0.iter().enumerate() {
            let law = match is_diagonal {
                true => format!("{own}__torque.{}/{}", k + 1, entry(k + 1, k + 1)),
                false => {
                    let terms =
                        [1, 2, 3].map(|j| format!("{}*{own}__torque.{j}", cofactor(j, k + 1)));
                    format!("({})/{own}__det", terms.join(" + "))
                }
            };
            made.equation(name, &law);
        }
        let rates = [
            format!("-({b}*{p} + {c}*{q} + {d}*{r})/2"),
            format!("({a}*{p} + {c}*{r} - {d}*{q})/2"),
            format!("({a}*{q} + {d}*{p} - {b}*{r})/2"),
            format!("({a}*{r} + {b}*{q} - {c}*{p})/2"),
        ];
        for (name, rate) in attitude.quaternion.iter().zip(rates) {
            made.equation(name, &rate);
        }
    }

    /// Sum of the loads of a class, with components in `frame`.
    fn sum(&self, class: LoadClass, frame: &str) -> Expr {
        let span = self.body.name.span;
        let loads = self.loads.iter().filter(|(load, _)| load.class == class);
        let terms = loads.map(|(load, _)| {
            let name = on_body(load, &self.body.name.text);
            expression(&format!("in_{frame}({name})"), span)
        });
        let none = || expression(&format!("(0, 0, 0) in {frame}"), span);
        added(terms.collect(), span).unwrap_or_else(none)
    }
}

/// Name of a load as a quantity of the model.
fn on_body(load: &Load, body: &str) -> String {
    format!("{}_on_{body}", load.name.text)
}
