//! Made datasets: flights are where the model puts them, around their release, and can be written and read.

use dataset::synthesize::{Corruption, Plan, Spread, SynthesisError, SyntheticDataset, flights};
use dataset::{KnownValue, Role, load, write};
use flight::release::{Release, Stop, Vocabulary, built_in, read};
use flight::{InputInterpolation, InputSeries};
use model_spec::model::Model;

fn released(name: &str) -> (Model, Release) {
    let mut model = None;
    let release = read(name, built_in(name).expect("built in"), |named| {
        let loaded = model_spec::load::load(named, &[])?;
        let vocabulary = Vocabulary::of(&loaded);
        model = Some(loaded);
        Ok(vocabulary)
    });
    (model.expect("a model"), release.expect("a release"))
}

fn made(name: &str, plan: &Plan) -> SyntheticDataset {
    let (model, release) = released(name);
    flights(&model, &[release], plan).expect("made")
}

#[test]
fn flights_are_made_written_and_read() {
    for name in ["backhand", "serve", "discus"] {
        let plan = Plan {
            flights: 3,
            held_out: 1,
            noise: Corruption {
                dropouts: 0.1,
                ..Corruption::default()
            },
            ..Plan::default()
        };
        let made = made(name, &plan);
        let dataset = &made.dataset;
        let roles: Vec<Role> = dataset.flights.iter().map(|flight| flight.role).collect();
        assert_eq!(roles, [Role::Fit, Role::Fit, Role::HeldOut]);
        let folder = tempfile::tempdir().expect("a folder");
        let folder = folder.path().join("made");
        write(&folder, dataset).expect("written");
        assert_eq!(load(&folder).expect("read"), *dataset);
        toml::from_str::<toml::Table>(&made.truth.text()).expect("the truth is TOML");
    }
}

#[test]
fn without_noise_a_ball_is_seen_where_it_is() {
    let (model, mut release) = released("serve");
    release.parameters = vec![("rho".into(), 0.0)];
    release.known = vec![("omega".into(), [1.0, 2.0, 3.0])];
    let plan = Plan {
        noise: Corruption {
            sigma: 0.0,
            ..Corruption::default()
        },
        decimals: None,
        ..Plan::default()
    };
    let made = flights(&model, &[release], &plan).expect("made");
    assert_eq!(made.dataset.parameters["rho"], 0.0);
    for (flight, (file, state)) in made.dataset.flights.iter().zip(&made.truth.initial) {
        assert_eq!(flight.file, *file);
        assert_eq!(flight.known["omega"], KnownValue::Vector([1.0, 2.0, 3.0]));
        assert_eq!(flight.times.len(), 55);
        assert_eq!(flight.times[..3], [0.0, 0.008333, 0.016667]);
        for (t, row) in flight.times.iter().zip(&flight.positions) {
            let [x, y, z] = row[0].expect("seen");
            assert!((x - state["vx"] * t).abs() < 1e-9);
            assert!((y - state["vy"] * t).abs() < 1e-9);
            let fallen = 0.3 + state["vz"] * t - 0.5 * 9.81 * t * t;
            assert!((z - fallen).abs() < 1e-9, "{z} {fallen}");
        }
    }
}

#[test]
fn markers_of_a_rigid_body_keep_their_distances() {
    let plan = Plan {
        noise: Corruption {
            sigma: 0.0,
            ..Corruption::default()
        },
        decimals: None,
        ..Plan::default()
    };
    let made = made("backhand", &plan);
    let distance = |a: [f64; 3], b: [f64; 3]| {
        let squares = a.iter().zip(b).map(|(a, b)| (a - b).powi(2));
        squares.sum::<f64>().sqrt()
    };
    let markers = &made.dataset.markers;
    for row in made
        .dataset
        .flights
        .iter()
        .flat_map(|flight| &flight.positions)
    {
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let seen = distance(row[i].expect("seen"), row[j].expect("seen"));
            let declared = distance(markers[i].position, markers[j].position);
            assert!((seen - declared).abs() < 1e-9);
        }
    }
}

