//! Discrimination (T-optimal) design: the throw that would best distinguish the accepted hypotheses.

use dataset::pose::RigidMotion;
use flight::parallel;
use flight::throw::{Motion, RPM, Throw, release_axes};
use identify::{
    FitProblem, FlightAt, Iterate, Loss, NoiseModel, NormalBlock, Observations, Unknowns,
    eliminate, pseudo_inverse, state_for_motion,
};
use model_spec::model::FlightAxes;
use nalgebra::{DMatrix, DVector, Rotation3, UnitQuaternion};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use serde::{Deserialize, Serialize};

use crate::context::{ColumnId, ScoreTestModel, ThrowRanges, select};
use crate::noise::DAMPING;
use crate::selection::{Hypothesis, Search};

/// Number of simulated throws, from which the best one is chosen, and seed of their random launch conditions.
const DRAWN: (usize, u64) = (96, 1);

/// Separation at which hypotheses are distinguished, standard deviations, and minimum factor, relative to the present
/// separation or 1, by which another throw must help.
const SEPARATION: (f64, f64) = (3.0, 1.3);

/// Input from which a point mass reads its angular velocity, rad/s.
const ANGULAR_VELOCITY: &str = "omega";

/// Launch conditions of the proposed next throw, which would best distinguish the accepted hypotheses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProposedThrow {
    /// Sentence that describes the throw, or states that no throw helps.
    pub description: String,
    /// Speed of the body at release, m/s.
    pub speed: f64,
    /// Launch angle: angle of the velocity above the horizontal, rad.
    pub launch: f64,
    /// Nose angle: angle of attack at release, positive nose up, rad.
    pub nose: f64,
    /// Hyzer angle: tilt about the velocity, rad; positive if the left edge, from behind, is lower.
    pub hyzer: f64,
    /// Spin rate, rad/s; positive clockwise from above, as of a right-handed backhand.
    pub spin: f64,
    /// Heading of the velocity in the horizontal plane, measured from the x axis towards the y axis, rad.
    pub heading: f64,
    /// Expected separation of the closest two hypotheses after the throw, standard deviations.
    pub separation: f64,
    /// Separation, by the present flights, of the two hypotheses with the closest predictions, in standard deviations.
    pub separation_now: f64,
}

/// The simulated throw that most separates the closest two accepted hypotheses; `None` for fewer than two.
pub(crate) fn proposed_throw(model: &ScoreTestModel<'_>, search: &Search) -> Option<ProposedThrow> {
    let ranges = &model.context.options.throws;
    let hypotheses = search.accepted.as_slice();
    let [best, _, ..] = hypotheses else {
        return None;
    };
    let noise = &search.noise;
    let (problem, iterate) = (&best.problem, &best.iterate);
    let blocks = model.normal_equations(problem, iterate, noise).ok()?;
    let known = information(model, &blocks)?;
    let each = hypotheses.iter().map(|h| Alternative::new(model, h));
    let alternatives: Vec<Alternative> = each.collect();
    let now = separation(&model.base, &alternatives, &known);
    let mut random = ChaCha12Rng::seed_from_u64(DRAWN.1);
    let throws: Vec<Throw> = (0..DRAWN.0).map(|_| draw(ranges, &mut random)).collect();
    let after = parallel::each_on(model.threads(), throws.len(), |index| {
        let flight = (&model.flights[0], &throws[index]);
        let block = simulated(problem, flight, ranges, iterate, noise)?;
        let more = information(model, &[block])?;
        Some(separation(&model.base, &alternatives, &(&known + more)))
    });
    let each = after.into_iter().zip(&throws);
    let best = each
        .filter_map(|(after, throw)| Some((after?, throw)))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(after, throw)| ProposedThrow::new(throw, after, now))
}

/// Normal equations of a simulated flight of `throw` under the conditions of `like`, at the unknowns `at`.
fn simulated(
    problem: &FitProblem,
    (like, throw): (&Observations, &Throw),
    ranges: &ThrowRanges,
    at: &Iterate,
    noise: &NoiseModel,
) -> Option<NormalBlock> {
    let samples = (ranges.duration * ranges.rate) as usize;
    let points = samples * problem.channels.len();
    let mut parameters = like.parameters.clone();
    if let (false, Some(components)) = (
        problem.points.has_attitude,
        problem.body.layout().components(ANGULAR_VELOCITY),
    ) {
        let spin = rigid_motion(throw, true, FlightAxes::default()).rates?;
        for (component, value) in components.iter().zip(spin.iter()) {
            parameters[component.index()] = *value;
        }
    }
    let observations = Observations {
        times: (0..samples).map(|k| k as f64 / ranges.rate).collect(),
        measured: vec![Some([0.0; 3]); points],
        outlier: vec![false; points],
        parameters,
        known_states: Vec::new(),
        stand_ins: Vec::new(),
        // That of `like` bounds the error along its own path.
        tolerance_factor: 1.0,
        ..like.clone()
    };
    let axes = problem.model.flight_axes();
    let axes = axes.map_or_else(FlightAxes::default, |(_, axes)| axes);
    let motion = rigid_motion(throw, problem.points.has_attitude, axes);
    let local = state_for_motion(problem, &observations, &motion).ok()?;
    let at = FlightAt::new(problem, &observations, (&at.global, &local));
    at.linearise(Unknowns::All, Loss::Whitened(noise)).ok()
}

