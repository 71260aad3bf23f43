//! Flights in lanes are those of the scalar solver, and the same bits in any company.

use flight::release::{Vocabulary, built_in, read};
use flight::{
    CompiledModel, FlightParameters, InputInterpolation, InputSeries, InputsOverTime, LaneModel,
};
use lanes::Isa;
use model_spec::model::Model;
use ode::{
    Event, FlightEnd, FlightOutcome, FlightQueue, FlightSpan, IntegrationFailure,
    IntegrationOptions, Method, integrate, integrate_to_event,
};

/// Text of a test model that is not built in: a dart that turns into the relative wind, with one validity limit.
const DART: &str = "model dart;
frame N;
param m = 0.02 kg;
param g = 9.81 m/s^2;
param k = 0.0004 kg/m;
coefficient s = 3 1/s;
input wind in N = (0, 0, 0) m/s;
state angle = 0.1 rad;
state x = 0 m;
state y = 0 m;
state z = 1 m;
state vx = 20 m/s;
state vy = 0 m/s;
state vz = 3 m/s;
limit angle > -0.5 \"it stalls\";
let air = (vx, vy, vz) in N - wind;
let V = norm(air);
let drag = -k/m*V*air;
der(angle) = s*(atan2(dot(air, N.3), dot(air, N.1)) - angle);
der(x) = vx;
der(y) = vy;
der(z) = vz;
der(vx) = dot(drag, N.1);
der(vy) = dot(drag, N.2);
der(vz) = dot(drag, N.3) - g;
";

/// Queue of flights, each given by its initial states and parameters. `order` contains indices of flights, which are
/// integrated from the last entry to the first. `ends` collects the results, by index of the flight.
struct Queue<'f> {
    flights: &'f [(Vec<f64>, Vec<f64>)],
    order: Vec<usize>,
    ends: Vec<Option<End>>,
}

#[derive(Clone, Debug, PartialEq)]
struct End {
    outcome: FlightOutcome,
    time: f64,
    state: Vec<f64>,
    apex: (f64, f64),
    steps: usize,
}

impl FlightQueue for Queue<'_> {
    fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64> {
        let flight = self.order.pop()?;
        x.copy_from_slice(&self.flights[flight].0);
        p.copy_from_slice(&self.flights[flight].1);
        Some(flight as u64)
    }

    fn end(&mut self, end: FlightEnd<'_>) {
        let to = &mut self.ends[end.flight as usize];
        assert!(to.is_none(), "a flight ends once");
        *to = Some(End {
            outcome: end.outcome,
            time: end.time,
            state: end.state.to_vec(),
            apex: end.apex,
            steps: end.stats.steps,
        });
    }
}

fn flown(
    model: &LaneModel,
    flights: &[(Vec<f64>, Vec<f64>)],
    order: Vec<usize>,
    (span, options): (&FlightSpan, &IntegrationOptions),
    isa: Option<Isa>,
) -> Vec<Option<End>> {
    let mut queue = Queue {
        flights,
        order,
        ends: vec![None; flights.len()],
    };
    model.fly(&mut queue, span, options, isa);
    queue.ends
}

/// Integrates one flight, from the states and parameters `(x, p)`, by the scalar solver.
fn scalar(
    compiled: &CompiledModel,
    (x, p): &(Vec<f64>, Vec<f64>),
    span: &FlightSpan,
    options: &IntegrationOptions,
) -> End {
    let bound = compiled.bind(p.clone());
    let mut events = bound.limits();
    let limits = events.len();
    if let Some(z) = span.height {
        events.push(Event::peak_of("apex", z));
        if span.until_ground {
            events.push(Event::falls_to("ground", z, 0.0).terminal());
        }
    }
    let (mut rhs, start) = (bound.rhs(), x.clone().into());
    let integrated = match span.until_ground {
        true => integrate_to_event(&mut rhs, (0.0, &start), span.t_end, options, &mut events),
        false => integrate(&mut rhs, (0.0, &start), span.t_end, options, &mut events),
    };
    let mut end = End {
        outcome: FlightOutcome::Time,
        time: 0.0,
        state: x.clone(),
        apex: (0.0, span.height.map_or(f64::NAN, |z| x[z])),
        steps: 0,
    };
    let error = match integrated {
        Ok(flight) => {
            let z = span.height.unwrap_or(0);
            for event in &flight.events {
                if event.state[z] > end.apex.1 {
                    end.apex = (event.time, event.state[z]);
                }
            }
            if flight.end_state[z] > end.apex.1 {
                end.apex = (flight.end, flight.end_state[z]);
            }
            if flight.terminal_event.is_some() {
                end.outcome = FlightOutcome::Ground;
            }
            (end.time, end.state) = (flight.end, flight.end_state);
            end.steps = flight.stats.steps;
            return end;
        }
        Err(error) => error,
    };
    end.time = error.time;
    end.state = error.states.iter().map(|(_, value)| *value).collect();
    end.outcome = match error.cause {
        IntegrationFailure::Limit { .. } => FlightOutcome::Limit(limits - 1),
        IntegrationFailure::TooManySteps { .. } => FlightOutcome::TooManySteps,
        IntegrationFailure::StartsPastEvent { .. } => FlightOutcome::StartsBelowGround,
        IntegrationFailure::InvalidInput { .. } => FlightOutcome::NotFinite,
        IntegrationFailure::NoTerminalEvent { .. } => FlightOutcome::Time,
        _ => FlightOutcome::StepTooSmall,
    };
    end
}

