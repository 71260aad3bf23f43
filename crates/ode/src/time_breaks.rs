//! Steps at times where a right-hand side is not smooth: a step ends just before each such time, and the next begins
//! with the derivative just after it.

/// Distance from a break at which the step before it ends, and at which the derivative after it is evaluated: more than
/// the rounding errors of the time and of the break.
fn margin(time_break: f64) -> f64 {
    32.0 * f64::EPSILON * time_break.abs().max(1.0)
}

/// Time at which the last step of a segment that begins at `t` ends: just before the next of the increasing `breaks`,
/// or at `t_end`.
pub(crate) fn segment_end(breaks: &[f64], t: f64, t_end: f64) -> f64 {
    let next = breaks.partition_point(|time| time - margin(*time) <= t);
    let before = breaks.get(next).map(|time| time - margin(*time));
    before.map_or(t_end, |before| before.min(t_end))
}

/// Time at which the derivative at the beginning of a segment is evaluated: `t`, or just after a break at `t`.
pub(crate) fn just_after(breaks: &[f64], t: f64) -> f64 {
    let first = breaks.partition_point(|time| time + 2.0 * margin(*time) < t);
    match breaks.get(first) {
        Some(time) if (time - t).abs() <= 2.0 * margin(*time) => time + margin(*time),
        _ => t,
    }
}
