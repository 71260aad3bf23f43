//! The paper's situation replayed: its two flights, fitted one by one, and what a spread of throws makes of it.

use flight::batch;
use identify::dataset::Dataset;
use identify::synthesize::{Corruption, corrupt};
use identify::{FitOptions, fit};
use model_spec::model::Model;

use crate::oracle_flights::dataset::{Plan, disc, flights};
use crate::oracle_flights::paper_flight::{RATE, paper_flight};
use crate::oracle_flights::throws::Throws;

/// Best fit of the paper's marker positions, m.
const SIGMA: f64 = 0.0014;

/// A way to estimate the coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// In words.
    pub name: &'static str,
    /// Estimates by coefficient (in the model's order) and seed.
    pub estimates: Vec<Vec<f64>>,
    /// Seeds whose estimate of a coefficient cannot be: by coefficient.
    pub impossible: Vec<usize>,
    /// Seeds with any impossible coefficient.
    pub any_impossible: usize,
    /// Seeds whose report names the coefficient among those that are not determined: by coefficient.
    pub undetermined: Vec<usize>,
    /// Seeds whose report names any.
    pub any_undetermined: usize,
    /// Seeds whose fit failed.
    pub failed: usize,
    /// What the report of the first seed says is not determined.
    pub told: Vec<String>,
}

/// The replay.
#[derive(Clone, Debug, PartialEq)]
pub struct Replay {
    /// Names of the coefficients and their true values.
    pub truth: Vec<(String, f64)>,
    /// Seeds that were tried.
    pub seeds: usize,
    /// The paper's flights one by one, both together, and a spread of throws.
    pub ways: Vec<Way>,
}

/// The paper's Table 1 with the signs of this project's disc: coefficient, fssh3, bffl8.
pub const TABLE_1: [(&str, f64, f64); 8] = [
    ("C_L0", -0.40, 1.17),
    ("C_La", 1.89, 0.28),
    ("C_D0", 0.83, 5.07),
    ("C_Da", 0.83, 0.077),
    ("C_Ma", -0.16, 0.22),
    ("C_Mq", -0.029, -0.025),
    ("C_Rr", 0.012, -0.0030),
    ("C_Nr", -0.000074, 0.00000025),
];

/// Whether a coefficient can have a value: drag does not push, lift grows with the angle of attack, dampings damp.
pub fn is_possible(name: &str, value: f64) -> bool {
    match name {
        "C_D0" | "C_Da" | "C_La" => value >= 0.0,
        "C_Mq" | "C_Nr" => value <= 0.0,
        _ => true,
    }
}

/// Replays the paper's situation with the model's own coefficients as the truth.
///
/// # Panics
/// Where a built-in model or release is broken.
pub fn replay(seeds: u64) -> Replay {
    let model = disc();
    let [fssh3, bffl8] = ["fssh3", "bffl8"].map(|name| paper_flight(&model, name, None));
    let both = Dataset {
        flights: [fssh3.flights.clone(), bffl8.flights.clone()].concat(),
        ..fssh3.clone()
    };
    let spread = Plan {
        truth: &[],
        throws: Throws::SPREAD,
        flights: 12,
        duration: (0.5, 1.0),
        rate: RATE,
    };
    let spread = flights(&model, &spread, 1);
    let half = shortened(&bffl8, 0.5);
    let ways = [
        ("fssh3 alone, 0.5 s", &fssh3, 0.0),
        ("fssh3 alone, 0.5 s, AR(0.6)", &fssh3, 0.6),
        ("bffl8 alone, 1 s", &bffl8, 0.0),
        ("bffl8 alone, its first 0.5 s", &half, 0.0),
        ("bffl8 alone, its first 0.5 s, AR(0.6)", &half, 0.6),
        ("both together", &both, 0.0),
        ("both together, AR(0.6)", &both, 0.6),
        ("twelve throws, AR(0.6)", &spread, 0.6),
    ];
    Replay {
        truth: model
            .coefficients
            .iter()
            .map(|c| (c.name.clone(), c.value))
            .collect(),
        seeds: seeds as usize,
        ways: ways
            .map(|(name, dataset, ar1)| way(&model, name, dataset, ar1, seeds))
            .into(),
    }
}

/// The first part of every flight, s.
fn shortened(dataset: &Dataset, duration: f64) -> Dataset {
    let mut short = dataset.clone();
    for flight in &mut short.flights {
        let count = flight
            .times
            .partition_point(|time| *time <= duration + 1e-9);
        flight.times.truncate(count);
        flight.positions.truncate(count);
    }
    short
}

/// Estimates from a dataset under the paper's noise, over the seeds.
pub fn way(model: &Model, name: &'static str, clean: &Dataset, ar1: f64, seeds: u64) -> Way {
    let noise = Corruption {
        sigma: SIGMA,
        ar1,
        ..Corruption::default()
    };
    let reports = batch::each(seeds as usize, |seed| {
        let mut dataset = clean.clone();
        for (index, flight) in dataset.flights.iter_mut().enumerate() {
            corrupt(
                &mut flight.positions,
                &noise,
                1000 * (seed as u64 + 1) + index as u64,
            );
        }
        let options = FitOptions {
            // As the paper did: nothing keeps the coefficients where they can be.
            unbounded: true,
            threads: Some(1),
            ..FitOptions::default()
        };
        fit(model, &dataset, &options)
            .ok()
            .map(|fitted| fitted.report)
    });
    let failed = reports.iter().filter(|report| report.is_none()).count();
    let reports: Vec<_> = reports.into_iter().flatten().collect();
    let names: Vec<&str> = model.coefficients.iter().map(|c| c.name.as_str()).collect();
    let impossible = |name: &str, report: &identify::FitReport| {
        !is_possible(name, report.coefficients[name].value)
    };
    let named = |name: &str, report: &identify::FitReport| {
        report
            .undetermined
            .iter()
            .any(|u| u.combination.iter().any(|n| n == name))
    };
    let over = |test: &dyn Fn(&str, &identify::FitReport) -> bool| -> Vec<usize> {
        names
            .iter()
            .map(|name| reports.iter().filter(|report| test(name, report)).count())
            .collect()
    };
    let any = |test: &dyn Fn(&str, &identify::FitReport) -> bool| {
        reports
            .iter()
            .filter(|report| names.iter().any(|name| test(name, report)))
            .count()
    };
    let told = reports
        .first()
        .map(|report| report.undetermined.iter().map(|u| u.why.clone()).collect());
    Way {
        name,
        estimates: names
            .iter()
            .map(|name| {
                reports
                    .iter()
                    .map(|report| report.coefficients[*name].value)
                    .collect()
            })
            .collect(),
        impossible: over(&impossible),
        any_impossible: any(&impossible),
        undetermined: over(&named),
        any_undetermined: any(&named),
        failed,
        told: told.unwrap_or_default(),
    }
}
