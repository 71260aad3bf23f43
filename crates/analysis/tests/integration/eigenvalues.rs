//! Modes against simulated flights, models of the same body against one another, the criteria against the modes.

use analysis::stability::{Body, BoundBody, FlightDirection, ModeKind, Modes, at, modes};
use flight::throw::Throw;
use nalgebra::{Complex, Vector3};
use ode::{IntegrationOptions, integrate};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

pub fn body(name: &str) -> Body {
    Body::new(model_spec::load::load(name, &[]).expect(name)).expect(name)
}

pub fn defaults(body: &Body) -> BoundBody<'_> {
    body.with_parameters(body.compiled.layout().default_parameters())
}

fn backhand(speed: f64, spin: f64) -> Throw {
    Throw {
        nose: Some(4.0),
        hyzer: Some(5.0),
        launch: 3.0,
        spin: Some(spin),
        height: 2.0,
        ..Throw::at_speed(speed)
    }
}

fn modes_of(bound: &BoundBody<'_>, throw: &Throw) -> Modes {
    let state = bound
        .body
        .thrown
        .state(throw, [0.0; 2], &bound.parameters)
        .expect("a state");
    modes(&bound.linearise(0.0, &state).expect("a linearisation"), 0.0)
}

#[test]
fn one_body_in_two_charts_has_the_same_modes() {
    let (angles, quaternion) = (body("disc"), body("disc_quaternion"));
    for speed in [8.0, 14.0, 22.0] {
        let throw = backhand(speed, 40.0 * speed);
        let a = modes_of(&defaults(&angles), &throw);
        let b = modes_of(&defaults(&quaternion), &throw);
        assert_eq!(a.ignorable, ["x", "y", "z", "turn about the axis"]);
        assert_eq!(a.ignorable, b.ignorable);
        assert_eq!(a.modes.len(), b.modes.len());
        for (a, b) in a.modes.iter().zip(&b.modes) {
            assert_eq!(a.kind, b.kind);
            assert!(
                (a.value - b.value).norm() < 1e-6 * (1.0 + a.value.norm()),
                "{} {}",
                a.value,
                b.value
            );
        }
    }
}

#[test]
fn many_throws_have_the_same_modes_in_two_charts() {
    let (angles, quaternion) = (body("disc"), body("disc_quaternion"));
    let (angles, quaternion) = (defaults(&angles), defaults(&quaternion));
    for k in 0..200 {
        let part = |step: f64| (f64::from(k) * step).fract();
        let throw = Throw {
            launch: 40.0 * part(0.618) - 10.0,
            nose: Some(20.0 * part(0.755) - 5.0),
            hyzer: Some(80.0 * part(0.570) - 40.0),
            ..backhand(8.0 + 17.0 * part(0.414), 200.0 + 900.0 * part(0.732))
        };
        let (a, b) = (modes_of(&angles, &throw), modes_of(&quaternion, &throw));
        assert_eq!(a.ignorable, b.ignorable, "{throw:?}");
        for (a, b) in a.modes.iter().zip(&b.modes) {
            let off = (a.value - b.value).norm();
            assert!(off < 1e-6 * (1.0 + a.value.norm()), "{throw:?}: {off:e}");
        }
    }
}