impl ProposedThrow {
    fn new(throw: &Throw, after: f64, now: f64) -> Self {
        let radians = |degrees: Option<f64>| degrees.unwrap_or(0.0).to_radians();
        Self {
            description: sentence(throw, after, now),
            speed: throw.speed,
            launch: throw.launch.to_radians(),
            nose: radians(throw.nose),
            hyzer: radians(throw.hyzer),
            spin: throw.spin.unwrap_or(0.0) * RPM,
            heading: throw.heading.to_radians(),
            separation: after,
            separation_now: now,
        }
    }
}

/// Describes a throw in the numbers of a release's `[throw]`, or states that no throw helps.
fn sentence(throw: &Throw, after: f64, now: f64) -> String {
    if after < SEPARATION.0 && after < SEPARATION.1 * now.max(1.0) {
        return format!(
            "no throw helps: after the best of {} simulated throws the closest explanations would be {after:.1} standard \
             deviations apart ({now:.1} now); measure their parameters by other means",
            DRAWN.0
        );
    }
    // A rounded -0.2 is 0, not -0.
    let whole = |value: f64| value.round() + 0.0;
    format!(
        "throw at {:.0} m/s, launch angle {:.0}°, nose angle {:.0}°, hyzer angle {:.0}°, spin {:.0} rpm, heading {:.0}°: the \
         closest explanations would be {after:.1} standard deviations apart ({now:.1} now)",
        throw.speed,
        whole(throw.launch),
        whole(throw.nose.unwrap_or(0.0)),
        whole(throw.hyzer.unwrap_or(0.0)),
        whole(throw.spin.unwrap_or(0.0)),
        whole(throw.heading)
    )
}

// Separation of hypotheses by the information in the flights.

/// Information of the global unknowns; `None` if a flight does not determine its local parameters.
fn information(model: &ScoreTestModel<'_>, blocks: &[NormalBlock]) -> Option<DMatrix<f64>> {
    let size = model.global_columns();
    let mut sum = DMatrix::zeros(size, size);
    for block in blocks {
        let system = eliminate(std::slice::from_ref(block), DAMPING).ok()?;
        sum += system.reduced.view((0, 0), (size, size));
    }
    Some(sum)
}

/// Differences of the fitted coefficients of a hypothesis from their null values.
struct Alternative {
    columns: Vec<ColumnId>,
    /// Fitted value less null value of each of `columns`, SI.
    largest_misfits: Vec<f64>,
}

impl Alternative {
    /// Computes the fitted minus the null value of every coefficient of the hypothesis.
    pub fn new(model: &ScoreTestModel<'_>, hypothesis: &Hypothesis) -> Self {
        let effects = hypothesis.effects.iter();
        let columns: Vec<ColumnId> = effects
            .flat_map(|&e| model.columns_of(e))
            .copied()
            .collect();
        let departure = |column: &ColumnId| {
            let null_value = model.problem.globals[column.index()].model_value;
            hypothesis.iterate.global[column.index()] - null_value
        };
        Self {
            largest_misfits: columns.iter().map(departure).collect(),
            columns,
        }
    }
}

/// Smallest separation among all ordered pairs of hypotheses, in standard deviations: the square root of the χ² that
/// remains when the second, with `nuisance`, is fitted to the predictions of the first. 0 if none has a column that
/// another lacks.
fn separation(
    nuisance: &[ColumnId],
    hypotheses: &[Alternative],
    information: &DMatrix<f64>,
) -> f64 {
    let mut least = f64::INFINITY;
    for truth in hypotheses {
        for other in hypotheses {
            let own = truth.columns.iter().zip(&truth.largest_misfits);
            let own = own.filter(|(column, _)| !other.columns.contains(column));
            let (own, largest_misfits): (Vec<ColumnId>, Vec<f64>) = own.unzip();
            if own.is_empty() {
                continue;
            }
            let free: Vec<ColumnId> = nuisance.iter().chain(&other.columns).copied().collect();
            let Some(inverse) = pseudo_inverse(&select(information, &free, &free)) else {
                continue;
            };
            let cross = select(information, &free, &own);
            let effective = select(information, &own, &own) - cross.tr_mul(&(inverse * &cross));
            let largest_misfits = DVector::from_vec(largest_misfits);
            let chi2 = largest_misfits
                .dot(&(effective * &largest_misfits))
                .max(0.0);
            least = least.min(chi2.sqrt());
        }
    }
    if least.is_finite() { least } else { 0.0 }
}

// Random throws for the experimental design.

