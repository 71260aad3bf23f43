// Written by `hyzer generate`; changes belong in the model.
//! The disc of `disc` with its attitude as a quaternion: the same physics, and no singular attitude.
//!
//! Velocity is in N, angular velocity in C, the frame fixed in the disc; the coefficients are those of `disc`.
//!
//! | function | operations |
//! |---|---|
//! | `prepare` | 19 operations: 1 add, 13 mul, 3 div, 2 neg |
//! | `f` | 141 operations: 47 add, 88 mul, 1 div, 1 neg, 2 sqrt, 1 call, 1 select |
//! | `f_jac` | 568 operations: 205 add, 349 mul, 2 div, 7 neg, 2 sqrt, 1 call, 2 select |
//! | `f_jac_par` | 654 operations: 212 add, 405 mul, 2 div, 31 neg, 2 sqrt, 1 call, 1 select |
//! | `observe` | 44 operations: 20 add, 24 mul |
//! | `observe_jac` | 92 operations: 38 add, 52 mul, 2 neg |
//! | `quantities` | 89 operations: 28 add, 54 mul, 2 div, 2 neg, 2 sqrt, 1 call |
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
pub const STATES: [&str; 13] = [
    "x", "y", "z", "vx", "vy", "vz", "q0", "q1", "q2", "q3", "p", "q", "r",
];

/// States where a release does not say otherwise.
#[rustfmt::skip]
pub const INITIAL: [f64; 13] = [
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
];

/// Constants of the body and the place, coefficients, components of the inputs, in order.
#[rustfmt::skip]
pub const PARAMETERS: [&str; 18] = [
    "m", "I_a", "I_d", "d", "A", "rho", "g", "C_L0", "C_La", "C_D0", "C_Da", "C_Ma", "C_Mq", "C_Rr",
    "C_Nr", "wind_x", "wind_y", "wind_z",
];

/// Default values of `PARAMETERS`.
#[rustfmt::skip]
pub const DEFAULTS: [f64; 18] = [
    0.175, 0.00235, 0.00122, 0.269, 0.057, 1.23, 9.7935, 0.188, 2.37, 0.15, 1.24, -0.38, -0.005,
    -0.0004, -3.4e-5, 0.0, 0.0, 0.0,
];

/// How many of them are constants of the body and the place.
pub const PARAMS: usize = 7;

/// How many are coefficients, after those.
pub const COEFFICIENTS: usize = 8;

/// What `prepare` computes.
#[rustfmt::skip]
pub const PREPARED: [&str; 18] = [
    "inv_m_rho_A", "half_d_inv_I_d_rho_A", "one_minus_inv_I_d_I_a", "C_Nr_inv_I_a",
    "d_rho_A_inv_I_d", "two_C_Da", "C_Mq_d_rho_A_inv_I_d", "inv_m", "inv_I_d", "inv_I_a", "rho_A",
    "I_a_inv_I_d", "inv_I_d_d", "minus_I_a_inv_I_d", "minus_inv_I_a_d_r_dot_d_r", "rho_half",
    "A_rho_half", "half_d",
];

/// What `quantities` computes.
#[rustfmt::skip]
pub const QUANTITIES: [&str; 34] = [
    "air_x", "air_y", "air_z", "rho_air", "g_here", "J_11", "J_22", "J_13", "J_23",
    "air_velocity_1", "air_velocity_2", "air_velocity_3", "d3_1", "d3_2", "d3_3", "V", "d1_1",
    "d1_2", "d1_3", "d2_1", "d2_2", "d2_3", "alpha", "pressure", "C_L", "C_D", "lift", "drag",
    "rate_1", "rate_2", "spin_ratio", "roll", "pitch", "spin_down",
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
pub const J_PATTERN: [(u32, u32); 69] = [
    (0, 3),
    (1, 4),
    (2, 5),
    (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9),
    (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9),
    (5, 3), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9),
    (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (6, 12),
    (7, 6), (7, 8), (7, 9), (7, 10), (7, 11), (7, 12),
    (8, 6), (8, 7), (8, 9), (8, 10), (8, 11), (8, 12),
    (9, 6), (9, 7), (9, 8), (9, 10), (9, 11), (9, 12),
    (10, 3), (10, 4), (10, 5), (10, 6), (10, 7), (10, 8), (10, 9), (10, 10), (10, 11), (10, 12),
    (11, 3), (11, 4), (11, 5), (11, 6), (11, 7), (11, 8), (11, 9), (11, 10), (11, 11), (11, 12),
    (12, 12),
];

/// (row, column) of each entry of `jp`.
#[rustfmt::skip]
pub const JP_PATTERN: [(u32, u32); 55] = [
    (3, 0), (3, 4), (3, 5), (3, 7), (3, 8), (3, 9), (3, 10), (3, 15), (3, 16), (3, 17),
    (4, 0), (4, 4), (4, 5), (4, 7), (4, 8), (4, 9), (4, 10), (4, 15), (4, 16), (4, 17),
    (5, 0), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9), (5, 10), (5, 15), (5, 16), (5, 17),
    (10, 1), (10, 2), (10, 3), (10, 4), (10, 5), (10, 11), (10, 12), (10, 13), (10, 15), (10, 16), (10, 17),
    (11, 1), (11, 2), (11, 3), (11, 4), (11, 5), (11, 11), (11, 12), (11, 13), (11, 15), (11, 16), (11, 17),
    (12, 1), (12, 14),
];

/// (row, column) of each entry of `dy_dx`.
#[rustfmt::skip]
pub const DY_DX_PATTERN: [(u32, u32); 15] = [
    (0, 0), (0, 6), (0, 7), (0, 8), (0, 9),
    (1, 1), (1, 6), (1, 7), (1, 8), (1, 9),
    (2, 2), (2, 6), (2, 7), (2, 8), (2, 9),
];

/// (row, column) of each entry of `dy_dp`.
#[rustfmt::skip]
pub const DY_DP_PATTERN: [(u32, u32); 0] = [
];

/// (row, column) of each entry of `dy_dmarker`.
#[rustfmt::skip]
pub const DY_DMARKER_PATTERN: [(u32, u32); 9] = [
    (0, 0), (0, 1), (0, 2),
    (1, 0), (1, 1), (1, 2),
    (2, 0), (2, 1), (2, 2),
];

/// Tells whether this code belongs to a model's text.
pub const SOURCE_HASH: u64 = 0xe78b50dab2933955;

/// These equations as a type.
#[derive(Clone, Copy, Debug)]
pub struct DiscQuaternion;

impl crate::Equations for DiscQuaternion {
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
    name: "disc_quaternion",
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
    prepare: crate::plain::prepare::<DiscQuaternion>,
    f: crate::plain::f::<DiscQuaternion>,
    f_jac: crate::plain::f_jac::<DiscQuaternion>,
    f_jac_par: crate::plain::f_jac_par::<DiscQuaternion>,
    observe: crate::plain::observe::<DiscQuaternion>,
    observe_jac: crate::plain::observe_jac::<DiscQuaternion>,
    quantities: crate::plain::quantities::<DiscQuaternion>,
    limits: crate::plain::limits::<DiscQuaternion>,
};
