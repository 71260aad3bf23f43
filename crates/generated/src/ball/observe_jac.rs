// Written by `hyzer generate`; changes belong in the model.
//! `ball`: what is observed, and its derivatives.

use lanes::Real;

/// The marker, `seen`, and its derivatives by states, parameters and its own coordinates.
///
/// 3 operations: 3 add.
#[inline(always)]
pub fn observe_jac<T: Real>(
    _time: T,
    state: &[T; 6],
    _parameters: &[T; 11],
    _prepared: &[T; 8],
    marker: &[T; 3],
    seen: &mut [T; 3],
    dy_dx: &mut [T; 3],
    _dy_dp: &mut [T; 0],
    dy_dmarker: &mut [T; 3],
) {
    let x = state[0];
    let mark_x = marker[0];
    let mark_x_2 = x + mark_x;
    seen[0] = mark_x_2;
    let y = state[1];
    let mark_y = marker[1];
    let mark_y_2 = y + mark_y;
    seen[1] = mark_y_2;
    let z = state[2];
    let mark_z = marker[2];
    let mark_z_2 = z + mark_z;
    seen[2] = mark_z_2;

    dy_dx[0] = T::splat(1.0); // d_seen_x_d_x
    dy_dx[1] = T::splat(1.0); // d_seen_y_d_y
    dy_dx[2] = T::splat(1.0); // d_seen_z_d_z
    dy_dmarker[0] = T::splat(1.0); // d_seen_x_d_mark_x
    dy_dmarker[1] = T::splat(1.0); // d_seen_y_d_mark_y
    dy_dmarker[2] = T::splat(1.0); // d_seen_z_d_mark_z
}
