//! Accuracy of the elementary functions: hard cases computed by mpmath, and the standard library (within 1 ulp).

// Miri randomizes the last bits of the standard library's functions, the reference here.
#![cfg(not(miri))]
// Tables of reference values.
#![allow(clippy::approx_constant)]

use lanes::Real;
use proptest::prelude::*;

/// Distance of two numbers in units in the last place (ulp).
fn ulps(a: f64, b: f64) -> u64 {
    let ordered = |v: f64| {
        let bits = v.to_bits() as i64;
        if bits < 0 { i64::MIN - bits } else { bits }
    };
    if a.is_nan() && b.is_nan() {
        0
    } else {
        ordered(a).abs_diff(ordered(b))
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: u64, what: &str) {
    assert!(
        ulps(found, expected) <= within,
        "{what}: {found:e}, but it is {expected:e}"
    );
}

#[test]
fn sines_next_to_multiples_of_a_quarter_turn() {
    // The first rows are the doubles below 1e5 that are closest to a multiple of π/2.
    for (x, sine, cosine) in [
        (45.553093477052, 1.0, -6.189806365883577e-19),
        (728.849495632832, 9.903690185413723e-18, 1.0),
        (5830.795965062656, 7.922952148330979e-17, 1.0),
        (std::f64::consts::PI, 1.2246467991473532e-16, -1.0),
        (46066.74387591393, -1.0, 1.3593070393188837e-16),
        (99999.99999999999, 0.035748797986559125, -0.9993608074376923),
        (0.7853981633974483, 0.7071067811865475, 0.7071067811865476),
        (1e-08, 1e-08, 1.0),
        (2.5, 0.5984721441039565, -0.8011436155469337),
        (1e22, -0.8522008497671888, 0.5232147853951389),
    ] {
        for (x, sine) in [(x, sine), (-x, -sine)] {
            let (s, c) = Real::sin_cos(x);
            close(s, sine, 1, &format!("sin {x}"));
            close(c, cosine, 1, &format!("cos {x}"));
        }
    }
}

#[test]
fn angles_in_all_quadrants() {
    for (y, x, angle) in [
        (0.3660450359433639, 0.6809093904731136, 0.49325973485301206),
        (1.0, -1.0, 2.356194490192345),
        (-3.0, -1e-12, -1.5707963267952298),
        (0.5625, 1.0, 0.5123894603107377),
        (1e-300, 1e-308, 1.5707963167948966),
        (5e-324, -5e-324, 2.356194490192345),
        (2.0, -1e-20, std::f64::consts::FRAC_PI_2),
        (1e308, 1e308, std::f64::consts::FRAC_PI_4),
        (0.0, -2.0, std::f64::consts::PI),
        (-0.0, -2.0, -std::f64::consts::PI),
        (0.0, 2.0, 0.0),
        (-0.0, 2.0, -0.0),
        (f64::INFINITY, f64::NEG_INFINITY, 2.356194490192345),
        (-1.0, f64::INFINITY, -0.0),
    ] {
        close(Real::atan2(y, x), angle, 1, &format!("atan2 {y} {x}"));
    }
    for (y, x) in [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (-0.0, -0.0)] {
        assert_eq!(
            Real::atan2(y, x).to_bits(),
            0,
            "the origin's angle is 0, without a sign"
        );
    }
    assert!(Real::atan2(f64::NAN, 1.0).is_nan() && Real::atan2(1.0, f64::NAN).is_nan());
}

#[test]
fn the_other_functions_at_their_seams() {
    for (name, x, expected) in [
        ("exp", -745.0, 5e-324),
        ("exp", -708.5, 2.006132305331306e-308),
        ("exp", 709.7, 1.6549840276802644e+308),
        ("exp", 710.0, f64::INFINITY),
        ("exp", -800.0, 0.0),
        ("exp", f64::INFINITY, f64::INFINITY),
        ("exp", f64::NEG_INFINITY, 0.0),
        ("exp", 1e-17, 1.0),
        ("exp", 0.34657, 1.4142084849595797),
        ("exp", -0.34658, 0.7071022488445762),
        ("log", 5e-324, -744.4400719213812),
        ("log", 0.9999999999999999, -1.1102230246251565e-16),
        ("log", 1.0, 0.0),
        ("log", 1.4142135623730951, 0.3465735902799727),
        ("log", f64::MAX, 709.782712893384),
        ("log", 0.7071067811865475, -0.34657359027997275),
        ("log", f64::INFINITY, f64::INFINITY),
        ("tanh", 1e-09, 1e-09),
        ("tanh", 0.625, 0.5545997223493823),
        ("tanh", 0.6250000001, 0.5545997224186242),
        ("tanh", 18.5, 0.9999999999999998),
        ("tanh", -3.0, -0.9950547536867305),
        ("tanh", f64::NEG_INFINITY, -1.0),
        ("asin", 0.5, 0.5235987755982989),
        ("asin", 0.5000000001, 0.5235987757137689),
        ("asin", 0.9999999999999999, 1.5707963118937354),
        ("asin", -0.3, -0.3046926540153975),
        ("asin", 1e-09, 1e-09),
    ] {
        close(function(name)(x), expected, 1, &format!("{name} {x}"));
    }
    for name in ["exp", "log", "tanh", "asin"] {
        assert!(function(name)(f64::NAN).is_nan(), "{name} of NaN");
    }
}

fn function(name: &str) -> fn(f64) -> f64 {
    match name {
        "exp" => Real::exp,
        "log" => Real::log,
        "tanh" => Real::tanh,
        _ => Real::asin,
    }
}

#[test]
fn stated_values_at_singular_points() {
    assert_eq!(Real::sqrt(-1.0), 0.0);
    assert_eq!(Real::log(0.0), 0.0);
    assert_eq!(Real::log(-1.0), 0.0);
    assert_eq!(Real::asin(2.0), std::f64::consts::FRAC_PI_2);
    assert_eq!(Real::asin(-2.0), -std::f64::consts::FRAC_PI_2);
    assert_eq!(
        (
            0.0_f64.recip_or_zero(),
            1e-76_f64.recip_or_zero(),
            1e-75_f64.recip_or_zero()
        ),
        (0.0, 0.0, 1.0 / 1e-75)
    );
    assert_eq!(
        (
            Real::if_zero(-1e-76, 1.0, 2.0),
            Real::if_zero(1e-75, 1.0, 2.0)
        ),
        (1.0, 2.0)
    );
    assert_eq!(
        (Real::sign(-3.0), Real::sign(-0.0), Real::sign(5e-324)),
        (-1.0, 0.0, 1.0)
    );
    assert_eq!(
        (
            Real::heaviside(-3.0),
            Real::heaviside(0.0),
            Real::heaviside(5e-324)
        ),
        (0.0, 0.0, 1.0)
    );
    assert_eq!((Real::min(1.0, 2.0), Real::max(1.0, 2.0)), (1.0, 2.0));
    assert!(Real::sqrt(f64::NAN).is_nan() && f64::NAN.recip_or_zero().is_nan());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..Default::default() })]

    #[test]
    fn random_arguments(x in -30.0..30.0_f64, y in -30.0..30.0_f64, far in -1e5..1e5_f64, unit in -1.0..1.0_f64) {
        for x in [x, far, unit] {
            let (s, c) = Real::sin_cos(x);
            close(s, x.sin(), 2, &format!("sin {x:e}"));
            close(c, x.cos(), 2, &format!("cos {x:e}"));
        }
        close(Real::atan2(y, x), f64::atan2(y, x), 2, &format!("atan2 {y:e} {x:e}"));
        close(Real::exp(x), f64::exp(x), 2, &format!("exp {x:e}"));
        close(Real::exp(unit * 708.0), f64::exp(unit * 708.0), 2, &format!("exp {:e}", unit * 708.0));
        close(Real::log(x.abs()), x.abs().ln(), 2, &format!("log {:e}", x.abs()));
        close(Real::log(1.0 + unit / 2.0), (1.0 + unit / 2.0).ln(), 2, &format!("log {:e}", 1.0 + unit / 2.0));
        close(Real::tanh(unit * 2.0), (unit * 2.0).tanh(), 3, &format!("tanh {:e}", unit * 2.0));
        close(Real::asin(unit), unit.asin(), 3, &format!("asin {unit:e}"));
    }
}