/// Measures the nutation (wobble) in simulated flights between two times: phase advance (rad), and logarithm of the
/// ratio of initial to final amplitude. The signal is the angular velocity normal to the body axis, in a flight with
/// small wobble minus a flight without.
fn measured(bound: &BoundBody<'_>, throw: &Throw, (from, until): (f64, f64)) -> (f64, f64) {
    const SAMPLES: usize = 2000;
    /// Number of samples between the values of which second differences are taken; the differences remove slow motions
    /// from the signal.
    const APART: usize = 20;
    let thrown = &bound.body.thrown;
    let options = IntegrationOptions::with_tolerance(1e-12);
    let fly = |wobble: Option<f64>| {
        let throw = Throw { wobble, ..*throw };
        let state = thrown
            .state(&throw, [0.0; 2], &bound.parameters)
            .expect("a state");
        let start: Box<[f64]> = state.into();
        integrate(
            &mut bound.bound().rhs(),
            (0.0, &start),
            until + 0.02,
            &options,
            &mut [],
        )
        .expect("a flight")
    };
    let (plain, wobbling) = (fly(None), fly(Some(0.1)));
    let step = (until - from) / SAMPLES as f64;
    let sample = |k: usize| {
        let t = from + step * (k as f64 - APART as f64);
        let across = |flight: &ode::Trajectory| {
            let motion = thrown.motion(&flight.sample(t).expect("within"), &bound.parameters);
            let turning = motion.turning.expect("an attitude");
            let axis = turning.axes.column(2).into_owned();
            (turning.rates - axis * axis.dot(&turning.rates), axis)
        };
        let ((a, axis), (b, _)) = (across(&wobbling), across(&plain));
        // Inertial axes across the body's, which moves little while the nutation goes round.
        let first = (Vector3::x() - axis * axis.x).normalize();
        let off = a - b;
        Complex::new(off.dot(&first), off.dot(&axis.cross(&first)))
    };
    let signal: Vec<Complex<f64>> = (0..=SAMPLES + 2 * APART).map(sample).collect();
    let fast: Vec<Complex<f64>> = (0..=SAMPLES)
        .map(|k| signal[k] - signal[k + APART] * 2.0 + signal[k + 2 * APART])
        .collect();
    let phase: f64 = fast.windows(2).map(|pair| (pair[1] / pair[0]).arg()).sum();
    // The mean amplitude of a turn or so at each end: an oval nutation has two.
    let turn =
        ((SAMPLES as f64 * std::f64::consts::TAU / phase.abs()).round() as usize).min(SAMPLES / 3);
    let mean = |at: usize| {
        fast[at..at + turn]
            .iter()
            .map(|z| z.norm().ln())
            .sum::<f64>()
            / turn as f64
    };
    let loss = (mean(0) - mean(SAMPLES - turn)) * SAMPLES as f64 / (SAMPLES - turn) as f64;
    (phase.abs(), loss)
}

/// Integrals, between two times, of the frequency and the decay rate of the nutation (wobble) mode along the flight
/// without wobble: the expected phase advance, rad, and logarithm of the ratio of initial to final amplitude.
fn expected(bound: &BoundBody<'_>, throw: &Throw, (from, until): (f64, f64)) -> (f64, f64) {
    let thrown = &bound.body.thrown;
    let state = thrown
        .state(throw, [0.0; 2], &bound.parameters)
        .expect("a state");
    let start: Box<[f64]> = state.into();
    let options = IntegrationOptions::with_tolerance(1e-10);
    let flight = integrate(
        &mut bound.bound().rhs(),
        (0.0, &start),
        until,
        &options,
        &mut [],
    )
    .expect("a flight");
    let steps = 40;
    let (mut phase, mut loss) = (0.0, 0.0);
    for k in 0..=steps {
        let t = from + (until - from) * f64::from(k) / f64::from(steps);
        let linearised = bound
            .linearise(t, &flight.sample(t).expect("within"))
            .expect("a linearisation");
        let modes = modes(&linearised, 0.0).modes;
        let nutation = modes
            .iter()
            .find(|mode| mode.kind == ModeKind::Nutation)
            .expect("a nutation");
        let weight =
            if k == 0 || k == steps { 0.5 } else { 1.0 } * (until - from) / f64::from(steps);
        phase += weight * nutation.frequency();
        loss += weight * nutation.decay();
    }
    (phase, loss)
}

#[test]
fn the_nutation_is_the_one_of_simulated_flights() {
    let mut worst = (0.0_f64, 0.0_f64);
    for name in ["disc", "disc_quaternion", "discus"] {
        let body = body(name);
        let bound = defaults(&body);
        for (speed, spin) in [
            (10.0, 400.0),
            (14.0, 600.0),
            (18.0, 900.0),
            (24.0, 1100.0),
            (14.0, -700.0),
        ] {
            let throw = backhand(speed, spin);
            let window = (0.02, 0.32);
            let (phase, loss) = measured(&bound, &throw, window);
            let (of_modes, decay) = expected(&bound, &throw, window);
            let (off, by) = (phase / of_modes - 1.0, (loss - decay) / decay);
            println!(
                "{name} {speed} {spin}: {phase:.3} {of_modes:.3} rad {off:+.5}; {loss:.4} {decay:.4} {by:+.4}"
            );
            worst = (worst.0.max(off.abs()), worst.1.max(by.abs()));
        }
    }
    assert!(worst.0 < 0.01 && worst.1 < 0.01, "{worst:?}");
}

