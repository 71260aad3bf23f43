// Written by `hyzer generate`; changes belong in the compiler.
//! Models by name, and as types.

use lanes::Real;

/// A model with its functions for `f64`.
///
/// Arguments are those of the model's own functions: time `t`, state `x`, parameters `p`, what `prepare`
/// made of them `k`, and the results. A slice that is too short is a panic.
#[derive(Clone, Copy, Debug)]
pub struct Model {
    /// Its name.
    pub name: &'static str,
    /// Tells whether this code belongs to a model's text.
    pub source_hash: u64,
    /// Names of the states.
    pub states: &'static [&'static str],
    /// States where a release does not say otherwise.
    pub initial: &'static [f64],
    /// Names of constants, coefficients and components of inputs.
    pub parameters: &'static [&'static str],
    /// Their default values.
    pub defaults: &'static [f64],
    /// How many are constants of the body and the place.
    pub params: usize,
    /// How many are coefficients.
    pub coefficients: usize,
    /// Names of what `prepare` computes.
    pub prepared: &'static [&'static str],
    /// Names of what `quantities` computes.
    pub quantity_names: &'static [&'static str],
    /// The model holds where each of `limits` is above its bound.
    pub limit_bounds: &'static [f64],
    /// What happens at each limit.
    pub limit_reasons: &'static [&'static str],
    /// (row, column) of each entry of `j`.
    pub j_pattern: &'static [(u32, u32)],
    /// (row, column) of each entry of `jp`.
    pub jp_pattern: &'static [(u32, u32)],
    /// (row, column) of each entry of `dy_dx`.
    pub dy_dx_pattern: &'static [(u32, u32)],
    /// (row, column) of each entry of `dy_dp`.
    pub dy_dp_pattern: &'static [(u32, u32)],
    /// (row, column) of each entry of `dy_dmarker`.
    pub dy_dmarker_pattern: &'static [(u32, u32)],
    /// Whether there is something to observe.
    pub observed: bool,
    /// `(p, k)`
    pub prepare: fn(&[f64], &mut [f64]),
    /// `(t, x, p, k, dx)`
    pub f: fn(f64, &[f64], &[f64], &[f64], &mut [f64]),
    /// `(t, x, p, k, dx, j)`
    pub f_jac: fn(f64, &[f64], &[f64], &[f64], &mut [f64], &mut [f64]),
    /// `(t, x, p, k, dx, j, jp)`
    pub f_jac_par: fn(f64, &[f64], &[f64], &[f64], &mut [f64], &mut [f64], &mut [f64]),
    /// `(t, x, p, k, marker, y)`
    pub observe: fn(f64, &[f64], &[f64], &[f64], &[f64], &mut [f64]),
    /// `(t, x, p, k, marker, y, dy_dx, dy_dp, dy_dmarker)`
    #[rustfmt::skip]
    pub observe_jac: fn(f64, &[f64], &[f64], &[f64], &[f64], &mut [f64], &mut [f64], &mut [f64], &mut [f64]),
    /// `(t, x, p, k, q)`
    pub quantities: fn(f64, &[f64], &[f64], &[f64], &mut [f64]),
    /// `(t, x, p, k, l)`
    pub limits: fn(f64, &[f64], &[f64], &[f64], &mut [f64]),
}

/// The equations of a model as a type, over slices, for `f64` and lanes alike.
#[rustfmt::skip]
pub trait Equations {
    /// Names, patterns, and the functions for `f64`.
    const MODEL: &'static Model;
    /// What depends on parameters alone.
    fn prepare<T: Real>(p: &[T], k: &mut [T]);
    /// Derivatives of the states.
    fn f<T: Real>(t: T, x: &[T], p: &[T], k: &[T], dx: &mut [T]);
    /// And their Jacobian by the states.
    fn f_jac<T: Real>(t: T, x: &[T], p: &[T], k: &[T], dx: &mut [T], j: &mut [T]);
    /// And by the parameters.
    fn f_jac_par<T: Real>(t: T, x: &[T], p: &[T], k: &[T], dx: &mut [T], j: &mut [T], jp: &mut [T]);
    /// What is observed of a marker.
    fn observe<T: Real>(t: T, x: &[T], p: &[T], k: &[T], marker: &[T], y: &mut [T]);
    /// And its derivatives.
    fn observe_jac<T: Real>(t: T, x: &[T], p: &[T], k: &[T], marker: &[T], y: &mut [T], dy_dx: &mut [T], dy_dp: &mut [T], dy_dmarker: &mut [T]);
    /// Named quantities.
    fn quantities<T: Real>(t: T, x: &[T], p: &[T], k: &[T], q: &mut [T]);
    /// Left sides of the limits.
    fn limits<T: Real>(t: T, x: &[T], p: &[T], k: &[T], l: &mut [T]);
}

/// Something to be done with a model that is picked by name; see [`visit`](crate::visit).
pub trait Visitor {
    /// What comes of it.
    type Output;
    /// Does it.
    fn visit<E: Equations>(self) -> Self::Output;
}

/// A model by its name.
pub fn model(name: &str) -> Option<&'static Model> {
    crate::MODELS
        .iter()
        .copied()
        .find(|model| model.name == name)
}

/// The first `N` numbers of a slice.
#[inline(always)]
pub(crate) fn array<T, const N: usize>(slice: &[T]) -> &[T; N] {
    slice
        .first_chunk()
        .expect("a slice with room for every value of the model")
}

/// The first `N` places of a slice.
#[inline(always)]
pub(crate) fn array_mut<T, const N: usize>(slice: &mut [T]) -> &mut [T; N] {
    slice
        .first_chunk_mut()
        .expect("a slice with room for every value of the model")
}
