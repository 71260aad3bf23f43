//! Models of the gallery with blocks `solve { … }`, against equations of motion in minimal coordinates that are solved by
//! hand.

use flight::release::{Release, Stop};
use flight::{CompiledModel, simulate};
use model_spec::load::from_text;
use ode::{IntegrationOptions, integrate, rhs_from_fn};
use std::collections::HashMap;

const DURATION: f64 = 10.0;
const TOLERANCE: f64 = 1e-13;

type V3 = [f64; 3];

fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn sum<const N: usize>(terms: [(f64, V3); N]) -> V3 {
    [0, 1, 2].map(|k| terms.iter().map(|(factor, v)| factor * v[k]).sum())
}

/// States by name at the end of a flight of a model of the gallery.
fn flown(name: &str) -> HashMap<String, f64> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/gallery/");
    let text = std::fs::read_to_string(format!("{folder}{name}.hyz")).unwrap();
    flown_from(&text, &[])
}

/// States by name at the end of a flight; `start` has those at the release that are not the defaults.
fn flown_from(text: &str, start: &[(&str, f64)]) -> HashMap<String, f64> {
    let model = from_text("probe", text, &[]).unwrap_or_else(|error| panic!("{error}"));
    let release = start.iter().fold(Release::of(&model), |release, own| {
        release.with_initial(own.0, own.1)
    });
    let release = Release {
        stop: Stop::Duration(DURATION),
        ..release
    };
    let options = IntegrationOptions::with_tolerance(TOLERANCE);
    let compiled = CompiledModel::new(&model);
    let flight = simulate(&compiled, &release, &options).unwrap_or_else(|error| panic!("{error}"));
    let names = compiled.layout().states.iter().cloned();
    names.zip(flight.end_state).collect()
}

fn reference<const N: usize>(start: [f64; N], f: impl Fn(&[f64; N]) -> [f64; N]) -> [f64; N] {
    let mut rhs = rhs_from_fn(&[], |_, x: &[f64; N], dx: &mut [f64; N]| *dx = f(x));
    let options = IntegrationOptions::with_tolerance(TOLERANCE);
    let flight = integrate(&mut rhs, (0.0, &start), DURATION, &options, &mut []).unwrap();
    flight.end_state.try_into().unwrap()
}

fn assert_near(found: &HashMap<String, f64>, expected: &[(&str, f64)], scale: f64) {
    for &(name, value) in expected {
        let error = (found[name] - value).abs();
        assert!(error < 1e-9 * scale, "{name}: {} for {value}", found[name]);
    }
}

#[test]
fn double_pendulum() {
    let (m_1, m_2, l_1, l_2, g) = (1.0, 0.6, 1.0, 0.7, 9.81);
    let start = [40_f64.to_radians(), 20_f64.to_radians(), 0.0, 0.0];
    let end = reference(start, |&[a, b, u, v]| {
        let (s, c) = (a - b).sin_cos();
        let below = 2.0 * m_1 + m_2 - m_2 * (2.0 * (a - b)).cos();
        let du = -g * (2.0 * m_1 + m_2) * a.sin()
            - m_2 * g * (a - 2.0 * b).sin()
            - 2.0 * s * m_2 * (v * v * l_2 + u * u * l_1 * c);
        let dv = 2.0
            * s
            * (u * u * l_1 * (m_1 + m_2) + g * (m_1 + m_2) * a.cos() + v * v * l_2 * m_2 * c);
        [u, v, du / (l_1 * below), dv / (l_2 * below)]
    });
    let names = ["theta_1", "theta_2", "omega_1", "omega_2"];
    let expected: Vec<(&str, f64)> = names.into_iter().zip(end).collect();
    assert_near(&flown("double_pendulum"), &expected, 10.0);
}

