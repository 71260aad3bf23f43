//! Coverage of the fit's 95 % confidence intervals over simulated datasets with different throws and noise.

use flight::parallel;
use identify::{fit, interval};
use serde::Serialize;

use crate::bounded_fit::on_threads;
use crate::oracle_flights::{NoiseCondition, Plan, add_noise, disc, flights, truth};

/// Coverage of the confidence intervals of one coefficient, and statistics of z = (estimate - true value) / standard
/// error.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CoefficientCoverage {
    /// Name of the coefficient whose confidence intervals are examined.
    pub name: String,
    /// Number of datasets whose 95 % confidence interval contains the true value.
    pub covered: usize,
    /// Number of datasets whose cluster-robust 95 % interval (clusters are flights) contains the true value.
    pub covered_clustered: usize,
    /// Mean over the datasets of z = (estimate − true value) / standard error.
    pub mean_z: f64,
    /// RMS over the datasets of z = (estimate − true value) / standard error; 1 if the standard errors are right.
    pub rms_z: f64,
    /// Maximum over the datasets of |z|, where z = (estimate − true value) / standard error.
    pub max_z: f64,
}

/// Coverage of the confidence intervals of all coefficients under one noise condition.
#[derive(Clone, Debug, PartialEq)]
pub struct Coverage {
    /// Noise condition under which the datasets were simulated.
    pub condition: NoiseCondition,
    /// Number of simulated datasets.
    pub seeds: usize,
    /// Number of fits that failed or did not converge. Their intervals count as not containing the true value.
    pub failed: usize,
    /// Coverage of the confidence intervals of each coefficient, in the order of the model's coefficients.
    pub coefficients: Vec<CoefficientCoverage>,
}

impl Coverage {
    /// Fraction of the 95 % intervals, over all datasets and coefficients, that contain the true value.
    pub fn covered(&self) -> f64 {
        self.fraction(|coefficient| coefficient.covered)
    }

    /// Fraction of the cluster-robust 95 % intervals, over all datasets and coefficients, that contain the true value.
    pub fn covered_clustered(&self) -> f64 {
        self.fraction(|coefficient| coefficient.covered_clustered)
    }

    fn fraction(&self, covered: impl Fn(&CoefficientCoverage) -> usize) -> f64 {
        let covered: usize = self.coefficients.iter().map(covered).sum();
        covered as f64 / (self.coefficients.len() * self.seeds).max(1) as f64
    }
}

/// Simulates and fits `seeds` datasets of a plan (set of random throws) under a noise condition, each with different
/// throws. Compares the estimates with the true values.
pub fn coverage(plan: &Plan<'_>, condition: &NoiseCondition, seeds: u64) -> Coverage {
    let model = disc();
    let truth = truth(&model, plan);
    let reports = parallel::each(seeds as usize, |seed| {
        let seed = seed as u64;
        let mut dataset = flights(&model, plan, seed);
        add_noise(&mut dataset, &condition.noise, seed);
        // Datasets are fitted in parallel, each on one thread.
        let report = fit(&model, &dataset, &on_threads(1)).ok()?.report;
        report.iterations.converged.then_some(report)
    });
    let failed = reports.iter().filter(|report| report.is_none()).count();
    let reports: Vec<_> = reports.into_iter().flatten().collect();
    let coefficients = truth.iter().map(|(name, truth)| {
        let estimates = || reports.iter().map(|report| &report.coefficients[name]);
        let contains = |[low, high]: [f64; 2]| (low..=high).contains(truth);
        let clustered =
            estimates().filter_map(|c| Some(interval(c.value, c.std_error_cluster_robust?)));
        let z: Vec<f64> = estimates()
            .map(|c| (c.value - truth) / c.std_error)
            .collect();
        let count = z.len().max(1) as f64;
        CoefficientCoverage {
            name: name.clone(),
            covered: estimates().filter(|c| contains(c.interval)).count(),
            covered_clustered: clustered.filter(|interval| contains(*interval)).count(),
            mean_z: z.iter().sum::<f64>() / count,
            rms_z: (z.iter().map(|z| z * z).sum::<f64>() / count).sqrt(),
            max_z: z.iter().fold(0.0, |max: f64, z| max.max(z.abs())),
        }
    });
    Coverage {
        condition: condition.clone(),
        seeds: seeds as usize,
        failed,
        coefficients: coefficients.collect(),
    }
}
