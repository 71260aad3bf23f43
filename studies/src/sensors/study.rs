//! Fits and diagnoses simulated flights with each set of sensors.

use dataset::{Role, Sensor, SensorKind};
use diagnose::{DiagnosisOptions, diagnose};
use flight::parallel;
use identify::{fit, interval};
use model_spec::compose::Instrument;
use serde::Serialize;

use super::flights::{Observed, SensorNoise, sensor_flights};
use crate::bounded_fit::on_threads;
use crate::oracle_flights::{Plan, TWELVE, disc, truth};

/// Number of flights per dataset, and how many of them a diagnosis holds out from the fit, to test predictions.
const FLIGHTS: (usize, usize) = (12, 4);

/// Displacement of the accelerometer from its stated position, m, body axes, in the datasets in which the diagnosis
/// should find such a displacement.
pub const DISPLACEMENT: [f64; 3] = [0.005, 0.0, 0.0];

/// Name, in the built-in effects catalogue, of the effect of a displaced accelerometer.
const MISPLACED: &str = "accelerometer-misplaced";

/// Results of the fits and diagnoses of datasets measured with one set of sensors.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SensorSet {
    /// Description of the sensors or measured quantities, such as "gyroscope and accelerometer".
    pub name: String,
    /// Number of datasets that were fitted.
    pub datasets: usize,
    /// Number of fits that failed, did not converge or were reported as unreliable.
    pub failed: usize,
    /// Number of 95 % confidence intervals, over datasets and coefficients.
    pub intervals: usize,
    /// Number of the 95 % confidence intervals that contain the true value.
    pub covered: usize,
    /// Number of estimates, over datasets and coefficients, within three standard errors of the true value.
    pub within_three: usize,
    /// RMS, over datasets and coefficients, of z = (estimate − true value) / standard error.
    pub rms_z: f64,
    /// Median elapsed time of a fit of one dataset, s.
    pub seconds: f64,
    /// Median over the coefficients of the ratio of the standard error with these sensors to that with markers alone.
    pub relative_error: f64,
    /// Number of diagnoses of datasets without a displaced sensor, and how many of them detect no effect.
    pub clean: [usize; 2],
    /// Number of diagnoses of datasets with a displaced accelerometer, and how many of them find the displacement, with
    /// an estimate within three standard errors of the true one. `None` for a set without an accelerometer.
    pub displaced: Option<[usize; 2]>,
}

/// The sensor sets that the study compares, each as (description, whether marker positions are measured, sensors).
fn sets() -> Vec<(&'static str, bool, Vec<Sensor>)> {
    let instrument = |name, kind, place| Sensor::new(name, SensorKind::Instrument(kind), place);
    let pose = Sensor::new("tag", SensorKind::Pose, [0.03, 0.0, 0.01]);
    let gyroscope = instrument("gyro", Instrument::Gyroscope, [0.0; 3]);
    let accelerometer = instrument("acc", Instrument::Accelerometer, [0.02, -0.01, 0.005]);
    let speed = instrument("radar", Instrument::Speed, [0.0; 3]);
    let inertial = vec![gyroscope.clone(), accelerometer.clone()];
    vec![
        ("three markers", true, Vec::new()),
        ("pose", false, vec![pose.clone()]),
        ("gyroscope and accelerometer", false, inertial.clone()),
        ("three markers, gyroscope and accelerometer", true, inertial),
        (
            "pose, gyroscope, accelerometer and speed",
            false,
            vec![pose, gyroscope, accelerometer, speed],
        ),
    ]
}

/// Fits `seeds` datasets of each sensor set, and returns the results of each set. Also diagnoses `diagnosed` datasets
/// of each set and, if the set contains an accelerometer, as many with a displaced accelerometer. Calls `done` with a
/// description of each finished step.
pub fn sensors(
    seeds: u64,
    diagnosed: u64,
    threads: usize,
    done: &(dyn Fn(&str) + Sync),
) -> Vec<SensorSet> {
    let mut markers = Vec::new();
    let mut found = Vec::new();
    for (name, has_markers, sensors) in sets() {
        let observed = Observed {
            markers: has_markers,
            sensors,
            displacement: [0.0; 3],
            noise: SensorNoise::default(),
        };
        let runs = parallel::each_on(threads, seeds as usize, |seed| run(&observed, seed as u64));
        let mut set = SensorSet {
            name: name.to_owned(),
            datasets: runs.len(),
            ..SensorSet::default()
        };
        let errors = gather(&runs, &mut set);
        if markers.is_empty() {
            markers.clone_from(&errors);
        }
        let mut ratios: Vec<f64> = errors
            .iter()
            .zip(&markers)
            .map(|(own, of)| own / of)
            .collect();
        set.relative_error = dataset::statistics::median(&mut ratios);
        done(name);
        diagnoses(&observed, diagnosed, threads, &mut set);
        done(&format!("{name}, diagnoses"));
        found.push(set);
    }
    found
}