/// Pseudorandom number between -1 and 1; `seed` is the state of the generator, which each call advances.
fn noise(seed: &mut u64) -> f64 {
    *seed = seed
        .wrapping_mul(6364136223846793005)
        .wrapping_add(1442695040888963407);
    ((*seed >> 11) as f64) / ((1u64 << 52) as f64) - 1.0
}

/// Flights whose initial states and parameters scatter by 10 % around `x` and `p`. Some have an abnormal initial
/// height, such as NaN or below the ground; `height` is the index of that state.
fn scattered(x: &[f64], p: &[f64], height: usize, count: usize) -> Vec<(Vec<f64>, Vec<f64>)> {
    let mut seed = 7;
    (0..count)
        .map(|k| {
            let scatter = |value: &f64, seed: &mut u64| value * (1.0 + 0.1 * noise(seed));
            let mut x: Vec<f64> = x.iter().map(|v| scatter(v, &mut seed)).collect();
            let p = p.iter().map(|v| scatter(v, &mut seed)).collect();
            match k % 16 {
                3 => x[height] = -0.5,
                7 => x[height] = f64::NAN,
                11 => x[height] = 0.0,
                14 => x[height] = 40.0,
                _ => {}
            }
            (x, p)
        })
        .collect()
}

/// Largest difference between the final states, end times and apex heights of two results `a` and `b` of a flight. Each
/// difference is relative to the magnitude of the value in `b`, or to 1 if that is larger.
fn difference(a: &End, b: &End) -> f64 {
    let a = a.state.iter().chain([&a.time, &a.apex.1]);
    let b = b.state.iter().chain([&b.time, &b.apex.1]);
    let both = a.zip(b).filter(|(a, b)| !(a.is_nan() && b.is_nan()));
    both.map(|(a, b)| (a - b).abs() / b.abs().max(1.0))
        .fold(0.0, f64::max)
}

/// Test cases, each with a model, and the initial states and parameters of one flight.
fn scenes() -> Vec<(Model, Vec<f64>, Vec<f64>)> {
    let mut scenes = Vec::new();
    for (name, release) in [
        ("disc", "backhand"),
        ("discus", "discus"),
        ("ball", "serve"),
    ] {
        let model = model_spec::load::load(name, &[]).expect("a model");
        let text = built_in(release).expect("a release");
        let release = read(release, text, |_| Ok(Vocabulary::of(&model))).expect("a release");
        let p = CompiledModel::new(&model)
            .release_parameters(&release)
            .constants;
        scenes.push((model, release.state(), p));
    }
    let with = model_spec::load::load("disc", &["wind_by_height"]).expect("a disc with an effect");
    let layout = CompiledModel::interpreted(&with);
    let (_, x, _) = &scenes[0];
    let mut own = layout.layout().default_states();
    own[..x.len()].copy_from_slice(x);
    let p = layout.layout().default_parameters();
    scenes.push((with, own, p));
    let dart = model_spec::load::from_text("dart", DART, &[]).expect("a dart");
    let layout = CompiledModel::interpreted(&dart);
    let start = (
        layout.layout().default_states(),
        layout.layout().default_parameters(),
    );
    scenes.push((dart, start.0, start.1));
    scenes
}

fn height(model: &Model) -> usize {
    let z = model.states.iter().position(|state| state.name == "z");
    z.expect("a height")
}

