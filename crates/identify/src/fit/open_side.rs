//! Recordings that leave open which side of a body is up, or which hand their axes are of.

use model_spec::compose::Instrument;

use crate::channel::ChannelKind;
use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::screening::{MEND, is_upside_down};

/// Why the recordings leave open which side of the body is up, or which hand their axes are of, and what to check; `None`
/// if they show it. The path of a point shows no hand: only a known spin, whose force is then the opposite, does.
pub fn open_side(problem: &FitProblem, flights: &[Observations]) -> Option<String> {
    if has_instruments_alone(problem) {
        return Some("nothing but the instruments shows the axes of the body; check their axes (`gyroscope_axes` and `accelerometer_axes` in [recording])".into());
    }
    if !problem.points.has_attitude && problem.sees_positions() {
        return Some(format!(
            "the path of a point does not show whether the axes are left-handed: if they are, {MEND}; otherwise check the signs of what the flights state, such as a spin"
        ));
    }
    let poses = flights.iter().map(|flight| flight.poses(problem));
    is_upside_down(problem, poses).then(|| {
        format!(
            "in all flights the body is upside down, as left-handed axes or exchanged labels show it: if they do, {MEND}"
        )
    })
}

fn has_instruments_alone(problem: &FitProblem) -> bool {
    let mut channels = problem.channels.iter();
    !problem.sees_positions()
        && channels.all(|own| own.kind != ChannelKind::Attitude)
        && problem
            .instruments
            .iter()
            .any(|(kind, _)| matches!(kind, Instrument::Gyroscope | Instrument::Accelerometer))
}

#[cfg(test)]
mod tests {
    use crate::fit::tests::simulated;
    use crate::fit::{Fit, fit};
    use crate::options::FitOptions;
    use dataset::synthesize::Plan;

    /// Fit of two flights of a disc, whose coordinates y are multiplied by `y`.
    fn fitted(y: f64) -> Fit {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 2,
            duration: Some(0.8),
            ..Plan::default()
        };
        let mut dataset = simulated(&model, "backhand", &plan);
        let flights = dataset.flights.iter_mut();
        let rows = flights.flat_map(|flight| flight.positions.iter_mut().flatten());
        rows.flatten().for_each(|point| point[1] *= y);
        fit(&model, &dataset, &FitOptions::default()).unwrap()
    }

    #[test]
    fn left_handed_axes_of_two_flights_are_told() {
        assert_eq!(fitted(1.0).report.cautions, Vec::<String>::new());
        let told = fitted(-1.0).report.cautions;
        let of_axes = told.iter().find(|own| own.contains("left-handed axes"));
        assert!(
            of_axes.is_some_and(|own| own.starts_with("C_L0")),
            "{told:?}"
        );
    }

    #[test]
    fn negatives_of_declared_coefficients_are_told_where_the_side_of_the_body_is_open() {
        let mut report = fitted(1.0).report;
        let mut told = |is_open: bool, sign: f64| {
            report.open_side = is_open.then(|| "the side is open".to_owned());
            let lift = report.coefficients.get_mut("C_L0").expect("estimated");
            lift.value = sign * 1.05 * lift.model_value;
            report.assess();
            report
                .cautions
                .iter()
                .any(|own| own.starts_with("C_L0: the sign"))
        };
        assert!(told(true, -1.0));
        assert!(!told(true, 1.0));
        assert!(!told(false, -1.0));
    }
}
