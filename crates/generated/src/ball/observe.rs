// Written by `hyzer generate`; changes belong in the model.
//! `ball`: what is observed.

use lanes::Real;

/// The marker, `seen`, in the inertial frame.
///
/// 3 operations: 3 add.
#[inline(always)]
pub fn observe<T: Real>(
    _time: T,
    state: &[T; 6],
    _parameters: &[T; 11],
    _prepared: &[T; 8],
    marker: &[T; 3],
    seen: &mut [T; 3],
) {
    let mark_x = marker[0];
    let x = state[0];

    // ball.hyz:53  observe mark = place;
    let mark_x_2 = mark_x + x;
    seen[0] = mark_x_2;
    let mark_y = marker[1];
    let y = state[1];
    let mark_y_2 = mark_y + y;
    seen[1] = mark_y_2;
    let mark_z = marker[2];
    let z = state[2];
    let mark_z_2 = mark_z + z;
    seen[2] = mark_z_2;
}