/// Precession, inclination and rotation of the top of the gallery, the rate of the inclination, and that of the precession,
/// by its conserved momenta.
fn top() -> [f64; 5] {
    let (m, l, i_1, i_3, g) = (0.1, 0.04, 2.4e-4, 8e-5, 9.81);
    let (theta, psidot) = (30_f64.to_radians(), 200.0);
    let (spin, about) = (psidot, i_3 * psidot * theta.cos());
    let precession = |theta: f64| (about - i_3 * spin * theta.cos()) / (i_1 * theta.sin().powi(2));
    let [phi, theta, psi, rate] = reference([0.0, theta, 0.0, 0.0], |&[_, theta, _, rate]| {
        let (s, c) = theta.sin_cos();
        let phidot = precession(theta);
        let up = i_1 * phidot * phidot * s * c - i_3 * spin * phidot * s + m * g * l * s;
        [phidot, rate, spin - phidot * c, up / i_1]
    });
    [phi, theta, psi, rate, precession(theta)]
}

#[test]
fn top_by_its_conserved_momenta() {
    let names = ["phi", "theta", "psi", "thetadot", "phidot"];
    let expected: Vec<(&str, f64)> = names.into_iter().zip(top()).collect();
    assert_near(&flown("spinning_top"), &expected, 2000.0);
}

/// The same top as a free body whose tip three constraints hold.
const HELD_TOP: &str = "model held_top;
param m = 0.1 kg;
param l = 4 cm;
frame N;
{frames}
body top {
  mass m;
  inertia diag(8e-5, 8e-5, 8e-5) kg*m^2 in C;
  fixed in C;
  position (x, y, z) in N = (0, -2, 3.4641016151377546) cm;
  velocity (vx, vy, vz) in N;
  {angular}
}
let tip = position - l*in_N(C.3);
let x_tip = tip.1;
let y_tip = tip.2;
let z_tip = tip.3;
solve pivot {
  unknown R: vector N in N;
  constraint x_tip = 0 within 0.1 mm;
  constraint y_tip = 0 within 0.1 mm;
  constraint z_tip = 0 within 0.1 mm;
}
force weight = -m*9.81 [m/s^2]*N.3;
force pivot = R;
moment pivot = -l*C.3 × in_C(R);
";

#[test]
fn a_top_whose_tip_three_constraints_hold_moves_as_in_its_angles() {
    let half = 15_f64.to_radians();
    let by_quaternion = [("q0", half.cos()), ("q1", half.sin()), ("r", 200.0)];
    let by_angles = [("theta", 30_f64.to_radians()), ("psidot", 200.0)];
    let [phi, theta, ..] = top();
    let (level, up) = (0.04 * theta.sin(), 0.04 * theta.cos());
    let place = [
        ("x", level * phi.sin()),
        ("y", -level * phi.cos()),
        ("z", up),
    ];
    let angles = "frame A = N turned phi about 3; frame B = A turned theta about 1; frame C = B turned psi about 3;";
    for (frames, angular, start) in [
        (
            "frame C = N by quaternion (q0, q1, q2, q3);",
            "angular velocity (p, q, r) in C;",
            &by_quaternion[..],
        ),
        (angles, "", &by_angles),
    ] {
        let text = HELD_TOP.replace("{frames}", frames);
        let found = flown_from(&text.replace("{angular}", angular), start);
        // To 1e-9 of a metre.
        assert_near(&found, &place, 1.0);
    }
}

