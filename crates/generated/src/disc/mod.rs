// Written by `hyzer generate`; changes belong in the model.
//! A spinning disc in flight: Hubbard & Hummel, "Simulation of Frisbee Flight" (2000), in vector form.
//!
//! Eight aerodynamic coefficients. Their signs are such that a negative `C_Mq` and a negative `C_Nr` damp.
//! Against the paper's Table 1: `C_Mq` is −C_Mα̇ (the paper multiplies α̇ by a positive coefficient),
//! `C_Nr` is −C_Nr, and `C_Rr` is C_Rγ̇, multiplied here by r = ω·d3, which does not depend on the
//! choice of angles, where the paper has γ̇. All others are the paper's own.
//! Default coefficients: Hummel & Hubbard (2002) and Hummel (2003), carried into these frames.
//!
//! | function | operations |
//! |---|---|
//! | `prepare` | 23 operations: 14 mul, 3 div, 6 neg |
//! | `f` | 108 operations: 35 add, 63 mul, 2 div, 2 sqrt, 5 call, 1 select |
//! | `f_jac` | 339 operations: 103 add, 212 mul, 3 div, 13 neg, 2 sqrt, 5 call, 1 select |
//! | `f_jac_par` | 493 operations: 125 add, 323 mul, 3 div, 34 neg, 2 sqrt, 5 call, 1 select |
//! | `observe` | 27 operations: 9 add, 12 mul, 6 call |
//! | `observe_jac` | 59 operations: 15 add, 33 mul, 5 neg, 6 call |
//! | `quantities` | 66 operations: 16 add, 39 mul, 2 div, 2 neg, 2 sqrt, 5 call |
//! | `limits` | 1 operations: 1 call |

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
pub const STATES: [&str; 12] = [
    "x", "y", "z", "u", "v", "w", "phi", "theta", "gamma", "phidot", "thetadot", "gammadot",
];

/// States where a release does not say otherwise.
#[rustfmt::skip]
pub const INITIAL: [f64; 12] = [
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
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
pub const PREPARED: [&str; 22] = [
    "inv_m_half_rho_A", "minus_g", "half_rho_A_d_inv_I_d", "inv_I_d_I_a", "C_Nr_inv_I_a",
    "minus_wind_y", "C_Da_two", "two_d_half_rho_A_inv_I_d", "inv_m", "inv_I_d", "inv_I_a", "A_half",
    "half_rho_A", "inv_I_d_d", "rho_half", "minus_rho_half", "minus_A_half",
    "minus_half_rho_A_inv_m", "half_rho_A_inv_I_d", "minus_half_rho_A_inv_I_d",
    "inv_I_a_d_gammadot_dot_d_r", "half_d",
];

/// What `quantities` computes.
#[rustfmt::skip]
pub const QUANTITIES: [&str; 35] = [
    "air_x", "air_y", "air_z", "rho_air", "g_here", "J_11", "J_22", "J_13", "J_23",
    "air_velocity_1", "air_velocity_2", "air_velocity_3", "d3_1", "d3_2", "d3_3", "V", "d1_1",
    "d1_2", "d1_3", "d2_1", "d2_2", "d2_3", "alpha", "q", "C_L", "C_D", "lift", "drag", "r",
    "rate_1", "rate_2", "spin_ratio", "roll", "pitch", "spin_down",
];

/// The model holds where each of `limits` is above its bound.
#[rustfmt::skip]
pub const LIMITS: [f64; 1] = [
    0.01,
];

/// What happens at each limit.
#[rustfmt::skip]
pub const LIMIT_REASONS: [&str; 1] = [
    "the plane of the disc stands vertical, where phi and gamma turn about one axis",
];

/// (row, column) of each entry of `j`.
#[rustfmt::skip]
pub const J_PATTERN: [(u32, u32); 60] = [
    (0, 3), (0, 5), (0, 7),
    (1, 3), (1, 4), (1, 5), (1, 6), (1, 7),
    (2, 3), (2, 4), (2, 5), (2, 6), (2, 7),
    (3, 3), (3, 4), (3, 5), (3, 6), (3, 7), (3, 9), (3, 10),
    (4, 3), (4, 4), (4, 5), (4, 6), (4, 7), (4, 9),
    (5, 3), (5, 4), (5, 5), (5, 6), (5, 7), (5, 9), (5, 10),
    (6, 9),
    (7, 10),
    (8, 11),
    (9, 3), (9, 4), (9, 5), (9, 6), (9, 7), (9, 9), (9, 10), (9, 11),
    (10, 3), (10, 4), (10, 5), (10, 6), (10, 7), (10, 9), (10, 10), (10, 11),
    (11, 3), (11, 4), (11, 5), (11, 6), (11, 7), (11, 9), (11, 10), (11, 11),
];

/// (row, column) of each entry of `jp`.
#[rustfmt::skip]
pub const JP_PATTERN: [(u32, u32); 67] = [
    (3, 0), (3, 4), (3, 5), (3, 6), (3, 7), (3, 8), (3, 9), (3, 10), (3, 15), (3, 16), (3, 17),
    (4, 0), (4, 4), (4, 5), (4, 6), (4, 7), (4, 8), (4, 9), (4, 10), (4, 15), (4, 16), (4, 17),
    (5, 0), (5, 4), (5, 5), (5, 6), (5, 7), (5, 8), (5, 9), (5, 10), (5, 15), (5, 16), (5, 17),
    (9, 1), (9, 2), (9, 3), (9, 4), (9, 5), (9, 11), (9, 12), (9, 13), (9, 15), (9, 16), (9, 17),
    (10, 1), (10, 2), (10, 3), (10, 4), (10, 5), (10, 11), (10, 12), (10, 13), (10, 15), (10, 16), (10, 17),
    (11, 1), (11, 2), (11, 3), (11, 4), (11, 5), (11, 11), (11, 12), (11, 13), (11, 14), (11, 15), (11, 16), (11, 17),
];

/// (row, column) of each entry of `dy_dx`.
#[rustfmt::skip]
pub const DY_DX_PATTERN: [(u32, u32); 11] = [
    (0, 0), (0, 7), (0, 8),
    (1, 1), (1, 6), (1, 7), (1, 8),
    (2, 2), (2, 6), (2, 7), (2, 8),
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
pub const SOURCE_HASH: u64 = 0x60ff8625fd177c55;

/// These equations as a type.
#[derive(Clone, Copy, Debug)]
pub struct Disc;

impl crate::Equations for Disc {
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
    name: "disc",
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
    prepare: crate::plain::prepare::<Disc>,
    f: crate::plain::f::<Disc>,
    f_jac: crate::plain::f_jac::<Disc>,
    f_jac_par: crate::plain::f_jac_par::<Disc>,
    observe: crate::plain::observe::<Disc>,
    observe_jac: crate::plain::observe_jac::<Disc>,
    quantities: crate::plain::quantities::<Disc>,
    limits: crate::plain::limits::<Disc>,
};
