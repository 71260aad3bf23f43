//! The paper's two flights, flown by the oracle.

use flight::release;
use identify::dataset::{Dataset, Flight, Role};
use identify::synthesize::MARKERS;
use model_spec::model::Model;
use oracle::physical::Physical;
use oracle::point::Point;
use oracle::reference::Reference;

use crate::oracle_flights::dataset::empty;
use crate::oracle_flights::integrate::{fly_with, markers};
use crate::real_data::wind_tunnel::{Measured, interpolated};

/// Samples each second.
pub const RATE: f64 = 120.0;

/// A flight of the paper's Table 3 by the disc of its Table 2: with the model's own coefficients, or with lift, drag and
/// pitching moment as a wind tunnel measured them.
///
/// # Panics
/// Where a built-in model or release is broken.
pub fn paper_flight(model: &Model, name: &str, tunnel: Option<&[Measured]>) -> Dataset {
    let read = released(model, name);
    let reference = Reference::bind(model)
        .expect("a reference")
        .expect("its names");
    let mut constants = Point::defaults(model);
    for (constant, place) in model.params.iter().zip(&mut constants.params) {
        let mut set = read.parameters.iter();
        let set = set.find(|(name, _)| *name == constant.name);
        *place = set.map_or(constant.value, |(_, value)| *value);
    }
    let release::Stop::Duration(duration) = read.stop else {
        panic!("the paper's flights last a stated time");
    };
    let start = reference.chart.physical(&read.state());
    let samples = (duration * RATE).round() as usize;
    let times: Vec<f64> = (0..=samples).map(|k| k as f64 / RATE).collect();
    let follow = |body: &Physical<f64>| match tunnel {
        Some(rows) => measured_at(model, &constants, rows, body),
        None => constants.clone(),
    };
    let flown = fly_with(&reference, &follow, start, &times);
    let mut dataset = empty(model);
    dataset.parameters = read.parameters.iter().cloned().collect();
    dataset.flights = vec![Flight {
        file: format!("{name}.csv"),
        role: Role::Fit,
        known: Default::default(),
        positions: flown
            .iter()
            .map(|body| markers(body, &MARKERS).into_iter().map(Some).collect())
            .collect(),
        times,
    }];
    dataset
}

fn released(model: &Model, name: &str) -> release::Release {
    let text = release::built_in(name).expect("a built-in release");
    let vocabulary = release::Vocabulary::of(model);
    release::read(name, text, |_| Ok(vocabulary)).expect("a good release")
}

/// The angle of attack that a flight of the paper is released at, rad.
///
/// # Panics
/// Where a built-in model or release is broken.
pub fn released_at(model: &Model, name: &str) -> f64 {
    let reference = Reference::bind(model)
        .expect("a reference")
        .expect("its names");
    angle_of_attack(&reference.chart.physical(&released(model, name).state()))
}

/// The angle of attack in still air, rad.
fn angle_of_attack(body: &Physical<f64>) -> f64 {
    let through = body.attitude.bring_back(body.velocity);
    (-through.z).atan2(through.x.hypot(through.y))
}

/// The constants with which the model's curves pass through the tunnel's at the body's angle of attack.
fn measured_at(
    model: &Model,
    constants: &Point<f64>,
    rows: &[Measured],
    body: &Physical<f64>,
) -> Point<f64> {
    let alpha = angle_of_attack(body);
    let [lift, drag, moment] = interpolated(rows, alpha);
    let mut here = constants.clone();
    let mut set = |name: &str, value: f64| {
        if let Some(place) = model.coefficients.iter().position(|c| c.name == name) {
            here.coefficients[place] = value;
        }
    };
    set("C_L0", lift);
    set("C_La", 0.0);
    set("C_D0", drag);
    set("C_Da", 0.0);
    // The model's moment is a multiple of the angle, which near 0 no multiple can lift off 0.
    let slope = if alpha.abs() > 1e-3 {
        moment / alpha
    } else {
        0.0
    };
    set("C_Ma", slope);
    here
}
