//! Trial fits: of data whose faults may be loads of the model, of readings in another unit, and of values that the user
//! holds.

use model_spec::compose::ModelTree;

use super::{Fit, FitError, Task};
use crate::numbers::Digits;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use crate::report::{Coefficient, LACK_OF_FIT_LEVEL, LackOfFit, MAX_PRIOR_CONFLICT};
use dataset::levels::SIGNIFICANT;
use dataset::screening::{self, OtherMeaning, Poses};
use dataset::statistics::median_of;
use dataset::{DataFault, FaultKind};
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

impl Task<'_> {
    /// Removes faults that all flights have in common if they rest on accelerations, which screening compares with usual
    /// loads, and the model describes the data as they are.
    pub fn remove_refuted(self, faults: &mut Vec<DataFault>) {
        let is_common = |flight: &&Flight| {
            let mut own = faults.iter().filter(|fault| fault.file == flight.file);
            own.clone().next().is_some() && own.all(|fault| rests_on_loads(fault.fault))
        };
        let tracks = self.fitted();
        let tracks = tracks.filter(|flight| !self.dataset.is_summary(flight));
        if self.options.trust_data || !tracks.clone().all(|flight| is_common(&flight)) {
            return;
        }
        if let Some(fit) = self.tried(tracks.cloned()) {
            let is_noise = lacks_fit(&fit, self.options).is_some_and(|(fails, _)| !fails);
            faults.retain(|fault| match fault.fault {
                // A hand pushes about as hard as the model may.
                FaultKind::NotFreeFlight => !is_noise,
                kind => !(rests_on_loads(kind) && flies_as_recorded(&fit)),
            });
        }
    }

    /// The flights with the role `fit`.
    fn fitted(&self) -> impl Iterator<Item = &Flight> + Clone {
        let flights = self.dataset.flights.iter();
        flights.filter(|flight| flight.role == Role::Fit)
    }

    /// Fit of a few of `flights`, which take the place of those of the dataset, as they are; `None` if it has no result.
    fn tried(self, flights: impl Iterator<Item = Flight>) -> Option<Fit> {
        let few = Dataset {
            flights: flights.take(FLIGHTS).collect(),
            ..self.dataset.clone()
        };
        let as_they_are = FitOptions {
            known_faults: Some(&[]),
            profiles: &[],
            ..*self.options
        };
        let task = Task {
            dataset: &few,
            options: &as_they_are,
            ..self
        };
        task.fit(None).ok()
    }

    /// [`tried`](Self::tried), if the fit is reliable, also by the tests of its residuals.
    fn tried_reliably(self, flights: impl Iterator<Item = Flight>) -> Option<Fit> {
        let fit = self.tried(flights)?;
        let tested = fit.with_lack_of_fit(self.options.threads()).ok();
        tested.filter(|fit| fit.report.reliable)
    }

    /// Reliable fit of a few flights with readings of another meaning.
    fn tried_with(self, other: &OtherMeaning) -> Option<Fit> {
        self.tried_reliably(self.fitted().map(|flight| other.converted(flight.clone())))
    }

    /// Whether the readings may be meant otherwise than stated: the user does not trust them, and they were not judged before.
    fn is_open(self) -> bool {
        !self.options.trust_data && self.options.known_faults.is_none()
    }

    /// Faults of a gyroscope whose axes are those of a mirror image, if it may be so and the flights then fit in every
    /// respect.
    pub fn mirrored(self, problem: &FitProblem) -> Vec<DataFault> {
        if !self.is_open() {
            return Vec::new();
        }
        let mut others = screening::mirrored(problem, self.dataset).into_iter();
        let found = others.find(|other| self.tried_with(other).is_some());
        let why = "only so does the angular momentum turn slowly, and the flights fit";
        found.map_or_else(Vec::new, |other| other.faults(self.dataset, why, false))
    }

    /// Faults of readings whose unit they do not tell by themselves: as they are, the flights have no fit or one that is not
    /// to the noise, and in the other unit they fit in every respect.
    pub fn other_unit(self, as_they_are: &Result<Fit, FitError>) -> Vec<DataFault> {
        if !self.is_open() {
            return Vec::new();
        }
        let mut units = screening::undetermined(self.dataset).into_iter();
        let may_be_wrong = match as_they_are {
            Err(FitError::FaultyData(_)) => false,
            Err(_) => true,
            // Another unit leaves more than a little.
            Ok(fit) => units.len() > 0 && self.is_far_from_noise(fit),
        };
        let is_meant = |unit: &OtherMeaning| {
            let found = self.tried_with(unit);
            found.is_some_and(|fit| {
                unit.is_followed(self.dataset, |name| {
                    let mut sensors = fit.report.sensors.iter();
                    let sensor = sensors.find(|own| own.name == name);
                    sensor.map(|own| own.rms)
                })
            })
        };
        let found = units.find(|unit| may_be_wrong && is_meant(unit));
        let why = "the flights fit to the noise in this unit, and not as they are";
        found.map_or_else(Vec::new, |unit| unit.faults(self.dataset, why, true))
    }

    fn is_far_from_noise(self, fit: &Fit) -> bool {
        lacks_fit(fit, self.options).is_some_and(|(_, is_far)| is_far)
    }

    /// Faults of poses whose positions and attitudes are in different frames: as they are, the fit is far from the noise,
    /// and with attitudes turned far about the third axis, or with one coordinate negated, the flights fit in every respect,
    /// which of several is the most usual. Smaller turns are those of an effect.
    pub fn frames_of_poses(self, as_they_are: &Result<Fit, FitError>) -> Vec<DataFault> {
        let found = as_they_are.as_ref().ok().filter(|_| self.is_open());
        let found = Poses::of(self.dataset).zip(found);
        let Some((pose, stated)) = found.filter(|(_, fit)| self.is_far_from_noise(fit)) else {
            return Vec::new();
        };
        let problem = &stated.problem;
        let own = ModelTree::of(self.model);
        let turned = own.find_effect(ATTITUDE_TURNED);
        let Ok(turned) = turned.and_then(|effect| own.with(&effect)?.check()) else {
            return Vec::new();
        };
        let with_turn = Task {
            model: &turned,
            ..self
        };
        let mut other = None;
        for degrees in [90.0, -90.0, 180.0] {
            let turned = |flight: &Flight| pose.turned(flight, degrees);
            if !pose.are_better(problem, turned) {
                continue;
            }
            let found = with_turn.tried_reliably(self.fitted().map(turned));
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
            let negated = |flight: &Flight| pose.negated(flight, axis);
            if pose.are_better(problem, negated)
                && self.tried_reliably(self.fitted().map(negated)).is_some()
            {
                return pose.faults_of_sign(axis);
            }
        }
        other.map_or_else(Vec::new, |by| pose.faults_of_turn(by))
    }

    /// Sentences on held coefficients that are more than [`MAX_PRIOR_CONFLICT`] standard errors from their estimates.
    pub fn conflicts(self, held: &Fit) -> Vec<String> {
        let fixed = self.options.fixed.iter().enumerate();
        let each = fixed.filter_map(|(place, (name, _))| {
            let (_, value) = held.problem.fixed.iter().find(|(own, _)| own == name)?;
            let mut others = self.options.fixed.to_vec();
            others.remove(place);
            let freed = FitOptions {
                fixed: &others,
                profiles: &[],
                known_faults: Some(&held.report.data_faults),
                ..*self.options
            };
            let task = Task {
                options: &freed,
                ..self
            };
            let fit = task.fit(Some(held)).ok()?;
            let free = fit.report.coefficients.get(name)?;
            let clustered = free.std_error_cluster_robust.unwrap_or(0.0);
            let error = free.std_error.max(clustered);
            let conflict = (free.value - value).abs() / error;
            // An estimate at a bound has no standard error: the data may tell nothing of it.
            (!free.at_bound && conflict > MAX_PRIOR_CONFLICT).then(|| {
                format!(
                    "the data contradict the held value {name} = {value}: they give {}, {conflict:.1} standard errors away",
                    Digits::of(free.value, error).one(free.value)
                )
            })
        });
        each.collect()
    }
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