/// Result of one fit: its computing time, s, and for each coefficient z = (estimate - true value) / standard error,
/// whether the 95 % interval contains the true value, and the standard error. `None` without a converged, reliable fit.
type Run = Option<(f64, Vec<(f64, bool, f64)>)>;

fn run(observed: &Observed, seed: u64) -> Run {
    let model = disc();
    let plan = Plan {
        flights: FLIGHTS.0,
        ..TWELVE
    };
    let dataset = sensor_flights(&model, &plan, observed, seed);
    let clock = std::time::Instant::now();
    let found = fit(&model, &dataset, &on_threads(1)).ok()?;
    let seconds = clock.elapsed().as_secs_f64();
    if !found.report.iterations.converged || !found.report.reliable {
        return None;
    }
    let each = truth(&model, &plan).into_iter().map(|(name, value)| {
        let own = &found.report.coefficients[&name];
        let [low, high] = interval(own.value, own.std_error);
        let z = (own.value - value) / own.std_error;
        (z, low <= value && value <= high, own.std_error)
    });
    Some((seconds, each.collect()))
}

/// Stores statistics of the fits in `set`: number of failed fits, coverage of the confidence intervals, RMS z-score
/// (error of an estimate divided by its standard error) and median time. Returns the median standard error of each
/// coefficient over the successful fits.
fn gather(runs: &[Run], set: &mut SensorSet) -> Vec<f64> {
    let good: Vec<_> = runs.iter().flatten().collect();
    set.failed = runs.len() - good.len();
    let all = || good.iter().flat_map(|(_, each)| each);
    set.intervals = all().count();
    set.covered = all().filter(|(_, is_covered, _)| *is_covered).count();
    set.within_three = all().filter(|(z, ..)| z.abs() <= 3.0).count();
    let squares: f64 = all().map(|(z, ..)| z * z).sum();
    set.rms_z = (squares / set.intervals.max(1) as f64).sqrt();
    set.seconds =
        dataset::statistics::median(&mut good.iter().map(|(s, _)| *s).collect::<Vec<f64>>());
    let count = good.first().map_or(0, |(_, each)| each.len());
    let errors = (0..count).map(|index| {
        let of_one = good.iter().map(|(_, each)| each[index].2);
        dataset::statistics::median(&mut of_one.collect::<Vec<f64>>())
    });
    errors.collect()
}

fn diagnoses(observed: &Observed, count: u64, threads: usize, set: &mut SensorSet) {
    let is_accelerometer =
        |sensor: &Sensor| sensor.kind == SensorKind::Instrument(Instrument::Accelerometer);
    let clean = parallel::each_on(threads, count as usize, |seed| {
        let names = causes(observed, seed as u64)?;
        Some(names.is_empty())
    });
    set.clean = [
        clean.len(),
        clean.iter().filter(|found| **found == Some(true)).count(),
    ];
    if observed.sensors.iter().any(is_accelerometer) {
        let displaced = Observed {
            displacement: DISPLACEMENT,
            ..observed.clone()
        };
        let found = parallel::each_on(threads, count as usize, |seed| {
            let names = causes(&displaced, seed as u64)?;
            Some(
                names
                    .iter()
                    .any(|(name, is_right)| name == MISPLACED && *is_right),
            )
        });
        let named = found.iter().filter(|found| **found == Some(true)).count();
        set.displaced = Some([found.len(), named]);
    }
}

/// Diagnoses a simulated dataset. Returns, for each effect in the hypotheses that the diagnosis found: its name, and
/// whether its estimate of the accelerometer's displacement is within three standard errors of the true one. `None` if
/// the diagnosis fails.
fn causes(observed: &Observed, seed: u64) -> Option<Vec<(String, bool)>> {
    let model = disc();
    let plan = Plan {
        flights: FLIGHTS.0,
        ..TWELVE
    };
    let mut dataset = sensor_flights(&model, &plan, observed, 1000 + seed);
    let fitted = FLIGHTS.0 - FLIGHTS.1;
    for flight in dataset.flights.iter_mut().skip(fitted) {
        flight.role = Role::HeldOut;
    }
    let options = DiagnosisOptions {
        fit: on_threads(1),
        ..DiagnosisOptions::default()
    };
    let found = diagnose(&model, &dataset, &options).ok()?;
    let effects = found
        .report
        .explanations
        .iter()
        .flat_map(|cause| &cause.effects);
    let each = effects.map(|effect| {
        let first = effect.estimates.get("accelerometer_by_1");
        let off = first.map(|own| (own.value - DISPLACEMENT[0]).abs() / own.std_error);
        (effect.name.clone(), off.is_some_and(|off| off <= 3.0))
    });
    Some(each.collect())
}
