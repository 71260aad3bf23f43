//! Steps at times where a right-hand side is not smooth: a step ends just before each such time, and the next begins
//! with the derivative just after it.

/// Distance from a break at which the step before it ends, and at which the derivative after it is evaluated: more than
/// the rounding errors of the time and of the break.
fn margin(time_break: f64) -> f64 {
    32.0 * f64::EPSILON * time_break.abs().max(1.0)
}

/// Steps that each break allows beyond the maximum number of steps.
const STEPS_AT_BREAK: usize = 4;

/// Number of further steps that `breaks` allow.
pub(crate) fn steps_at(breaks: &[f64]) -> usize {
    STEPS_AT_BREAK * breaks.len()
}

/// End of the last step of a segment from `t`: just before the next of the increasing `breaks`, or `t_end`.
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

/// Fraction of the time that remains until the end of a segment at the start of a step. A step that would leave less
/// than this fraction is extended to the end, which avoids a tiny last step.
const FINAL_STEP_SLACK: f64 = 1e-10;

/// Size and end time of a step.
#[derive(Clone, Copy)]
pub(crate) struct StepEnd {
    pub h: f64,
    pub t: f64,
    /// Whether the step ends at the final time of the integration.
    pub is_last: bool,
}

impl StepEnd {
    /// End of a step of at most the size `h` from the time `t` in a segment; `t_end` is the final time.
    #[inline(always)]
    pub(crate) fn new(h: f64, t: f64, segment_end: f64, t_end: f64) -> StepEnd {
        let remaining = segment_end - t;
        if h >= remaining * (1.0 - FINAL_STEP_SLACK) {
            StepEnd {
                h: remaining,
                t: segment_end,
                is_last: segment_end == t_end,
            }
        } else {
            StepEnd {
                h,
                t: t + h,
                is_last: false,
            }
        }
    }
}