#[test]
fn spread_varies_what_is_no_position() {
    let (model, release) = released("backhand");
    let spread = Spread::default();
    let deviations = spread.deviations(&model, &release.state());
    let of = |name: &str| {
        let place = model.states.iter().position(|state| state.name == name);
        let value = release.initial.iter().find(|(known, _)| known == name);
        (
            deviations[place.expect("a state")],
            value.expect("a value").1.abs(),
        )
    };
    assert_eq!([of("x").0, of("y").0, of("z").0], [0.0; 3]);
    assert_eq!(of("u").0, 0.1 * of("u").1);
    assert_eq!(of("v").0, 0.5);
    assert_eq!(of("phi").0, 0.1);
    assert_eq!(of("gammadot").0, 0.1 * of("gammadot").1);
    // An attitude varies as much where a quaternion is its state: the parts of a small turn are half its angle.
    let quaternion = model_spec::load::load("disc_quaternion", &[]).expect("a model");
    let upright = quaternion
        .states
        .iter()
        .map(|own| f64::from(own.name == "q0"));
    let deviations = spread.deviations(&quaternion, &upright.collect::<Vec<_>>());
    let place = quaternion.states.iter().position(|own| own.name == "q1");
    assert_eq!(2.0 * deviations[place.expect("a state")], of("phi").0);
    let alike = Plan {
        spread: Spread {
            fraction: 0.0,
            ..spread
        },
        ..Plan::default()
    };
    for (_, state) in made("backhand", &alike).truth.initial {
        assert!(
            release
                .initial
                .iter()
                .all(|(name, value)| state[name] == *value)
        );
    }
}

