//! Constraints of declared bodies, and their drift in flights.

use flight::{BoundModel, CompiledModel, LaneModel, ModelState};
use model_spec::load::from_text;
use nalgebra::DVector;
use ode::{
    Event, FlightEnd, FlightOutcome, FlightQueue, FlightSpan, IntegrationOptions, OdeRhs, Project,
    RhsProperties, Sensitivities, integrate, integrate_to_end, rhs_from_fn,
};

/// A bob on a rod, as a declared point.
const BOB: &str = "model bob;
param m = 0.5 kg;
param L = 1.2 m;
param g = 9.81 m/s^2;
frame N;
point bob { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
force weight = -m*g*N.3;
force rod = -T*unit(position);
solve rod {
  unknown T: N;
  constraint norm(position) = L within 0.1 m;
}
";

/// A rod that hangs by its end on a string, as a declared body with velocities in its own frame.
const ROD: &str = "model rod;
param m = 0.5 kg;
param l = 0.6 m;
param I = 0.06 kg*m^2;
param I_a = 1e-3 kg*m^2;
param L = 0.8 m;
param g = 9.81 m/s^2;
frame N;
frame C = N by quaternion (q0, q1, q2, q3);
body rod {
  mass m; inertia diag(I, I, I_a) in C; fixed in C; axis C.3;
  position (x, y, z) in N; velocity (u, v, w) in C; angular velocity (p, q, r) in C;
}
let end = position + l*in_N(C.3);
force weight = -m*g*N.3;
force string = -T*unit(end);
moment string = l*C.3 × in_C(-T*unit(end));
solve string {
  unknown T: N;
  constraint norm(end) = L within 1 cm;
}
";

/// The right-hand side of a model, whose steps are not held to the constraints.
struct Free<D>(D);

impl<D> RhsProperties for Free<D> {}

impl<D: OdeRhs> OdeRhs for Free<D> {
    type State = D::State;

    fn derivative(&mut self, t: f64, x: &D::State, dx: &mut D::State) {
        self.0.derivative(t, x, dx);
    }
}

fn compiled(text: &str) -> CompiledModel {
    let model = from_text("probe.hyz", text, &[]).unwrap_or_else(|error| panic!("{error}"));
    CompiledModel::new(&model)
}

fn state(compiled: &CompiledModel, values: &[(&str, f64)]) -> ModelState {
    let mut state = compiled.layout().default_states();
    for (name, value) in values {
        state[compiled.layout().state(name).expect(name).index()] = *value;
    }
    state.into()
}

/// Greatest deviations from constraints in flights of 0.5 s to 10 s: at their ends, held to the constraints and not, and
/// where the held ones are read between the steps.
fn drifts(text: &str, values: &[(&str, f64)], tolerance: f64) -> [f64; 3] {
    let compiled = compiled(text);
    let bound = compiled.bind(compiled.layout().default_parameters());
    let constraints = compiled.constraints().expect("constraints");
    let constraints = constraints.bind(compiled.layout().default_parameters());
    let off = |t: f64, state: &[f64]| constraints.deviations(t, state).0.amax();
    let start = state(&compiled, values);
    assert!(off(0.0, &start) < 1e-15);
    let options = IntegrationOptions::with_tolerance(tolerance);
    let mut worst = [0.0_f64; 3];
    for half_seconds in 1..=20 {
        let (from, end) = ((0.0, &start), 0.5 * f64::from(half_seconds));
        let held = bound.integrate(from, end, &options, &mut bound.limits());
        let held = held.unwrap_or_else(|error| panic!("{error}"));
        let free = integrate_to_end(&mut Free(bound.rhs()), from, end, &options, &mut []);
        let free = free.expect("it swings").state;
        if let Some(first) = compiled.layout().state("q0") {
            let quaternion = &held.end_state[first.index()..][..4];
            let length = quaternion.iter().map(|q| q * q).sum::<f64>().sqrt();
            assert!((length - 1.0).abs() < 100.0 * tolerance, "{length}");
        }
        let times: Vec<f64> = (0..200).map(|k| end * f64::from(k) / 200.0).collect();
        let between = times
            .iter()
            .map(|&t| off(t, &held.sample(t).expect("within")));
        let between = between.fold(read_off(&bound, &start, &times, &options, &off), f64::max);
        let found = [off(end, &held.end_state), off(end, &free), between];
        worst = [0, 1, 2].map(|k| worst[k].max(found[k]));
    }
    worst
}

/// Greatest deviation in the states of a flight at `times`, and at the highest points of its first state.
fn read_off(
    bound: &BoundModel<'_>,
    start: &ModelState,
    times: &[f64],
    options: &IntegrationOptions,
    off: &dyn Fn(f64, &[f64]) -> f64,
) -> f64 {
    let mut samples = vec![0.0; start.len() * times.len()];
    let mut events = [Event::peak_of("peak", 0)];
    let from = (0.0, start);
    let flown = bound.integrate_at(from, times, options, &mut events, &mut samples);
    let peaks = flown.expect("it swings").occurrences;
    assert!(times[199] < 2.0 || !peaks.is_empty());
    let samples = times.iter().zip(samples.chunks(start.len()));
    let peaks = peaks.iter().map(|own| off(own.time, &own.state));
    let samples = samples.map(|(&t, state)| off(t, state));
    samples.chain(peaks).fold(0.0, f64::max)
}

/// Derivatives of the states of a flight by its initial states, along directions that keep the constraints, and by a
/// parameter, against differences of flights.
#[test]
fn sensitivities_are_those_of_the_projected_states() {
    for (text, values, parameter) in [(BOB, &SWING[..], "g"), (ROD, &HANGING, "I_a")] {
        let compiled = compiled(text);
        let parameters = compiled.layout().default_parameters();
        let index = compiled
            .layout()
            .parameter(parameter)
            .expect("declared")
            .index();
        let start = state(&compiled, values);
        let constraints = compiled.constraints().expect("constraints");
        let constraints = constraints.bind(parameters.clone());
        let mut direction: Vec<f64> = (0..start.len()).map(|k| (k as f64 + 0.3).sin()).collect();
        constraints.project_directions(0.0, &start, &mut direction);
        let options = IntegrationOptions::with_tolerance(1e-7);
        let times: Vec<f64> = (1..=97).map(|k| f64::from(k) * 0.031).collect();
        let flown = |along: f64, by: f64| {
            let mut moved = start.clone();
            for (value, direction) in moved.iter_mut().zip(&direction) {
                *value += along * direction;
            }
            constraints.project(0.0, &mut moved, None);
            let mut parameters = parameters.clone();
            parameters[index] += by;
            let mut samples = vec![0.0; start.len() * times.len()];
            let bound = compiled.bind(parameters);
            let (from, none) = ((0.0, &moved), &mut [][..]);
            bound
                .integrate_at(from, &times, &options, none, &mut samples)
                .expect("it swings");
            samples
        };
        let bound = compiled.bind(parameters.clone());
        let mut rhs = bound.rhs();
        let mut both = Sensitivities::new(&mut rhs, 1, &[index]);
        let entries = direction.iter().enumerate();
        let entries: Vec<_> = entries.map(|(k, value)| (k, 0, *value)).collect();
        let augmented = both.initial_state(&start, &entries);
        let mut samples = vec![0.0; both.len() * times.len()];
        let from = (0.0, &augmented);
        both.integrate_at(from, &times, &options, &mut [], &mut samples)
            .expect("it swings");
        let (layout, length) = (both.layout(), both.len());
        let step = 1e-6;
        for column in 0..2 {
            let by = |sign: f64| match column {
                0 => flown(sign * step, 0.0),
                _ => flown(0.0, sign * step * parameters[index]),
            };
            let width = 2.0 * step * if column == 0 { 1.0 } else { parameters[index] };
            let (above, below) = (by(1.0), by(-1.0));
            let mut worst = [0.0_f64; 3];
            for (k, augmented) in samples.chunks(length).enumerate() {
                let (_, by_state) = constraints.deviations(times[k], layout.state(augmented));
                let rows = (0..start.len()).map(|row| layout.padded_row(augmented, row)[column]);
                let found = DVector::from_iterator(start.len(), rows);
                let difference = |row| {
                    let row = k * start.len() + row;
                    (above[row] - below[row]) / width
                };
                let expected = DVector::from_fn(start.len(), |row, _| difference(row));
                worst[0] = worst[0].max((&found - &expected).amax());
                worst[1] = worst[1].max(expected.amax());
                worst[2] = worst[2].max((by_state * found).amax());
            }
            println!("{parameter} {column}: {worst:?}");
            assert!(worst[0] < 1e-5 * worst[1].max(1e-3), "{worst:?}");
            assert!(worst[2] < 1e-12 * worst[1].max(1.0), "{worst:?}");
        }
    }
}

const SWING: [(&str, f64); 5] = [
    ("x", 0.72),
    ("z", -0.96),
    ("vy", 1.5),
    ("vx", 0.8),
    ("vz", 0.6),
];

#[test]
fn a_flight_drifts_from_a_constraint_by_at_most_its_tolerance() {
    for (name, text, values) in [("bob", BOB, &SWING[..]), ("rod", ROD, &HANGING)] {
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
            let [held, free, between] = drifts(text, values, tolerance);
            println!(
                "{name} {tolerance:.0e}: held {held:.1e}, free {free:.1e}, dense {between:.1e}"
            );
            assert!(held <= 1e-13 && held <= tolerance, "{name}: {held:e}");
            assert!(free > 10.0 * held, "{name}: {held:e} {free:e}");
            assert!(
                between <= 1e-13 && between <= tolerance,
                "{name}: {between:e}"
            );
        }
    }
}

