//! Tests of the search for cells, with arguments as functions of the fraction of a step.

use super::*;
use lanes::Level;

/// One argument, by its values and, if known, by its bounds.
struct One(fn(f64) -> f64, Option<fn(Enclosure) -> Enclosure>);

impl Passed for One {
    fn arguments(&mut self, s: f64, to: &mut [f64]) {
        to[0] = self.0(s);
    }

    fn bounds(&mut self, (from, until): (f64, f64), to: &mut [Enclosure]) -> bool {
        let s = Enclosure::polynomial(&[0.5 * (from + until), 0.5 * (until - from)]);
        self.1.is_some_and(|of| {
            to[0] = of(s);
            true
        })
    }

    fn deviation(&mut self, _s: f64) -> f64 {
        0.0
    }
}

/// An argument with these levels, which are smooth.
fn smooth(levels: &[f64]) -> Switch {
    let level = |&value| Level {
        value,
        is_kink: false,
    };
    Switch {
        levels: levels.iter().map(level).collect(),
        is_phase: false,
    }
}

fn found(levels: &[f64], argument: fn(f64) -> f64) -> Vec<Cell> {
    found_in(smooth(levels), One(argument, None))
}

fn found_in(switch: Switch, mut argument: One) -> Vec<Cell> {
    let switches = [switch];
    let points = [0.0, 0.5, 1.0].map(|s| [argument.0(s)]);
    let points = points.each_ref().map(|values| &values[..]);
    if !may_have_cells(&switches, points) {
        return Vec::new();
    }
    cells(&switches, &mut argument).0
}

/// Distances from a line and products, whose extreme no parabola through samples shows.
#[test]
fn narrow_extremes_are_found_by_bounds() {
    macro_rules! cell {
        ($levels:expr, |$s:ident| $value:expr) => {{
            fn of<T: Real>($s: T) -> T {
                $value
            }
            let cells = found_in(smooth($levels), One(of::<f64>, Some(of::<Enclosure>)));
            let widths = cells.iter().map(|cell| (cell.middle(), cell.width()));
            widths.collect::<Vec<(f64, f64)>>()
        }};
    }
    fn number<T: Real>(value: f64) -> T {
        T::splat(value)
    }
    let near = |cells: &[(f64, f64)], expected: &[(f64, f64)]| {
        assert_eq!(cells.len(), expected.len(), "{cells:?}");
        for (a, b) in cells.iter().zip(expected) {
            assert!(
                (a.0 - b.0).abs() < 1e-7 && (a.1 - b.1).abs() < 1e-7,
                "{cells:?}"
            );
        }
    };
    // 5e-6 of the step wide: a distance that comes to 4e-6 of it.
    let cells = cell!(&[0.0], |s| {
        let x = s - number(0.7313);
        number::<T>(5e-6) - (x * x + number(1.6e-11)).sqrt()
    });
    near(&cells, &[(0.7313, 6e-6)]);
    let cells = cell!(&[0.0], |s| (s - number(0.31)) * (number::<T>(0.31001) - s));
    near(&cells, &[(0.310005, 1e-5)]);
    // Just too far away.
    let cells = cell!(&[0.0], |s| {
        let x = s - number(0.7313);
        number::<T>(3.9e-6) - (x * x + number(1.6e-11)).sqrt()
    });
    near(&cells, &[]);
    let cells = cell!(&[0.5], |s| (s - number(0.2)).heaviside()
        - (s - number(0.20003)).heaviside());
    near(&cells, &[]);
}

#[test]
fn a_cell_is_between_two_passages() {
    let near = |cells: Vec<Cell>, middle: f64, width: f64| {
        let [cell] = cells[..] else {
            panic!("{cells:?}")
        };
        assert!((cell.middle() - middle).abs() < 1e-6);
        assert!((cell.width() - width).abs() < 1e-6);
    };
    near(found(&[3.0, 3.01], |s| 10.0 * s), 0.3005, 0.001);
    near(found(&[3.0, 3.01], |s| 10.0 - 10.0 * s), 0.6995, 0.001);
    // An extreme between the samples, of a parabola and of a function with a kink that is not at a sample.
    near(
        found(&[-1.0], |s| -(1e3 * (s - 0.333)).powi(2)),
        0.333,
        0.002,
    );
    near(found(&[0.0], |s| 1e-6 - (s - 0.01).powi(2)), 0.01, 0.002);
    // From a level at the start.
    near(found(&[0.0, 1.0], |s| 5.0 * s), 0.1, 0.2);
    // One passage, none, and an argument that rests on its level.
    assert!(found(&[0.3], |s| s).is_empty());
    assert!(found(&[2.0, 3.0], |s| s).is_empty());
    assert!(found(&[0.0], |_| 0.0).is_empty());
    assert!(found(&[0.0], |_| f64::NAN).is_empty());
}

#[test]
fn a_kink_parts_a_step() {
    let mut kink = smooth(&[0.3]);
    kink.levels[0].is_kink = true;
    let cells = found_in(kink, One(|s| s, None));
    let [before, after] = cells[..] else {
        panic!("{cells:?}")
    };
    assert_eq!((before.from, after.until), (0.0, 1.0));
    assert!(before.until == after.from && (after.from - 0.3).abs() < 1e-7);
    // A step ends just before the kink, then as far behind it, and never at its own start or end.
    let near = before.cut(1e4);
    assert!((near - 0.3 * (1.0 - 5e-4)).abs() < 1e-7);
    assert!((after.cut(1e4) - 0.6).abs() < 1e-6);
    for change in [11.0, 1e300, f64::INFINITY, f64::NAN] {
        for (from, until) in [
            (0.0, 1.0),
            (0.0, 1e-6),
            (1e-12, 1.0),
            (0.9, 1.0),
            (0.2, 0.3),
        ] {
            let cut = Cell { from, until }.cut(change);
            assert!(0.0 < cut && cut < until && cut > from.min(1e-8), "{cut}");
        }
    }
}

/// A train of pulses, of whose sine three values show none.
struct Pulses;

fn turned<T: Real>(s: T) -> [T; 2] {
    let phase = s * T::splat(300.0 * std::f64::consts::TAU);
    [phase.sin_cos().0, phase]
}

impl Passed for Pulses {
    fn arguments(&mut self, s: f64, to: &mut [f64]) {
        to.copy_from_slice(&turned(s));
    }

    fn bounds(&mut self, (from, until): (f64, f64), to: &mut [Enclosure]) -> bool {
        let s = Enclosure::polynomial(&[0.5 * (from + until), 0.5 * (until - from)]);
        to.copy_from_slice(&turned(s));
        true
    }

    fn deviation(&mut self, _s: f64) -> f64 {
        0.0
    }
}

#[test]
fn a_step_with_more_periods_than_bounds_can_show_ends_with_these() {
    let phase = Switch {
        levels: Vec::new(),
        is_phase: true,
    };
    let switches = [smooth(&[0.9]), phase];
    let points = [0.0, 0.5, 1.0].map(turned);
    assert!(may_have_cells(
        &switches,
        points.each_ref().map(|own| &own[..])
    ));
    let (cells, examined) = cells(&switches, &mut Pulses);
    assert!(0.05 < examined && examined < 1.0, "{examined}");
    let width = (std::f64::consts::PI - 2.0 * 0.9_f64.asin()) / (300.0 * std::f64::consts::TAU);
    assert!(cells.len() > 30);
    for pulse in cells.iter().step_by(2) {
        assert!((pulse.width() - width).abs() < 1e-7, "{pulse:?}");
    }
    assert_eq!(overlooked(&switches, &mut Pulses), Some(examined));
}
