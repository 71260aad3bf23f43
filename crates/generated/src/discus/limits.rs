// Written by `hyzer generate`; changes belong in the model.
//! `discus`: the limits of the model.

use lanes::Real;

/// What must stay above `LIMITS`.
///
/// 1 operations: 1 call.
#[inline(always)]
pub fn limits<T: Real>(
    _time: T,
    state: &[T; 12],
    _parameters: &[T; 18],
    _prepared: &[T; 29],
    margins: &mut [T; 1],
) {
    let theta = state[7];
    let cos_theta = theta.sin_cos().1;
    margins[0] = cos_theta;
}
