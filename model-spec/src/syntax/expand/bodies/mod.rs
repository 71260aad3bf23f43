//! Bodies after the first one: their states, and Newton's and Euler's laws for them as stated equations.
//!
//! The equations of the first body are those of the model. The statements of the others stay, each followed by the
//! statements that it stands for; these are made anew whenever a file is expanded, so that effects may add loads.

mod attitude;
mod collisions;
mod statements;

use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::{Body, BodyClass, Expr, File, Item, ItemKind, Load, LoadClass, Name};
use crate::syntax::body_parts::Triple;
use crate::syntax::reserved::BodyQuantity;
use crate::syntax::{Parts, of_kind};
use crate::unit::Unit;
use attitude::Attitude;
use statements::{Statement, Statements, expression};

use super::unroll::added;
use super::{of_template, written_out};

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
    faults.extend(collisions::collisions(file, others));
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
        let written = written_out(item);
        let mut all = vec![(written.clone(), None)];
        all.extend(statements.iter().cloned());
        file.items.extend(of_template(written, all));
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

/// Error about what only the first body can have.
fn only_of_first(body: &Body, span: Span, message: String, help: &str) -> Diagnostic {
    let message = format!("{message}, as `{}` is not the first body", body.name.text);
    Diagnostic::new(Kind::Frame, span, message).help(help)
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

impl<'f> Laws<'f> {
    fn of(file: &'f File, body: &'f Body) -> Result<Self, Vec<Diagnostic>> {
        let (parts, mut faults) = Parts::of(body);
        // A model without frames is refused by the checks.
        let inertial = file.inertial().unwrap_or("N");
        let own = |span, message, help: &str| only_of_first(body, span, message, help);
        let of_first = [
            ("axis", parts.axis.map(|e| e.span)),
            ("forward", parts.forward.map(|e| e.span)),
            (
                "angular velocity in",
                parts.angular_velocity_frame.map(|f| f.span),
            ),
        ];
        for (words, span) in of_first {
            let message = format!("`{words}` has no meaning here");
            faults.extend(span.map(|span| own(span, message, "remove it")));
        }
        let attitude = match body.class {
            BodyClass::Point => None,
            BodyClass::Rigid => match Attitude::of(file, body, &parts, inertial) {
                Ok(attitude) => attitude,
                Err(fault) => {
                    faults.push(fault);
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
            let help = format!("write `in {inertial}`");
            faults.push(own(frame.span, message, &help));
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

impl Laws<'_> {
    /// Name of a quantity of the body.
    fn name(&self, quantity: BodyQuantity) -> String {
        quantity.of(&self.body.name.text)
    }

    fn statements(&self) -> Vec<Statement> {
        let (own, span) = (&self.body.name.text, self.body.name.span);
        let [mass, position, velocity, force] = [
            BodyQuantity::Mass,
            BodyQuantity::Position,
            BodyQuantity::Velocity,
            BodyQuantity::Force,
        ]
        .map(|quantity| self.name(quantity));
        let mut made = Statements::at(span);
        made.states(self.position, Unit::METRE);
        made.states(self.velocity, Unit::SPEED);
        made.constant(mass.clone(), Unit::KILOGRAM, self.mass.clone());
        made.vector(position, self.position);
        made.vector(velocity.clone(), self.velocity);
        for (load, item) in &self.loads {
            made.load(own, load, item);
        }
        let sum = self.sum(LoadClass::Force, &self.velocity.1.text);
        made.quantity(force.clone(), Unit::NEWTON, sum);
        let carried = match &self.attitude {
            Some(attitude) if attitude.frame == self.velocity.1.text => {
                let spin = self.name(BodyQuantity::AngularVelocity);
                format!(" - cross({spin}, {velocity})")
            }
            _ => String::new(),
        };
        for k in 0..3 {
            let travel = format!("in_{}({velocity}).{}", self.inertial, k + 1);
            made.equation(&self.position.0[k], &travel);
            let law = format!("({force}/{mass}{carried}).{}", k + 1);
            made.equation(&self.velocity.0[k], &law);
        }
        let mut energy = format!("{mass}*dot({velocity}, {velocity})/2");
        let mut power = format!("dot({force}, {velocity})");
        if let Some(attitude) = &self.attitude {
            self.turn(attitude, &mut made);
            let [spin, momentum, moment] = self.names_of_turning();
            energy += &format!(" + dot({momentum}, {spin})/2");
            power += &format!(" + dot({moment}, {spin})");
            made.claim(&momentum, &moment);
        }
        made.claim(&energy, &power);
        made.list
    }

    /// Names of the angular velocity, the angular momentum and the moment.
    fn names_of_turning(&self) -> [String; 3] {
        [
            BodyQuantity::AngularVelocity,
            BodyQuantity::AngularMomentum,
            BodyQuantity::Moment,
        ]
        .map(|quantity| self.name(quantity))
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
