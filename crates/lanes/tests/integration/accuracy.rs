//! Accuracy of the elementary functions: hard cases computed by mpmath, and the standard library (within 1 ulp).

// Miri randomizes the last bits of the standard library's functions, the reference here.
#![cfg(not(miri))]
// Tables of reference values.
#![allow(clippy::approx_constant)]

use crate::support::{REFERENCE_VALUES, standard};
use lanes::{ElementaryFunction, Real};
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
    for (function, x, expected) in REFERENCE_VALUES {
        close(
            x.elementary(function),
            expected,
            1,
            &format!("{function:?} {x}"),
        );
    }
    for function in ElementaryFunction::ALL {
        assert!(
            f64::NAN.elementary(function).is_nan(),
            "{function:?} of NaN"
        );
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
        for function in ElementaryFunction::ALL {
            let arguments = match function {
                ElementaryFunction::Exp => [x, unit * 708.0],
                ElementaryFunction::Log => [x.abs(), 1.0 + unit / 2.0],
                _ => [unit, unit * 2.0],
            };
            for x in arguments {
                close(x.elementary(function), standard(function, x), 3, &format!("{function:?} {x:e}"));
            }
        }
    }
}
