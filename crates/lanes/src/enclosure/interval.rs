//! Intervals of real numbers: least and greatest value.

pub(super) type Interval = [f64; 2];

pub(super) const UNBOUNDED: Interval = [f64::NEG_INFINITY, f64::INFINITY];

pub(super) fn sum(a: Interval, b: Interval) -> Interval {
    known([a[0] + b[0], a[1] + b[1]])
}

/// Products of all numbers of two intervals; 0 times an unbounded number is 0.
pub(super) fn product(a: Interval, b: Interval) -> Interval {
    let of = |x: f64, y: f64| match x == 0.0 || y == 0.0 {
        true => 0.0,
        false => x * y,
    };
    let [p, q, r, s] = [
        of(a[0], b[0]),
        of(a[0], b[1]),
        of(a[1], b[0]),
        of(a[1], b[1]),
    ];
    if [p, q, r, s].iter().any(|value| value.is_nan()) {
        return UNBOUNDED;
    }
    [p.min(q).min(r.min(s)), p.max(q).max(r.max(s))]
}

pub(super) fn hull(a: Interval, b: Interval) -> Interval {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// Greatest magnitude.
pub(super) fn reach([low, high]: Interval) -> f64 {
    low.abs().max(high.abs())
}

/// The interval, or all numbers where an end is not a number.
fn known(of: Interval) -> Interval {
    match of[0] <= of[1] {
        true => of,
        false => UNBOUNDED,
    }
}
