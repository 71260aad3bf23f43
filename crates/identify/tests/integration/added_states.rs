//! What an effect adds: states, of each flight its own and found with its initial state, and coefficients of what is observed.

use crate::support::release;
use dataset::synthesize::{Corruption, Plan, flights};
use identify::{FitOptions, fit};

const GUST: &str = "
effect gust {
  site wind;
  state W_x = 0 m/s;
  state W_y = 0 m/s;
  der(W_x) = 0;
  der(W_y) = 0;
  replace air_velocity = previous - (W_x, W_y, 0) in N;
}
";

#[test]
fn the_wind_of_each_flight_is_found() {
    let ball = model_spec::load::MODELS.iter().find(|m| m.0 == "ball");
    let text = ball.expect("built in").1.to_owned() + GUST;
    let model = model_spec::load::from_text("ball.hyz", &text, &["gust"]).expect("a model");
    let release = release("serve", &model);
    let plan = Plan {
        flights: 4,
        noise: Corruption {
            sigma: 1e-5,
            ..Corruption::default()
        },
        ..Plan::default()
    };
    let made = flights(&model, &[release], &plan).expect("made");
    let fitted = fit(&model, &made.dataset, &FitOptions::default()).expect("a fit");
    let mut winds = Vec::new();
    for (flight, (_, truth)) in fitted.report.flights.iter().zip(&made.truth.initial) {
        for name in ["W_x", "W_y"] {
            let found = &flight.initial[name];
            let error = (found.value - truth[name]).abs();
            assert!(error < 5.0 * found.std_error, "{name}: {found:?} {truth:?}");
            assert!(found.std_error < 0.3, "{name}: {found:?}");
            winds.push(truth[name]);
        }
    }
    assert!(winds.iter().all(|wind| wind.abs() > 1e-3), "{winds:?}");
}

const SCALE: &str = "
effect longer {
  site scale;
  coefficient b = 0 in -0.5 .. 0.5;
  replace observe = previous*(1 + b);
}
";

/// By gravity, as of a recording whose lengths are too long.
#[test]
fn a_coefficient_of_the_observation_alone_is_estimated() {
    let ball = model_spec::load::MODELS.iter().find(|m| m.0 == "ball");
    let text = ball.expect("built in").1.to_owned() + SCALE;
    let model = |text: &str| model_spec::load::from_text("ball.hyz", text, &["longer"]);
    let longer = model(&text.replace("b = 0", "b = 0.03")).expect("a model");
    let release = release("serve", &longer);
    let plan = Plan {
        flights: 3,
        noise: Corruption {
            sigma: 1e-5,
            ..Corruption::default()
        },
        ..Plan::default()
    };
    let made = flights(&longer, &[release], &plan).expect("made");
    let model = model(&text).expect("a model");
    let fitted = fit(&model, &made.dataset, &FitOptions::default()).expect("a fit");
    let found = &fitted.report.coefficients["b"];
    assert!(
        (found.value - 0.03).abs() < 5.0 * found.std_error,
        "{found:?}"
    );
    assert!(found.std_error < 0.003, "{found:?}");
}
