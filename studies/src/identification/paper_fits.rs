//! Fits of the paper's two flights, one by one and together, and of twelve different throws, all under the paper's
//! noise.

use dataset::Dataset;
use dataset::synthesize::Corruption;
use flight::parallel;
use identify::{FitOptions, FitReport, fit};
use model_spec::model::Model;

use crate::bounded_fit::on_threads;
use crate::oracle_flights::{Plan, SAMPLE_RATE, Throws, add_noise, disc, flights, paper_flight};
use crate::statistics::mean_and_deviation;

/// Standard deviation of the residuals of the marker positions in the fits of Hubbard & Hummel (2000), m; used for the
/// simulated noise.
const SIGMA: f64 = 0.0014;

/// Estimates from one set of flights under one noise condition, over many seeds of the noise.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// Description of the fitted flights and of the noise added to them.
    pub name: &'static str,
    /// Estimates (SI), indexed by coefficient (in the order of the model's coefficients) and by noise seed. Seeds for
    /// which the fit failed are left out.
    pub estimates: Vec<Vec<f64>>,
    /// Number of noise seeds for which the fit gives a physically implausible estimate, such as negative drag.
    pub implausible: usize,
    /// For each coefficient, in the order of the model's coefficients, the number of noise seeds for which the fit
    /// report names it as practically non-identifiable.
    pub non_identifiable: Vec<usize>,
    /// Number of noise seeds for which the fit report names any coefficient as practically non-identifiable.
    pub any_non_identifiable: usize,
    /// Number of noise seeds for which the fit failed.
    pub failed: usize,
    /// Explanations of the non-identifiable combinations of coefficients, from the report of the first successful fit
    /// in the order of the noise seeds.
    pub messages: Vec<String>,
}

impl Scenario {
    /// Mean and standard deviation, over the noise seeds, of the estimates of one coefficient, SI. `coefficient` is its
    /// index in the order of the model's coefficients.
    pub(crate) fn mean_and_deviation(&self, coefficient: usize) -> (f64, f64) {
        mean_and_deviation(&self.estimates[coefficient])
    }
}

/// Fits of the two flights of Hubbard & Hummel (2000), and of twelve random throws of the same disc, under several
/// scenarios.
#[derive(Clone, Debug, PartialEq)]
pub struct PaperFits {
    /// Name and true value (SI) of each coefficient.
    pub truth: Vec<(String, f64)>,
    /// Number of noise seeds, and thus of fits, in each scenario.
    pub seeds: usize,
    /// Scenarios (sets of fitted flights under one noise): the flights fssh3 and bffl8 of Hubbard & Hummel (2000) alone
    /// and the first half second of bffl8, then both flights together, and last the twelve random throws.
    pub scenarios: Vec<Scenario>,
}

/// Name of the scenario in which only flight fssh3 of Hubbard & Hummel (2000), 0.5 s long, is fitted, under noise with
/// a lag-1 correlation of 0.6.
pub(super) const FSSH3_HALF: &str = "fssh3 alone, 0.5 s, AR(0.6)";

/// Name of the scenario in which only the first 0.5 s of flight bffl8 of Hubbard & Hummel (2000) is fitted, under noise
/// with a lag-1 correlation of 0.6.
pub(super) const BFFL8_HALF: &str = "bffl8 alone, its first 0.5 s, AR(0.6)";

/// Whether an estimate is physically plausible: drag coefficients are not negative, lift does not fall with the angle
/// of attack, damping moments oppose the rotation.
fn is_plausible(name: &str, value: f64) -> bool {
    match name {
        "C_D0" | "C_Da" | "C_La" => value >= 0.0,
        "C_Mq" | "C_Nr" => value <= 0.0,
        _ => true,
    }
}

