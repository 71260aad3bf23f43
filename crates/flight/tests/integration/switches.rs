//! Narrow features of the state are not flown over: layers, jets, masts and switches placed at random.

use flight::release::{Vocabulary, built_in, read};
use flight::{BoundModel, CompiledModel, LaneModel, ModelState};
use model_spec::EffectTree;
use model_spec::load::from_text;
use ode::{
    Endpoint, FlightEnd, FlightQueue, FlightSpan, IntegrationOptions, OdeRhs, RhsProperties,
    Sensitivities, integrate_to_end, rhs_from_fn,
};

/// Length of the path on which the features lie; the step would be longer than it.
const PATH: f64 = 1000.0;

/// Narrowest and widest feature, as a part of the path.
const WIDTHS: (f64, f64) = (1.0 / 2000.0, 1.0 / 10.0);

/// Features of each kind.
const FEATURES: u64 = 40;

/// Kinds of features about `c` of the half-width `w`, as functions of the position `s`.
const KINDS: [(&str, &str); 22] = [
    ("a Gaussian jet", "exp(-((s - c)/w)^2)"),
    ("a mast", "step(s - c + w)*step(c + w - s)"),
    (
        "a pair of smooth switches",
        "(tanh(10*(s - c + w)/w) - tanh(10*(s - c - w)/w))/2",
    ),
    ("the slope of a smooth switch", "1 - tanh((s - c)/w)^2"),
    (
        "a pair of logistic switches",
        "1/(1 + exp(-9*(s - c + w)/w)) - 1/(1 + exp(-9*(s - c - w)/w))",
    ),
    (
        "the slope of a logistic switch",
        "exp((s - c)/w)/(1 + exp((s - c)/w))^2",
    ),
    ("a clamped parabola", "max(1 - ((s - c)/w)^2, 0)"),
    ("a roof", "max(1 - abs(s - c)/w, 0)"),
    (
        "a clamped ramp up and down",
        "min(max((s - c)/w + 1, 0), 1) - min(max((s - c)/w, 0), 1)",
    ),
    ("a half circle", "sqrt(1 - ((s - c)/w)^2)"),
    ("signs", "(sign(s - c + w) - sign(s - c - w))/2"),
    (
        "an odd switch",
        "(s - c)/w*exp(-((s - c)/w)^2) + exp(-abs(s - c)/w)",
    ),
    ("a table", "layer((s - c)/w)"),
    (
        "a pulse in time",
        "exp(-(((time - 1 [s])/(1 [s]) - c)/w)^2)",
    ),
    (
        "a pole beside the path",
        "step(w - sqrt((s - c)^2 + 0.01*w^2))",
    ),
    (
        "a cone beside the path",
        "max(1 - sqrt((s - c)^2 + 0.01*w^2)/w, 0)",
    ),
    (
        "a decay with the distance",
        "exp(-sqrt((s - c)^2 + 0.01*w^2)/w)",
    ),
    (
        "a smooth pole",
        "1 - tanh((sqrt((s - c)^2 + 0.01*w^2) - w)/(0.1*w))",
    ),
    (
        "a product in time",
        "step((time/(1 [s]) - c + w)*(c + w - time/(1 [s])))",
    ),
    (
        "a half circle in time",
        "sqrt(1 - ((time/(1 [s]) - c)/w)^2)",
    ),
    (
        "a crest in time",
        "2*(500/w)^2*max(cos((time/(1 [s]) - c)/500) - cos(w/500), 0)",
    ),
    (
        "a table of the square of the time",
        "layer(((time/(1 [s]))^2 - c^2)/(2*c*w))",
    ),
];

/// A point that moves at one unit per second, and what the feature drives.
fn text(feature: &str) -> String {
    format!(
        "model probe;\nframe N;\nparam c = 500;\nparam w = 10;\ncoefficient a = 2 1/s;\n\
         table layer(q: 1) = {{ -1: 0, -0.8: 1, 0.8: 1, 1: 0 }} linear, constant;\n\
         state s = 0;\nstate u = 0;\nder(s) = 1/(1 [s]);\nder(u) = a*({feature}) - u/(500 [s]);\n"
    )
}

