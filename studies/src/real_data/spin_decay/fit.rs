//! Maximum-likelihood fit of a form of the spin's decay, under AR(1) noise.

use nalgebra::{DMatrix, DVector};

use super::form::Form;
use super::record::Record;

/// Number of values of the noise's lag-1 correlation, evenly spaced in [0, 1), for which a fit is tried.
const CORRELATIONS: usize = 400;

/// Number of Gauss–Newton steps in each fit of a torque law.
const STEPS: usize = 12;

/// Fit of one torque law to a record of a disc's spin, with first-order autoregressive (AR(1)) noise.
#[derive(Clone, Debug, PartialEq)]
pub struct DecayFit {
    /// Estimates of the torque law's unknowns: spin at release (rad/s), fraction of the spin lost per second at
    /// release, and, for some laws, a third unknown (exponent of the spin, or rate at which a factor falls).
    pub unknowns: Vec<f64>,
    /// Standard errors of the estimated unknowns of the torque law, in the order of `unknowns`.
    pub std_errors: Vec<f64>,
    /// RMS residual (measured − fitted spin), rad/s.
    pub rms: f64,
    /// Lag-1 correlation of the noise, estimated together with the torque law's unknowns.
    pub ar1: f64,
    /// Akaike information criterion of the fit; lower is better.
    pub aic: f64,
}

/// Fits one torque law to a spin record for each lag-1 correlation of the noise on a grid, and returns the fit with the
/// minimum AIC; `None` if the record does not determine the unknowns.
pub(super) fn fit(form: Form, record: &Record) -> Option<DecayFit> {
    let correlations = (0..CORRELATIONS).map(|step| step as f64 / CORRELATIONS as f64);
    let fits = correlations.filter_map(|ar1| fit_with(form, record, ar1));
    fits.min_by(|a, b| a.aic.total_cmp(&b.aic))
}

/// Fits one torque law to a spin record with a given lag-1 correlation of the noise; `None` if the record does not
/// determine the unknowns.
fn fit_with(form: Form, record: &Record, ar1: f64) -> Option<DecayFit> {
    let count = record.times.len();
    let first = (1.0 - ar1 * ar1).sqrt();
    let whitened = |residuals: &[f64]| {
        DVector::from_fn(count, |k, _| match k {
            0 => first * residuals[0],
            _ => residuals[k] - ar1 * residuals[k - 1],
        })
    };
    let residuals = |unknowns: &DVector<f64>| -> Vec<f64> {
        let samples = record.times.iter().zip(&record.rates);
        let each = samples.map(|(time, rate)| rate - form.at(unknowns, *time));
        each.collect()
    };
    let mut unknowns = form.initial_guess(record.rates.first().copied().unwrap_or(1.0));
    let mut normal = DMatrix::zeros(unknowns.len(), unknowns.len());
    for _ in 0..STEPS {
        let here = whitened(&residuals(&unknowns));
        let columns: Vec<DVector<f64>> = (0..unknowns.len())
            .map(|k| {
                let mut shifted = unknowns.clone();
                let size = 1e-6 * unknowns[k].abs().max(1e-3);
                shifted[k] += size;
                (&here - whitened(&residuals(&shifted))) / size
            })
            .collect();
        let jacobian = DMatrix::from_columns(&columns);
        normal = jacobian.transpose() * &jacobian;
        let factor = normal.clone().cholesky()?;
        unknowns += factor.solve(&(jacobian.transpose() * here));
    }
    let residuals = residuals(&unknowns);
    let squares = whitened(&residuals).norm_squared();
    let n = count as f64;
    let dof = n - unknowns.len() as f64;
    let covariance = normal.try_inverse()? * (squares / dof);
    let deviance = n * (squares / n).ln() - 2.0 * first.ln();
    // The noise's standard deviation and correlation count as parameters too.
    let aic = deviance + 2.0 * (unknowns.len() as f64 + 2.0);
    aic.is_finite().then(|| DecayFit {
        std_errors: covariance.diagonal().iter().map(|v| v.sqrt()).collect(),
        unknowns: unknowns.iter().copied().collect(),
        rms: (residuals.iter().map(|r| r * r).sum::<f64>() / n).sqrt(),
        ar1,
        aic,
    })
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_chacha::ChaCha12Rng;
    use rand_distr::{Distribution, StandardNormal};

    use super::*;

    /// Simulates a measured spin in free flight with AR(1) noise. `torque` returns the angular acceleration (rad/s²) at
    /// a given spin (rad/s) and time (s).
    fn made(torque: impl Fn(f64, f64) -> f64) -> Record {
        let mut random = ChaCha12Rng::seed_from_u64(5);
        let (mut spin, mut noise) = (60.0, 0.0);
        let mut record = Record::default();
        for k in 0..225 {
            let time = f64::from(k) * 0.01;
            let fresh: f64 = StandardNormal.sample(&mut random);
            noise = 0.5 * noise + 0.008 * fresh;
            record.times.push(time);
            record.rates.push(spin + noise);
            for step in 0..100 {
                spin += 1e-4 * torque(spin, time + f64::from(step) * 1e-4);
            }
        }
        record
    }

    #[test]
    fn the_form_that_made_a_record_has_the_least_aic_and_its_loss_is_found() {
        type Torque = fn(f64, f64) -> f64;
        let torques: [(Form, Torque); 4] = [
            (Form::Constant, |_, _| -2.4),
            (Form::Linear, |spin, _| -0.04 * spin),
            (Form::Quadratic, |spin, _| -0.04 / 60.0 * spin * spin),
            (Form::Falling, |spin, time| {
                -0.04 * (1.0 - 0.2 * time) * spin
            }),
        ];
        for (form, torque) in torques {
            let record = made(torque);
            let of = |form| fit(form, &record).unwrap();
            let found = of(form);
            let pull = (found.unknowns[1] - 0.04) / found.std_errors[1];
            assert!(pull.abs() < 3.5, "{form:?} {found:?}");
            assert!((0.3..0.7).contains(&found.ar1), "{found:?}");
            for other in [Form::Constant, Form::Linear, Form::Quadratic] {
                assert!(
                    other == form || of(other).aic > found.aic + 10.0,
                    "{form:?} {other:?}"
                );
            }
        }
    }
}
