//! Rates of the states that a claim implies: the rates with which the claimed quantities satisfy the laws of motion.
//! The laws are linear in the rates. Since a body has more equations than some models have states, they are solved by
//! least squares.

use crate::claimed::{BalanceLaw, ClaimedBody, moving};
use crate::point::Point;
use crate::scalar::ErrorBound;
use crate::tree::Tree;
use model_spec::model::Model;
use nalgebra::{DMatrix, DVector};
use num_traits::{One, Zero};

/// Minimum ratio of a singular value to the greatest one for the singular value to count as nonzero. The singular
/// values are those of the scaled linear system of the laws of motion for the rates of the states.
const RANK: f64 = 1e-10;
/// Bound on the components of an undetermined combination of state rates (a singular vector with singular value 0). A
/// state with a component of greater absolute value counts as undetermined, even if rounding causes the component.
const FREE: f64 = 1e-12;
/// Residual above which a law of motion counts as unsatisfied, relative to the sum of the magnitudes of its terms.
const RESIDUAL: f64 = 1e-10;

/// Rates of a model's states at one point, as implied by the laws of motion of the claimed body.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimedRates {
    /// Derivative of each state by true, not recorded time; `None` if the laws do not determine it.
    pub rates: Vec<Option<ErrorBound>>,
    /// Laws of motion that no rates of the states satisfy. Each comes with its residual, divided by the sum of the
    /// absolute values of the law's terms; of the components of a law, the greatest ratio counts.
    pub unsatisfied: Vec<(BalanceLaw, f64)>,
    /// Whether `rates` satisfy every component of the laws of motion in which the rate of a state occurs. If false,
    /// some of these components contradict each other, and `rates` satisfy them in the least-squares sense only.
    pub solves_the_others: bool,
}

/// Solves the laws of motion of the body that a model claims to describe for the derivatives of the model's states with
/// respect to true time; `time_rate` is the number of seconds of recorded time per second of true time. `None` if the
/// model claims no body or a value is not finite.
pub fn claimed_rates(
    model: &Model,
    point: &Point<ErrorBound>,
    time_rate: ErrorBound,
) -> Option<ClaimedRates> {
    let system = System::of(model, point, time_rate)?;
    system.solved()
}

/// The laws of motion as a linear system for the rates of the states: `a` · rates = `b`, one row per component of a
/// law; `laws` contains the law of each row. Rows of zeros are appended until there are as many rows as states.
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
        // At least as many rows as columns, so that the singular vectors include the free directions.
        while system.a.len() < count {
            system.a.push(vec![ErrorBound::zero(); count]);
            system.b.push(ErrorBound::zero());
            system.laws.push(BalanceLaw::Position);
        }
        let all = system.a.iter().flatten().chain(&system.b);
        let mut finite = all.map(|v| v.magnitude.is_finite());
        finite.all(|f| f).then_some(system)
    }

    fn solved(&self) -> Option<ClaimedRates> {
        let (rows, columns) = (self.a.len(), self.a[0].len());
        let matrix = DMatrix::from_fn(rows, columns, |i, j| self.a[i][j].value);
        let right = DVector::from_fn(rows, |i, _| self.b[i].value);
        // Rows and columns are scaled to size 1, so that the rank does not depend on units. The sizes are those of the
        // magnitudes of the terms, so that rounding errors of cancelling terms stay small.
        let size = |norm: f64| if norm > 0.0 { 1.0 / norm } else { 1.0 };
        let sizes = DMatrix::from_fn(rows, columns, |i, j| self.a[i][j].magnitude);
        let row_scale: Vec<f64> = sizes.row_iter().map(|r| size(r.norm())).collect();
        let scaled_by_row =
            |of: &DMatrix<f64>| DMatrix::from_fn(rows, columns, |i, j| of[(i, j)] * row_scale[i]);
        let sizes = scaled_by_row(&sizes);
        let column_scale: Vec<f64> = sizes.column_iter().map(|c| size(c.norm())).collect();
        let mut scaled = scaled_by_row(&matrix);
        for (j, scale) in column_scale.iter().enumerate() {
            scaled.column_mut(j).scale_mut(*scale);
        }
        let alone: Vec<bool> = scaled.row_iter().map(|r| r.norm() <= RANK).collect();
        let svd = scaled.svd(true, true);
        let tolerance = RANK * svd.singular_values.max();
        let free = free_states(&svd, tolerance, columns);
        let inverse = svd.pseudo_inverse(tolerance).ok()?;
        let inverse = DMatrix::from_fn(columns, rows, |j, i| {
            column_scale[j] * inverse[(j, i)] * row_scale[i]
        });
        let mut rates = &inverse * &right;
        rates += &inverse * (&right - &matrix * &rates);
        let residual = &right - &matrix * &rates;
        let terms = self.terms(rates.iter().map(|rate| rate.abs()));
        let magnitudes: Vec<f64> = (0..columns)
            .map(|j| {
                let of_terms = (0..rows).map(|i| inverse[(j, i)].abs() * terms[i]);
                of_terms.sum::<f64>().max(rates[j].abs())
            })
            .collect();
        // A rate that vanishes is known to within the rounding of the terms that sum to it.
        let rounded = self.terms(magnitudes.iter().copied());
        let mut unsatisfied: Vec<(BalanceLaw, f64)> = Vec::new();
        let mut solves_the_others = true;
        for i in 0..rows {
            if residual[i].abs() <= RESIDUAL * rounded[i] {
                continue;
            }
            let error = residual[i].abs() / terms[i].max(f64::MIN_POSITIVE);
            solves_the_others &= alone[i];
            match unsatisfied.iter_mut().find(|(law, _)| *law == self.laws[i]) {
                Some((_, worst)) => *worst = worst.max(error),
                None => unsatisfied.push((self.laws[i], error)),
            }
        }
        let bounded = { rates.iter() }.zip(magnitudes).zip(free);
        let bounded = bounded
            .map(|((&value, magnitude), free)| (!free).then_some(ErrorBound { value, magnitude }));
        Some(ClaimedRates {
            rates: bounded.collect(),
            unsatisfied,
            solves_the_others,
        })
    }

    /// Sum of the absolute values of the terms in each row of the linear system of the laws of motion for the rates of
    /// the states; `rates` are bounds on the absolute values of these rates.
    fn terms(&self, rates: impl Iterator<Item = f64> + Clone) -> Vec<f64> {
        let of_row = |(a, b): (&Vec<ErrorBound>, &ErrorBound)| {
            let of_rates = a.iter().zip(rates.clone());
            b.magnitude + of_rates.map(|(a, rate)| a.magnitude * rate).sum::<f64>()
        };
        self.a.iter().zip(&self.b).map(of_row).collect()
    }
}

/// Whether each state occurs in a combination of rates that the laws of motion leave undetermined (a singular vector
/// whose singular value is at most `tolerance`). The system must have at least as many rows as columns.
fn free_states(
    svd: &nalgebra::SVD<f64, nalgebra::Dyn, nalgebra::Dyn>,
    tolerance: f64,
    columns: usize,
) -> Vec<bool> {
    let Some(v_t) = &svd.v_t else {
        return vec![true; columns];
    };
    let values = svd.singular_values.iter().enumerate();
    let free: Vec<usize> = values
        .filter(|(_, s)| **s <= tolerance)
        .map(|(k, _)| k)
        .collect();
    (0..columns)
        .map(|j| free.iter().any(|&k| v_t[(k, j)].abs() > FREE))
        .collect()
}
