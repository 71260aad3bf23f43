//! Standard errors of the predictions of held-out flights.

use identify::{CONDITIONING_FRACTION, Coefficient, Fit, FitReport, FlightId, pseudo_inverse};
use nalgebra::{DMatrix, DVector};

/// Half width of a 95 % confidence interval, in standard errors.
pub(crate) const WIDTH_95: f64 = 1.96;

/// Standard errors of the predicted marker positions of a held-out flight.
#[derive(Clone, Debug, PartialEq)]
pub struct PredictionBand {
    /// File name of the held-out flight.
    pub file: String,
    /// `std_error[sample][marker]`: standard error along each axis of the inertial frame, m, from the covariances of the
    /// coefficients and of the initial state, without measurement noise; NaN where the marker was not measured.
    pub std_error: Vec<Vec<[f64; 3]>>,
    /// First predicted sample; the initial state is fitted to the samples before it.
    pub first: usize,
}

/// The larger of the Cramér–Rao and the cluster-robust standard error; 0 for a fixed coefficient.
pub(crate) fn std_error(coefficient: &Coefficient) -> f64 {
    let clustered = coefficient.std_error_cluster_robust.unwrap_or(0.0);
    if coefficient.fixed {
        0.0
    } else {
        coefficient.std_error.max(clustered)
    }
}

/// Covariance matrix of the estimates of the coefficients `names`, SI; entries are 0 if unknown or fixed.
pub(crate) fn covariance(report: &FitReport, names: &[&str]) -> DMatrix<f64> {
    let error = |name: &str| {
        let error = report.coefficients.get(name).map(std_error);
        error.filter(|e| e.is_finite()).unwrap_or(0.0)
    };
    DMatrix::from_fn(names.len(), names.len(), |i, j| {
        let row = report.correlations.get(names[i]);
        let correlation = row.and_then(|row| row.get(names[j])).copied();
        let correlation = correlation.filter(|c| c.is_finite()).unwrap_or(0.0);
        error(names[i]) * error(names[j]) * if i == j { 1.0 } else { correlation }
    })
}

/// Derivatives of one predicted position, a row for each axis: by the initial state, then by the common parameters.
struct Sensitivity {
    sample: usize,
    channel: usize,
    is_outlier: bool,
    rows: [DVector<f64>; 3],
}

/// `None` if the flight is excluded, or its first samples do not determine its initial state.
pub fn prediction_band(fit: &Fit, flight: FlightId) -> Option<PredictionBand> {
    let at = fit.at(flight)?;
    let (problem, observations, samples) = (at.problem, at.observations, at.samples);
    let first = ((samples as f64 * CONDITIONING_FRACTION).ceil() as usize).clamp(1, samples);
    let names: Vec<&str> = problem.globals.iter().map(|g| g.name.as_str()).collect();
    let columns = problem.global_parameters();
    let mut found: Vec<Sensitivity> = Vec::new();
    let done = at.each_residual(&columns, &mut |point| {
        let at = point.sample * observations.channels + point.channel;
        found.push(Sensitivity {
            sample: point.sample,
            channel: point.channel,
            is_outlier: observations.outlier[at],
            rows: [0, 1, 2].map(|axis| DVector::from_column_slice(&point.rows[axis])),
        });
    });
    done.ok()?;
    let locals = found.first()?.rows[0].len() - columns.len();
    let mut information = DMatrix::zeros(locals, locals);
    let mut cross = DMatrix::zeros(locals, columns.len());
    for point in found.iter().filter(|p| p.sample < first && !p.is_outlier) {
        let sigma = fit.noise().of(point.channel).sigma;
        let components = problem.channels[point.channel].components.min(sigma.len());
        for (row, sigma) in point.rows[..components].iter().zip(sigma) {
            let by_local = row.rows(0, locals);
            let weight = 1.0 / (sigma * sigma);
            information.ger(weight, &by_local, &by_local, 1.0);
            cross.ger(weight, &by_local, &row.rows(locals, columns.len()), 1.0);
        }
    }
    let of_local = pseudo_inverse(&information)?;
    // The initial state depends on the coefficients, since it is fitted with the coefficients fixed.
    let follows = -(&of_local * cross);
    let of_global = covariance(&fit.report, &names);
    // The evidence of a flight contains only positions, in the order of the channels.
    let channels = problem.channels.iter().enumerate();
    let positions = channels.filter(|(_, channel)| channel.is_position());
    let positions: Vec<usize> = positions.map(|(index, _)| index).collect();
    let mut std_error = vec![vec![[f64::NAN; 3]; positions.len()]; samples];
    for point in &found {
        let Some(marker) = positions.iter().position(|p| *p == point.channel) else {
            continue;
        };
        for (axis, row) in point.rows.iter().enumerate() {
            let by_local = row.rows(0, locals);
            let by_global = row.rows(locals, columns.len()) + follows.tr_mul(&by_local);
            let variance =
                by_local.dot(&(&of_local * by_local)) + by_global.dot(&(&of_global * &by_global));
            std_error[point.sample][marker][axis] = variance.max(0.0).sqrt();
        }
    }
    Some(PredictionBand {
        file: observations.file.clone(),
        std_error,
        first,
    })
}