#[test]
fn every_lane_is_the_scalar_flight() {
    for (model, x, p) in scenes() {
        let compiled = CompiledModel::new(&model);
        let z = height(&model);
        let flights = scattered(&x, &p, z, 48);
        let lane_model = LaneModel::new(&model);
        let mut outcomes = Vec::new();
        for method in [Method::Tsit5, Method::Dop853] {
            for (t_end, until_ground, max_steps) in [
                (600.0, true, 100_000),
                (0.3, false, 100_000),
                (600.0, true, 3),
            ] {
                let span = FlightSpan {
                    t_end,
                    height: Some(z),
                    seeks_apex: true,
                    until_ground,
                };
                let options = IntegrationOptions {
                    method,
                    max_steps,
                    ..Default::default()
                };
                let order = (0..flights.len()).collect();
                let ends = flown(&lane_model, &flights, order, (&span, &options), None);
                for (k, (flight, end)) in flights.iter().zip(ends).enumerate() {
                    let end = end.expect("every flight ends");
                    let expected = scalar(&compiled, flight, &span, &options);
                    let is_limit = matches!(end.outcome, FlightOutcome::Limit(_));
                    outcomes.push(end.outcome);
                    assert_eq!(
                        end.outcome, expected.outcome,
                        "{} {method:?} {k}",
                        model.name
                    );
                    // The apex has the accuracy of the dense output's slope; faults keep no apex.
                    let faults = [FlightOutcome::StartsBelowGround, FlightOutcome::NotFinite];
                    if faults.contains(&end.outcome) {
                        continue;
                    }
                    let (mut end, mut expected) = (end, expected);
                    let is_whole =
                        [FlightOutcome::Ground, FlightOutcome::Time].contains(&end.outcome);
                    if is_whole && until_ground {
                        assert!(
                            (end.apex.1 - expected.apex.1).abs() < 1e-7,
                            "{end:?} {expected:?}"
                        );
                    }
                    (end.apex, expected.apex) = ((0.0, 0.0), (0.0, 0.0));
                    if is_limit {
                        // The scalar solver reports the state at the limit, too.
                        assert!((end.time - expected.time).abs() < 1e-9);
                    }
                    let far = difference(&end, &expected);
                    // Where the steps run out depends on the last digits of their sizes.
                    let bound = match end.outcome {
                        FlightOutcome::TooManySteps => 1e-6,
                        _ => 1e-9,
                    };
                    assert!(
                        far < bound,
                        "{} {method:?} {k}: {far:e}\n{end:?}\n{expected:?}",
                        model.name
                    );
                }
            }
        }
        for outcome in [
            FlightOutcome::Ground,
            FlightOutcome::Time,
            FlightOutcome::TooManySteps,
            FlightOutcome::StartsBelowGround,
            FlightOutcome::NotFinite,
        ] {
            assert!(
                outcomes.contains(&outcome),
                "{} has no {outcome:?}",
                model.name
            );
        }
        let has_limit = outcomes
            .iter()
            .any(|o| matches!(o, FlightOutcome::Limit(_)));
        assert!(has_limit || model.name != "dart", "{}", model.name);
    }
}

#[test]
fn the_company_of_a_flight_changes_no_bit() {
    for (model, x, p) in scenes() {
        let z = height(&model);
        let flights = scattered(&x, &p, z, 61);
        let lane_model = LaneModel::new(&model);
        for method in [Method::Tsit5, Method::Dop853] {
            let span = FlightSpan {
                t_end: 600.0,
                height: Some(z),
                seeks_apex: true,
                until_ground: true,
            };
            let options = IntegrationOptions {
                method,
                ..Default::default()
            };
            let all = |order, isa| flown(&lane_model, &flights, order, (&span, &options), isa);
            let bits = |ends: &[Option<End>]| format!("{ends:?}");
            let forward = all((0..61).collect(), None);
            let backward = all((0..61).rev().collect(), None);
            assert_eq!(bits(&forward), bits(&backward), "{}", model.name);
            let shuffled = all((0..61).map(|k| k * 17 % 61).collect(), None);
            assert_eq!(bits(&forward), bits(&shuffled), "{}", model.name);
            for alone in [0, 8, 60] {
                let end = &all(vec![alone], None)[alone];
                assert_eq!(format!("{end:?}"), format!("{:?}", forward[alone]));
            }
            // Lanes of another width that fuse as these do.
            if Isa::Avx512.is_supported() {
                let [wide, narrow] =
                    [Isa::Avx512, Isa::Avx2].map(|isa| all((0..61).collect(), Some(isa)));
                assert_eq!(bits(&wide), bits(&narrow), "{}", model.name);
            }
        }
    }
}

#[test]
fn the_tape_flies_as_the_generated_code_does() {
    let (model, x, p) = scenes().remove(0);
    let z = height(&model);
    let flights = scattered(&x, &p, z, 20);
    let span = FlightSpan {
        t_end: 600.0,
        height: Some(z),
        seeks_apex: true,
        until_ground: true,
    };
    let options = IntegrationOptions::default();
    let [code, tape] = [LaneModel::new(&model), LaneModel::interpreted(&model)];
    assert!(code.is_generated() && !tape.is_generated());
    let order = || (0..flights.len()).collect();
    let code = flown(&code, &flights, order(), (&span, &options), None);
    let tape = flown(&tape, &flights, order(), (&span, &options), None);
    for (a, b) in code.into_iter().flatten().zip(tape.into_iter().flatten()) {
        assert_eq!(a.outcome, b.outcome);
        assert!(difference(&a, &b) < 1e-9);
    }
}

