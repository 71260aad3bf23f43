//! Constraints of declared bodies, and their drift in flights.

use flight::{CompiledModel, ModelState};
use model_spec::load::from_text;
use ode::{IntegrationOptions, OdeRhs, integrate, integrate_to_end, rhs_from_fn};

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
/// in the dense output of the held ones.
fn drifts(text: &str, values: &[(&str, f64)], tolerance: f64) -> [f64; 3] {
    let compiled = compiled(text);
    let bound = compiled.bind(compiled.layout().default_parameters());
    let constraints = compiled.constraints().expect("constraints");
    let mut constraints = constraints.bind(compiled.layout().default_parameters());
    let mut off = |t: f64, state: &[f64]| constraints.deviations(t, state).0.amax();
    let start = state(&compiled, values);
    assert!(off(0.0, &start) < 1e-15);
    let options = IntegrationOptions::with_tolerance(tolerance);
    let mut worst = [0.0_f64; 3];
    for half_seconds in 1..=20 {
        let (start, end) = ((0.0, &start), 0.5 * f64::from(half_seconds));
        let held = bound.integrate(start, end, &options, &mut bound.limits());
        let held = held.unwrap_or_else(|error| panic!("{error}"));
        let free = integrate_to_end(&mut Free(bound.rhs()), start, end, &options, &mut []);
        let free = free.expect("it swings").state;
        if let Some(first) = compiled.layout().state("q0") {
            let quaternion = &held.end_state[first.index()..][..4];
            let length = quaternion.iter().map(|q| q * q).sum::<f64>().sqrt();
            assert!((length - 1.0).abs() < 100.0 * tolerance, "{length}");
        }
        let between = (0..200).map(|k| end * f64::from(k) / 200.0);
        let between = between.map(|t| off(t, &held.sample(t).expect("within")));
        let between = between.fold(0.0, f64::max);
        let found = [off(end, &held.end_state), off(end, &free), between];
        worst = [0, 1, 2].map(|k| worst[k].max(found[k]));
    }
    worst
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
            // Dense output has its own error, which does not grow.
            assert!(between <= 1e3 * tolerance, "{name}: {between:e}");
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
