//! Trial fits: of data whose faults may be loads of the model, of readings in another unit, and of values that the user
//! holds.

use model_spec::compose::ModelTree;
use model_spec::model::Model;

use super::{Fit, FitError, fit_within};
use crate::error::{DataFault, FaultKind};
use crate::levels::SIGNIFICANT;
use crate::numbers::Digits;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use crate::report::{Coefficient, LACK_OF_FIT_LEVEL, LackOfFit, MAX_PRIOR_CONFLICT};
use crate::screening::{self, OtherMeaning, Poses};
use dataset::statistics::median_of;
use dataset::{Dataset, Flight, Role};

const FLIGHTS: usize = 4;

/// Effect of attitudes in a turned frame, and its coefficients.
const ATTITUDE_TURNED: &str = "attitude_turned";
const TURNS: [&str; 3] = ["turned_1", "turned_2", "turned_3"];

/// Least turn of attitudes, degrees, that is a fault of the data: fits find smaller ones as an effect.
const FAR_TURN: f64 = 45.0;

/// Greatest turn, degrees, beside quarters of a turn, which are more usual than negated coordinates, and these than others.
const NEARLY: f64 = 5.0;

/// Acceleration that corresponds to the residuals, m/s², below which the data are as the model says; wrong axes, units
/// or times leave about that of gravity.
const MAX_ACCELERATION: f64 = 2.0;

/// Root mean square of a parabola a·t²/2 about its best straight line over a time T, in units of a·T²: 1/√720.
const BENDING: f64 = 0.0373;

/// Removes faults that all flights have in common if they rest on accelerations, which screening compares with usual
/// loads, and the model describes the data as they are.
pub fn remove_refuted(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    faults: &mut Vec<DataFault>,
) {
    let is_common = |flight: &Flight| {
        let mut own = faults.iter().filter(|fault| fault.file == flight.file);
        own.clone().next().is_some() && own.all(|fault| rests_on_loads(fault.fault))
    };
    let to_fit = dataset.flights.iter().filter(|f| f.role == Role::Fit);
    let to_fit = to_fit.filter(|flight| !dataset.is_summary(flight));
    if options.trust_data || !to_fit.clone().all(is_common) {
        return;
    }
    if let Some(fit) = tried(model, dataset, to_fit.cloned(), options) {
        let is_noise = lacks_fit(&fit, options).is_some_and(|(fails, _)| !fails);
        faults.retain(|fault| match fault.fault {
            // A hand pushes about as hard as the model may.
            FaultKind::NotFreeFlight => !is_noise,
            kind => !(rests_on_loads(kind) && flies_as_recorded(&fit)),
        });
    }
}

/// Fit of a few of `flights`, which take the place of those of the dataset, as they are; `None` if it has no result.
fn tried(
    model: &Model,
    dataset: &Dataset,
    flights: impl Iterator<Item = Flight>,
    options: &FitOptions<'_>,
) -> Option<Fit> {
    let few = Dataset {
        flights: flights.take(FLIGHTS).collect(),
        ..dataset.clone()
    };
    let as_they_are = FitOptions {
        known_faults: Some(&[]),
        profiles: &[],
        ..*options
    };
    fit_within(model, &few, &as_they_are, None).ok()
}

/// [`tried`], if the fit is reliable, also by the tests of its residuals.
fn tried_reliably(
    model: &Model,
    dataset: &Dataset,
    flights: impl Iterator<Item = Flight>,
    options: &FitOptions<'_>,
) -> Option<Fit> {
    let fit = tried(model, dataset, flights, options)?;
    let tested = fit.with_lack_of_fit(options.threads()).ok();
    tested.filter(|fit| fit.report.reliable)
}

/// Reliable fit of a few flights with readings of another meaning.
fn tried_with(
    other: &OtherMeaning,
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
) -> Option<Fit> {
    let to_fit = dataset.flights.iter().filter(|f| f.role == Role::Fit);
    let converted = to_fit.map(|flight| other.converted(flight.clone()));
    tried_reliably(model, dataset, converted, options)
}