#[test]
fn quaternions_stay_of_length_one() {
    let model = model_spec::load::load("disc_quaternion", &[]).expect("a model");
    let state = |name: &str| match name {
        "q0" | "z" => 1.0,
        "vx" => 12.0,
        "r" => -40.0,
        _ => 0.0,
    };
    let names = model.states.iter().map(|state| state.name.clone());
    let (_, like) = released("backhand");
    let release = Release {
        initial: names.map(|name| (name.clone(), state(&name))).collect(),
        parameters: Vec::new(),
        coefficients: Vec::new(),
        stop: Stop::Duration(0.5),
        ..like
    };
    let made = flights(&model, &[release], &Plan::default()).expect("made");
    for (_, state) in made.truth.initial {
        let squares = ["q0", "q1", "q2", "q3"].map(|name| state[name].powi(2));
        assert!((squares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert_ne!(state["q0"], 1.0);
    }
}

#[test]
fn one_flight_more_does_not_change_the_others() {
    let plan = |flights| Plan {
        flights,
        ..Plan::default()
    };
    let (few, many) = (made("backhand", &plan(2)), made("backhand", &plan(3)));
    assert_eq!(few.dataset.flights[..], many.dataset.flights[..2]);
    let initial = &few.truth.initial;
    assert_ne!(initial[0].1, initial[1].1, "no two flights are alike");
    let other = Plan { seed: 2, ..plan(2) };
    assert_ne!(made("backhand", &other).dataset, few.dataset);
}

#[test]
fn plans_that_make_no_sense_are_refused() {
    let refused = |change: &dyn Fn(&mut Plan)| {
        let (model, release) = released("serve");
        let mut plan = Plan::default();
        change(&mut plan);
        match flights(&model, &[release], &plan).expect_err("it makes no sense") {
            SynthesisError::Plan(why) => why,
            SynthesisError::OutOfRange(why) => why.to_string(),
            other => panic!("{other}"),
        }
    };
    assert!(refused(&|plan| plan.flights = 0).starts_with("flights: found 0"));
    assert!(refused(&|plan| plan.held_out = 9).starts_with("held-out: found 9"));
    assert!(refused(&|plan| plan.rate = 0.0).starts_with("rate: found 0"));
    assert!(refused(&|plan| plan.duration = Some(f64::NAN)).starts_with("duration: found NaN"));
    assert!(refused(&|plan| plan.spread.fraction = -0.1).starts_with("spread: found -0.1"));
    assert!(refused(&|plan| plan.seed = u64::MAX).starts_with("seed"));
    let (model, release) = released("serve");
    flights(&model, &[], &Plan::default()).expect_err("no release");
    let mut heavy = release.clone();
    heavy.parameters = vec![("m".into(), 1.0)];
    let both = [release.clone(), heavy];
    flights(&model, &both, &Plan::default()).expect_err("two bodies");
    let dense = Plan {
        rate: 1e6,
        flights: 100,
        ..Plan::default()
    };
    let error = flights(&model, &[release], &dense).expect_err("too many points");
    assert!(error.to_string().contains("marker points"), "{error}");
}

#[test]
fn a_flight_to_the_ground_ends_there_or_earlier_where_it_is_watched_no_longer() {
    let plan = |duration| Plan {
        duration,
        spread: Spread {
            fraction: 0.0,
            ..Spread::default()
        },
        ..Plan::default()
    };
    let last = |duration| {
        let made = made("discus", &plan(duration));
        let times = &made.dataset.flights[0].times;
        *times.last().expect("samples")
    };
    assert!(last(None) > 2.0);
    assert_eq!(last(Some(60.0)), last(None));
    assert_eq!(last(Some(0.5)), 0.5);
    let (model, mut release) = released("serve");
    release.stop = Stop::Ground;
    release.parameters = vec![("g".into(), 0.0)];
    let error = flights(&model, &[release], &plan(None)).expect_err("it rises for ever");
    assert!(error.to_string().contains("still up"), "{error}");
}

#[test]
fn a_flight_out_of_the_model_is_named() {
    let (model, mut release) = released("backhand");
    for (name, value) in &mut release.initial {
        match name.as_str() {
            "theta" => *value = 1.5,
            "thetadot" => *value = 5.0,
            // With spin it would turn aside.
            "phidot" | "gammadot" => *value = 0.0,
            _ => {}
        }
    }
    let plan = Plan {
        spread: Spread {
            fraction: 0.0,
            ..Spread::default()
        },
        ..Plan::default()
    };
    for stop in [Stop::Ground, Stop::Duration(0.5)] {
        release.stop = stop;
        let error = flights(&model, &[release.clone()], &plan).expect_err("it stands vertical");
        let told = error.to_string();
        assert!(
            told.starts_with("flight 1: integration failed at t = ") && told.contains("vertical"),
            "{told}"
        );
    }
}

#[test]
fn inputs_of_releases_are_written_with_their_interpolation() {
    let text = "model cart; frame N; input throttle = 0; param m = 1 kg;
        point cart { mass m; position (x, y, z) in N; velocity (u, v, w) in N; }
        force push = throttle*1 [N]*N.1; marker mark in N; observe mark = position + mark;";
    let model = model_spec::load::from_text("cart.hyz", text, &[]).expect("a model");
    let with = |interpolation| {
        let samples = [(0.0, 0.2), (0.5, 0.8), (1.1, 0.3), (2.0, 0.5)];
        let mut release = Release::of(&model);
        release.initial[2].1 = 100.0;
        release.inputs = vec![("throttle".into(), InputSeries::new(&samples, interpolation))];
        release
    };
    let plan = Plan {
        flights: 2,
        duration: Some(1.0),
        ..Plan::default()
    };
    let around = tempfile::tempdir().expect("a folder");
    for interpolation in [InputInterpolation::Hold, InputInterpolation::Cubic] {
        let made = flights(&model, &[with(interpolation)], &plan)
            .expect("flights")
            .dataset;
        let folder = around.path().join(format!("{interpolation:?}"));
        write(&folder, &made).expect("written");
        assert_eq!(load(&folder).expect("read"), made);
    }
    let both = [
        with(InputInterpolation::Hold),
        with(InputInterpolation::Linear),
    ];
    let error = flights(&model, &both, &plan).expect_err("one for all");
    assert!(
        error.to_string().contains("different interpolations"),
        "{error}"
    );
}
