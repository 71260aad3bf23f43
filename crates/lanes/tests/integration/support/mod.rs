//! The elementary functions by others: reference values and the standard library.

#![allow(dead_code, clippy::approx_constant)]

use lanes::ElementaryFunction::{self, Asin, Exp, Log, Tanh};

/// Values of elementary functions computed by mpmath, as (function, argument, value). The arguments include those where
/// an implementation switches to another formula.
pub const REFERENCE_VALUES: [(ElementaryFunction, f64, f64); 28] = [
    (Exp, -745.0, 5e-324),
    (Exp, -708.5, 2.006132305331306e-308),
    (Exp, 709.7, 1.6549840276802644e+308),
    (Exp, 710.0, f64::INFINITY),
    (Exp, -800.0, 0.0),
    (Exp, f64::INFINITY, f64::INFINITY),
    (Exp, f64::NEG_INFINITY, 0.0),
    (Exp, 1e-17, 1.0),
    (Exp, 0.34657, 1.4142084849595797),
    (Exp, -0.34658, 0.7071022488445762),
    (Log, 5e-324, -744.4400719213812),
    (Log, 0.9999999999999999, -1.1102230246251565e-16),
    (Log, 1.0, 0.0),
    (Log, 1.4142135623730951, 0.3465735902799727),
    (Log, f64::MAX, 709.782712893384),
    (Log, 0.7071067811865475, -0.34657359027997275),
    (Log, f64::INFINITY, f64::INFINITY),
    (Tanh, 1e-09, 1e-09),
    (Tanh, 0.625, 0.5545997223493823),
    (Tanh, 0.6250000001, 0.5545997224186242),
    (Tanh, 18.5, 0.9999999999999998),
    (Tanh, -3.0, -0.9950547536867305),
    (Tanh, f64::NEG_INFINITY, -1.0),
    (Asin, 0.5, 0.5235987755982989),
    (Asin, 0.5000000001, 0.5235987757137689),
    (Asin, 0.9999999999999999, 1.5707963118937354),
    (Asin, -0.3, -0.3046926540153975),
    (Asin, 1e-09, 1e-09),
];

/// Value of an elementary function computed by the standard library, as reference for tests.
pub fn standard(function: ElementaryFunction, x: f64) -> f64 {
    match function {
        Exp => x.exp(),
        Log => x.ln(),
        Tanh => x.tanh(),
        Asin => x.clamp(-1.0, 1.0).asin(),
    }
}