/// By half an angle of 1 rad about axis 2: its upper end, on axis 3, is at rest 0.8 m below the origin.
const HANGING: [(&str, f64); 7] = [
    ("q0", 0.877_582_561_890_372_8),
    ("q2", 0.479_425_538_604_203),
    ("x", -0.504_882_590_884_737_9),
    ("z", -1.124_181_383_520_883_8),
    ("q", 0.7),
    ("u", -0.42),
    ("r", 3.0),
];

/// The bob against a pendulum in spherical coordinates.
#[test]
fn a_declared_bob_swings_as_a_spherical_pendulum() {
    let compiled = compiled(BOB);
    let bound = compiled.bind(compiled.layout().default_parameters());
    let start = state(&compiled, &[("x", 0.72), ("z", -0.96), ("vy", 1.0)]);
    let options = IntegrationOptions::with_tolerance(1e-12);
    let flight = bound.integrate((0.0, &start), 10.0, &options, &mut bound.limits());
    let end = flight.unwrap_or_else(|error| panic!("{error}")).end_state;
    // Angle from the downward vertical, azimuth, rate of the angle; the momentum about the vertical is kept.
    let (g, length) = (9.81, 1.2);
    let momentum = 0.72 * 1.0;
    let mut rhs = rhs_from_fn(&[], |_, x: &[f64; 3], dx: &mut [f64; 3]| {
        let (sin, cos) = x[0].sin_cos();
        let turn = momentum / (length * sin).powi(2);
        *dx = [x[2], turn, turn * turn * sin * cos - g / length * sin];
    });
    let start = [(0.72_f64 / 0.96).atan(), 0.0, 0.0];
    let reference = integrate(&mut rhs, (0.0, &start), 10.0, &options, &mut []).expect("it swings");
    let [angle, azimuth, _]: [f64; 3] = reference.end_state.try_into().expect("three");
    let expected = [
        length * angle.sin() * azimuth.cos(),
        length * angle.sin() * azimuth.sin(),
        -length * angle.cos(),
    ];
    for (name, expected) in ["x", "y", "z"].into_iter().zip(expected) {
        let found = end[compiled.layout().state(name).expect(name).index()];
        assert!(
            (found - expected).abs() < 1e-9,
            "{name}: {found} {expected}"
        );
    }
}

