//! The air's velocity where the body is.

/// Velocity of the air in the inertial frame, m/s.
pub trait Wind {
    /// At a time (s) and a place (m, inertial frame).
    fn at(&self, t: f64, position: [f64; 3]) -> [f64; 3];
}

/// The same velocity everywhere and always: what every model takes as its input `wind`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Constant(pub [f64; 3]);

impl Wind for Constant {
    #[inline(always)]
    fn at(&self, _: f64, _: [f64; 3]) -> [f64; 3] {
        self.0
    }
}
