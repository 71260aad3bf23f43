// Written by `hyzer generate`; changes belong in the model.
//! A ball as a point mass: gravity and drag, with its spin known from elsewhere.
//!
//! The spin does nothing in this model. It is an input so that effects of it (lift by spin, spin decay)
//! can be added and tested against measured flights.
//!
//! | function | operations |
//! |---|---|
//! | `prepare` | 13 operations: 12 mul, 1 div |
//! | `f` | 14 operations: 6 add, 7 mul, 1 sqrt |
//! | `f_jac` | 32 operations: 9 add, 16 mul, 1 div, 5 neg, 1 sqrt |
//! | `f_jac_par` | 53 operations: 9 add, 33 mul, 1 div, 9 neg, 1 sqrt |
//! | `observe` | 3 operations: 3 add |
//! | `observe_jac` | 3 operations: 3 add |
//! | `quantities` | 10 operations: 5 add, 4 mul, 1 sqrt |
//! | `limits` | 0 operations |

mod f;
mod f_jac;
mod f_jac_par;
mod limits;
mod observe;
mod observe_jac;
mod prepare;
mod quantities;

pub use f::f;
pub use f_jac::f_jac;
pub use f_jac_par::f_jac_par;
pub use limits::limits;
pub use observe::observe;
pub use observe_jac::observe_jac;
pub use prepare::prepare;
pub use quantities::quantities;

/// States, in order.
#[rustfmt::skip]
pub const STATES: [&str; 6] = [
    "x", "y", "z", "vx", "vy", "vz",
];

/// States where a release does not say otherwise.
#[rustfmt::skip]
pub const INITIAL: [f64; 6] = [
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
];

/// Constants of the body and the place, coefficients, components of the inputs, in order.
#[rustfmt::skip]
pub const PARAMETERS: [&str; 11] = [
    "m", "radius", "rho", "g", "C_D", "wind_x", "wind_y", "wind_z", "omega_x", "omega_y", "omega_z",
];

/// Default values of `PARAMETERS`.
#[rustfmt::skip]
pub const DEFAULTS: [f64; 11] = [
    0.0027, 0.02, 1.2, 9.81, 0.45, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
];

/// How many of them are constants of the body and the place.
pub const PARAMS: usize = 4;

/// How many are coefficients, after those.
pub const COEFFICIENTS: usize = 1;

/// What `prepare` computes.
#[rustfmt::skip]
pub const PREPARED: [&str; 8] = [
    "half_pi_C_D_rho_product", "radius_half", "rho_pi_radius_inv_m", "C_D_rho_pi_radius_inv_part",
    "half_radius_inv_m", "C_D_pi_radius_inv_m", "A", "C_D_half_pi_radius_product",
];

/// What `quantities` computes.
#[rustfmt::skip]
pub const QUANTITIES: [&str; 11] = [
    "air_x", "air_y", "air_z", "rho_air", "g_here", "air_velocity_x", "air_velocity_y",
    "air_velocity_z", "V", "A", "drag",
];

/// The model holds where each of `limits` is above its bound.
#[rustfmt::skip]
pub const LIMITS: [f64; 0] = [
];

/// What happens at each limit.
#[rustfmt::skip]
pub const LIMIT_REASONS: [&str; 0] = [
];

/// (row, column) of each entry of `j`.
#[rustfmt::skip]
pub const J_PATTERN: [(u32, u32); 12] = [
    (0, 3),
    (1, 4),
    (2, 5),
    (3, 3), (3, 4), (3, 5),
    (4, 3), (4, 4), (4, 5),
    (5, 3), (5, 4), (5, 5),
];

/// (row, column) of each entry of `jp`.
#[rustfmt::skip]
pub const JP_PATTERN: [(u32, u32); 22] = [
    (3, 0), (3, 1), (3, 2), (3, 4), (3, 5), (3, 6), (3, 7),
    (4, 0), (4, 1), (4, 2), (4, 4), (4, 5), (4, 6), (4, 7),
    (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6), (5, 7),
];

/// (row, column) of each entry of `dy_dx`.
#[rustfmt::skip]
pub const DY_DX_PATTERN: [(u32, u32); 3] = [
    (0, 0),
    (1, 1),
    (2, 2),
];

/// (row, column) of each entry of `dy_dp`.
#[rustfmt::skip]
pub const DY_DP_PATTERN: [(u32, u32); 0] = [
];

/// (row, column) of each entry of `dy_dmarker`.
#[rustfmt::skip]
pub const DY_DMARKER_PATTERN: [(u32, u32); 3] = [
    (0, 0),
    (1, 1),
    (2, 2),
];