/// Flights that differ in the speed of the bob, and their ends.
struct Bobs {
    start: ModelState,
    parameters: Vec<f64>,
    speed: usize,
    next: u64,
    ends: Vec<(FlightOutcome, f64, Vec<f64>, f64)>,
}

impl FlightQueue for Bobs {
    fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64> {
        let flight = self.next;
        self.next += 1;
        x.copy_from_slice(&self.start);
        x[self.speed] += 0.1 * flight as f64;
        p.copy_from_slice(&self.parameters);
        (flight < 20).then_some(flight)
    }

    fn end(&mut self, end: FlightEnd<'_>) {
        let state = end.state.to_vec();
        self.ends.push((end.outcome, end.time, state, end.apex.1));
    }
}

#[test]
fn flights_of_a_queue_are_held_to_constraints() {
    let model = from_text("probe.hyz", BOB, &[]).unwrap_or_else(|error| panic!("{error}"));
    let compiled = CompiledModel::new(&model);
    let parameters = compiled.layout().default_parameters();
    let index = |name| compiled.layout().state(name).expect(name).index();
    let mut flights = Bobs {
        start: state(&compiled, &SWING),
        speed: index("vy"),
        next: 0,
        ends: Vec::new(),
        parameters: parameters.clone(),
    };
    // It starts above the height at which it ends.
    flights.start[index("z")] = 0.96;
    flights.start[index("vz")] = -0.6;
    let span = FlightSpan {
        t_end: 10.0,
        height: Some(index("z")),
        seeks_apex: true,
        until_ground: true,
    };
    let options = IntegrationOptions::default();
    let evaluations = LaneModel::new(&model).fly(&mut flights, &span, &options, None);
    assert!(evaluations > 1000, "{evaluations}");
    let constraints = compiled.constraints().expect("constraints");
    let constraints = constraints.bind(parameters);
    assert_eq!(flights.ends.len(), 20);
    for (outcome, time, state, apex) in &flights.ends {
        assert_eq!(*outcome, FlightOutcome::Ground);
        assert!(*time > 0.1 && *apex >= 0.96, "{time} {apex}");
        assert!(state[index("z")].abs() < 1e-9, "{state:?}");
        assert!(constraints.deviations(*time, state).0.amax() < 1e-13);
    }
    // A state off the rod is refused.
    flights.start[index("x")] += 1.0;
    (flights.next, flights.ends) = (0, Vec::new());
    LaneModel::new(&model).fly(&mut flights, &span, &options, None);
    let refused = |own: &(FlightOutcome, f64, Vec<f64>, f64)| own.0 == FlightOutcome::Limit(0);
    assert!(flights.ends.iter().all(refused), "{:?}", flights.ends[0]);
}

/// Also on one whose value is −1 or 0.
#[test]
fn constraints_depend_on_the_parameters_that_they_name() {
    let text = BOB
        .replace("frame N;", "param a = -1 m;\nparam b = 0 m;\nframe N;")
        .replace(
            "norm(position) = L",
            "norm(position - (a, b, 0 m) in N) = L",
        );
    let compiled = compiled(&text);
    let layout = compiled.layout();
    let constraints = compiled.constraints().expect("constraints");
    let mut named = layout
        .parameters
        .iter()
        .enumerate()
        .filter_map(|(index, own)| {
            let depends = constraints.depend_on(&layout.default_parameters(), index);
            depends.then_some(own.as_str())
        })
        .collect::<Vec<_>>();
    named.sort_unstable();
    assert_eq!(named, ["L", "a", "b"]);
}
