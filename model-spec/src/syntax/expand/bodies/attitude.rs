//! Attitude of a body after the first one, by a quaternion or by three angles, and Euler's equations for it.

use super::statements::Statements;
use super::{Laws, only_of_first};
use crate::diagnostic::{Diagnostic, Kind};
use crate::syntax::Parts;
use crate::syntax::ast::{Body, Expr, File, FrameKind, LoadClass, Name, Quantity, UnitExpr};
use crate::syntax::body_parts::Triple;
use crate::unit::Unit;

/// Attitude of a body that turns.
pub(super) struct Attitude<'f> {
    /// Frame that is fixed in the body.
    pub frame: &'f str,
    orientation: Orientation<'f>,
    inertia: &'f [[Option<Expr>; 3]; 3],
}

/// What the states of the attitude are.
enum Orientation<'f> {
    /// A quaternion, and the components of the angular velocity.
    Quaternion(&'f [Name; 4], Triple<'f>),
    /// Angles of three turns, and their rates.
    Angles([Turn<'f>; 3]),
}

/// A frame that is turned by an angle.
struct Turn<'f> {
    frame: &'f str,
    angle: &'f Name,
    axis: u8,
}

impl<'f> Attitude<'f> {
    /// Attitude of a body; `None` if parts of it are missing.
    pub fn of(
        file: &'f File,
        body: &Body,
        parts: &Parts<'f>,
        inertial: &str,
    ) -> Result<Option<Attitude<'f>>, Diagnostic> {
        let (Some(fixed), Some((inertia, _))) = (parts.fixed, parts.inertia) else {
            return Ok(None);
        };
        let frame = &fixed.text;
        let fault = |span, message: &str| Diagnostic::new(Kind::Frame, span, message);
        let orientation = match (by_quaternion(file, frame, inertial), parts.angular) {
            (Some(quaternion), Some(own)) if own.1.text == *frame => {
                Orientation::Quaternion(quaternion, own)
            }
            (Some(_), _) => {
                let message = format!(
                    "with a quaternion the angular velocity has states, with components in {frame}"
                );
                let help =
                    format!("add `angular velocity (p, q, r) in {frame};` with states of its own");
                return Err(fault(fixed.span, &message).help(help));
            }
            (None, angular) => {
                let Some(turns) = by_angles(file, frame, inertial) else {
                    let message = format!(
                        "three frames turned by angles, or one by a quaternion, must lead from {inertial} to {frame}"
                    );
                    let help = format!(
                        "declare `frame {frame} = {inertial} by quaternion (e0, e1, e2, e3);`"
                    );
                    return Err(fault(fixed.span, &message).help(help));
                };
                let is_one_turn = |pair: &&[Turn<'_>]| pair[0].axis == pair[1].axis;
                if let Some(pair) = turns.windows(2).find(is_one_turn) {
                    let message = "two turns in a row about one axis are one turn";
                    let fault = fault(pair[1].angle.span, message);
                    return Err(fault.help("turn the frame about another axis"));
                }
                if let Some((_, own, _)) = angular {
                    let message = "the angular velocity follows from the angles of the frames";
                    return Err(fault(own.span, message).help("remove `angular velocity`"));
                }
                Orientation::Angles(turns)
            }
        };
        if inertia.frame.text != *frame {
            let message = format!("the moments of inertia must be given in {frame}");
            let help = format!("write `in {frame}`");
            return Err(only_of_first(body, inertia.frame.span, message, &help));
        }
        Ok(Some(Attitude {
            frame,
            orientation,
            inertia: &inertia.rows,
        }))
    }
}

/// Kind of the declared frame of this name.
fn kind<'f>(file: &'f File, name: &str) -> Option<&'f FrameKind> {
    let found = file.frames().find(|own| own.name.text == name);
    found.map(|own| &own.kind)
}

/// States of the quaternion that turns a frame from the inertial one.
fn by_quaternion<'f>(file: &'f File, frame: &str, inertial: &str) -> Option<&'f [Name; 4]> {
    match kind(file, frame)? {
        FrameKind::Quaternion { parent, states } if parent.text == inertial => Some(states),
        _ => None,
    }
}

/// The three turns that lead from the inertial frame to another.
fn by_angles<'f>(file: &'f File, frame: &'f str, inertial: &str) -> Option<[Turn<'f>; 3]> {
    let mut turns = Vec::new();
    let mut frame = frame;
    while frame != inertial && turns.len() < 3 {
        let FrameKind::Turned {
            parent,
            angle,
            axis,
        } = kind(file, frame)?
        else {
            return None;
        };
        let axis = *axis;
        turns.push(Turn { frame, angle, axis });
        frame = &parent.text;
    }
    turns.reverse();
    let is_whole = frame == inertial;
    turns.try_into().ok().filter(|_| is_whole)
}

