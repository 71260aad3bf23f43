//! Signs and units of Table 1 that a reading may assume. They are the same for both flights.

/// Measure of the spin, such as rad/s or the advance ratio, to which the rolling moment due to spin is proportional.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RollSpin {
    /// Spin in rad/s, as Table 1 of Hubbard & Hummel (2000) prints it.
    RadPerSecond,
    /// Spin in revolutions per second.
    RevPerSecond,
    /// Spin multiplied by √(d/g), with the diameter d and the gravitational acceleration g; dimensionless, as in
    /// Hummel's later program.
    RootDOverG,
    /// Advance ratio r d/(2 V), where r is the spin.
    SpinRatio,
}

/// Unit assumed for the spin-damping coefficient C_Nr in Table 1 of Hubbard & Hummel (2000).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SpinDown {
    /// N m s, as Table 1 of Hubbard & Hummel (2000) prints it: a moment per rad/s of spin.
    NewtonMetreSecond,
    /// N m s per revolution: a moment per revolution per second of spin.
    PerRevPerSecond,
    /// Seconds: the coefficient is multiplied by ρ V² A d/2, like the coefficients of the other moments.
    TimesDynamicPressure,
}

/// Combination of signs and units that one interpretation of Table 1 of Hubbard & Hummel (2000) assumes for both
/// flights.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Conventions {
    /// Whether the pitching moment due to α̇ is assumed to have the opposite sign to the one that Hubbard & Hummel
    /// (2000) print.
    pub pitch_damping_reversed: bool,
    /// Whether the rolling moment due to ω·d1, the angular rate about the roll axis d1, is assumed to have the opposite
    /// sign to the one that Hubbard & Hummel (2000) print.
    pub roll_damping_reversed: bool,
    /// Whether the rolling moment due to spin is assumed to have the opposite sign to the one that Hubbard & Hummel
    /// (2000) print.
    pub roll_spin_reversed: bool,
    /// Whether the spin-damping moment is assumed to have the opposite sign to the one that Hubbard & Hummel (2000)
    /// print, so that a positive coefficient increases the spin.
    pub spin_down_reversed: bool,
    /// Measure of the spin, such as rad/s or the advance ratio, to which the rolling moment due to spin is
    /// proportional.
    pub roll_spin: RollSpin,
    /// Unit assumed for the spin-damping coefficient C_Nr.
    pub spin_down: SpinDown,
}

impl Conventions {
    /// Signs and units as Hubbard & Hummel (2000) print them: the pitching and rolling moments contain `+C_Mα̇` times
    /// the respective angular rate, and a positive C_Nr slows the spin.
    pub const PRINTED: Self = Self {
        pitch_damping_reversed: false,
        roll_damping_reversed: false,
        roll_spin_reversed: false,
        spin_down_reversed: false,
        roll_spin: RollSpin::RadPerSecond,
        spin_down: SpinDown::NewtonMetreSecond,
    };

    /// Returns all 192 combinations of signs and units that an interpretation of Table 1 of Hubbard & Hummel (2000) can
    /// assume.
    pub(super) fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for signs in 0..16_u8 {
            for roll_spin in [
                RollSpin::RadPerSecond,
                RollSpin::RevPerSecond,
                RollSpin::RootDOverG,
                RollSpin::SpinRatio,
            ] {
                for spin_down in [
                    SpinDown::NewtonMetreSecond,
                    SpinDown::PerRevPerSecond,
                    SpinDown::TimesDynamicPressure,
                ] {
                    all.push(Self {
                        pitch_damping_reversed: signs & 1 != 0,
                        roll_damping_reversed: signs & 2 != 0,
                        roll_spin_reversed: signs & 4 != 0,
                        spin_down_reversed: signs & 8 != 0,
                        roll_spin,
                        spin_down,
                    });
                }
            }
        }
        all
    }

    /// Descriptions of the hypotheses on Table 1 of Hubbard & Hummel (2000), one for each sign or unit that is assumed
    /// to differ from the printed one.
    pub(super) fn hypotheses(&self) -> Vec<&'static str> {
        let signs = [
            (self.pitch_damping_reversed, "pitch damping reversed"),
            (self.roll_damping_reversed, "roll damping reversed"),
            (self.roll_spin_reversed, "rolling moment by spin reversed"),
            (self.spin_down_reversed, "spin-down reversed"),
        ];
        let roll_spin = match self.roll_spin {
            RollSpin::RadPerSecond => None,
            RollSpin::RevPerSecond => Some("rolling moment per rev/s"),
            RollSpin::RootDOverG => Some("rolling moment by spin × √(d/g)"),
            RollSpin::SpinRatio => Some("rolling moment by spin × d/2V"),
        };
        let spin_down = match self.spin_down {
            SpinDown::NewtonMetreSecond => None,
            SpinDown::PerRevPerSecond => Some("C_Nr per rev/s"),
            SpinDown::TimesDynamicPressure => Some("C_Nr in s, times ρV²Ad/2"),
        };
        let reversed = signs.into_iter().filter(|(is, _)| *is);
        let reversed = reversed.map(|(_, description)| description);
        reversed.chain(roll_spin).chain(spin_down).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_as_many_conventions_as_combinations() {
        assert_eq!(Conventions::all().len(), 16 * 4 * 3);
    }
}
