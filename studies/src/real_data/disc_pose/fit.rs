//! Fits the throws of a golf disc: all together, each alone, and all but one.

use std::path::Path;

use dataset::{Dataset, Flight, Sensor, SensorKind};
use identify::{Fit, FitError, FitOptions, FitReport, FlightReport, Prior};
use model_spec::model::Model;
use serde::Serialize;

use super::read::Poses;
use crate::error::StudyError;

/// Assumed constants of the golf disc, SI. The moments of inertia were not stated by the source; the data determine
/// only their ratio.
pub(super) const BODY: [(&str, f64); 7] = [
    ("m", 0.175),
    ("d", 0.212),
    ("A", 0.0353),
    ("I_a", 0.00113),
    ("I_d", 0.00063),
    ("rho", 1.2),
    ("g", 9.81),
];

/// Assumed moment of inertia about a diameter, kg·m², by which the fitted I_a is divided to obtain the ratio I_a/I_d.
const I_D: f64 = 0.00063;

/// Priors of the aerodynamic coefficients: name, mean, standard deviation, SI.
pub(super) const PRIORS: [(&str, f64, f64); 8] = [
    ("C_L0", 0.2, 0.2),
    ("C_La", 2.4, 0.7),
    ("C_D0", 0.1, 0.05),
    ("C_Da", 1.5, 0.7),
    ("C_Ma", -0.3, 0.3),
    ("C_Mq", 0.0, 0.01),
    ("C_Rr", 0.0, 0.001),
    ("C_Nr", 0.0, 1e-4),
];

/// Ratio I_a/I_d of the moments of inertia about the disc's axis and about a diameter, with standard errors.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ratio {
    /// Estimate of the ratio I_a/I_d of the axial to the diametral moment of inertia.
    pub value: f64,
    /// Standard error due to the measurement noise of the poses.
    pub std_error: f64,
    /// Cluster-robust standard error, from the differences between throws; `None` for one throw.
    pub clustered: Option<f64>,
}

/// Results for one throw, from the fit of all throws and from a fit of this throw alone.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Throw {
    pub name: String,
    pub samples: usize,
    /// Number of this throw's measured poses that the fit of all throws used.
    pub used: usize,
    /// Spin, rev/min, positive clockwise seen from above, and its standard error.
    pub spin: [f64; 2],
    /// Angle between the disc's axis and the angular momentum at the first sample, degrees.
    pub wobble: f64,
    /// Ratio of the axial to the diametral moment of inertia, estimated from this throw alone; `None` if the throw
    /// could not be fitted alone.
    pub alone: Option<Ratio>,
}

/// Results of the fits to the measured poses of thrown golf discs.
pub(in super::super) struct DiscPose {
    /// Upward direction in camera axes, from the poses of a printed tag at rest on the ground.
    pub(super) up: [f64; 3],
    /// RMS angle between the measured normals of a printed tag at rest on the ground and their mean, rad.
    pub(super) scatter: f64,
    /// Fit of all throws together with priors on the aerodynamic coefficients.
    pub(super) joint: FitReport,
    /// Fit of all throws together without aerodynamic loads.
    pub(super) without_air: FitReport,
    /// Fit of all throws together in which the tilt of the vertical against the normal of a tag on the ground is
    /// estimated.
    pub(super) tilted: FitReport,
    pub(super) throws: Vec<Throw>,
    /// Jackknife standard error of the ratio I_a/I_d (axial / diametral moment of inertia) of all throws, from fits
    /// that each leave out one throw.
    pub(super) jackknife: f64,
    /// Random-effects mean of the ratios I_a/I_d (axial / diametral moment of inertia) estimated from the single
    /// throws, its standard error, and the standard deviation between throws.
    pub(super) pooled: [f64; 3],
}

impl DiscPose {
    /// Reads the tables of poses in a folder. Fits all throws together, each throw alone, and, for each throw, all
    /// throws but this one.
    pub(in super::super) fn of(folder: &Path) -> Result<Self, StudyError> {
        let poses = Poses::read(folder)?;
        let model = model_spec::load::load("disc_quaternion", &[])?;
        let tilting = model_spec::load::load("disc_quaternion", &["tilted_vertical"])?;
        let (air, held) = (Air::Prior, Air::None);
        let joint = fitted(&model, poses.flights.clone(), air)?.report;
        let without_air = fitted(&model, poses.flights.clone(), held)?.report;
        let tilted = fitted(&tilting, poses.flights.clone(), air)?.report;
        let mut left_out = Vec::new();
        for index in 0..poses.flights.len() {
            let mut others = poses.flights.clone();
            others.remove(index);
            left_out.push(ratio(&fitted(&model, others, air)?.report).value);
        }
        let throws = poses.flights.iter().zip(&joint.flights);
        let throws = throws.map(|(flight, report)| {
            // A throw that cannot be fitted alone gives no ratio.
            let alone = fitted(&model, vec![flight.clone()], held);
            let alone = alone.ok().map(|found| ratio(&found.report));
            throw(flight, report, ratio(&joint).value, alone)
        });
        let throws: Vec<Throw> = throws.collect();
        let alone: Vec<Ratio> = throws.iter().filter_map(|throw| throw.alone).collect();
        Ok(Self {
            up: poses.up,
            scatter: poses.scatter,
            jackknife: jackknife(&left_out),
            pooled: pooled(&alone),
            joint,
            without_air,
            tilted,
            throws,
        })
    }

    /// Ratio I_a/I_d of the axial to the diametral moment of inertia, from the fit of all throws together.
    pub(in super::super) fn ratio(&self) -> Ratio {
        ratio(&self.joint)
    }
}