/// Random numbers in 0 .. 1 (SplitMix64).
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *seed;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

/// Place and half-width of a feature.
fn placed(seed: &mut u64) -> [f64; 2] {
    let width = PATH * WIDTHS.0 * (WIDTHS.1 / WIDTHS.0).powf(random(seed));
    [PATH * (0.1 + 0.8 * random(seed)), 0.5 * width]
}

fn parameters(compiled: &CompiledModel, [c, w]: [f64; 2]) -> Vec<f64> {
    let mut parameters = compiled.layout().default_parameters();
    for (name, value) in [("c", c), ("w", w)] {
        parameters[compiled.layout().parameter(name).expect(name).index()] = value;
    }
    parameters
}

fn flown(
    compiled: &CompiledModel,
    at: [f64; 2],
    options: &IntegrationOptions,
) -> Endpoint<ModelState> {
    let start = compiled.layout().default_states().into();
    let bound = compiled.bind(parameters(compiled, at));
    let flown = bound.integrate_to_end((0.0, &start), PATH, options, &mut []);
    flown.unwrap_or_else(|error| panic!("{error}"))
}

/// Relative error above which a feature counts as flown over. A step that ends near a kink may be off by thousandths
/// where its error estimate happens to vanish, at the tolerances of these tests.
const MISSED: f64 = 0.01;

fn compiled(feature: &str) -> CompiledModel {
    let model = from_text("probe", &text(feature), &[]);
    CompiledModel::new(&model.unwrap_or_else(|error| panic!("{error}")))
}

/// Result with steps that cannot miss the feature.
fn expected(compiled: &CompiledModel, at: [f64; 2]) -> f64 {
    let short = IntegrationOptions {
        max_step: 0.2 * at[1],
        ..IntegrationOptions::with_tolerance(1e-7)
    };
    flown(compiled, at, &short).state[1]
}

/// Both methods, each at a tolerance that it is for.
fn methods() -> [IntegrationOptions; 2] {
    [1e-6, 1e-9].map(IntegrationOptions::with_tolerance)
}

#[test]
fn no_feature_is_flown_over() {
    let mut missed = Vec::new();
    for (kind, feature) in KINDS {
        let compiled = compiled(feature);
        let mut seed = 1;
        for _ in 0..FEATURES {
            let at = placed(&mut seed);
            let expected = expected(&compiled, at);
            for options in methods() {
                let end = flown(&compiled, at, &options);
                let error = (end.state[1] - expected).abs() / expected.abs();
                if error > MISSED {
                    let method = options.method;
                    missed.push(format!(
                        "{kind}, {method:?}, {at:?}: {error:e}, {:?}",
                        end.stats
                    ));
                }
            }
        }
    }
    assert!(missed.is_empty(), "{} missed: {missed:#?}", missed.len());
}

#[test]
fn sensitivities_and_lanes_see_what_the_state_sees() {
    for (kind, feature) in KINDS {
        let model = from_text("probe", &text(feature), &[]).expect("a model");
        let (compiled, lanes) = (CompiledModel::new(&model), LaneModel::new(&model));
        let mut seed = 2;
        let places: Vec<[f64; 2]> = (0..16).map(|_| placed(&mut seed)).collect();
        for options in methods() {
            let ends = in_lanes(&lanes, &compiled, &places, &options);
            for (at, in_lane) in places.iter().zip(ends) {
                let expected = expected(&compiled, *at);
                // The drift is proportional to the coefficient, which is 2.
                let by_coefficient = 2.0 * derivative(&compiled, *at, &options);
                for (what, found) in [("lanes", in_lane), ("sensitivity", by_coefficient)] {
                    let error = (found - expected).abs() / expected.abs();
                    let method = options.method;
                    assert!(
                        error < MISSED,
                        "{kind}, {what}, {method:?}, {at:?}: {error:e}"
                    );
                }
            }
        }
    }
}