/// Faults of a gyroscope whose axes are those of a mirror image, if it may be so and the flights then fit in every respect.
pub fn mirrored(
    model: &Model,
    dataset: &Dataset,
    problem: &FitProblem,
    options: &FitOptions<'_>,
) -> Vec<DataFault> {
    if options.trust_data || options.known_faults.is_some() {
        return Vec::new();
    }
    let mut others = screening::mirrored(problem, dataset).into_iter();
    let found = others.find(|other| tried_with(other, model, dataset, options).is_some());
    let why = "only so does the angular momentum turn slowly, and the flights fit";
    found.map_or_else(Vec::new, |other| other.faults(dataset, why, false))
}

/// Faults of readings whose unit they do not tell by themselves: as they are, the flights have no fit or one that is not
/// to the noise, and in the other unit they fit in every respect.
pub fn other_unit(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    as_they_are: &Result<Fit, FitError>,
) -> Vec<DataFault> {
    if options.trust_data || options.known_faults.is_some() {
        return Vec::new();
    }
    let units = screening::undetermined(dataset);
    let fails = |fit: &Fit| lacks_fit(fit, options);
    let may_be_wrong = match as_they_are {
        Err(FitError::FaultyData(_)) => false,
        Err(_) => true,
        // Another unit leaves more than a little.
        Ok(fit) => !units.is_empty() && fails(fit).is_some_and(|(_, is_far)| is_far),
    };
    for unit in units.into_iter().filter(|_| may_be_wrong) {
        let found = tried_with(&unit, model, dataset, options);
        if found.is_some_and(|fit| unit.is_followed(dataset, &fit.report.sensors)) {
            let why = "the flights fit to the noise in this unit, and not as they are";
            return unit.faults(dataset, why, true);
        }
    }
    Vec::new()
}

/// Faults of poses whose positions and attitudes are in different frames: as they are, the fit is far from the noise, and
/// with attitudes turned far about the third axis, or with one coordinate negated, the flights fit in every respect, which of
/// several is the most usual. Smaller turns are those of an effect.
pub fn frames_of_poses(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    as_they_are: &Result<Fit, FitError>,
) -> Vec<DataFault> {
    let is_far = |fit: &&Fit| lacks_fit(fit, options).is_some_and(|(_, is_far)| is_far);
    let may_be_wrong = options.known_faults.is_none() && !options.trust_data;
    let found = as_they_are.as_ref().ok().filter(|_| may_be_wrong);
    let found = Poses::of(dataset).zip(found);
    let Some((pose, stated)) = found.filter(|(_, fit)| is_far(fit)) else {
        return Vec::new();
    };
    let problem = &stated.problem;
    let to_fit = || dataset.flights.iter().filter(|f| f.role == Role::Fit);
    let own = ModelTree::of(model);
    let turned = own.find_effect(ATTITUDE_TURNED);
    let Ok(turned) = turned.and_then(|effect| own.with(&effect)?.check()) else {
        return Vec::new();
    };
    let mut other = None;
    for degrees in [90.0, -90.0, 180.0] {
        if !pose.are_better(problem, |flight| pose.turned(flight, degrees)) {
            continue;
        }
        let to_fit = to_fit().map(|flight| pose.turned(flight, degrees));
        let found = tried_reliably(&turned, dataset, to_fit, options);
        let Some(left) = found.as_ref().and_then(turn_about_third) else {
            continue;
        };
        if left.abs() < NEARLY {
            return pose.faults_of_turn(left - degrees);
        }
        other = Some(left - degrees).filter(|by| by.abs() > FAR_TURN);
        break;
    }
    for axis in [1, 2, 0] {
        if !pose.are_better(problem, |flight| pose.negated(flight, axis)) {
            continue;
        }
        let negated = to_fit().map(|flight| pose.negated(flight, axis));
        if tried_reliably(model, dataset, negated, options).is_some() {
            return pose.faults_of_sign(axis);
        }
    }
    other.map_or_else(Vec::new, |by| pose.faults_of_turn(by))
}

