//! Declared hypotheses on what the paper's tables mean.
//!
//! A [`Reading`] chooses one answer to each question; the answer that takes the print at its word is free, every other
//! one is a hypothesis that has to earn its place.

use serde::Deserialize;

/// Table 1 as printed: eight numbers for each flight.
#[derive(Clone, Debug, Deserialize)]
pub struct Table1 {
    /// Flight fssh3.
    pub fssh3: [f64; 8],
    /// Flight bffl8.
    pub bffl8: [f64; 8],
}

impl Table1 {
    /// The built-in copy.
    pub fn printed() -> Self {
        toml::from_str(include_str!("data/table1.toml")).expect("the built-in table is well formed")
    }
}

/// What the rolling moment's coefficient multiplies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RollSpin {
    /// The spin in rad/s, as printed.
    RadPerSecond,
    /// The spin in revolutions per second.
    RevPerSecond,
    /// The spin made dimensionless with √(d/g), as in Hummel's later program.
    RootDOverG,
    /// The spin ratio r d/(2 V).
    SpinRatio,
}

/// What the spin-down coefficient is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SpinDown {
    /// N m s, as printed.
    NewtonMetreSecond,
    /// N m per revolution per second.
    PerRevPerSecond,
    /// Seconds, with ρ V² A d/2 before it as in the other moments.
    TimesDynamicPressure,
}

/// The order in which the four lift and drag columns were printed: `columns[i]` is the printed column that
/// holds C_L0, C_La, C_D0, C_Da.
pub type Columns = [u8; 4];

/// The printed order.
pub const PRINTED: Columns = [0, 1, 2, 3];

/// Answers to the questions that concern both flights alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Common {
    /// The pitching moment by α̇ has the opposite sign.
    pub pitch_damping_reversed: bool,
    /// The rolling moment by ω·d1 has the opposite sign.
    pub roll_damping_reversed: bool,
    /// The rolling moment by spin has the opposite sign.
    pub roll_spin_reversed: bool,
    /// The spin-down moment is opposite to the paper's word that a positive coefficient slows.
    pub spin_down_reversed: bool,
    /// What the rolling moment's coefficient multiplies.
    pub roll_spin: RollSpin,
    /// What the spin-down coefficient is.
    pub spin_down: SpinDown,
}

/// One reading of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Reading {
    /// What concerns both flights.
    pub common: Common,
    /// Columns of fssh3.
    pub fssh3: Columns,
    /// Columns of bffl8.
    pub bffl8: Columns,
}

impl Common {
    /// The print at its word. The paper's M1 and M2 add `C_Mα̇` times the rates; C_Nr slows where positive.
    pub const PRINTED: Self = Self {
        pitch_damping_reversed: false,
        roll_damping_reversed: false,
        roll_spin_reversed: false,
        spin_down_reversed: false,
        roll_spin: RollSpin::RadPerSecond,
        spin_down: SpinDown::NewtonMetreSecond,
    };

    /// Every combination of answers.
    pub fn all() -> Vec<Self> {
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

    /// The hypotheses used, in words.
    pub fn hypotheses(&self) -> Vec<&'static str> {
        let mut words = Vec::new();
        let mut say = |used: bool, what| {
            if used {
                words.push(what);
            }
        };
        say(self.pitch_damping_reversed, "pitch damping reversed");
        say(self.roll_damping_reversed, "roll damping reversed");
        say(self.roll_spin_reversed, "rolling moment by spin reversed");
        say(self.spin_down_reversed, "spin-down reversed");
        say(
            self.roll_spin == RollSpin::RevPerSecond,
            "rolling moment per rev/s",
        );
        say(
            self.roll_spin == RollSpin::RootDOverG,
            "rolling moment by spin × √(d/g)",
        );
        say(
            self.roll_spin == RollSpin::SpinRatio,
            "rolling moment by spin × d/2V",
        );
        say(
            self.spin_down == SpinDown::PerRevPerSecond,
            "C_Nr per rev/s",
        );
        say(
            self.spin_down == SpinDown::TimesDynamicPressure,
            "C_Nr in s, times ρV²Ad/2",
        );
        words
    }
}

/// Every order of the four columns.
pub fn orders() -> Vec<Columns> {
    let mut orders = Vec::with_capacity(24);
    for code in 0..256_u16 {
        let order = [0, 2, 4, 6].map(|shift| (code >> shift & 3) as u8);
        let mut sorted = order;
        sorted.sort_unstable();
        if sorted == PRINTED {
            orders.push(order);
        }
    }
    orders.sort_unstable();
    orders
}

/// Fewest interchanges of two columns that make this order: each is one hypothesis.
pub fn interchanges(order: Columns) -> usize {
    let mut order = order;
    let mut count = 0;
    for i in 0..4 {
        while order[i] as usize != i {
            let j = order[i] as usize;
            order.swap(i, j);
            count += 1;
        }
    }
    count
}

/// What an order changes, or nothing for the printed one: `C_L0 ↔ C_La` for two that are interchanged, `C_L0 from C_D0`
/// where more than two are moved around.
fn order_in_words(order: Columns) -> Option<String> {
    let names = ["C_L0", "C_La", "C_D0", "C_Da"];
    let mut words = Vec::new();
    for i in 0..4 {
        let j = order[i] as usize;
        let interchanged = order[j] as usize == i;
        if j > i && interchanged {
            words.push(format!("{} ↔ {}", names[i], names[j]));
        } else if j != i && !interchanged {
            words.push(format!("{} from {}", names[i], names[j]));
        }
    }
    (!words.is_empty()).then(|| words.join(", "))
}