/// Results in lanes.
fn in_lanes(
    lanes: &LaneModel,
    compiled: &CompiledModel,
    places: &[[f64; 2]],
    options: &IntegrationOptions,
) -> Vec<f64> {
    let mut queue = Queue {
        compiled,
        places,
        next: 0,
        ends: vec![f64::NAN; places.len()],
    };
    let span = FlightSpan {
        t_end: PATH,
        height: None,
        seeks_apex: false,
        until_ground: false,
    };
    lanes.fly(&mut queue, &span, options, None);
    queue.ends
}

/// Greatest error at a jump or a kink, in tolerances.
const OFF_AT_A_KINK: f64 = 30.0;

#[test]
fn a_kink_is_as_exact_as_the_tolerance() {
    let kinks = [
        "step(s - c)",
        "max(s - c, 0)/c",
        "abs(s - c)/c",
        "sqrt((s - c)/c)",
        "layer(1 + 0.2*(s - c)/c)",
        "step((s/c)^2 - 1)",
    ];
    for feature in kinks {
        let model = from_text("probe", &text(feature), &[]).expect("a model");
        let (compiled, lanes) = (CompiledModel::new(&model), LaneModel::new(&model));
        let mut seed = 3;
        let places: Vec<[f64; 2]> = (0..40).map(|_| placed(&mut seed)).collect();
        for options in methods() {
            let ends = in_lanes(&lanes, &compiled, &places, &options);
            for (at, in_lane) in places.iter().zip(ends) {
                let exact = IntegrationOptions::with_tolerance(1e-12);
                let expected = flown(&compiled, *at, &exact).state[1];
                let alone = flown(&compiled, *at, &options).state[1];
                for found in [alone, in_lane] {
                    let error = (found - expected).abs() / expected.abs().max(1.0);
                    assert!(
                        error < OFF_AT_A_KINK * options.rtol,
                        "{feature}, {:?}, {at:?}: {error:e}",
                        options.method
                    );
                }
            }
        }
    }
}

/// Three values of a step of a train of pulses, whose period is shorter than the step, show none.
#[test]
fn periodic_pulses_are_seen() {
    // The mean of the pulses is arccos(0.9)/π.
    let mean = 2.0 * 0.9_f64.acos() / std::f64::consts::PI;
    let expected = mean * 500.0 * (1.0 - (-PATH / 500.0).exp());
    let model = from_text("probe", &text("step(sin(pi*time/(1 [s])) - 0.9)"), &[]);
    let model = model.expect("a model");
    let (compiled, lanes) = (CompiledModel::new(&model), LaneModel::new(&model));
    let at = [500.0, 10.0];
    for options in methods() {
        let alone = flown(&compiled, at, &options).state[1];
        let in_lane = in_lanes(&lanes, &compiled, &[at], &options)[0];
        for found in [alone, in_lane] {
            let error = (found - expected).abs() / expected;
            assert!(error < MISSED, "{:?}: {found} {expected}", options.method);
        }
    }
}

/// Derivative of the drift by the coefficient.
fn derivative(compiled: &CompiledModel, at: [f64; 2], options: &IntegrationOptions) -> f64 {
    let bound = compiled.bind(parameters(compiled, at));
    let coefficient = compiled.layout().parameter("a").expect("a").index();
    let mut rhs = bound.rhs();
    let mut sensitivities = Sensitivities::new(&mut rhs, 0, &[coefficient]);
    let start = sensitivities.initial_state(&compiled.layout().default_states(), &[]);
    let mut end = f64::NAN;
    let row = sensitivities.layout().row_range(1);
    let mut read = |_: usize, state: &[f64]| end = state[row.start];
    let (start, times) = ((0.0, &start), [PATH]);
    let ranges = [row.clone()];
    let flown = sensitivities.integrate_with_callback(start, &times, options, &ranges, &mut read);
    flown.expect("it flies");
    end
}

