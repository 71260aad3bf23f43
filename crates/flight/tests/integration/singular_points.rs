//! Values and derivatives at the ends of the range of a function, and steps at breaks in time.

use flight::release::{Release, Stop};
use flight::{CompiledModel, simulate};
use model_spec::load::from_text;
use model_spec::model::Model;
use ode::{DifferentiableRhs, IntegrationOptions};

/// A model of a falling point with the drag `law`, N, a function of its speed `V`.
fn drag(law: &str) -> Model {
    let text = format!(
        "model probe;
param m = 0.1 kg;
coefficient a = 0.4 in 0 .. 3;
coefficient n = 1.7 in 0.5 .. 3;
param V_0 = 12 m/s;
param w = 0.01 m/s;
frame N;
point probe {{ mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }}
let V = norm(velocity);
let drag = ({law})*1 [N];
force weight = -m*9.81 [m/s^2]*N.3;
force air = -drag*unit(velocity);
"
    );
    from_text("probe.hyz", &text, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// dvx/dt and the derivatives of f by vx and by every parameter, at the velocity `vx`.
fn along_x(model: &Model, vx: f64) -> (f64, Vec<f64>) {
    let compiled = CompiledModel::new(model);
    let bound = compiled.bind(compiled.layout().default_parameters());
    let mut rhs = bound.rhs();
    let x = [0.0, 0.0, 10.0, vx, 0.0, 0.0];
    let mut dx = [0.0; 6];
    let mut jacobian = vec![0.0; rhs.jacobian_pattern().len()];
    let mut by_parameter = vec![0.0; rhs.parameter_jacobian_pattern().len()];
    rhs.derivative_with_jacobians(0.0, &x, &mut dx, &mut jacobian, &mut by_parameter);
    // That by vx itself comes first of dvx/dt by the states x, y, z, vx, vy, vz.
    let of_vx = |pattern: &[(usize, usize)], entries: &[f64]| {
        let rows = pattern
            .iter()
            .zip(entries)
            .filter(|((row, _), _)| *row == 3);
        rows.map(|((_, column), value)| (*column, *value))
            .collect::<Vec<_>>()
    };
    let by_state = of_vx(rhs.jacobian_pattern(), &jacobian);
    let by_vx = by_state.iter().filter(|(column, _)| *column == 3);
    let mut all: Vec<f64> = by_vx.map(|(_, value)| *value).collect();
    let by_parameter = of_vx(rhs.parameter_jacobian_pattern(), &by_parameter);
    all.extend(
        by_state
            .iter()
            .chain(&by_parameter)
            .map(|(_, value)| *value),
    );
    (dx[3], all)
}

#[test]
fn smooth_switches_have_finite_derivatives_far_from_the_switch() {
    let laws = [
        "a/(1 + exp((V - V_0)/w))",
        "a/(1 + exp(-(V - V_0)/w))",
        "a*exp((V - V_0)/w)/(2 + exp((V - V_0)/w))",
        "a/(1 + 3*exp((V - V_0)/w))^2",
        "a/sqrt(1 + exp((V - V_0)/w))",
        "a*2/(exp((V - V_0)/w) + exp((V_0 - V)/w))",
    ];
    for law in laws {
        let model = drag(law);
        for vx in [1.0, 4.0, 11.99, 12.0, 12.02, 19.0, 36.0, 3e3] {
            let (value, derivatives) = along_x(&model, vx);
            assert!(value.is_finite(), "{law} at {vx}: {value}");
            assert!(
                derivatives.iter().all(|d| d.is_finite()),
                "{law} at {vx}: {derivatives:?}"
            );
        }
        // Differences of the value confirm the derivative in the middle of the switch.
        let at = |vx: f64| along_x(&model, vx).0;
        let difference = (at(12.005 + 1e-6) - at(12.005 - 1e-6)) / 2e-6;
        let exact = along_x(&model, 12.005).1[0];
        assert!(
            (difference - exact).abs() < 1e-5 * exact.abs().max(1.0),
            "{law}: {difference} {exact}"
        );
    }
}

/// Laws that are finite where an exponential within them overflows, each with its value by the speed.
#[test]
fn exponentials_that_a_switch_turns_off_may_overflow() {
    type Law = (&'static str, fn(f64) -> f64);
    let laws: [Law; 8] = [
        ("a*step(V - V_0)*exp(-(V - V_0)/w)", |v| {
            0.4 * off(v - 12.0, 1.0)
        }),
        ("exp(-(V - V_0)/w)*a*step(V - V_0)", |v| {
            0.4 * off(v - 12.0, 1.0)
        }),
        ("(1 - step(V_0 - V))*exp((V_0 - V)/w)/2", |v| {
            0.5 * off(v - 12.0, 1.0)
        }),
        ("a*step(V - V_0)*(2 - exp(-(V - V_0)/w))", |v| {
            if v > 12.0 {
                0.8 - 0.4 * (-(v - 12.0) / 0.01).exp()
            } else {
                0.0
            }
        }),
        ("a*max((V - V_0)/V_0, 0)*exp(-(V - V_0)/w)", |v| {
            0.4 * off(v - 12.0, (v - 12.0) / 12.0)
        }),
        ("a*step(V - V_0)/exp((V - V_0)/w)", |v| {
            0.4 * off(v - 12.0, 1.0)
        }),
        ("a*w/V_0*log(1 + exp((V - V_0)/w))", |v| {
            0.4 * 0.01 / 12.0 * softplus(v)
        }),
        ("a*w/V_0*log(2 + 3*exp((V - V_0)/w))", |v| {
            let u = (v - 12.0) / 0.01;
            0.4 * 0.01 / 12.0
                * (u.max(0.0) + (2.0 * (-u.max(0.0)).exp() + 3.0 * (u.min(0.0)).exp()).ln())
        }),
    ];
    for (law, value) in laws {
        let model = drag(law);
        for vx in [0.5, 4.0, 11.9, 12.004, 12.1, 19.0, 36.0, 3e3] {
            let (found, derivatives) = along_x(&model, vx);
            let expected = -value(vx) / 0.1;
            let scale = expected.abs().max(1e-300);
            assert!(
                (found - expected).abs() <= 1e-12 * scale,
                "{law} at {vx}: {found} {expected}"
            );
            assert!(
                derivatives.iter().all(|d| d.is_finite()),
                "{law} at {vx}: {derivatives:?}"
            );
            let d = 1e-6;
            let difference = -(value(vx + d) - value(vx - d)) / (2.0 * d) / 0.1;
            let error = (derivatives[0] - difference).abs();
            assert!(
                error <= 1e-5 * difference.abs() + 1e-8,
                "{law} at {vx}: {derivatives:?} {difference}"
            );
        }
    }
}

/// `factor` e^(-past/w) where `past`, a speed beyond a switch, is above 0, else 0.
fn off(past: f64, factor: f64) -> f64 {
    match past > 0.0 {
        true => factor * (-past / 0.01).exp(),
        false => 0.0,
    }
}

/// log(1 + e^u) of u = (v - 12)/0.01, by a formula that does not overflow.
fn softplus(v: f64) -> f64 {
    let u = (v - 12.0) / 0.01;
    u.max(0.0) + (-u.abs()).exp().ln_1p()
}

#[test]
fn a_power_with_a_coefficient_as_exponent_vanishes_at_rest() {
    let model = drag("a*(V/V_0)^n");
    let (value, derivatives) = along_x(&model, 0.0);
    assert_eq!(value, 0.0);
    assert!(derivatives.iter().all(|d| *d == 0.0), "{derivatives:?}");
    for vx in [1e-9, 0.3, 12.0, 80.0] {
        let (value, derivatives) = along_x(&model, vx);
        let expected = -0.4 * (vx / 12.0_f64).powf(1.7) / 0.1;
        assert!((value / expected - 1.0).abs() < 1e-13, "{value} {expected}");
        let slope = expected * 1.7 / vx;
        assert!(
            (derivatives[0] / slope - 1.0).abs() < 1e-12,
            "{derivatives:?} {slope}"
        );
    }
    let literal = drag("a*(V/V_0)^1.7");
    assert_eq!(along_x(&literal, 7.0).0, along_x(&model, 7.0).0);
}

/// Two kicks that are shorter than a step, and a thruster that is switched on and off.
pub const KICKS: &str = "model kicks;
param m = 2 kg;
param t_on = 4.1 s;
param burn = 20 ms;
frame N;
table push(t: s): N = { 0: 0, 2: 0, 2.01: 400, 2.02: 0, 9: 0 } monotone, constant;
point body { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
let since = time - t_on;
let thrust = 500 [N]*step(since)*step(burn - since);
force push = push(time)*N.1;
force thrust = thrust*N.2;
force late = 300 [N]*max(0, 1 - abs((time - 6.005 [s])/(5 ms)))*N.3;
";

#[test]
fn no_pulse_in_time_is_stepped_over() {
    let model = from_text("kicks.hyz", KICKS, &[]).unwrap_or_else(|error| panic!("{error}"));
    let compiled = CompiledModel::new(&model);
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let release = Release {
            stop: Stop::Duration(8.0),
            ..Release::of(&model)
        };
        let options = IntegrationOptions::with_tolerance(tolerance);
        let flight = simulate(&compiled, &release, &options).expect("a flight");
        let [vx, vy, vz] = [3, 4, 5].map(|state| flight.end_state[state]);
        // Two monotone cubics from 0 to 400 N have half the area of their rectangles.
        assert!((vx - 400.0 * 0.01 / 2.0).abs() < 1e-6, "{tolerance}: {vx}");
        assert!((vy - 500.0 * 0.02 / 2.0).abs() < 1e-6, "{tolerance}: {vy}");
        assert!((vz - 300.0 * 0.005 / 2.0).abs() < 1e-6, "{tolerance}: {vz}");
        assert!(flight.stats.steps < 60, "{}", flight.stats.steps);
    }
}