impl Reading {
    /// The print at its word.
    pub const PRINTED: Self = Self {
        common: Common::PRINTED,
        fssh3: PRINTED,
        bffl8: PRINTED,
    };

    /// How many hypotheses it uses: an interchange of columns in both flights counts once.
    pub fn hypotheses(&self) -> usize {
        let columns = if self.fssh3 == self.bffl8 {
            interchanges(self.fssh3)
        } else {
            interchanges(self.fssh3) + interchanges(self.bffl8)
        };
        columns + self.common.hypotheses().len()
    }

    /// The one answer in which another reading differs from this one, as (here, there); nothing where it is not one.
    pub fn difference(&self, other: &Self) -> Option<(String, String)> {
        let columns = |reading: &Self| {
            Self {
                common: Common::PRINTED,
                ..*reading
            }
            .words()
        };
        let only = |left: &Common, right: &Common| -> Vec<&'static str> {
            left.hypotheses()
                .into_iter()
                .filter(|word| !right.hypotheses().contains(word))
                .collect()
        };
        let say = |words: &[&str]| words.first().map_or("as printed", |word| word).to_owned();
        let (here, there) = (
            only(&self.common, &other.common),
            only(&other.common, &self.common),
        );
        let same = (self.fssh3, self.bffl8) == (other.fssh3, other.bffl8);
        match (same, here.len(), there.len()) {
            (true, 0..=1, 0..=1) => Some((say(&here), say(&there))),
            (false, 0, 0) => Some((columns(self), columns(other))),
            _ => None,
        }
    }

    /// What it assumes, in words.
    pub fn words(&self) -> String {
        let mut words: Vec<String> = Vec::new();
        if self.fssh3 == self.bffl8 {
            words.extend(order_in_words(self.fssh3).map(|order| format!("both flights: {order}")));
        } else {
            words.extend(order_in_words(self.fssh3).map(|order| format!("fssh3: {order}")));
            words.extend(order_in_words(self.bffl8).map(|order| format!("bffl8: {order}")));
        }
        words.extend(self.common.hypotheses().iter().map(|&word| word.to_owned()));
        if words.is_empty() {
            "as printed".to_owned()
        } else {
            words.join("; ")
        }
    }
}

/// Coefficients of the `disc` model, in the order C_L0, C_La, C_D0, C_Da, C_Ma, C_Mq (pitch), C_Mq (roll), C_Rr, C_Nr.
/// Pitch and roll damping are apart because their signs are separate hypotheses.
pub type Coefficients = [f64; 9];

/// The coefficients that a reading makes of a printed row. `d` in m, `g` in m/s².
pub fn coefficients(
    row: &[f64; 8],
    columns: Columns,
    common: &Common,
    d: f64,
    g: f64,
) -> Coefficients {
    let sign = |reversed: bool| if reversed { -1.0 } else { 1.0 };
    let roll_scale = match common.roll_spin {
        RollSpin::RadPerSecond | RollSpin::SpinRatio => 1.0,
        RollSpin::RevPerSecond => 0.5 / std::f64::consts::PI,
        RollSpin::RootDOverG => (d / g).sqrt(),
    };
    let spin_down_scale = match common.spin_down {
        SpinDown::NewtonMetreSecond | SpinDown::TimesDynamicPressure => 1.0,
        SpinDown::PerRevPerSecond => 0.5 / std::f64::consts::PI,
    };
    let column = |i: usize| row[columns[i] as usize];
    [
        column(0),
        column(1),
        column(2),
        column(3),
        row[4],
        sign(common.pitch_damping_reversed) * row[5],
        sign(common.roll_damping_reversed) * row[5],
        sign(common.roll_spin_reversed) * row[6] * roll_scale,
        // The paper's coefficient slows where positive; the model's damps where negative.
        -sign(common.spin_down_reversed) * row[7] * spin_down_scale,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_as_many_readings_as_answers() {
        assert_eq!(Common::all().len(), 16 * 4 * 3);
        assert_eq!(orders().len(), 24);
        assert_eq!(orders()[0], PRINTED);
    }

    #[test]
    fn interchanges_are_counted() {
        for (order, count) in [
            ([0, 1, 2, 3], 0),
            ([1, 0, 2, 3], 1),
            ([1, 0, 3, 2], 2),
            ([1, 2, 3, 0], 3),
        ] {
            assert_eq!(interchanges(order), count, "{order:?}");
        }
    }

    #[test]
    fn the_print_at_its_word_uses_no_hypothesis() {
        assert_eq!(Reading::PRINTED.hypotheses(), 0);
        assert_eq!(Reading::PRINTED.words(), "as printed");
        let swapped = Reading {
            fssh3: [1, 0, 2, 3],
            bffl8: [1, 0, 2, 3],
            ..Reading::PRINTED
        };
        assert_eq!(swapped.hypotheses(), 1);
        assert_eq!(swapped.words(), "both flights: C_L0 ↔ C_La");
    }
}
