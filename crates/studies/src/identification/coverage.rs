//! Do the stated intervals hold the true values as often as they say?

use flight::batch;
use identify::interval;
use identify::synthesize::{Corruption, corrupt};
use identify::{FitOptions, fit};

use crate::oracle_flights::dataset::{Plan, disc, flights, truth};
use crate::oracle_flights::throws::Throws;

/// True coefficients of the trials: possible ones, and none of them where the fit starts.
pub const TRUTH: [(&str, f64); 8] = [
    ("C_L0", 0.15),
    ("C_La", 2.8),
    ("C_D0", 0.10),
    ("C_Da", 1.6),
    ("C_Ma", -0.30),
    ("C_Mq", -0.008),
    ("C_Rr", -0.0006),
    ("C_Nr", -5e-5),
];

/// Twelve throws of a second each, three markers, 120 Hz.
pub const TWELVE: Plan<'static> = Plan {
    truth: &TRUTH,
    throws: Throws::SPREAD,
    flights: 12,
    duration: (1.0, 1.0),
    rate: 120.0,
};

/// A kind of noise with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// In words.
    pub name: &'static str,
    /// What is done to the markers.
    pub noise: Corruption,
}

/// The noises that intervals are tried under: 1.5 mm, white; correlated; with outliers of 5 cm; with dropouts.
pub fn conditions() -> Vec<Condition> {
    let white = Corruption {
        sigma: 0.0015,
        ar1: 0.0,
        outliers: 0.0,
        outlier_size: 0.05,
        dropouts: 0.0,
    };
    let (ar1, outliers, dropouts) = (0.6, 0.01, 0.12);
    vec![
        Condition {
            name: "white",
            noise: white,
        },
        Condition {
            name: "AR(0.6)",
            noise: Corruption { ar1, ..white },
        },
        Condition {
            name: "1 % outliers",
            noise: Corruption { outliers, ..white },
        },
        Condition {
            name: "AR(0.6) and 1 % outliers",
            noise: Corruption {
                ar1,
                outliers,
                ..white
            },
        },
        Condition {
            name: "12 % dropouts",
            noise: Corruption { dropouts, ..white },
        },
    ]
}

/// How one coefficient came out over the seeds.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its name.
    pub name: String,
    /// Seeds whose interval of 95 % holds the true value.
    pub covered: usize,
    /// Seeds whose interval by the scatter of the flights does.
    pub covered_clustered: usize,
    /// Mean of the errors over their standard errors.
    pub bias: f64,
    /// Root mean square of the same: 1 where the standard errors are right.
    pub spread: f64,
    /// The greatest of them.
    pub worst: f64,
}

/// How all coefficients came out under one noise.
#[derive(Clone, Debug, PartialEq)]
pub struct Coverage {
    /// The noise.
    pub condition: Condition,
    /// Seeds that were tried.
    pub seeds: usize,
    /// Seeds whose fit failed or did not converge; none of them counts as covered.
    pub failed: usize,
    /// Each coefficient, in the model's order.
    pub rows: Vec<Row>,
}

impl Coverage {
    /// Part of all intervals, over seeds and coefficients, that hold the true value.
    pub fn covered(&self) -> f64 {
        let covered: usize = self.rows.iter().map(|row| row.covered).sum();
        covered as f64 / (self.rows.len() * self.seeds).max(1) as f64
    }

    /// The same of the intervals by the scatter of the flights.
    pub fn covered_clustered(&self) -> f64 {
        let covered: usize = self.rows.iter().map(|row| row.covered_clustered).sum();
        covered as f64 / (self.rows.len() * self.seeds).max(1) as f64
    }
}

/// Makes, fits and compares `seeds` datasets under a noise, each seed with throws of its own.
pub fn coverage(plan: &Plan<'_>, condition: &Condition, seeds: u64) -> Coverage {
    let model = disc();
    let truth = truth(&model, plan);
    let tried = batch::each(seeds as usize, |seed| {
        let seed = seed as u64;
        let mut dataset = flights(&model, plan, seed);
        for (index, flight) in dataset.flights.iter_mut().enumerate() {
            corrupt(
                &mut flight.positions,
                &condition.noise,
                1000 * seed + index as u64,
            );
        }
        // The seeds are worked on side by side already.
        let options = FitOptions {
            threads: Some(1),
            ..FitOptions::default()
        };
        let report = fit(&model, &dataset, &options).ok()?.report;
        report.iterations.converged.then_some(report)
    });
    let failed = tried.iter().filter(|report| report.is_none()).count();
    let reports: Vec<_> = tried.into_iter().flatten().collect();
    let rows = truth.iter().map(|(name, truth)| {
        let found = || reports.iter().map(|report| &report.coefficients[name]);
        let errors: Vec<f64> = found().map(|c| (c.value - truth) / c.std_error).collect();
        let holds = |[low, high]: [f64; 2]| (low..=high).contains(truth);
        let clustered = found().filter_map(|c| Some(interval(c.value, c.std_error_clustered?)));
        let count = errors.len().max(1) as f64;
        Row {
            name: name.clone(),
            covered: found().filter(|c| holds(c.interval)).count(),
            covered_clustered: clustered.filter(|range| holds(*range)).count(),
            bias: errors.iter().sum::<f64>() / count,
            spread: (errors.iter().map(|error| error * error).sum::<f64>() / count).sqrt(),
            worst: errors
                .iter()
                .fold(0.0, |worst: f64, error| worst.max(error.abs())),
        }
    });
    Coverage {
        condition: condition.clone(),
        seeds: seeds as usize,
        failed,
        rows: rows.collect(),
    }
}