/// Tells whether this code belongs to a model's text.
pub const SOURCE_HASH: u64 = 0x9375cb8994ff8bdd;

/// These equations as a type.
#[derive(Clone, Copy, Debug)]
pub struct Ball;

impl crate::Equations for Ball {
    const MODEL: &'static crate::Model = &MODEL;

    #[rustfmt::skip]
    #[inline(always)]
    fn prepare<T: lanes::Real>(parameters: &[T], prepared: &mut [T]) {
        prepare(crate::array(parameters), crate::array_mut(prepared));
    }

    #[rustfmt::skip]
    #[inline(always)]
    fn f<T: lanes::Real>(time: T, state: &[T], parameters: &[T], prepared: &[T], dx: &mut [T]) {
        f(time, crate::array(state), crate::array(parameters), crate::array(prepared), crate::array_mut(dx));
    }

    #[rustfmt::skip]
    #[inline(always)]
    fn f_jac<T: lanes::Real>(time: T, state: &[T], parameters: &[T], prepared: &[T], dx: &mut [T], j: &mut [T]) {
        f_jac(time, crate::array(state), crate::array(parameters), crate::array(prepared), crate::array_mut(dx), crate::array_mut(j));
    }

    #[rustfmt::skip]
    #[inline(always)]
    fn f_jac_par<T: lanes::Real>(time: T, state: &[T], parameters: &[T], prepared: &[T], dx: &mut [T], j: &mut [T], jp: &mut [T]) {
        f_jac_par(time, crate::array(state), crate::array(parameters), crate::array(prepared), crate::array_mut(dx), crate::array_mut(j), crate::array_mut(jp));
    }

    #[rustfmt::skip]
    #[inline(always)]
    fn observe<T: lanes::Real>(time: T, state: &[T], parameters: &[T], prepared: &[T], marker: &[T], seen: &mut [T]) {
        observe(time, crate::array(state), crate::array(parameters), crate::array(prepared), crate::array(marker), crate::array_mut(seen));
    }

    #[rustfmt::skip]
    #[inline(always)]
    fn observe_jac<T: lanes::Real>(time: T, state: &[T], parameters: &[T], prepared: &[T], marker: &[T], seen: &mut [T], dy_dx: &mut [T], dy_dp: &mut [T], dy_dmarker: &mut [T]) {
        observe_jac(time, crate::array(state), crate::array(parameters), crate::array(prepared), crate::array(marker), crate::array_mut(seen), crate::array_mut(dy_dx), crate::array_mut(dy_dp), crate::array_mut(dy_dmarker));
    }

    #[rustfmt::skip]
    #[inline(always)]
    fn quantities<T: lanes::Real>(time: T, state: &[T], parameters: &[T], prepared: &[T], values: &mut [T]) {
        quantities(time, crate::array(state), crate::array(parameters), crate::array(prepared), crate::array_mut(values));
    }

    #[rustfmt::skip]
    #[inline(always)]
    fn limits<T: lanes::Real>(time: T, state: &[T], parameters: &[T], prepared: &[T], margins: &mut [T]) {
        limits(time, crate::array(state), crate::array(parameters), crate::array(prepared), crate::array_mut(margins));
    }
}

/// The table of this model, for callers that pick one by name.
pub static MODEL: crate::Model = crate::Model {
    name: "ball",
    source_hash: SOURCE_HASH,
    states: &STATES,
    initial: &INITIAL,
    parameters: &PARAMETERS,
    defaults: &DEFAULTS,
    prepared: &PREPARED,
    quantity_names: &QUANTITIES,
    limit_bounds: &LIMITS,
    limit_reasons: &LIMIT_REASONS,
    j_pattern: &J_PATTERN,
    jp_pattern: &JP_PATTERN,
    dy_dx_pattern: &DY_DX_PATTERN,
    dy_dp_pattern: &DY_DP_PATTERN,
    dy_dmarker_pattern: &DY_DMARKER_PATTERN,
    params: PARAMS,
    coefficients: COEFFICIENTS,
    observed: true,
    prepare: crate::plain::prepare::<Ball>,
    f: crate::plain::f::<Ball>,
    f_jac: crate::plain::f_jac::<Ball>,
    f_jac_par: crate::plain::f_jac_par::<Ball>,
    observe: crate::plain::observe::<Ball>,
    observe_jac: crate::plain::observe_jac::<Ball>,
    quantities: crate::plain::quantities::<Ball>,
    limits: crate::plain::limits::<Ball>,
};
