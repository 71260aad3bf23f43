//! Axes of a body in flight: about which it spins, and which of them points ahead.

/// An axis of a frame, or the opposite of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyAxis {
    /// Number of the axis, 1 to 3.
    pub number: u8,
    /// Whether the opposite direction is meant, as in `-C.3`.
    pub is_opposite: bool,
}

impl BodyAxis {
    fn new(number: u8, is_opposite: bool) -> BodyAxis {
        BodyAxis {
            number,
            is_opposite,
        }
    }

    /// Components of the axis in its frame.
    pub fn vector(self) -> [f64; 3] {
        let size = if self.is_opposite { -1.0 } else { 1.0 };
        [1, 2, 3].map(|number| if number == self.number { size } else { 0.0 })
    }

    /// Number of the axis that follows in the order 1, 2, 3, 1.
    fn next(self) -> u8 {
        self.number % 3 + 1
    }
}

/// Axes of a body in flight, in the frame that is fixed in it; of a mere axis of revolution, in the frame of that axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlightAxes {
    /// Axis about which the body spins, such as the axis of revolution. Unless stated, the third.
    pub spin: BodyAxis,
    /// Axis that points ahead. Unless stated, the one that follows the axis of the spin.
    pub forward: BodyAxis,
    /// Whether the model states the axis of the spin.
    pub states_spin: bool,
    /// Whether the model states which axis points ahead.
    pub states_forward: bool,
}

impl Default for FlightAxes {
    fn default() -> Self {
        FlightAxes::new(None, None)
    }
}

impl FlightAxes {
    /// Axes by what a model states of them.
    pub fn new(spin: Option<BodyAxis>, forward: Option<BodyAxis>) -> FlightAxes {
        let of_spin = spin.unwrap_or(BodyAxis::new(3, false));
        FlightAxes {
            spin: of_spin,
            forward: forward.unwrap_or(BodyAxis::new(of_spin.next(), false)),
            states_spin: spin.is_some(),
            states_forward: forward.is_some(),
        }
    }

    /// Whether the body flies along the axis of its spin, as an arrow does; a disc flies across it.
    pub fn is_along(self) -> bool {
        self.spin.number == self.forward.number
    }

    /// Axes that point ahead, to the left and up at a release without angles. Up is the axis of the spin, if the body
    /// flies across it.
    pub fn release(self) -> [BodyAxis; 3] {
        let (forward, up) = (self.forward, self.spin);
        if self.is_along() {
            let left = BodyAxis::new(forward.next(), false);
            return [
                forward,
                left,
                BodyAxis::new(left.next(), forward.is_opposite),
            ];
        }
        let third = 6 - forward.number - up.number;
        let is_cyclic = forward.number == up.next();
        let is_opposite = forward.is_opposite ^ up.is_opposite ^ !is_cyclic;
        [forward, BodyAxis::new(third, is_opposite), up]
    }
}