/// Flights past features at places of their own.
struct Queue<'a> {
    compiled: &'a CompiledModel,
    places: &'a [[f64; 2]],
    next: usize,
    ends: Vec<f64>,
}

impl FlightQueue for Queue<'_> {
    fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64> {
        let at = self.places.get(self.next)?;
        x.copy_from_slice(&self.compiled.layout().default_states());
        p.copy_from_slice(&parameters(self.compiled, *at));
        self.next += 1;
        Some(self.next as u64 - 1)
    }

    fn end(&mut self, end: FlightEnd<'_>) {
        self.ends[end.flight as usize] = end.state[1];
    }
}

/// A body that falls at its terminal velocity through a layer of wind, and a wheel that rolls out past a resonance of
/// its speed and of its angle.
const FLIGHTS: [(&str, &str, f64); 4] = [
    (
        "wind",
        "param m = 1 kg;\nparam g = 9.81 m/s^2;\nparam k = 0.3924 kg/m;\n\
         point body { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }\n\
         table wind_at(h: m): m/s = { 0: 0, 1000: 0, 1001: 8, 1029: 8, 1030: 0, 3000: 0 } linear, constant;\n\
         let air = velocity - (wind_at(z), 0 [m/s], 0 [m/s]) in N;\n\
         force weight = -m*g*N.3;\nforce drag = -k*norm(air)*air;\n",
        3000.0,
    ),
    (
        "speed",
        "state vx = 100 m/s;\nstate x = 0 m;\nder(vx) = -vx/(500 [s]);\n\
         der(x) = exp(-((vx - 50 [m/s])/(0.1 [m/s]))^2)*1 [m/s];\n",
        0.0,
    ),
    (
        "angle",
        "state turn = 0 rad;\nstate x = 0 m;\nder(turn) = 0.01 [rad/s];\n\
         der(x) = step(turn - 3 [rad])*step(3.01 [rad] - turn)*1 [m/s];\n",
        0.0,
    ),
    (
        // Past a mast on a path that bends, where the parts of the dense output that a cubic lacks count.
        "mast",
        "state s = 0 m;\nstate v = 10 m/s;\nstate y = 0 m;\nstate u = 0.1 m/s;\nstate x = 0 m;\n\
         der(s) = v;\nder(v) = -v/(200 [s]);\nder(y) = u;\nder(u) = -y/(400 [s^2]);\n\
         let r = sqrt((s - 900 [m])^2 + (y - 0.1 [m])^2);\n\
         der(x) = max(1 - r/(2.5 [m]), 0)*10 [m/s];\n",
        0.0,
    ),
];

#[test]
fn layers_speeds_and_angles_are_seen() {
    for (kind, body, height) in FLIGHTS {
        let model = from_text("probe", &format!("model probe;\nframe N;\n{body}"), &[]);
        let model = model.unwrap_or_else(|error| panic!("{kind}: {error}"));
        let compiled = CompiledModel::new(&model);
        let mut start = compiled.layout().default_states();
        if let Some(z) = compiled.layout().state("z") {
            start[z.index()] = height;
            start[compiled.layout().state("vz").expect("vz").index()] = -5.0;
        }
        let x = compiled.layout().state("x").expect("x").index();
        let bound = compiled.bind(compiled.layout().default_parameters());
        let drift = |options: &IntegrationOptions| {
            let start = (0.0, &start.clone().into());
            let flown = bound.integrate_to_end(start, 550.0, options, &mut []);
            flown.expect("it flies").state[x]
        };
        let short = IntegrationOptions {
            max_step: 0.05,
            ..IntegrationOptions::with_tolerance(1e-9)
        };
        let expected = drift(&short);
        for options in methods() {
            let error = (drift(&options) - expected).abs() / expected;
            assert!(error < MISSED, "{kind}, {:?}: {error:e}", options.method);
        }
    }
}

/// Greatest growth of the number of evaluations of a flight of a body with a built-in effect.
const GREATEST_COST: f64 = 1.05;

