//! Event location in one lane: where in a step the height falls to 0, and where the height has its maximum.

use crate::event::{HERMITE_MARGIN, cubic_minimum, falling_zeros, location_width};
use crate::method::{Method, ROWS};
use crate::root::first_past_root;

/// Bracket width to which an apex is located, as a fraction of the step; the relative error of the apex height is of
/// the order of the square of this fraction.
const APEX_WIDTH: f64 = 1e-8;

const NEWTON_STEPS: u32 = 6;

/// Data of the cubic Hermite interpolant of the height over a step: the height at the start and the end of the step,
/// and the time derivative of the height at both points, multiplied by the step size.
#[derive(Clone, Copy, Default)]
pub(crate) struct HeightEnds {
    pub start: f64,
    pub end: f64,
    pub start_slope: f64,
    pub end_slope: f64,
}

impl HeightEnds {
    #[inline(always)]
    pub(crate) fn may_land(&self) -> bool {
        let (a, b) = (self.start, self.end);
        if a > 0.0 && (b <= 0.0 || self.is_monotone()) {
            return b <= 0.0;
        }
        self.dips()
    }

    /// Whether the cubic interpolant of the height comes to 0, but for its difference from the dense output.
    #[inline(never)]
    fn dips(&self) -> bool {
        let ends = (self.start, self.end, self.start_slope, self.end_slope);
        cubic_minimum(ends) <= HERMITE_MARGIN * self.chord_distance()
    }

    /// Bound of the distance of the cubic from its chord: (|slopes| + |change of height|) / 4.
    #[inline(always)]
    fn chord_distance(&self) -> f64 {
        let slopes = self.start_slope.abs() + self.end_slope.abs();
        0.25 * (slopes + (self.end - self.start).abs())
    }

    /// Whether the cubic may reach 0 within the step, by a cheaper bound than [`may_land`](Self::may_land).
    #[inline(always)]
    pub(crate) fn is_near_ground(&self) -> bool {
        self.start.min(self.end) <= self.chord_distance()
    }

    /// Whether the cubic interpolant of the height is monotone within the step, by the sufficient condition on its
    /// slopes of Fritsch & Carlson, SIAM J. Numer. Anal. 17 (1980).
    #[inline(always)]
    fn is_monotone(&self) -> bool {
        let steepest = 3.0 * (self.end - self.start);
        let (least, greatest) = (steepest.min(0.0), steepest.max(0.0));
        let (first, last) = (self.start_slope, self.end_slope);
        (least <= first) && (first <= greatest) && (least <= last) && (last <= greatest)
    }

    /// Whether the cubic falls monotonically from above 0 to below 0, so that it has exactly one zero.
    fn falls_once(&self) -> bool {
        self.start > 0.0 && self.end < 0.0 && self.is_monotone()
    }

    #[inline(always)]
    pub(crate) fn has_peak(&self) -> bool {
        self.start_slope > 0.0 && self.end_slope <= 0.0
    }
}

/// Dense output of the height of one lane over a step, as nested products: terms[0] + f₀ (terms[1] + f₁ (terms[2] +
/// …)), where f₀ = f₂ = … = s is the fraction of the step, and f₁ = f₃ = … is s for Tsit5 and 1 - s for DOP853.
pub(crate) struct HeightStep {
    pub method: Method,
    pub t: f64,
    pub h: f64,
    /// Coefficients of the nested products: for Tsit5 the coefficients of the powers of the fraction s of the step, for
    /// DOP853 the height components of the dense-output rows.
    pub terms: [f64; ROWS],
}

impl HeightStep {
    /// Returns three values for the evaluation of the dense output, whose nested products are described at
    /// [`HeightStep`]: the degree of the polynomial in the fraction `s` of the step; the factor at odd levels of the
    /// nested products (`s` for Tsit5, `1 - s` for DOP853); and the derivative of that factor with respect to `s`.
    #[inline(always)]
    fn factors(&self, s: f64) -> (usize, f64, f64) {
        match self.method {
            Method::Tsit5 => (4, s, 1.0),
            Method::Dop853 => (7, 1.0 - s, -1.0),
        }
    }

    #[inline(always)]
    pub(crate) fn height(&self, s: f64) -> f64 {
        let (degree, odd, _) = self.factors(s);
        let mut height = self.terms[degree];
        for k in (0..degree).rev() {
            height = if k % 2 == 0 { s } else { odd } * height + self.terms[k];
        }
        height
    }

    #[inline(always)]
    fn slope(&self, s: f64) -> f64 {
        let terms = &self.terms;
        if self.method == Method::Tsit5 {
            return terms[1] + s * (2.0 * terms[2] + s * (3.0 * terms[3] + s * 4.0 * terms[4]));
        }
        let (degree, odd, odd_by_s) = self.factors(s);
        let (mut height, mut slope) = (terms[degree], 0.0);
        for k in (0..degree).rev() {
            let (factor, by_s) = if k % 2 == 0 {
                (s, 1.0)
            } else {
                (odd, odd_by_s)
            };
            slope = factor * slope + by_s * height;
            height = factor * height + terms[k];
        }
        slope
    }

    /// Fraction of the step at which the height first falls to 0, or `None` if the height does not fall to 0.
    pub(crate) fn landing(&self, ends: &HeightEnds, found: &mut Vec<f64>) -> Option<f64> {
        let height = |s: f64| self.height(s);
        if ends.falls_once() {
            let (bracket, width) = ((ends.start, ends.end), location_width(self.t, self.h));
            let found = self.newton(bracket, width);
            return Some(
                found.unwrap_or_else(|| first_past_root(height, (0.0, 1.0), bracket, width)),
            );
        }
        found.clear();
        falling_zeros((self.t, self.h), true, height, found);
        found.first().copied()
    }

    /// Locates the zero of the height, `first` and `last` at the ends of the step, by Newton's method from the chord's.
    fn newton(&self, (first, last): (f64, f64), width: f64) -> Option<f64> {
        let mut s = first / (first - last);
        for _ in 0..NEWTON_STEPS {
            let step = self.height(s) / self.slope(s);
            s -= step;
            if step.abs() <= 0.25 * width {
                break;
            }
        }
        let past = s + 0.5 * width;
        let is_past = past <= 1.0 && self.height(past) <= 0.0;
        (is_past && self.height(past - width) > 0.0).then_some(past)
    }

    /// Fraction of the step at which the height, which first rises and then falls, has its maximum.
    pub(crate) fn peak(&self) -> f64 {
        let slope = |s: f64| self.slope(s);
        let (first, last) = (slope(0.0), slope(1.0));
        if !(first > 0.0 && last <= 0.0) {
            return if first > 0.0 { 1.0 } else { 0.0 };
        }
        first_past_root(slope, (0.0, 1.0), (first, last), APEX_WIDTH)
    }
}
