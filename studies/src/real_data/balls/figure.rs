//! Figure of the ball study: direction of the lift by file, and lift coefficient by advance ratio.

use report::figures::{Dots, Line, Look, Panel, figure};

use super::lift::Lift;
use super::results::Balls;
use super::stretches::{is_agreeing, number};

/// Draws two panels as SVG: the cosine between lift and ω × v by file number, and the lift coefficient by advance
/// ratio.
pub(in super::super) fn balls_figure(balls: &Balls) -> String {
    let dots = |look: Look, agreeing: bool, point: fn(&Lift) -> (f64, f64)| {
        let lifts = balls.lifts.iter();
        let lifts = lifts.filter(|lift| is_agreeing(&lift.file) == agreeing);
        Dots {
            look,
            points: lifts.map(point).collect(),
        }
    };
    let side = |lift: &Lift| (f64::from(number(&lift.file)), lift.cosine());
    let coefficient = |lift: &Lift| (lift.advance_ratio(), lift.coefficient_by_spin());
    let value = |step: usize, name: &str| {
        let found = balls.lift_by_spin[step].coefficients.get(name);
        found.map_or(0.0, |found| found.value)
    };
    let curve = |name: &str, step: usize| Line {
        name: name.into(),
        points: (0..=65)
            .map(|k| f64::from(k) * 0.02)
            .map(|s| (s, value(step, "C_Lw") * s + value(step, "C_Lww") * s * s))
            .collect(),
    };
    let panels = [
        Panel {
            title: "Cosine between lift and ω × v".into(),
            across: "file number".into(),
            dots: vec![dots(Look::Pale, false, side), dots(Look::Cross, true, side)],
            levels: vec![0.0],
            up: Some((-1.1, 1.1)),
            ..Panel::default()
        },
        Panel {
            title: "Lift coefficient along ω × v".into(),
            across: "advance ratio".into(),
            lines: vec![curve("magnus", 1), curve("and its square", 2)],
            thin: true,
            dots: vec![dots(Look::Cross, true, coefficient)],
            ..Panel::default()
        },
    ];
    figure("Spin and lift of table-tennis balls", &panels)
}
