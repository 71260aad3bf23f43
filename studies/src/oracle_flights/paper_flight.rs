//! The paper's two flights, simulated by the oracle.

use dataset::Dataset;
use flight::release;
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::{Physical, Point};

use super::constants::{CurveCoefficients, angle_of_attack, reference_of};
use super::dataset::{empty, even_times, marker_flight};
use super::integrate::{SMALL_STEP, integrate_with_constants};

/// Sample rate of the flights of Hubbard & Hummel (2000), Hz.
pub(crate) const SAMPLE_RATE: f64 = 120.0;

/// Angle of attack (rad) below which the pitching moment is set to 0 if it is given by a table.
const MIN_ALPHA: f64 = 1e-3;

/// Lift, drag and pitching-moment coefficients (moment nose-down positive, as in the model) as a function of the angle
/// of attack, rad.
pub type Curves<'c> = &'c dyn Fn(f64) -> [f64; 3];

/// Simulates a flight from Table 3 of Hubbard & Hummel (2000), `fssh3` or `bffl8`, with the disc of their Table 2,
/// without noise. `curves` replaces the model's coefficients of lift, drag and pitching moment; `None` keeps them.
///
/// # Panics
/// If the built-in release is missing, or if the reference simulator (`oracle`) has no law of motion for the model.
pub fn paper_flight(model: &Model, name: &str, curves: Option<Curves<'_>>) -> Dataset {
    let release = built_in_release(model, name);
    let reference = reference_of(model);
    let mut constants = Point::defaults(model);
    for (parameter, place) in model.params.iter().zip(&mut constants.params) {
        let mut set = release.parameters.iter();
        let set = set.find(|(name, _)| *name == parameter.name);
        *place = set.map_or(parameter.value, |(_, value)| *value);
    }
    let release::Stop::Duration(duration) = release.stop else {
        panic!("the paper's flights last a stated time");
    };
    let start = reference.chart.physical(&release.state());
    let times = even_times(duration, SAMPLE_RATE);
    let coefficients = CurveCoefficients::of(model, MIN_ALPHA);
    let set_curves = |body: &Physical<f64>, constants: &mut Point<f64>| {
        if let Some(curves) = curves {
            let alpha = angle_of_attack(body, Vector3::zeros());
            coefficients.set(constants, alpha, curves(alpha));
        }
    };
    let states = integrate_with_constants(
        &reference,
        &constants,
        &set_curves,
        start,
        &times,
        SMALL_STEP,
    );
    Dataset {
        parameters: release.parameters.iter().cloned().collect(),
        flights: vec![marker_flight(format!("{name}.csv"), times, &states)],
        ..empty(model)
    }
}

fn built_in_release(model: &Model, name: &str) -> release::Release {
    let text = release::built_in(name).expect("a built-in release");
    let vocabulary = release::Vocabulary::of(model);
    release::read(name, text, |_| Ok(vocabulary)).expect("a valid release")
}

/// Angle of attack (rad) at the release of a flight of Hubbard & Hummel (2000), given by its name.
///
/// # Panics
/// If the built-in release is missing, or if the reference simulator (`oracle`) has no law of motion for the model.
pub(crate) fn release_angle_of_attack(model: &Model, name: &str) -> f64 {
    let state = built_in_release(model, name).state();
    let body = reference_of(model).chart.physical(&state);
    angle_of_attack(&body, Vector3::zeros())
}
