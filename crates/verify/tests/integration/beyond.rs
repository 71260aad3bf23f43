//! Errors that only show beyond the states of a slow flight near the ground are found.

use model_spec::load::inspect_text;
use verify::Options;
use verify::report::Outcome;

const OPTIONS: Options = Options {
    seed: 1,
    cases: 200,
    mutants: false,
    effects: false,
};

/// A point on a rail with an acceleration beside that of its claimed force: `wrong` times `right`.
fn rail(term: &str, wrong: bool) -> String {
    let claimed = if wrong { "f" } else { "f + m*extra" };
    format!(
        "model rail; param m = 2 kg; coefficient k = 0.3 kg/s in 0 .. 1; input throttle: 1 = 0 in 0 .. 1; frame N;
state x = 0 m; state vx = 1 m/s; state theta = 0 rad; state spin = 0 rad/s; state part = 1;
table bump(x: m): m/s^2 = {{ 0: 0, 300: 0, 310: 5, 320: 0, 1000: 0 }} linear, constant;
table thrust(M: 1): m/s^2 = {{ 0: 0, 1.1: 0, 1.12: 3, 1.14: 0, 9: 0 }} linear, constant;
let f = -k*vx;
let extra: m/s^2 = {term};
der(x) = vx; der(vx) = f/m + extra; der(theta) = 0; der(spin) = 0; der(part) = 0;
claim point rail {{ mass m; position x*N.1; velocity vx*N.1; force ({claimed})*N.1; }}\n"
    )
}

fn outcome(term: &str, wrong: bool) -> Outcome {
    let text = rail(term, wrong);
    let loaded = inspect_text("rail", &text, &[]).unwrap();
    assert!(loaded.model.is_some(), "{text}\n{:#?}", loaded.diagnostics);
    verify::run(&loaded, &OPTIONS).outcome()
}

/// What a wrong term depends on; each is 0 at all states of slow flights near the ground.
const TERMS: [(&str, &str); 9] = [
    ("speed", "0.1 [m/s^2]*step(vx - 20 [m/s])"),
    (
        "speed of sound",
        "0.1 [m/s^2]*step(abs(vx)/340 [m/s] - 0.9)",
    ),
    ("height", "0.1 [m/s^2]*max(x/100 [m] - 1, 0)"),
    ("angle", "0.1 [m/s^2]*step(abs(theta) - 1.3 [rad])"),
    ("spin", "0.1 [m/s^2]*step(spin - 200 [rad/s])"),
    ("pure number", "0.1 [m/s^2]*step(part - 5)"),
    ("input", "0.1 [m/s^2]*max(throttle - 0.8, 0)"),
    ("knots", "bump(x)"),
    ("narrow knots", "thrust(abs(vx)/340 [m/s])"),
];

#[test]
fn an_error_beyond_slow_flights_is_found() {
    let passed: Vec<&str> = { TERMS.iter() }
        .filter(|(_, term)| outcome(term, true) != Outcome::Refuted)
        .map(|(what, _)| *what)
        .collect();
    assert!(passed.is_empty(), "not refuted: {passed:?}");
}

#[test]
fn a_claim_that_has_the_term_holds() {
    let refuted: Vec<&str> = { TERMS.iter() }
        .filter(|(_, term)| outcome(term, false) != Outcome::Verified)
        .map(|(what, _)| *what)
        .collect();
    assert!(refuted.is_empty(), "not verified: {refuted:?}");
}
