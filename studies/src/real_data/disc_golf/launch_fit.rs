//! Fits a launch to its measured track, with the stated launch as a prior.

use flight::parallel;
use nalgebra::{DMatrix, DVector};

use super::simulate::{Factors, Simulator};
use super::throw::{TRACK_UNCERTAINTY, Throw, UNCERTAINTY, rms_distance};

/// Prior standard deviation of each factor by which tabulated coefficients are multiplied; the prior mean is 1.
const FACTOR_UNCERTAINTY: f64 = 1.0;

/// Number of launch quantities, which are the unknowns of a fit. A fit that also estimates factors on the tabulated
/// lift, drag and pitching moment has three more unknowns.
const LAUNCH_UNKNOWNS: usize = 7;
const ALL_UNKNOWNS: usize = 10;

/// Step of the central differences by which the residuals are differentiated, in prior standard deviations. The
/// aerodynamic table is interpolated linearly; its kinks would bias one-sided differences and end the fit before its
/// minimum.
const DIFFERENCE: f64 = 0.05;

/// Maximum number of Gauss–Newton steps in the fit of the launch quantities of one throw.
const MAX_STEPS: usize = 40;

/// Number of step lengths that are tried in a Gauss–Newton step: the full step, then repeated halves of it.
const MAX_HALVINGS: usize = 6;

/// The fit ends when a step decreases the sum of squared weighted residuals by less than this value.
const MIN_DECREASE: f64 = 1e-3;

/// Result of fitting the launch quantities of a throw to its measured track.
#[derive(Clone, Debug, PartialEq)]
pub struct LaunchFit {
    /// RMS difference, per coordinate, between the measured track and the simulated path, m: for the published launch,
    /// and for the fitted launch.
    pub rms: [f64; 2],
    /// Changes of the launch quantities by the fit (fitted − published), in units of their published uncertainties.
    /// Order: speed, pitch, roll, nose, yaw, tailwind, crosswind.
    pub changes: [f64; 7],
    /// Fitted factors by which the tabulated lift, drag and pitching moment are multiplied; 1 if the factors were not
    /// fitted.
    pub factors: [f64; 3],
    /// Standard errors of the fitted factors on the tabulated lift, drag and pitching moment; 0 if the factors were not
    /// fitted.
    pub factor_errors: [f64; 3],
}

/// Fits the launch quantities of a throw to its measured track. If `with_factors` is true, factors on the tabulated
/// lift, drag and pitching moment are fitted too. `None` if the normal equations are singular.
pub(super) fn launch_fit(
    simulator: &Simulator<'_>,
    throw: &Throw,
    with_factors: bool,
) -> Option<LaunchFit> {
    let points = throw.points();
    let times: Vec<f64> = points.iter().map(|(time, _)| *time).collect();
    let count = match with_factors {
        true => ALL_UNKNOWNS,
        false => LAUNCH_UNKNOWNS,
    };
    // The unknowns are deviations from the prior means, in prior standard deviations.
    let track = |unknowns: &[f64]| {
        let launch = std::array::from_fn(|k| throw.launch[k] + UNCERTAINTY[k] * unknowns[k]);
        simulator.track(throw, &launch, &factors(unknowns), &times)
    };
    let residuals = |unknowns: &[f64]| {
        let track = track(unknowns);
        let pairs = track.iter().zip(&points);
        let distances = pairs.flat_map(|(a, (_, b))| [b[0] - a[0], b[1] - a[1]]);
        let weighted = distances.map(|d| d / TRACK_UNCERTAINTY);
        let priors = unknowns.iter().map(|unknown| -unknown);
        DVector::from_iterator(2 * points.len() + count, weighted.chain(priors))
    };
    let (unknowns, covariance) = minimised(count, residuals)?;
    let error = |k: usize| covariance[(LAUNCH_UNKNOWNS + k, LAUNCH_UNKNOWNS + k)].max(0.0);
    Some(LaunchFit {
        rms: [
            rms_distance(&track(&vec![0.0; count]), &points),
            rms_distance(&track(&unknowns), &points),
        ],
        changes: std::array::from_fn(|k| unknowns[k]),
        factors: factors(&unknowns),
        factor_errors: std::array::from_fn(|k| match with_factors {
            true => FACTOR_UNCERTAINTY * error(k).sqrt(),
            false => 0.0,
        }),
    })
}

fn factors(unknowns: &[f64]) -> Factors {
    let unknown = |k: usize| unknowns.get(LAUNCH_UNKNOWNS + k).unwrap_or(&0.0);
    std::array::from_fn(|k| 1.0 + FACTOR_UNCERTAINTY * unknown(k))
}

/// Minimises the sum of squared residuals by Gauss–Newton over `count` unknowns, starting from 0. A step that does not
/// decrease the sum is halved repeatedly; the minimisation ends if no tried step decreases the sum. Returns the
/// unknowns and their covariance; `None` if the normal equations are singular.
fn minimised(
    count: usize,
    residuals: impl Fn(&[f64]) -> DVector<f64> + Sync,
) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let mut unknowns = vec![0.0; count];
    let mut here = residuals(&unknowns);
    let mut covariance = DMatrix::identity(count, count);
    for _ in 0..MAX_STEPS {
        let columns = parallel::each(count, |k| {
            let shifted = |by: f64| {
                let mut unknowns = unknowns.clone();
                unknowns[k] += by;
                residuals(&unknowns)
            };
            (shifted(-DIFFERENCE) - shifted(DIFFERENCE)) / (2.0 * DIFFERENCE)
        });
        let jacobian = DMatrix::from_columns(&columns);
        covariance = (jacobian.transpose() * &jacobian).try_inverse()?;
        let step = &covariance * (jacobian.transpose() * &here);
        let lower = (0..MAX_HALVINGS).find_map(|halvings| {
            let fraction = 0.5_f64.powi(halvings as i32);
            let shifted = unknowns.iter().zip(step.iter());
            let next: Vec<f64> = shifted.map(|(s, d)| s + fraction * d).collect();
            let there = residuals(&next);
            (there.norm_squared() < here.norm_squared()).then_some((next, there))
        });
        let Some((next, there)) = lower else { break };
        let decrease = here.norm_squared() - there.norm_squared();
        (unknowns, here) = (next, there);
        if decrease < MIN_DECREASE {
            break;
        }
    }
    Some((unknowns, covariance))
}

#[cfg(test)]
mod tests {
    use super::super::simulate::tests::smooth_disc;
    use super::super::throw::RAD;
    use super::*;

    #[test]
    fn a_launch_is_fitted_to_the_track_of_another() {
        let (disc, model) = (smooth_disc(), crate::oracle_flights::disc());
        let simulator = Simulator::new(&model, &disc).unwrap();
        let launch = [22.0, 0.15, 0.1, 0.0, 0.1, 2.0, 0.0];
        let mut throw = Throw {
            number: 1,
            launch,
            spin: 120.0,
            height: 1.5,
            track: Vec::new(),
        };
        let times: Vec<f64> = (0..60).map(|k| f64::from(k) * 0.04).collect();
        let mut other = launch;
        other[0] += 1.2;
        other[4] += 4.0 * RAD;
        let track = simulator.track(&throw, &other, &[1.0; 3], &times);
        throw.track = times.into_iter().zip(track).collect();
        let found = launch_fit(&simulator, &throw, false).unwrap();
        assert!(found.rms[0] > 1.5 && found.rms[1] < 0.3, "{found:?}");
        assert!(
            found.changes[0] > 1.0 && found.changes[4] > 1.0,
            "{found:?}"
        );
    }
}