/// Draws a disc with random coefficients, and a throw of it with random speed and spin; some of these discs are
/// unstable.
fn disc_of_grid<'b>(body: &'b Body, random: &mut ChaCha8Rng) -> (BoundBody<'b>, Throw) {
    let layout = body.compiled.layout();
    let mut between = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let mut parameters = layout.default_parameters();
    // Without roll by spin, whose moment the criteria do not know.
    for (name, low, high) in [
        ("C_Ma", -1.0, 1.0),
        ("C_Mq", -0.03, 0.0),
        ("C_La", 0.3, 4.0),
        ("C_D0", 0.05, 0.3),
        ("C_L0", 0.0, 0.3),
        ("I_d", 0.0008, 0.003),
        ("C_Rr", 0.0, 0.0),
    ] {
        parameters[layout.parameter(name).expect(name).index()] = between(low, high);
    }
    let throw = Throw {
        spin: Some(between(0.0, 1200.0)),
        nose: Some(0.0),
        ..Throw::at_speed(between(6.0, 30.0))
    };
    (body.with_parameters(parameters), throw)
}

#[test]
fn the_criteria_agree_with_the_modes_of_a_thousand_discs() {
    let body = body("disc");
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let (mut stable, mut disagreements) = (0, Vec::new());
    for case in 0..1000 {
        let (bound, throw) = disc_of_grid(&body, &mut random);
        let state = body
            .thrown
            .state(&throw, [0.0; 2], &bound.parameters)
            .expect("a state");
        let instant = at(&bound, 0.0, &state).expect("modes");
        let roots = instant.derivatives.eigenvalues();
        // Routh and Hurwitz against the zeros of the polynomial itself.
        let decays = roots.iter().all(|root| root.re < 0.0);
        assert_eq!(decays, instant.criteria.is_stable(), "{case}: {roots:?}");
        stable += usize::from(decays);
        // Each zero against the mode of the whole body next to it.
        for root in roots.iter().filter(|root| root.im >= 0.0) {
            let values = instant.modes.modes.iter().map(|mode| mode.value);
            let nearest = values.min_by(|a, b| (a - root).norm().total_cmp(&(b - root).norm()));
            let nearest = nearest.expect("modes");
            if (nearest.re < 0.0) != (root.re < 0.0) {
                disagreements.push((case, *root, nearest, instant.criteria.gyroscopic_factor));
            }
        }
    }
    println!("{stable} stable; {disagreements:?}");
    // Both answers occur often, so that agreement says something.
    assert!((100..900).contains(&stable), "{stable}");
    assert!(disagreements.len() <= 2, "{disagreements:?}");
    for (case, root, nearest, factor) in disagreements {
        // Either neutral but for what the criteria leave out (gravity and drag, of the order of g/V), or at the limit of the spin's
        // stiffness, where path and axis move alike.
        let is_neutral = root.re.abs() < 0.05 && nearest.re.abs() < 0.05;
        let is_marginal = (0.0..2.0).contains(&factor);
        assert!(
            is_neutral || is_marginal,
            "{case}: {root} {nearest} {factor}"
        );
    }
}

