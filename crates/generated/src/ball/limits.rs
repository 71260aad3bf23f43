// Written by `hyzer generate`; changes belong in the model.
//! `ball`: the limits of the model.

use lanes::Real;

/// What must stay above `LIMITS`.
///
/// 0 operations.
#[inline(always)]
pub fn limits<T: Real>(
    _time: T,
    _state: &[T; 6],
    _parameters: &[T; 11],
    _prepared: &[T; 8],
    _margins: &mut [T; 0],
) {
}
