//! Rates of the states that a claim implies: those with which the claimed quantities obey the laws of motion. The laws
//! are linear in the rates; as a body has more equations than some models have states, they are solved by least squares.

use crate::claimed::{BalanceLaw, ClaimedBody, moving};
use crate::point::Point;
use crate::scalar::ErrorBound;
use crate::tree::Tree;
use model_spec::model::Model;
use nalgebra::{DMatrix, DVector};
use num_traits::{One, Zero};

/// Smallest singular value of the scaled system that counts, relative to the largest.
const RANK: f64 = 1e-10;
/// Largest part of a state in a direction that the laws leave free.
const FREE: f64 = 1e-6;
/// Smallest residual of a law that no rates satisfy, relative to the sum of the magnitudes of its terms.
const RESIDUAL: f64 = 1e-10;

/// Rates of the states that the laws of the claimed body imply, at one point.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimedRates {
    /// Rate of each state with respect to the time of flight; `None` if the laws do not determine it.
    pub rates: Vec<Option<ErrorBound>>,
    /// Laws that no rates satisfy, with the residual relative to the sum of the magnitudes of the terms.
    pub unsatisfied: Vec<(BalanceLaw, f64)>,
    /// Whether each unsatisfied law is one in which no rate appears, so that the rates solve all others.
    pub solves_the_others: bool,
}

/// Solves the laws of the claimed body for the rates of the states; `time_rate` is the rate of the measuring clock
/// against the time of flight. `None` if the model claims no body, or where a value is not finite.
pub fn claimed_rates(
    model: &Model,
    point: &Point<ErrorBound>,
    time_rate: ErrorBound,
) -> Option<ClaimedRates> {
    let system = System::of(model, point, time_rate)?;
    system.solved()
}

/// The laws as rows of a linear system: `a` times rates = `b`.
struct System {
    a: Vec<Vec<ErrorBound>>,
    b: Vec<ErrorBound>,
    laws: Vec<BalanceLaw>,
}

impl System {
    fn of(model: &Model, point: &Point<ErrorBound>, time_rate: ErrorBound) -> Option<Self> {
        let count = model.states.len();
        let balances = |rates: &[ErrorBound], time_rate| {
            let point = moving(point, rates, time_rate);
            Some(ClaimedBody::of(&Tree::new(model, &point))?.balances())
        };
        let still = vec![ErrorBound::zero(); count];
        let mut system = Self {
            a: Vec::new(),
            b: Vec::new(),
            laws: Vec::new(),
        };
        for balance in balances(&still, time_rate)? {
            for (change, cause) in balance.change.iter().zip(balance.cause.iter()) {
                system.b.push(*cause - *change);
                system.a.push(vec![ErrorBound::zero(); count]);
                system.laws.push(balance.law);
            }
        }
        for state in 0..count {
            let mut alone = still.clone();
            alone[state] = ErrorBound::one();
            let columns = balances(&alone, ErrorBound::zero())?;
            let changes = columns.iter().flat_map(|b| b.change.iter());
            for (row, change) in system.a.iter_mut().zip(changes) {
                row[state] = *change;
            }
        }
        let all = system.a.iter().flatten().chain(&system.b);
        let mut finite = all.map(|v| v.magnitude.is_finite());
        finite.all(|f| f).then_some(system)
    }

    fn solved(&self) -> Option<ClaimedRates> {
        let (rows, columns) = (self.a.len(), self.a[0].len());
        let matrix = DMatrix::from_fn(rows, columns, |i, j| self.a[i][j].value);
        let right = DVector::from_fn(rows, |i, _| self.b[i].value);
        // Rows and columns of size 1, so that the rank does not depend on units.
        let size = |norm: f64| if norm > 0.0 { 1.0 / norm } else { 1.0 };
        let row_scale: Vec<f64> = matrix.row_iter().map(|r| size(r.norm())).collect();
        let mut scaled = DMatrix::from_fn(rows, columns, |i, j| matrix[(i, j)] * row_scale[i]);
        let column_scale: Vec<f64> = scaled.column_iter().map(|c| size(c.norm())).collect();
        for (j, scale) in column_scale.iter().enumerate() {
            scaled.column_mut(j).scale_mut(*scale);
        }
        let svd = scaled.clone().svd(true, true);
        let tolerance = RANK * svd.singular_values.max();
        let free = free_states(&svd, tolerance, columns);
        let inverse = svd.pseudo_inverse(tolerance).ok()?;
        let inverse = DMatrix::from_fn(columns, rows, |j, i| {
            column_scale[j] * inverse[(j, i)] * row_scale[i]
        });
        let mut rates = &inverse * &right;
        rates += &inverse * (&right - &matrix * &rates);
        let residual = &right - &matrix * &rates;
        // Magnitude of the terms of each row, with the rates as found.
        let terms: Vec<f64> = (0..rows)
            .map(|i| {
                let of_rates = (0..columns).map(|j| self.a[i][j].magnitude * rates[j].abs());
                self.b[i].magnitude + of_rates.sum::<f64>()
            })
            .collect();
        let mut unsatisfied: Vec<(BalanceLaw, f64)> = Vec::new();
        let mut solves_the_others = true;
        for i in 0..rows {
            let error = residual[i].abs() / terms[i].max(f64::MIN_POSITIVE);
            if error <= RESIDUAL {
                continue;
            }
            solves_the_others &= matrix.row(i).norm() == 0.0;
            match unsatisfied.iter_mut().find(|(law, _)| *law == self.laws[i]) {
                Some((_, worst)) => *worst = worst.max(error),
                None => unsatisfied.push((self.laws[i], error)),
            }
        }
        let bounded = (0..columns).map(|j| {
            let of_terms = (0..rows).map(|i| inverse[(j, i)].abs() * terms[i]);
            let magnitude = of_terms.sum::<f64>().max(rates[j].abs());
            (!free[j]).then(|| ErrorBound {
                value: rates[j],
                magnitude,
            })
        });
        Some(ClaimedRates {
            rates: bounded.collect(),
            unsatisfied,
            solves_the_others,
        })
    }
}

/// Whether each state has a part in a direction that the laws leave free.
fn free_states(
    svd: &nalgebra::SVD<f64, nalgebra::Dyn, nalgebra::Dyn>,
    tolerance: f64,
    columns: usize,
) -> Vec<bool> {
    let Some(v_t) = &svd.v_t else {
        return vec![true; columns];
    };
    // What the determined directions leave of each state's unit vector.
    (0..columns)
        .map(|j| {
            let values = svd.singular_values.iter().enumerate();
            let held: f64 = values
                .filter(|(_, s)| **s > tolerance)
                .map(|(k, _)| v_t[(k, j)].powi(2))
                .sum();
            held < 1.0 - FREE
        })
        .collect()
}
