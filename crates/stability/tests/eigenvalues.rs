//! Modes against simulated flights, models of the same body against one another, the criteria against the modes.

use flight::throw::Throw;
use nalgebra::{Complex, Vector3};
use ode::{IntegrationOptions, integrate};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use stability::*;

fn body(name: &str) -> Body {
    Body::new(model_spec::load::load(name, &[]).expect(name)).expect(name)
}

fn defaults(body: &Body) -> BoundBody<'_> {
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

/// Nutation of a flight as it is measured: phase gained and logarithm of the amplitude lost between two times, of the angular velocity
/// across the axis: that of a flight with a little wobble less that of one without.
fn measured(bound: &BoundBody<'_>, throw: &Throw, (from, until): (f64, f64)) -> (f64, f64) {
    const SAMPLES: usize = 2000;
    /// Samples over which second differences are taken, which leave what is slow behind.
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

/// Integral over a time of frequency and decay of the nutation along the flight without wobble.
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

#[test]
fn grid() {
    let body = body("disc");
    let layout = body.compiled.layout();
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let mut between = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let (mut agree, mut nut_bad, mut slow_bad, mut stable) = (0, 0, 0, 0);
    for case in 0..1000 {
        let mut parameters = layout.default_parameters();
        let set = |p: &mut Vec<f64>, name: &str, value: f64| {
            p[layout.parameter(name).unwrap().index()] = value
        };
        for (name, low, high) in [
            ("C_Ma", -1.0, 1.0),
            ("C_Mq", -0.03, 0.0),
            ("C_La", 0.3, 4.0),
            ("C_D0", 0.05, 0.3),
            ("C_L0", 0.0, 0.3),
            ("I_d", 0.0008, 0.003),
        ] {
            let v = between(low, high);
            set(&mut parameters, name, v);
        }
        set(&mut parameters, "C_Rr", 0.0);
        let bound = body.with_parameters(parameters.clone());
        let throw = Throw {
            spin: Some(between(0.0, 1200.0)),
            nose: Some(0.0),
            ..Throw::at_speed(between(6.0, 30.0))
        };
        let state = body.thrown.state(&throw, [0.0; 2], &parameters).unwrap();
        let lin = bound.linearise(0.0, &state).unwrap();
        let full = modes(&lin, 0.0);
        let d = AxisDerivatives::of(&lin);
        let c = d.criteria();
        let roots = d.eigenvalues();
        // sanity: criteria vs cubic roots
        let root_stable = roots.iter().all(|r| r.re < 0.0);
        assert_eq!(root_stable, c.is_stable(), "{case} {d:?} {roots:?}");
        let nearest = |r: &Complex<f64>| {
            full.modes
                .iter()
                .map(|m| if r.im < 0.0 { m.value.conj() } else { m.value })
                .min_by(|a, b| (a - r).norm().total_cmp(&(b - r).norm()))
                .unwrap()
        };
        let mut ok = true;
        for r in &roots {
            let n = nearest(r);
            if (n.re < 0.0) != (r.re < 0.0) {
                ok = false;
                if r.im.abs() > 1e-6 {
                    nut_bad += 1
                } else {
                    slow_bad += 1;
                }
                println!(
                    "{case} root {r:.3} nearest {n:.3} V {:.1} rpm {:.0} {d:.2?} {:?}",
                    throw.speed,
                    throw.spin.unwrap(),
                    full.modes
                        .iter()
                        .map(|m| format!("{} {:.2}", m.kind.name(), m.value))
                        .collect::<Vec<_>>()
                );
            }
        }
        agree += ok as usize;
        stable += c.is_stable() as usize;
    }
    println!("agree {agree} stable {stable} nut_bad {nut_bad} slow_bad {slow_bad}");
}