/// Draws a random throw, its launch conditions uniformly distributed within the ranges.
fn draw(ranges: &ThrowRanges, random: &mut impl Rng) -> Throw {
    let mut uniform = |(low, high): (f64, f64)| low + (high - low) * random.random::<f64>();
    let headings = ranges.headings as f64;
    Throw {
        speed: uniform(ranges.speed),
        launch: uniform(ranges.launch).to_degrees(),
        nose: Some(uniform(ranges.nose).to_degrees()),
        hyzer: Some(uniform(ranges.hyzer).to_degrees()),
        heading: uniform((0.0, headings)).floor() / headings * 360.0,
        spin: Some(uniform(ranges.spin) / RPM * if uniform((0.0, 1.0)) < 0.5 { 1.0 } else { -1.0 }),
        height: ranges.height,
        wobble: None,
    }
}

/// Motion at release; a point mass has no attitude.
fn rigid_motion(throw: &Throw, has_attitude: bool, axes: FlightAxes) -> RigidMotion {
    let Motion {
        position,
        velocity,
        turning,
    } = throw.motion([0.0; 2], has_attitude, axes.is_along());
    let attitude = turning.as_ref().map(|turning| {
        let rotation =
            Rotation3::from_matrix_unchecked(turning.axes * release_axes(axes).transpose());
        UnitQuaternion::from_rotation_matrix(&rotation)
    });
    RigidMotion {
        position,
        velocity,
        attitude,
        rates: turning.map(|turning| turning.rates),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha12Rng;

    #[test]
    fn a_throw_is_recommended_only_if_it_helps() {
        let throw = Throw {
            launch: 6.0,
            nose: Some(-0.2),
            hyzer: Some(11.0),
            spin: Some(570.0),
            ..Throw::at_speed(20.0)
        };
        let text = sentence(&throw, 5.0, 4.5);
        assert!(
            text.starts_with("throw at 20 m/s, launch angle 6°, nose angle 0°"),
            "{text}"
        );
        assert!(
            text.contains("hyzer angle 11°, spin 570 rpm, heading 0°"),
            "{text}"
        );
        assert!(sentence(&throw, 2.0, 1.0).starts_with("throw"));
        assert!(sentence(&throw, 1.2, 1.0).starts_with("no throw helps"));
    }

    #[test]
    fn hypotheses_are_as_far_apart_as_their_columns_are_independent() {
        let alternative = |column: usize| Alternative {
            columns: vec![ColumnId::new(column)],
            largest_misfits: vec![2.0],
        };
        let both = [alternative(0), alternative(1)];
        // Orthogonal columns: the other hypothesis explains nothing.
        let found = separation(&[], &both, &(DMatrix::identity(2, 2) * 9.0));
        assert!((found - 6.0).abs() < 1e-9, "{found}");
        // Correlation 0.8: 1 − R² = 0.36.
        let correlated = DMatrix::from_row_slice(2, 2, &[9.0, 7.2, 7.2, 9.0]);
        let found = separation(&[], &both, &correlated);
        assert!((found - 6.0 * 0.6).abs() < 1e-9, "{found}");
        assert_eq!(separation(&[], &both[..1], &correlated), 0.0);
    }

    #[test]
    fn throws_lie_within_their_ranges_and_have_their_angles() {
        let ranges = ThrowRanges::default();
        let mut random = ChaCha12Rng::seed_from_u64(1);
        for _ in 0..100 {
            let throw = draw(&ranges, &mut random);
            let within = |value: f64, (low, high): (f64, f64)| (low..=high).contains(&value);
            let (nose, spin) = (throw.nose.unwrap().to_radians(), throw.spin.unwrap() * RPM);
            assert!(within(throw.speed, ranges.speed) && within(nose, ranges.nose));
            assert!(within(spin.abs(), ranges.spin), "{throw:?}");
            let motion = rigid_motion(&throw, true, FlightAxes::default());
            let velocity = motion.velocity;
            assert!((velocity.norm() - throw.speed).abs() < 1e-9);
            assert!((velocity.z - throw.speed * throw.launch.to_radians().sin()).abs() < 1e-9);
            // The angle of attack is the angle of the velocity in the body frame.
            let attitude = motion.attitude.unwrap();
            let in_body = attitude.inverse() * velocity;
            let attack = (-in_body.z).atan2(in_body.x);
            assert!((attack - nose).abs() < 1e-9, "{attack} {throw:?}");
            // The left edge is the lower one where the hyzer angle is positive.
            let left = attitude * nalgebra::Vector3::y();
            assert!(left.z * throw.hyzer.unwrap() <= 0.0, "{left} {throw:?}");
            // Clockwise as seen from above is a rotation about the downward direction.
            let upwards = motion
                .rates
                .unwrap()
                .dot(&(attitude * nalgebra::Vector3::z()));
            assert!((upwards + spin).abs() < 1e-9, "{upwards} {throw:?}");
        }
    }
}