/// The yaw of repose and the acceleration found by turns, until neither changes.
#[test]
fn shell_by_turns_of_yaw_and_acceleration() {
    let (m, d, i_x, g) = (43.1, 0.1547, 0.146, 9.81);
    let (lift, overturning, magnus, slowing) = (1.9, 3.8, -0.25, -0.014);
    let pi = std::f64::consts::PI;
    let cross = |a: V3, b: V3| {
        [0, 1, 2].map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            a[i] * b[j] - a[j] * b[i]
        })
    };
    let start = [0.0, 0.0, 0.0, 400.0, 0.0, 60.0, 1380.0];
    let text = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../examples/gallery/shell.hyz"
    ));
    let text = text.unwrap();
    let table = text
        .lines()
        .find(|line| line.starts_with("table "))
        .unwrap();
    // The reference has no table: drag that does not depend on the Mach number.
    let text = text
        .replace(table, "")
        .replace("C_D0(V/sound)", "(0.3 + 0*V/sound)");
    let end = reference(start, |x| {
        let (v, p) = ([x[3], x[4], x[5]], x[6]);
        let speed = dot(v, v).sqrt();
        let q = pi / 8.0 * 1.225 * (-x[2] / 9000.0).exp() * d * d;
        let mut pull = [0.0; 3];
        for _ in 0..30 {
            let turned = cross(v, pull);
            let yaw = -8.0 * i_x * p / (8.0 * q * d * overturning * speed.powi(4));
            let yaw = turned.map(|own| yaw * own);
            pull = sum([
                (-q * 0.3 * speed / m, v),
                (q * lift * speed * speed / m, yaw),
                (-q * d * p * magnus / m, cross(yaw, v)),
                (-g, [0.0, 0.0, 1.0]),
            ]);
        }
        let slower = q * d * d * slowing * p * speed / i_x;
        [v[0], v[1], v[2], pull[0], pull[1], pull[2], slower]
    });
    let names = ["x", "y", "z", "u_x", "u_y", "u_z", "p"];
    let start: Vec<(&str, f64)> = names.into_iter().zip(start).collect();
    let expected: Vec<(&str, f64)> = names.into_iter().zip(end).collect();
    assert_near(&flown_from(&text, &start), &expected, 3000.0);
    // To the right, by some metres.
    assert!((-20.0..-1.0).contains(&end[1]), "{}", end[1]);
}

/// Directions on a sphere about axis 1: outwards, along the elevation from axis 1, and along the azimuth.
fn directions(elevation: f64, azimuth: f64) -> [V3; 3] {
    let ((s, c), (t, d)) = (elevation.sin_cos(), azimuth.sin_cos());
    [[s, c * d, c * t], [c, -s * d, -s * t], [0.0, -t, d]]
}

fn velocity(length: f64, [b, a, db, da]: [f64; 4]) -> V3 {
    let [_, up, round] = directions(b, a);
    sum([(length * db, up), (length * da * b.cos(), round)])
}

/// Rates of elevation, azimuth and their rates on a sphere, under an acceleration.
fn on_sphere(length: f64, [b, a, db, da]: [f64; 4], acceleration: V3) -> [f64; 4] {
    let [_, up, round] = directions(b, a);
    let ddb = dot(acceleration, up) / length - da * da * b.sin() * b.cos();
    let dda = dot(acceleration, round) / (length * b.cos()) + 2.0 * da * db * b.tan();
    [db, da, ddb, dda]
}

#[test]
fn kite_in_spherical_coordinates() {
    let (m, length, wind) = (0.4, 20.0, [8.0, 0.0, 0.0]);
    let half = 1.2 * 0.3 / 2.0;
    let start = [0.8_f64.asin(), 90_f64.to_radians(), 0.0, -3.0 / 12.0];
    let end = reference(start, |&state| {
        let [out, ..] = directions(state[0], state[1]);
        let air = sum([(1.0, wind), (-1.0, velocity(length, state))]);
        let speed = dot(air, air).sqrt();
        let lift = sum([(1.0, out), (-dot(out, air) / speed.powi(2), air)]);
        let forces = [
            (half * 0.8 * speed * speed / m, lift),
            (half * 0.2 * speed / m, air),
            (-9.81, [0.0, 0.0, 1.0]),
        ];
        on_sphere(length, state, sum(forces))
    });
    let found = flown("tethered_kite");
    let place = directions(end[0], end[1])[0].map(|part| length * part);
    let motion = velocity(length, end);
    let expected = [
        ("x", place[0]),
        ("y", place[1]),
        ("z", place[2]),
        ("vx", motion[0]),
        ("vy", motion[1]),
        ("vz", motion[2]),
    ];
    assert_near(&found, &expected, 10.0);
    let stretch = dot(place, place).sqrt() - length;
    assert!(stretch.abs() < 1e-9, "{stretch}");
}