impl Laws<'_> {
    /// Euler's equations and those of the attitude.
    pub(super) fn turn(&self, attitude: &Attitude<'_>, made: &mut Statements) {
        let (own, frame) = (&self.body.name.text, attitude.frame);
        let [spin, momentum, moment] = self.names_of_turning();
        match &attitude.orientation {
            Orientation::Quaternion(quaternion, angular_velocity) => {
                for (name, value) in quaternion.iter().zip(["1", "0", "0", "0"]) {
                    made.state(name, Quantity::new(value, None, name.span));
                }
                made.states(*angular_velocity, Unit::RATE);
                made.vector(spin.clone(), *angular_velocity);
            }
            Orientation::Angles(turns) => {
                let at_rest = |name: &Name, unit| {
                    Quantity::new("0", Some(UnitExpr::of(unit, name.span)), name.span)
                };
                for turn in turns {
                    made.state(turn.angle, at_rest(turn.angle, Unit::RADIAN));
                }
                for turn in turns {
                    made.state(&turn.rate(), at_rest(turn.angle, Unit::RATE));
                }
                for (k, turn) in turns.iter().enumerate() {
                    let direction = format!("in_{frame}({}.{})", turn.frame, turn.axis);
                    made.formula(format!("{own}__axis_{}", k + 1), &direction, true);
                }
                let terms = turns.iter().enumerate();
                let terms =
                    terms.map(|(k, turn)| format!("{}*{own}__axis_{}", turn.rate().text, k + 1));
                let sum = terms.collect::<Vec<_>>().join(" + ");
                made.formula(spin.clone(), &sum, false);
            }
        }
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
        let row = |i: usize| {
            let columns = if is_diagonal { i..=i } else { 1..=3 };
            let terms = columns.map(|j| format!("{}*{spin}.{j}", entry(i, j)));
            terms.collect::<Vec<_>>().join(" + ")
        };
        let components = format!("({}, {}, {}) in {frame}", row(1), row(2), row(3));
        made.formula(momentum.clone(), &components, false);
        let sum = self.sum(LoadClass::Moment, frame);
        made.quantity(moment.clone(), Unit::NEWTON_METRE, sum);
        let left = format!("{moment} - cross({spin}, {momentum})");
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
        let accelerations = [1, 2, 3].map(|k| match is_diagonal {
            true => format!("{own}__torque.{k}/{}", entry(k, k)),
            false => {
                let terms = [1, 2, 3].map(|j| format!("{}*{own}__torque.{j}", cofactor(j, k)));
                format!("({})/{own}__det", terms.join(" + "))
            }
        });
        match &attitude.orientation {
            Orientation::Quaternion(quaternion, (angular, ..)) => {
                for (name, law) in angular.iter().zip(&accelerations) {
                    made.equation(name, law);
                }
                rates_of_quaternion(quaternion, angular, made);
            }
            Orientation::Angles(turns) => {
                let [a, b, c] = accelerations;
                let acceleration = format!("({a}, {b}, {c}) in {frame}");
                rates_of_angles(own, turns, &acceleration, made);
            }
        }
    }
}

impl Turn<'_> {
    /// Name of the rate of the angle.
    fn rate(&self) -> Name {
        Name::new(format!("{}dot", self.angle.text), self.angle.span)
    }
}

/// Equations of a quaternion by the components of the angular velocity.
fn rates_of_quaternion(quaternion: &[Name; 4], angular: &[Name; 3], made: &mut Statements) {
    let [p, q, r] = angular.each_ref().map(|name| name.text.as_str());
    let [a, b, c, d] = quaternion.each_ref().map(|name| name.text.as_str());
    let rates = [
        format!("-({b}*{p} + {c}*{q} + {d}*{r})/2"),
        format!("({a}*{p} + {c}*{r} - {d}*{q})/2"),
        format!("({a}*{q} + {d}*{p} - {b}*{r})/2"),
        format!("({a}*{r} + {b}*{q} - {c}*{p})/2"),
    ];
    for (name, rate) in quaternion.iter().zip(rates) {
        made.equation(name, &rate);
    }
}

/// Equations of the angles and their rates by the derivative of the angular velocity, which is the sum of the rates along
/// the axes of the turns: each axis is carried by the turns before it.
fn rates_of_angles(own: &str, turns: &[Turn<'_>; 3], acceleration: &str, made: &mut Statements) {
    let axis = |k: usize| format!("{own}__axis_{}", k % 3 + 1);
    let rates = turns.each_ref().map(Turn::rate);
    let carried = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| {
        let (first, second) = (&rates[i].text, &rates[j].text);
        format!(" - {first}*{second}*cross({}, {})", axis(i), axis(j))
    });
    let rest = format!("{acceleration}{}", carried.concat());
    made.formula(format!("{own}__rest"), &rest, true);
    // The axes span a volume by the angle of the second turn alone.
    let [first, second, third] = turns;
    let follows = second.axis == first.axis % 3 + 1;
    let (function, sign) = match first.axis == third.axis {
        true => ("sin", "-"),
        false => ("cos", if follows { "" } else { "-" }),
    };
    let volume = format!("{function}({})", second.angle.text);
    let reason = format!(
        "{} and {} turn about one axis",
        first.angle.text, third.angle.text
    );
    made.limit(&volume, "0.01", reason);
    for (k, (turn, rate)) in turns.iter().zip(&rates).enumerate() {
        made.equation(turn.angle, &rate.text);
        let across = format!("cross({}, {})", axis(k + 1), axis(k + 2));
        let law = format!("{sign}dot({across}, {own}__rest)/{volume}");
        made.equation(rate, &law);
    }
}