/// Turn of the attitudes that a fit has found, degrees; `None` if it is about another than the third axis.
fn turn_about_third(fit: &Fit) -> Option<f64> {
    let [one, two, third] = TURNS.map(|name| fit.report.coefficients.get(name));
    let vanishes = |own: &Coefficient| own.value.abs() < SIGNIFICANT * own.std_error;
    let is_upright = [one?, two?].into_iter().all(vanishes);
    // The effect counts twice the tangent of half the angle.
    is_upright.then_some((2.0 * (0.5 * third?.value).atan()).to_degrees())
}

/// Whether the residuals of a fit are not noise, and whether they are far from it; `None` if they are too few to tell.
fn lacks_fit(fit: &Fit, options: &FitOptions<'_>) -> Option<(bool, bool)> {
    let test = LackOfFit::of_fit(fit, options.threads()).ok()??;
    let fails = test.fails(LACK_OF_FIT_LEVEL) || fit.report.is_above_noise();
    let is_far = fit.report.is_above_noise() || test.beyond_noise_m > test.noise_m;
    Some((fails, fails && is_far))
}

/// Whether a fault is inferred from loads that screening assumes.
fn rests_on_loads(fault: FaultKind) -> bool {
    matches!(
        fault,
        FaultKind::Axes | FaultKind::TimeUnit | FaultKind::Units | FaultKind::NotFreeFlight
    )
}

/// Whether the accelerations that the fit leaves are small compared with those that wrong data leave.
fn flies_as_recorded(fit: &Fit) -> bool {
    let flights = fit.fitted();
    let durations = flights.filter_map(|flight| {
        let times = &flight.observations.times;
        Some(times.last()? - times.first()?)
    });
    let left = fit.report.position_rms();
    median_of(durations)
        .zip(left)
        .is_some_and(|(duration, left)| left < BENDING * MAX_ACCELERATION * duration * duration)
}

/// Sentences on held coefficients that are more than [`MAX_PRIOR_CONFLICT`] standard errors from their estimates.
pub fn conflicts(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    held: &Fit,
) -> Vec<String> {
    let mut conflicts = Vec::new();
    for (place, (name, _)) in options.fixed.iter().enumerate() {
        let Some((_, value)) = held.problem.fixed.iter().find(|(own, _)| own == name) else {
            continue;
        };
        let mut others = options.fixed.to_vec();
        others.remove(place);
        let freed = FitOptions {
            fixed: &others,
            profiles: &[],
            known_faults: Some(&held.report.data_faults),
            ..*options
        };
        let fit = fit_within(model, dataset, &freed, Some(held)).ok();
        let Some(free) = fit.and_then(|fit| fit.report.coefficients.get(name).cloned()) else {
            continue;
        };
        // An estimate at a bound has no standard error: the data may tell nothing of it.
        if free.at_bound {
            continue;
        }
        let error = free
            .std_error
            .max(free.std_error_cluster_robust.unwrap_or(0.0));
        let conflict = (free.value - value).abs() / error;
        if conflict > MAX_PRIOR_CONFLICT {
            let digits = Digits::of(free.value, error);
            conflicts.push(format!(
                "the data contradict the held value {name} = {value}: they give {}, {conflict:.1} standard errors away",
                digits.one(free.value)
            ));
        }
    }
    conflicts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::channel::MARKER;
    use crate::fit::fit;
    use crate::fit::tests::balls;

    #[test]
    fn a_fit_that_leaves_accelerations_does_not_follow_the_recording() {
        let (model, dataset) = balls(3, 0.4);
        let mut found = fit(&model, &dataset, &FitOptions::default()).unwrap();
        assert!(flies_as_recorded(&found));
        // By an acceleration, m/s², in 0.4 s.
        let mut leaves = |acceleration: f64| {
            let position = found.report.residual_rms.get_mut(MARKER).expect("markers");
            position.value = BENDING * acceleration * 0.4 * 0.4;
            !flies_as_recorded(&found)
        };
        assert!(!leaves(1.5) && leaves(5.0));
    }
}