#[test]
fn parachute_and_payload_by_mass_centre_and_direction_of_the_line() {
    let (m_c, m_p, length, wind) = (1.4, 8.0, 6.0, [3.0, 0.0, 0.0]);
    let whole = m_c + m_p;
    let drag = |area: f64, v: V3| {
        let air = sum([(1.0, wind), (-1.0, v)]);
        air.map(|part| 0.6 * area * dot(air, air).sqrt() * part)
    };
    // Mass centre and its velocity, then elevation, azimuth and their rates of the line.
    let split = |x: &[f64; 10]| {
        let line: [f64; 4] = x[6..].try_into().unwrap();
        let (v, turning) = ([x[3], x[4], x[5]], velocity(length, line));
        let chute = sum([(1.0, v), (-m_p / whole, turning)]);
        let payload = sum([(1.0, v), (m_c / whole, turning)]);
        (line, chute, payload)
    };
    let lead = m_p / whole;
    let line = [0.6_f64.asin(), -90_f64.to_radians(), 0.0, 0.0];
    let start = [3.6 * lead, 0.0, 100.0 - 4.8 * lead, 0.0, 1.0, -5.0];
    let start: Vec<f64> = start.into_iter().chain(line).collect();
    let end = reference::<10>(start.try_into().unwrap(), |x| {
        let (line, chute, payload) = split(x);
        let (on_chute, on_payload) = (drag(7.0, chute), drag(0.05, payload));
        let fall = sum([
            (1.0 / whole, on_chute),
            (1.0 / whole, on_payload),
            (-9.81, [0.0, 0.0, 1.0]),
        ]);
        let apart = sum([(1.0 / m_p, on_payload), (-1.0 / m_c, on_chute)]);
        let turned = on_sphere(length, line, apart);
        let rates = [&x[3..6], &fall, &turned].concat();
        rates.try_into().unwrap()
    });
    let (line, chute, payload) = split(&end);
    let along = directions(line[0], line[1])[0];
    let centre = [end[0], end[1], end[2]];
    let place = sum([(1.0, centre), (-lead * length, along)]);
    let place_p = sum([(1.0, centre), ((1.0 - lead) * length, along)]);
    let of = |names: [&'static str; 3], v: V3| names.into_iter().zip(v);
    let expected: Vec<(&str, f64)> = of(["x", "y", "z"], place)
        .chain(of(["x_p", "y_p", "z_p"], place_p))
        .chain(of(["vx", "vy", "vz"], chute))
        .chain(of(["vx_p", "vy_p", "vz_p"], payload))
        .collect();
    assert_near(&flown("parachute_payload"), &expected, 30.0);
}

#[test]
fn rolling_coin_by_three_equations_for_its_spin() {
    let (m, a, g) = (0.44, 0.038, 9.81);
    let (i_d, i_a, ma2) = (m * a * a / 4.0, m * a * a / 2.0, m * a * a);
    let theta = 40_f64.to_radians();
    let (phidot, psidot) = (12.0, -8.0);
    let start = [
        0.0,
        0.0,
        0.0,
        theta,
        0.0,
        phidot * theta.sin(),
        phidot * theta.cos() + psidot,
    ];
    let end = reference(start, |&[_, _, phi, theta, w_1, w_2, w_3]| {
        let ((s, c), (t, d)) = (theta.sin_cos(), phi.sin_cos());
        let frame_3 = w_2 * c / s;
        let up = (i_a + ma2) * w_2 * w_3 - i_d * frame_3 * w_2 + m * g * a * c;
        [
            a * (w_1 * s * t - w_3 * d),
            a * (-w_1 * s * d - w_3 * t),
            w_2 / s,
            w_1,
            -up / (i_d + ma2),
            w_1 * (i_a * w_3 - i_d * frame_3) / i_d,
            ma2 * w_1 * w_2 / (i_a + ma2),
        ]
    });
    let [x, y, phi, theta, w_1, w_2, w_3] = end;
    let phidot = w_2 / theta.sin();
    let expected = [
        ("x", x),
        ("y", y),
        ("phi", phi),
        ("theta", theta),
        ("thetadot", w_1),
        ("phidot", phidot),
        ("psidot", w_3 - phidot * theta.cos()),
    ];
    assert_near(&flown("euler_disc"), &expected, 100.0);
}
