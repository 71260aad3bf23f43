// Written by `hyzer generate`; changes belong in the compiler.
//! Each function for `f64`, compiled once.

use crate::Equations;

/// See [`Equations::prepare`].
#[inline(never)]
pub fn prepare<E: Equations>(p: &[f64], k: &mut [f64]) {
    E::prepare(p, k);
}

/// See [`Equations::f`].
#[inline(never)]
pub fn f<E: Equations>(t: f64, x: &[f64], p: &[f64], k: &[f64], dx: &mut [f64]) {
    E::f(t, x, p, k, dx);
}

/// See [`Equations::f_jac`].
#[inline(never)]
#[rustfmt::skip]
pub fn f_jac<E: Equations>(t: f64, x: &[f64], p: &[f64], k: &[f64], dx: &mut [f64], j: &mut [f64]) {
    E::f_jac(t, x, p, k, dx, j);
}

/// See [`Equations::f_jac_par`].
#[inline(never)]
#[rustfmt::skip]
pub fn f_jac_par<E: Equations>(t: f64, x: &[f64], p: &[f64], k: &[f64], dx: &mut [f64], j: &mut [f64], jp: &mut [f64]) {
    E::f_jac_par(t, x, p, k, dx, j, jp);
}

/// See [`Equations::observe`].
#[inline(never)]
#[rustfmt::skip]
pub fn observe<E: Equations>(t: f64, x: &[f64], p: &[f64], k: &[f64], marker: &[f64], y: &mut [f64]) {
    E::observe(t, x, p, k, marker, y);
}

/// See [`Equations::observe_jac`].
#[inline(never)]
#[rustfmt::skip]
pub fn observe_jac<E: Equations>(t: f64, x: &[f64], p: &[f64], k: &[f64], marker: &[f64], y: &mut [f64], dy_dx: &mut [f64], dy_dp: &mut [f64], dy_dmarker: &mut [f64]) {
    E::observe_jac(t, x, p, k, marker, y, dy_dx, dy_dp, dy_dmarker);
}

/// See [`Equations::quantities`].
#[inline(never)]
pub fn quantities<E: Equations>(t: f64, x: &[f64], p: &[f64], k: &[f64], q: &mut [f64]) {
    E::quantities(t, x, p, k, q);
}

/// See [`Equations::limits`].
#[inline(never)]
pub fn limits<E: Equations>(t: f64, x: &[f64], p: &[f64], k: &[f64], l: &mut [f64]) {
    E::limits(t, x, p, k, l);
}