/// Fits flights simulated from the releases of Hubbard & Hummel (2000), `seeds` times with different noise. The
/// coefficients of the built-in disc are the true values.
///
/// # Panics
/// If a built-in model or release does not load.
pub fn paper_fits(seeds: u64) -> PaperFits {
    let model = disc();
    let [fssh3, bffl8] = ["fssh3", "bffl8"].map(|name| paper_flight(&model, name, None));
    let both = Dataset {
        flights: [fssh3.flights.clone(), bffl8.flights.clone()].concat(),
        ..fssh3.clone()
    };
    let twelve = Plan {
        truth: &[],
        throws: Throws::SPREAD,
        flights: 12,
        duration: (0.5, 1.0),
        rate: SAMPLE_RATE,
    };
    let twelve = flights(&model, &twelve, 1);
    let half = truncated(&bffl8, 0.5);
    let scenarios = [
        ("fssh3 alone, 0.5 s", &fssh3, 0.0),
        (FSSH3_HALF, &fssh3, 0.6),
        ("bffl8 alone, 1 s", &bffl8, 0.0),
        ("bffl8 alone, its first 0.5 s", &half, 0.0),
        (BFFL8_HALF, &half, 0.6),
        ("both together", &both, 0.0),
        ("both together, AR(0.6)", &both, 0.6),
        ("twelve throws, AR(0.6)", &twelve, 0.6),
    ];
    let truth = model.coefficients.iter();
    PaperFits {
        truth: truth.map(|c| (c.name.clone(), c.value)).collect(),
        seeds: seeds as usize,
        scenarios: scenarios
            .map(|(name, dataset, ar1)| scenario(&model, name, dataset, ar1, seeds))
            .into(),
    }
}

/// Returns a copy of a dataset in which each flight ends at the time `duration` (s).
fn truncated(dataset: &Dataset, duration: f64) -> Dataset {
    let mut dataset = dataset.clone();
    for flight in &mut dataset.flights {
        let times = &flight.times;
        let count = times.partition_point(|time| *time <= duration + 1e-9);
        flight.times.truncate(count);
        flight.positions.truncate(count);
    }
    dataset
}

/// Adds noise of the standard deviation [`SIGMA`] and the lag-1 correlation `ar1` to exact flights and fits them, for
/// `seeds` seeds of the noise. As in Hubbard & Hummel (2000), the coefficients are unbounded.
pub(crate) fn scenario(
    model: &Model,
    name: &'static str,
    exact: &Dataset,
    ar1: f64,
    seeds: u64,
) -> Scenario {
    let noise = Corruption {
        sigma: SIGMA,
        ar1,
        ..Corruption::default()
    };
    let reports = parallel::each(seeds as usize, |seed| {
        let mut dataset = exact.clone();
        add_noise(&mut dataset, &noise, seed as u64 + 1);
        let options = FitOptions {
            unbounded: true,
            ..on_threads(1)
        };
        let fitted = fit(model, &dataset, &options).ok()?;
        Some(fitted.report)
    });
    let failed = reports.iter().filter(|report| report.is_none()).count();
    let reports: Vec<FitReport> = reports.into_iter().flatten().collect();
    let names = || model.coefficients.iter().map(|c| c.name.as_str());
    let count =
        |is: &dyn Fn(&FitReport) -> bool| reports.iter().filter(|report| is(report)).count();
    let value = |name: &str, report: &FitReport| report.coefficients[name].value;
    let is_named = |name: &str, report: &FitReport| {
        let mut combinations = report.not_identifiable.iter().flat_map(|u| &u.combination);
        combinations.any(|named| named == name)
    };
    let first = reports.first().map(|report| &report.not_identifiable);
    Scenario {
        name,
        estimates: names()
            .map(|name| reports.iter().map(|report| value(name, report)).collect())
            .collect(),
        implausible: count(&|report| names().any(|name| !is_plausible(name, value(name, report)))),
        non_identifiable: names()
            .map(|name| count(&|report| is_named(name, report)))
            .collect(),
        any_non_identifiable: count(&|report| names().any(|name| is_named(name, report))),
        failed,
        messages: first.map_or(Vec::new(), |u| u.iter().map(|u| u.reason.clone()).collect()),
    }
}
