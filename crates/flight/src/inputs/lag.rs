//! First-order lag of an input over time, τ dL/dt + L = u: as u does not depend on the state of the model, L is a
//! function of the time and of τ, exact on each piece of u, for any τ down to 0.

use codegen::table::PiecewiseCubic;

/// Number of time constants after which nothing is left of the past: exp(-40) is below the rounding of numbers.
const MEMORY: f64 = 40.0;

/// Time constant below which an input acts at once, s.
const LEAST: f64 = 1e-9;

/// Lagged input, and its derivative by the time constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lagged {
    pub value: f64,
    /// ∂L/∂τ, per s.
    pub by_tau: f64,
}

impl Lagged {
    /// Response to the cubic `u` at the time `s` after the beginning of its piece, where the response was `self`.
    fn after(self, u: &[f64; 4], s: f64, tau: f64) -> Lagged {
        let now = steady(u, s, tau);
        let age = s / tau;
        if age > MEMORY {
            return now;
        }
        let then = steady(u, 0.0, tau);
        let (left, decay) = (self.value - then.value, (-age).exp());
        Lagged {
            value: now.value + left * decay,
            by_tau: now.by_tau + (self.by_tau - then.by_tau + left * age / tau) * decay,
        }
    }
}

/// Response that a cubic has if it lasts forever: u - τ u' + τ² u'' - τ³ u'''.
fn steady(&[a, b, c, d]: &[f64; 4], s: f64, tau: f64) -> Lagged {
    let (u, first) = (
        a + s * (b + s * (c + s * d)),
        b + s * (2.0 * c + s * 3.0 * d),
    );
    let (second, third) = (2.0 * c + 6.0 * d * s, 6.0 * d);
    Lagged {
        value: u - tau * (first - tau * (second - tau * third)),
        by_tau: -first + tau * (2.0 * second - tau * 3.0 * third),
    }
}

/// Whether an input with this time constant, s, acts at once.
pub(super) fn is_none(tau: f64) -> bool {
    tau.is_nan() || tau < LEAST
}

/// Responses at all knots of `u`, which was constant before the first one.
pub(super) fn at_knots(u: &PiecewiseCubic, tau: f64) -> Vec<Lagged> {
    let pieces = u.knots().windows(2).zip(&u.cubics()[1..]);
    let mut now = rest(u, 0);
    let later = pieces.map(|(ends, cubic)| {
        now = now.after(cubic, ends[1] - ends[0], tau);
        now
    });
    [rest(u, 0)].into_iter().chain(later).collect()
}

/// Response to `u` at time `t`, s, for a time constant that is not [`is_none`]; `known` at all knots, or empty.
pub(super) fn at(u: &PiecewiseCubic, t: f64, tau: f64, known: &[Lagged]) -> Lagged {
    let knots = u.knots();
    let below = |t: f64| knots.partition_point(|&knot| knot <= t);
    let Some(piece) = below(t).checked_sub(1) else {
        return rest(u, 0);
    };
    let begin = match known.get(piece) {
        Some(begin) => *begin,
        None => {
            let first = below(t - MEMORY * tau).saturating_sub(1);
            (first..piece).fold(rest(u, first), |now, k| {
                now.after(&u.cubics()[k + 1], knots[k + 1] - knots[k], tau)
            })
        }
    };
    begin.after(&u.cubics()[piece + 1], t - knots[piece], tau)
}

/// Response at a knot to an input that was constant before.
fn rest(u: &PiecewiseCubic, knot: usize) -> Lagged {
    Lagged {
        value: u.cubics()[knot + 1][0],
        by_tau: 0.0,
    }
}