#[test]
fn the_roll_of_straight_flight_is_that_of_crowther_and_potts() {
    let body = body("disc");
    let layout = body.compiled.layout();
    for (speed, spin, nose) in [(14.0, 900.0, 6.0), (18.0, 1100.0, 3.0), (14.0, -900.0, 6.0)] {
        let mut parameters = layout.default_parameters();
        parameters[layout.parameter("C_Rr").expect("C_Rr").index()] = 0.0;
        let bound = body.with_parameters(parameters);
        let throw = Throw {
            spin: Some(spin),
            nose: Some(nose),
            ..Throw::at_speed(speed)
        };
        let state = body
            .thrown
            .state(&throw, [0.0; 2], &bound.parameters)
            .expect("a state");
        let options = IntegrationOptions::with_tolerance(1e-11);
        let start: Box<[f64]> = state.into();
        let end = 0.5;
        let flight = integrate(
            &mut bound.bound().rhs(),
            (0.0, &start),
            end,
            &options,
            &mut [],
        )
        .expect("a flight");
        // Roll of the axis to the left edge down, over the flight once the wobble has decayed, and the closed form's along it.
        let (from, steps) = (0.3, 200);
        let side = |t: f64| {
            let motion = body
                .thrown
                .motion(&flight.sample(t).expect("within"), &bound.parameters);
            let left = Vector3::z().cross(&motion.velocity).normalize();
            motion
                .turning
                .expect("an attitude")
                .axes
                .column(2)
                .dot(&left)
                .asin()
        };
        let rolled = -(side(end) - side(from));
        let times = (0..=steps).map(|k| from + (end - from) * f64::from(k) / f64::from(steps));
        let rates =
            times.map(|t| at(&bound, t, &flight.sample(t).expect("within")).expect("modes"));
        let mean = rates.map(|i| i.criteria.roll_rate).sum::<f64>() / f64::from(steps + 1);
        let expected = mean * (end - from);
        println!("{speed} {spin}: rolled {rolled:.5}, closed form {expected:.5}");
        assert!(
            (rolled / expected - 1.0).abs() < 0.06,
            "{speed} {spin}: {rolled} {expected}"
        );
    }
}

/// A shell on stated derivatives, whose axis is held by its spin alone.
const SHELL: &str = "model shell;
param m = 43 kg;
param d = 15.5 cm;
param I_a = 0.14 kg*m^2;
param I_t = 1.2 kg*m^2;
param rho = 1.2 kg/m^3;
param g = 9.81 m/s^2;
coefficient C_N = 2.2 in 0 .. 10;
coefficient C_M = 3.5 in -10 .. 10;
coefficient C_Mq = -12 in -50 .. 0;
coefficient C_p = 0.1 in -3 .. 3;
coefficient C_D = 0.3 in 0 .. 2;
frame N;
frame B = N by quaternion (q0, q1, q2, q3);
body shell {
  mass m; inertia diag(I_t, I_t, I_a) in B; fixed in B;
  position (x, y, z) in N; velocity (vx, vy, vz) in N; angular velocity (p, q, r) in B;
}
let V = norm(velocity);
let i = in_B(unit(velocity));
let Q = rho*V^2/2*pi*d^2/4;
force weight = -m*g*N.3;
force air = -Q*C_D*i + Q*C_N*(B.3 - i.3*i);
moment overturning = Q*d*C_M*cross(i, B.3);
moment damping = Q*d*ratio(d, V, 0 s)*C_Mq*(angular_velocity - r*B.3);
moment magnus = Q*d*ratio(r*d, V, 0)*C_p*cross(B.3, cross(i, B.3));
";

#[test]
fn the_criteria_of_projectiles_agree_with_their_modes() {
    let model = model_spec::load::from_text("shell.hyz", SHELL, &[]).expect("a model");
    let body = Body::new(model).expect("a body");
    let layout = body.compiled.layout();
    let index = |name: &str| layout.parameter(name).expect(name).index();
    let mut random = ChaCha8Rng::seed_from_u64(8);
    let (mut stable, mut slow) = (0, 0);
    for case in 0..500 {
        let mut between = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
        let mut parameters = layout.default_parameters();
        for (name, low, high) in [
            ("C_N", 1.0, 4.0),
            ("C_M", -4.0, 4.0),
            ("C_Mq", -20.0, -1.0),
            ("C_p", -1.0, 1.0),
        ] {
            parameters[index(name)] = between(low, high);
        }
        let (speed, spin) = (between(100.0, 800.0), between(-1500.0, 1500.0));
        let bound = body.with_parameters(parameters);
        // The axis along x, in the direction of flight.
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let mut state = vec![0.0; layout.states.len()];
        for (name, value) in [("vx", speed), ("q0", half), ("q2", half), ("r", spin)] {
            state[layout.state(name).expect(name).index()] = value;
        }
        let instant = at(&bound, 0.0, &state).expect("modes");
        assert_eq!(instant.derivatives.flight, FlightDirection::AlongAxis);
        let expected = 0.14 / 1.2 * spin;
        assert!(
            (instant.derivatives.gyroscopic / expected - 1.0).abs() < 1e-6,
            "{case}"
        );
        let roots = instant.derivatives.eigenvalues();
        let decays = roots.iter().all(|root| root.re < 0.0);
        assert_eq!(decays, instant.criteria.is_stable(), "{case}: {roots:?}");
        stable += usize::from(decays);
        slow += usize::from(!instant.criteria.gyroscopic);
        for root in roots {
            let values = instant.modes.modes.iter().map(|mode| mode.value);
            let off = values.map(|value| (value.re - root.re).hypot(value.im - root.im.abs()));
            let nearest = off.fold(f64::INFINITY, f64::min);
            // Gravity and drag turn and slow the path at rates of the order of g/V.
            assert!(
                nearest < 0.15 + 0.01 * root.norm(),
                "{case}: {root} {nearest}"
            );
        }
    }
    assert!((100..400).contains(&stable) && slow > 20, "{stable} {slow}");
}