#[test]
fn ordinary_models_cost_no_more_evaluations() {
    let effects = EffectTree::built_in().iter().map(EffectTree::name);
    let effects: Vec<&str> = effects.collect();
    for (body, release) in [("disc", "backhand"), ("ball", "serve")] {
        let bare = model_spec::load::load(body, &[]).expect(body);
        let release = read(release, built_in(release).expect(release), |_| {
            Ok(Vocabulary::of(&bare))
        });
        let release = release.expect("a release");
        let model = CompiledModel::new(&bare);
        let bound = model.bind(model.release_parameters(&release));
        assert!(bound.rhs().switches().is_none(), "{body}");
        let (mut with, mut without) = (0, 0);
        for effect in &effects {
            let Ok(model) = model_spec::load::load(body, &[effect]) else {
                continue;
            };
            let model = CompiledModel::with_derivatives_by(&model, Vec::new());
            let bound = model.bind(model.release_parameters(&release));
            if bound.rhs().switches().is_none() {
                continue;
            }
            let mut start = model.layout().default_states();
            start[..release.state().len()].copy_from_slice(&release.state());
            for options in methods() {
                let [a, b] = evaluations(&bound, start.clone().into(), &options);
                assert!(
                    a as f64 <= GREATEST_COST * b as f64 + 1.0,
                    "{body} {effect} {a} {b}"
                );
                (with, without) = (with + a, without + b);
            }
        }
        assert!(without > 0 && with as f64 <= GREATEST_COST * without as f64);
    }
}

/// Evaluations of a flight with and without regard to switches.
fn evaluations(
    bound: &BoundModel<'_>,
    start: ModelState,
    options: &IntegrationOptions,
) -> [usize; 2] {
    let end = bound.integrate_to_end((0.0, &start), 2.0, options, &mut []);
    let mut rhs = bound.rhs();
    let mut unwatched = rhs_from_fn(&[], |t, x: &ModelState, dx: &mut ModelState| {
        rhs.derivative(t, x, dx);
    });
    let plain = integrate_to_end(&mut unwatched, (0.0, &start), 2.0, options, &mut []);
    [end, plain].map(|end| end.expect("it flies").stats.evaluations)
}

/// Three values of a step show nothing of a sine whose angle the state turns more than once in it.
#[test]
fn pulses_of_an_angle_that_the_state_turns_are_seen() {
    let text = |turned: f64| {
        format!(
            "model wheel;\nframe N;\nstate phi = 0 rad;\nstate om = {turned} rad/s;\nstate v = 0 m/s;\n\
             der(phi) = om;\nder(om) = -0.5 [/s]*om;\nder(v) = 3 [m/s^2]*step(sin(phi) - 0.995);\n"
        )
    };
    for turned in [3.0, 60.0, 600.0] {
        // phi = 2*turned*(1 - exp(-t/2)): the time of each passage, from the angle.
        let time = |phi: f64| -2.0 * (1.0 - phi / (2.0 * turned)).ln();
        let end = 2.0 * turned * (1.0 - (-2.5_f64).exp());
        let (first, turn) = (0.995_f64.asin(), std::f64::consts::TAU);
        let pulses = (0..)
            .map(|k| f64::from(k) * turn)
            .take_while(|from| from + first < end);
        let pulse = |from: f64| time((from + turn / 2.0 - first).min(end)) - time(from + first);
        let expected: f64 = pulses.map(|from| 3.0 * pulse(from)).sum();
        let model = from_text("wheel", &text(turned), &[]).expect("a model");
        let compiled = CompiledModel::new(&model);
        let bound = compiled.bind(compiled.layout().default_parameters());
        for options in methods() {
            let start: ModelState = compiled.layout().default_states().into();
            let end = integrate_to_end(&mut bound.rhs(), (0.0, &start), 5.0, &options, &mut []);
            let found = end.expect("it turns").state[2];
            let error = (found - expected).abs() / expected;
            assert!(
                error < MISSED,
                "{turned}, {:?}: {found} {expected}",
                options.method
            );
        }
    }
}
