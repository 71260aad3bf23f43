//! Arguments of functions that switch, such as steps, kinks and tables.

/// A value of an argument on whose two sides a function differs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// Value of the argument.
    pub value: f64,
    /// Whether the function or its slope jumps there.
    pub is_kink: bool,
}

/// What is known of one argument of functions that switch.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Switch {
    /// Levels, of increasing values.
    pub levels: Vec<Level>,
    /// Whether it is the angle of a sine within another argument: where that turns far, values of the other at a few points
    /// do not tell what it does between them.
    pub is_phase: bool,
}

impl Switch {
    /// Number of levels below a value of the argument.
    #[inline]
    pub fn index(&self, value: f64) -> usize {
        self.levels.partition_point(|level| level.value < value)
    }
}