#[test]
fn pulses_in_time_are_flown_in_lanes_as_by_the_scalar_solver() {
    let text = crate::singular_points::KICKS;
    let model = model_spec::load::from_text("kicks.hyz", text, &[]).expect("a model");
    let (compiled, lanes) = (CompiledModel::new(&model), LaneModel::new(&model));
    let parameters = compiled.layout().default_parameters();
    let switch = compiled.layout().parameter("t_on").expect("t_on").index();
    let flights: Vec<_> = (0..40)
        .map(|k| {
            let mut own = parameters.clone();
            own[switch] = 0.15 * f64::from(k);
            (compiled.layout().default_states(), own)
        })
        .collect();
    let span = FlightSpan {
        t_end: 8.0,
        height: None,
        seeks_apex: false,
        until_ground: false,
    };
    let options = IntegrationOptions::with_tolerance(1e-6);
    let ends = flown(&lanes, &flights, (0..40).collect(), (&span, &options), None);
    for (flight, end) in flights.iter().zip(ends) {
        let end = end.expect("flown");
        let expected = scalar(&compiled, flight, &span, &options);
        assert_eq!((end.time, end.steps), (expected.time, expected.steps));
        for (own, other) in end.state.iter().zip(&expected.state) {
            assert!((own - other).abs() < 1e-9, "{own} {other}");
        }
        assert!((end.state[4] - 5.0).abs() < 1e-6, "{:?}", end.state);
    }
}

#[test]
fn inputs_over_time_are_those_of_the_scalar_flight() {
    let text = DART.replace(
        "coefficient s = 3 1/s;",
        "coefficient s = 3 1/s;\ninput thrust: m/s^2 = 0;",
    );
    let text = text.replace(
        "der(vx) = dot(drag, N.1);",
        "der(vx) = dot(drag, N.1) + thrust;",
    );
    let model =
        model_spec::load::from_text("dart.hyz", &text, &["lag_of_thrust"]).expect("a model");
    let compiled = CompiledModel::new(&model);
    let samples: Vec<(f64, f64)> = (0..=40)
        .map(|k| f64::from(k) * 0.03)
        .map(|t| (t, 30.0 * (9.0 * t).sin()))
        .collect();
    for interpolation in [
        InputInterpolation::Linear,
        InputInterpolation::Hold,
        InputInterpolation::Cubic,
    ] {
        let series = InputSeries::new(&samples, interpolation);
        let inputs = InputsOverTime::of(compiled.layout(), [("thrust", series)]);
        let lanes = LaneModel::new(&model).with_inputs(inputs.clone());
        let mut p = compiled.layout().default_parameters();
        let lag = compiled
            .layout()
            .parameter("k_lag_of_thrust")
            .expect("a lag");
        p[lag.index()] = 0.02;
        let flights = scattered(&compiled.layout().default_states(), &p, height(&model), 24);
        for t_end in [1.0, 1.5] {
            let span = FlightSpan {
                t_end,
                height: Some(height(&model)),
                seeks_apex: false,
                until_ground: false,
            };
            let options = IntegrationOptions::with_tolerance(1e-9);
            let order = (0..flights.len()).collect();
            let ends = flown(&lanes, &flights, order, (&span, &options), None);
            for (flight, end) in flights.iter().zip(ends) {
                let end = end.expect("every flight ends");
                let parameters = FlightParameters {
                    constants: flight.1.clone(),
                    inputs: inputs.clone(),
                };
                let bound = compiled.bind(parameters);
                let start = flight.0.clone().into();
                let alone = bound.integrate((0.0, &start), t_end, &options, &mut bound.limits());
                match (alone, end.outcome) {
                    (Ok(alone), FlightOutcome::Time) => {
                        for (a, b) in end.state.iter().zip(alone.end_state.iter()) {
                            assert!(
                                (a - b).abs() < 1e-8 * b.abs().max(1.0),
                                "{interpolation:?} {a} {b}"
                            );
                        }
                    }
                    // The inputs end at 1.2 s; their limit comes after that of the model.
                    (Err(error), FlightOutcome::Limit(limit)) => {
                        assert_eq!(limit == 1, error.to_string().contains("thrust"), "{error}");
                        assert!((error.time - end.time).abs() < 1e-8, "{error} {}", end.time);
                    }
                    (Err(_), FlightOutcome::NotFinite | FlightOutcome::StartsBelowGround) => {}
                    (alone, outcome) => panic!("{outcome:?}: {:?}", alone.err()),
                }
            }
        }
    }
}
