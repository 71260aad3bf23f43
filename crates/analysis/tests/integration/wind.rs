//! Throws in winds by height and gusts: derivatives of landings, scatter of the wind, and the release that is written.

use crate::support;
use analysis::design::{
    Bounds, By, Goal, Scattered, SearchOptions, ThrownBody, design, landing_covariance,
};
use flight::release::{Release, Stop, Vocabulary, read_in_wind};
use flight::throw::Throw;
use model_spec::model::Model;
use nalgebra::Vector3;
use ode::{IntegrationOptions, Method};

const WIND: &str = "[wind]\nprofile = \"log\"\nspeed = 5.0\ndirection = 120.0\nreference_height = 6.0\nroughness = 0.1\n[wind.gusts]\nmodel = \"dryden\"\nseed = 4\n";
const POWER: &str = "[wind]\nprofile = \"power\"\nspeed = 5.0\ndirection = 120.0\n[wind.gusts]\nmodel = \"dryden\"\nseed = 4\nsd = [1.5, 1.0, 0.5]\nlength = [20.0, 10.0, 3.0]\n";

fn tight() -> IntegrationOptions {
    IntegrationOptions {
        method: Method::Dop853,
        ..IntegrationOptions::with_tolerance(1e-12)
    }
}

fn throw() -> Throw {
    Throw {
        launch: 9.0,
        height: 1.5,
        nose: Some(2.0),
        hyzer: Some(8.0),
        spin: Some(650.0),
        ..Throw::at_speed(18.0)
    }
}

/// Compiles a model with the wind given by the TOML text `wind`; returns the body and a release in this wind.
fn in_wind(model: &Model, wind: &str) -> (ThrownBody, Release) {
    let text = format!(
        "model = {:?}\nuntil = \"ground\"\n[throw]\nspeed = 18.0\n{wind}",
        model.name
    );
    let names = |_: &str| Ok(Vocabulary::of(model));
    let (release, names) = read_in_wind("r.toml", &text, &[], names).expect("a release");
    let model = names.model.expect("a model");
    (
        ThrownBody::new(Model::clone(&model)).expect("a body"),
        release,
    )
}

#[test]
fn derivatives_by_the_wind_are_the_slopes_of_flights() {
    let disc = support::body("disc").model;
    let plate = support::plate().model;
    let log = [
        "wind_speed",
        "wind_direction",
        "wind_reference_height",
        "wind_roughness",
        "gust_height",
    ];
    let power = [
        "wind_speed",
        "wind_exponent",
        "gust_sd_u",
        "gust_length_w",
        "gust_phase_w_9",
        "gust_heading",
    ];
    for (model, wind, names) in [
        (&disc, WIND, &log[..]),
        (&plate, WIND, &log[..]),
        (&plate, POWER, &power[..]),
    ] {
        let (body, release) = in_wind(model, wind);
        let layout = body.compiled.layout();
        let mut names = names.to_vec();
        names.push("gust_intensity");
        let places = names
            .iter()
            .map(|name| layout.parameter(name).expect(name).index());
        let places: Vec<usize> = places.collect();
        let by: Vec<By> = places.iter().map(|k| By::Parameter(*k)).collect();
        let flights = body.with(&release);
        let exact = flights
            .fly_with_derivatives(&throw(), None, &by, &tight())
            .expect("a flight")
            .landing();
        for (k, place) in places.iter().enumerate() {
            let step = 1e-4 * flights.parameters[*place].abs().max(0.1);
            let at = |steps: f64| {
                let mut parameters = flights.parameters.clone();
                parameters[*place] += steps * step;
                let moved = body.with_parameters(parameters);
                moved
                    .fly(&throw(), None, &tight())
                    .expect("a flight")
                    .landing()
                    .position
            };
            let slope = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step);
            let error = (slope - exact.position_by[k]).norm();
            let size = slope.norm();
            assert!(size > 1e-4, "{} {} {size}", model.name, names[k]);
            assert!(
                error < 1e-5 * size.max(0.1),
                "{} {} {slope:?} {:?}",
                model.name,
                names[k],
                exact.position_by[k]
            );
        }
    }
}

#[test]
fn the_spread_has_the_scatter_of_the_winds_speed_and_direction() {
    let (body, release) = in_wind(&support::plate().model, WIND);
    let flights = body.with(&release);
    let read = |text: &str| Bounds::read("b.toml", text, &body).map(|bounds| bounds.scatter);
    let scatter = read("[scatter]\nwind_speed = 0.5\nwind_direction = 10\n").expect("bounds");
    let index = |name: &str| body.compiled.layout().parameter(name).expect(name).index();
    let places = [index("wind_speed"), index("wind_direction")];
    assert_eq!(scatter.parameters, [(places[0], 0.5), (places[1], 10.0)]);
    let scattered = Scattered::of(&flights, &scatter);
    assert_eq!(scattered.by.len(), 2);
    let covariance =
        landing_covariance(&flights, &throw(), None, &scatter, &tight()).expect("a spread");
    let by = places.map(By::Parameter);
    let landing = flights
        .fly_with_derivatives(&throw(), None, &by, &tight())
        .expect("a flight")
        .landing();
    let (a, b) = (
        landing.position_by[0].xy() * 0.5,
        landing.position_by[1].xy() * 10.0,
    );
    let expected = a * a.transpose() + b * b.transpose();
    assert!(
        (covariance - expected).norm() < 1e-9 * expected.norm(),
        "{covariance} {expected}"
    );
    let error = read("[scatter]\nwind_sped = 0.5\n")
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("b.toml:2:1: unknown key \"wind_sped\""),
        "{error}"
    );
}

#[test]
fn a_throw_is_found_in_the_wind_and_its_release_states_it() {
    let ball = support::body("ball").model;
    let (body, release) = in_wind(&ball, WIND);
    let flights = body.with(&release);
    let options = SearchOptions {
        threads: 1,
        starts: 64,
        ..SearchOptions::default()
    };
    let bounds = Bounds::standard(&body);
    let target = Vector3::new(8.0, 1.0, 0.0);
    let found = design(&flights, Goal::Hit(target.into()), &bounds, &options).expect("a search");
    assert!(
        found.feasible && (found.landing - target).norm() < 1e-3,
        "{:?}",
        found.landing
    );
    let text = found.release_toml("ball", &release);
    let names = |_: &str| Ok(Vocabulary::of(&ball));
    let (written, names) =
        read_in_wind("release.toml", &text, &[], names).unwrap_or_else(|e| panic!("{e}\n{text}"));
    // The gusts keep the direction in which the search flew.
    assert_eq!(written.wind_field, release.wind_field);
    assert!(written.stop == Stop::Ground);
    let model = names.model.expect("a model");
    let compiled = flight::CompiledModel::new(&model);
    let flown = flight::simulate(&compiled, &written, &tight()).expect("a flight");
    let end = Vector3::from_column_slice(&flown.end_state[..3]);
    assert!((end - target).norm() < 2e-3, "{end}");
    // In still air it lands elsewhere.
    let calm = support::body("ball");
    let still = calm.with_parameters(calm.compiled.layout().default_parameters());
    let still = still
        .fly(&found.throw, None, &tight())
        .expect("a flight")
        .landing()
        .position;
    assert!((still - target).norm() > 0.3, "{still}");
}
