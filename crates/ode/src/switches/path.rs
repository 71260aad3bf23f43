//! Path of the state over a step: the dense output as polynomials.

use crate::dense_output::DenseOutput;
use crate::method::{Method, ROWS, tsit5};
use lanes::Enclosure;

/// State over a step, not projected, as polynomials of the fraction of the step.
pub(crate) struct Path {
    t: f64,
    h: f64,
    /// Coefficients of each component of the state, in order of rising power.
    components: Vec<[f64; ROWS]>,
}

impl Path {
    pub(crate) fn of(step: &DenseOutput<'_>) -> Path {
        let weights = powers(step.method, step.h);
        let mut components = vec![[0.0; ROWS]; step.rows[0].len()];
        for (row, weight) in step.rows.iter().zip(weights) {
            for (component, value) in components.iter_mut().zip(*row) {
                for (to, power) in component.iter_mut().zip(weight) {
                    *to += power * value;
                }
            }
        }
        let (t, h) = (step.t, step.h);
        Path { t, h, components }
    }

    pub(crate) fn time(&self, s: f64) -> f64 {
        self.t + s * self.h
    }

    /// State at the fraction `s` of the step.
    pub(crate) fn state(&self, s: f64) -> impl Iterator<Item = f64> + '_ {
        let horner = move |own: &[f64; ROWS]| own.iter().rev().fold(0.0, |sum, c| sum * s + c);
        self.components.iter().map(horner)
    }

    /// Bounds of the time and of the state in a part of the step; writes the latter to `to`.
    pub(crate) fn bounds(&self, (from, until): (f64, f64), to: &mut Vec<Enclosure>) -> Enclosure {
        let (middle, half) = (0.5 * (from + until), 0.5 * (until - from));
        to.clear();
        for own in &self.components {
            to.push(Enclosure::polynomial(&about(*own, middle, half)));
        }
        Enclosure::polynomial(&[self.time(middle), half * self.h])
    }
}

/// Coefficients of a polynomial as one of u, where the argument is `middle + half * u`.
fn about(mut polynomial: [f64; ROWS], middle: f64, half: f64) -> [f64; ROWS] {
    for first in 0..ROWS - 1 {
        for k in (first..ROWS - 1).rev() {
            polynomial[k] += middle * polynomial[k + 1];
        }
    }
    let mut scale = 1.0;
    for coefficient in &mut polynomial {
        *coefficient *= scale;
        scale *= half;
    }
    polynomial
}

/// Weights of the dense output, see [`Method::weights`], by their coefficients in order of rising power.
fn powers(method: Method, h: f64) -> [[f64; ROWS]; ROWS] {
    let mut weights = [[0.0; ROWS]; ROWS];
    weights[0][0] = 1.0;
    match method {
        Method::Tsit5 => {
            for (weight, powers) in weights[1..].iter_mut().zip(tsit5::INTERPOLANT) {
                for (to, power) in weight[1..].iter_mut().zip(powers) {
                    *to = h * power;
                }
            }
        }
        Method::Dop853 => {
            for k in 1..ROWS {
                let before = weights[k - 1];
                weights[k][1..].copy_from_slice(&before[..ROWS - 1]);
                // Each second factor is 1 - s.
                if k % 2 == 0 {
                    weights[k] = std::array::from_fn(|power| before[power] - weights[k][power]);
                }
            }
        }
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_the_dense_output() {
        let rows: [[f64; 1]; ROWS] = std::array::from_fn(|k| [(1.7 * k as f64 + 0.3).sin()]);
        for method in [Method::Tsit5, Method::Dop853] {
            let step = DenseOutput {
                method,
                t: 2.0,
                h: 0.5,
                rows: rows.each_ref().map(|row| &row[..]),
                projection: None,
            };
            let path = Path::of(&step);
            let mut bounds = Vec::new();
            let time = path.bounds((0.4, 0.6), &mut bounds).range();
            assert!((time[0] - 2.2).abs() < 1e-15 && (time[1] - 2.3).abs() < 1e-15);
            let [low, high] = bounds[0].range();
            for k in 0..=10 {
                let s = f64::from(k) / 10.0;
                let mut expected = [0.0];
                step.state(s, &mut expected);
                let found = path.state(s).next().expect("one component");
                assert!((found - expected[0]).abs() < 1e-13, "{method:?} {s}");
                let is_bounded = (low..=high).contains(&found);
                assert!(is_bounded || !(4..=6).contains(&k), "{method:?} {s}");
            }
            assert!(high - low < 1.0, "{method:?}");
        }
    }
}