/// The shell with its axis along the first axis of the body, which its block states.
#[test]
fn the_criteria_are_those_of_the_stated_axis() {
    let third = SHELL.replace("fixed in B;", "fixed in B; axis B.3; forward B.3;");
    let first = third
        .replace("diag(I_t, I_t, I_a)", "diag(I_a, I_t, I_t)")
        .replace("B.3", "B.1")
        .replace("i.3*i", "i.1*i")
        .replace("r*B.1", "p*B.1")
        .replace("r*d", "p*d");
    let found = [(SHELL.to_owned(), 'r'), (third, 'r'), (first, 'p')].map(|(text, spin)| {
        let model = model_spec::load::from_text("shell.hyz", &text, &[]).expect("a model");
        let body = Body::new(model).expect("a body");
        let bound = body.with_parameters(body.compiled.layout().default_parameters());
        let layout = body.compiled.layout();
        let mut state = vec![0.0; layout.states.len()];
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let (scalar, second) = if spin == 'r' {
            (half, half)
        } else {
            (1.0, 0.0)
        };
        let rate = if spin == 'r' { "r" } else { "p" };
        for (name, value) in [("vx", 300.0), ("q0", scalar), ("q2", second), (rate, 900.0)] {
            state[layout.state(name).expect(name).index()] = value;
        }
        at(&bound, 0.0, &state).expect("modes")
    });
    let [unstated, third, first] = found.map(|own| (own.derivatives, own.criteria));
    for (derivatives, criteria) in [third, first] {
        assert_eq!(derivatives.flight, FlightDirection::AlongAxis);
        for (a, b) in [
            (criteria.gyroscopic_factor, unstated.1.gyroscopic_factor),
            (criteria.nutation, unstated.1.nutation),
            (criteria.nutation_decay, unstated.1.nutation_decay),
            (derivatives.pitching, unstated.0.pitching),
        ] {
            assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
        }
        assert_eq!(criteria.is_stable(), unstated.1.is_stable());
    }
}

#[test]
fn a_constrained_body_is_refused() {
    let text = "model pendulum;
param m = 0.2 kg in 1e-3 .. 9;
param l = 0.5 m;
param I = 0.01 kg*m^2 in 1e-4 .. 1;
param g = 9.81 m/s^2;
frame N;
frame B = N turned theta about 2;
state theta = 0.4 rad;
state omega = 0 rad/s;
let torque = m*g*l*sin(theta);
let I_p = I + m*l^2;
der(theta) = omega;
der(omega) = torque/I_p;
let acc = omega^2*(-l)*in_N(B.3) + torque/I_p*l*in_N(B.1);
claim body bob {
  mass m; inertia diag(I, I, I) in B; axis B.3;
  position l*in_N(B.3); velocity omega*l*in_N(B.1);
  angular velocity (0, 1, 0) in B*omega;
  force m*acc;
  moment I*torque/I_p*B.2;
}
";
    let model = model_spec::load::from_text("pendulum.hyz", text, &[]).expect("a model");
    let body = Body::new(model).expect("a body");
    let bound = body.with_parameters(body.compiled.layout().default_parameters());
    let why = at(&bound, 0.0, &[0.4, 0.0]).expect_err("constrained");
    assert!(why.to_string().contains("constrained"), "{why}");
}
