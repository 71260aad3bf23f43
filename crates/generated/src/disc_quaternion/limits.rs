// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: the limits of the model.

use lanes::Real;

/// What must stay above `LIMITS`.
///
/// 0 operations.
#[inline(always)]
pub fn limits<T: Real>(
    _time: T,
    _state: &[T; 13],
    _parameters: &[T; 18],
    _prepared: &[T; 18],
    _margins: &mut [T; 0],
) {
}