/// Treatment of the aerodynamic coefficients in a fit to measured poses: estimated with priors, or fixed at 0.
#[derive(Clone, Copy)]
enum Air {
    /// The aerodynamic coefficients are estimated, with priors.
    Prior,
    /// All aerodynamic coefficients are fixed at 0.
    None,
}

fn fitted(model: &Model, flights: Vec<Flight>, air: Air) -> Result<Fit, FitError> {
    let dataset = Dataset {
        model: model.name.clone(),
        parameters: BODY.map(|(name, value)| (name.to_owned(), value)).into(),
        sensors: vec![Sensor::new("tag", SensorKind::Pose, [0.0; 3])],
        flights,
        ..Dataset::default()
    };
    let priors = PRIORS.map(|(name, value, sigma)| Prior {
        name: name.to_owned(),
        value,
        sigma,
    });
    let fixed = PRIORS.map(|(name, ..)| (name.to_owned(), Some(0.0)));
    let options = FitOptions {
        free: &["I_a".to_owned()],
        trust_data: true,
        ..FitOptions::default()
    };
    let options = match air {
        Air::Prior => FitOptions {
            priors: &priors,
            ..options
        },
        Air::None => FitOptions {
            fixed: &fixed,
            ..options
        },
    };
    identify::fit(model, &dataset, &options)
}

/// Ratio I_a/I_d of the axial to the diametral moment of inertia from a fit; NaN if the fit has no estimate of I_a.
pub(super) fn ratio(report: &FitReport) -> Ratio {
    match report.coefficients.get("I_a") {
        Some(found) => Ratio {
            value: found.value / I_D,
            std_error: found.std_error / I_D,
            clustered: found.std_error_cluster_robust.map(|error| error / I_D),
        },
        None => Ratio {
            value: f64::NAN,
            std_error: f64::NAN,
            clustered: None,
        },
    }
}

/// Results for one throw. `report` contains this throw's results in the fit of all throws, `joint` the ratio I_a/I_d of
/// that fit, and `alone` the ratio from a fit of this throw only.
fn throw(flight: &Flight, report: &FlightReport, joint: f64, alone: Option<Ratio>) -> Throw {
    let rate = |name: &str| {
        let own = report.initial.get(name);
        own.map_or([f64::NAN; 2], |own| [own.value, own.std_error])
    };
    let to_rpm = 60.0 / std::f64::consts::TAU;
    let [[p, _], [q, _], [r, error]] = ["p", "q", "r"].map(rate);
    // The components of the angular momentum are I_d p, I_d q and I_a r.
    let about_axis = joint * r;
    Throw {
        name: flight.file.trim_end_matches(".csv").to_owned(),
        samples: flight.times.len(),
        used: report.samples,
        spin: [-to_rpm * r, to_rpm * error],
        wobble: p.hypot(q).atan2(about_axis.abs()).to_degrees(),
        alone,
    }
}

/// Jackknife standard error of an estimate from all throws, computed from estimates that each leave out one throw:
/// Efron and Tibshirani, An introduction to the bootstrap (1993), equation 11.5.
fn jackknife(left_out: &[f64]) -> f64 {
    let count = left_out.len() as f64;
    let mean = left_out.iter().sum::<f64>() / count;
    let squares: f64 = left_out.iter().map(|value| (value - mean).powi(2)).sum();
    ((count - 1.0) / count * squares).sqrt()
}

/// Random-effects mean of estimates, its standard error, and the standard deviation between the estimates: DerSimonian
/// and Laird, Controlled Clinical Trials 7 (1986).
fn pooled(all: &[Ratio]) -> [f64; 3] {
    let weights = || all.iter().map(|own| own.std_error.powi(-2));
    let (sum, squares) = (
        weights().sum::<f64>(),
        weights().map(|w| w * w).sum::<f64>(),
    );
    let mean = |weights: &[f64]| {
        let products = weights.iter().zip(all).map(|(w, own)| w * own.value);
        products.sum::<f64>() / weights.iter().sum::<f64>()
    };
    let fixed = mean(&weights().collect::<Vec<f64>>());
    let misfit: f64 = weights()
        .zip(all)
        .map(|(w, own)| w * (own.value - fixed).powi(2))
        .sum();
    let freedom = all.len() as f64 - 1.0;
    let between = ((misfit - freedom) / (sum - squares / sum)).max(0.0);
    let by_both = all
        .iter()
        .map(|own| 1.0 / (own.std_error.powi(2) + between));
    let by_both: Vec<f64> = by_both.collect();
    let total: f64 = by_both.iter().sum();
    [mean(&by_both), total.powf(-0.5), between.sqrt()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn estimates_that_differ_more_than_their_errors_have_a_wider_mean() {
        let ratio = |value| Ratio {
            value,
            std_error: 0.1,
            clustered: None,
        };
        let [mean, error, between] = pooled(&[ratio(1.0), ratio(2.0), ratio(3.0)]);
        assert!((mean - 2.0).abs() < 1e-12);
        // The sample variance 1 is 0.01 by noise plus 0.99 between; the variance of the mean of three is a third of it.
        assert!((between - 0.99_f64.sqrt()).abs() < 1e-9, "{between}");
        assert!((error - (1.0_f64 / 3.0).sqrt()).abs() < 1e-9, "{error}");
        let [_, error, between] = pooled(&[ratio(2.0), ratio(2.0)]);
        assert!(between == 0.0 && (error - 0.1 / 2.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn the_jackknife_of_a_mean_is_its_standard_error() {
        let all = [1.0, 4.0, 2.0, 7.0];
        let sum: f64 = all.iter().sum();
        let left_out: Vec<f64> = all.iter().map(|own| (sum - own) / 3.0).collect();
        let (_, deviation) = crate::statistics::mean_and_deviation(&all);
        assert!((jackknife(&left_out) - deviation / 2.0).abs() < 1e-12);
    }
}
