//! The throw that would best distinguish the accepted hypotheses.

use flight::parallel;
use flight::throw::{RPM, Throw};
use identify::{
    FitProblem, Iterate, Loss, NoiseModel, NormalBlock, Observations, Unknowns, linearise,
    state_for_motion,
};
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use serde::{Deserialize, Serialize};

use super::information::{Alternative, information, separation};
use super::release::{draw, rigid_motion};
use crate::context::{ScoreTestModel, ThrowRanges};
use crate::error::DiagnosisError;
use crate::selection::Search;

/// Number of simulated throws, from which the throw that best distinguishes the hypotheses is chosen.
const THROWS: usize = 96;

/// Seed of the random launch conditions of the simulated throws.
const SEED: u64 = 1;

/// Minimum separation of the predictions of two hypotheses, in standard deviations, at which the hypotheses count as
/// distinguished.
const SUFFICIENT_SEPARATION: f64 = 3.0;

/// Minimum factor by which the best throw must increase the separation of the two hypotheses with the closest
/// predictions; otherwise the report states that no throw helps. The factor is relative to the present separation, or
/// to 1 if that is smaller. It does not apply to a throw that reaches [`SUFFICIENT_SEPARATION`].
const MIN_IMPROVEMENT: f64 = 1.3;

/// Name of the vector input from which a model that describes the body as a point mass reads the angular velocity,
/// rad/s.
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
    /// Hyzer angle: tilt of the disc about the velocity, rad; positive if the left edge, seen from behind, is the lower
    /// one.
    pub hyzer: f64,
    /// Spin rate about the axis of symmetry, rad/s; positive clockwise as seen from above, as of a right-handed
    /// backhand.
    pub spin: f64,
    /// Heading of the velocity in the horizontal plane, measured from the x axis towards the y axis, rad.
    pub heading: f64,
    /// Expected separation, after the throw, of the two hypotheses with the closest predictions, in standard
    /// deviations.
    pub separation: f64,
    /// Separation, by the present flights, of the two hypotheses with the closest predictions, in standard deviations.
    pub separation_now: f64,
}

/// Proposes the simulated throw that would most separate the two accepted hypotheses with the closest predictions;
/// `None` if fewer than two hypotheses are accepted, or no throw can be simulated.
///
/// # Errors
/// [`DiagnosisError::Fit`] if a measured flight cannot be integrated.
pub(crate) fn proposed_throw(
    model: &ScoreTestModel<'_>,
    search: &Search,
) -> Result<Option<ProposedThrow>, DiagnosisError> {
    let ranges = &model.context.options.throws;
    let hypotheses = search.accepted.as_slice();
    let [best, _, ..] = hypotheses else {
        return Ok(None);
    };
    let noise = &search.noise;
    let (problem, iterate) = (&best.problem, &best.iterate);
    let blocks = model.normal_equations(problem, iterate, noise)?;
    let Some(known) = information(model, &blocks) else {
        return Ok(None);
    };
    let each = hypotheses.iter().map(|h| Alternative::new(model, h));
    let alternatives: Vec<Alternative> = each.collect();
    let now = separation(&model.base, &alternatives, &known);
    let mut random = ChaCha12Rng::seed_from_u64(SEED);
    let throws: Vec<Throw> = (0..THROWS).map(|_| draw(ranges, &mut random)).collect();
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
    Ok(best.map(|(after, throw)| ProposedThrow::new(throw, after, now)))
}

/// Normal equations of a simulated flight of the throw `throw`, under the conditions of the measured
/// flight `like`, linearized at the unknowns `at`; `None` if the model cannot start from these launch conditions or
/// cannot be integrated.
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
        problem.has_attitude,
        problem.body.layout().components(ANGULAR_VELOCITY),
    ) {
        let spin = rigid_motion(throw, true).rates?;
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
        ..like.clone()
    };
    let motion = rigid_motion(throw, problem.has_attitude);
    let local = state_for_motion(problem, &observations, &motion).ok()?;
    let unknowns = (&at.global, &local);
    let loss = Loss::Whitened(noise);
    linearise(
        problem,
        &observations,
        unknowns,
        samples,
        Unknowns::All,
        loss,
    )
    .ok()
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
    if after < SUFFICIENT_SEPARATION && after < MIN_IMPROVEMENT * now.max(1.0) {
        return format!(
            "no throw helps: after the best of {THROWS} simulated throws the closest explanations would be {after:.1} standard \
             deviations apart ({now:.1} now); measure their parameters by other means"
        );
    }
    format!(
        "throw at {:.0} m/s, launch angle {:.0}°, nose angle {:.0}°, hyzer angle {:.0}°, spin {:.0} rpm, heading {:.0}°: the \
         closest explanations would be {after:.1} standard deviations apart ({now:.1} now)",
        throw.speed,
        throw.launch,
        throw.nose.unwrap_or(0.0),
        throw.hyzer.unwrap_or(0.0),
        throw.spin.unwrap_or(0.0),
        throw.heading
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_throw_is_recommended_only_if_it_helps() {
        let throw = Throw {
            launch: 6.0,
            nose: Some(0.0),
            hyzer: Some(11.0),
            spin: Some(570.0),
            ..Throw::at_speed(20.0)
        };
        let text = sentence(&throw, 5.0, 4.5);
        assert!(
            text.starts_with("throw at 20 m/s, launch angle 6°"),
            "{text}"
        );
        assert!(
            text.contains("hyzer angle 11°, spin 570 rpm, heading 0°"),
            "{text}"
        );
        assert!(sentence(&throw, 2.0, 1.0).starts_with("throw"));
        assert!(sentence(&throw, 1.2, 1.0).starts_with("no throw helps"));
    }
}
