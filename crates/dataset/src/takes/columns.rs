//! Parsing of the column names of a table, such as `t`, `time (ms)`, `m1_x`, `m1 X [mm]` or `disc_qw`.

use crate::takes::unit::{LengthUnit, TimeUnit};

/// Content of a column of a table of motion-capture data, derived from the column's name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Column {
    /// Label of the recorded point or body to which the column belongs; empty if the column name contains none.
    pub label: String,
    pub quantity: Quantity,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Quantity {
    /// Time; the unit is `None` if the column name states none.
    Time(Option<TimeUnit>),
    Frame,
    /// Coordinate 0, 1 or 2 (x, y, z) of a position; the unit is `None` if the column name states none.
    Coordinate(usize, Option<LengthUnit>),
    /// Component 0 to 3 of a quaternion, in the order w, x, y, z.
    Quaternion(usize),
    Other,
}

/// Characters between the label of a column name and what follows it.
pub(crate) const JOINTS: [char; 5] = ['_', ' ', '.', ':', '-'];

impl Column {
    /// Splits a column name into label, quantity and unit.
    pub fn parse(name: &str) -> Self {
        let (bare, unit) = without_unit(name.trim());
        let lower = bare.to_ascii_lowercase();
        let named = |quantity| Self {
            label: String::new(),
            quantity,
        };
        let (time_unit, length_unit) = (
            unit.and_then(TimeUnit::parse),
            unit.filter(|unit| LengthUnit::is_whole_name(unit))
                .and_then(LengthUnit::parse),
        );
        match lower.as_str() {
            "t" | "time" | "timestamp" => {
                // A column with an unknown unit is not read as a time.
                return named(if unit.is_some() && time_unit.is_none() {
                    Quantity::Other
                } else {
                    Quantity::Time(time_unit)
                });
            }
            // Exports of ROS bags count nanoseconds.
            "%time" => return named(Quantity::Time(Some(TimeUnit::Nanosecond))),
            "timeseconds" => return named(Quantity::Time(Some(TimeUnit::Second))),
            "frame" | "frame#" | "frame number" => return named(Quantity::Frame),
            _ => {}
        }
        let (label, last) = at_joint(bare);
        let last = last.to_ascii_lowercase();
        let coordinate = ["x", "y", "z"].iter().position(|axis| *axis == last);
        let component = ["qw", "qx", "qy", "qz"].iter().position(|q| *q == last);
        let quantity = match (coordinate, component) {
            (Some(axis), _) if unit.is_none() || length_unit.is_some() => {
                Quantity::Coordinate(axis, length_unit)
            }
            (_, Some(component)) if unit.is_none() => Quantity::Quaternion(component),
            _ => Quantity::Other,
        };
        Self {
            label: label.trim_matches(JOINTS).to_owned(),
            quantity,
        }
    }
}

/// Label of a column name without unit, and what follows it: after a joint, or an axis in capitals, as of `m1X`.
pub(crate) fn at_joint(bare: &str) -> (&str, &str) {
    let (label, last) = bare
        .rfind(JOINTS)
        .map_or(("", bare), |at| (&bare[..at], &bare[at + 1..]));
    let stem = last.strip_suffix(['X', 'Y', 'Z']).unwrap_or_default();
    // `tX` and `qX` are a translation and a part of a quaternion.
    let is_name = stem.ends_with(|c: char| c.is_ascii_lowercase() || c.is_ascii_digit())
        && stem != "t"
        && !stem.ends_with('q');
    match is_name {
        true => bare.split_at(bare.len() - 1),
        false => (label, last),
    }
}

/// Splits a column name with a unit at its end (`x_mm`, `x (mm)`, `x [mm]`) before the unit; `None` without one.
pub(crate) fn without_unit(name: &str) -> (&str, Option<&str>) {
    for (open, close) in [('(', ')'), ('[', ']')] {
        if let Some(rest) = name.strip_suffix(close)
            && let Some(at) = rest.rfind(open)
        {
            return (name[..at].trim_end(), Some(rest[at + 1..].trim()));
        }
    }
    let symbols = ["s", "ms", "us", "ns", "m", "cm", "mm", "in", "ft"];
    let is_symbol = |text: &str| symbols.iter().any(|own| own.eq_ignore_ascii_case(text));
    match name.rsplit_once('_') {
        Some((bare, unit)) if !bare.is_empty() && is_symbol(unit) => (bare, Some(unit)),
        _ => (name, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_taken_apart() {
        let parts = |name: &str| {
            let column = Column::parse(name);
            (column.label, column.quantity)
        };
        let mm = Some(LengthUnit::Millimetre);
        let cases = [
            ("t", "", Quantity::Time(None)),
            ("t_s", "", Quantity::Time(Some(TimeUnit::Second))),
            ("Time (ms)", "", Quantity::Time(Some(TimeUnit::Millisecond))),
            ("time [fortnights]", "", Quantity::Other),
            ("Frame", "", Quantity::Frame),
            ("%time", "", Quantity::Time(Some(TimeUnit::Nanosecond))),
            ("x_m", "", Quantity::Coordinate(0, Some(LengthUnit::Metre))),
            ("m1_x", "m1", Quantity::Coordinate(0, None)),
            ("left rim Y", "left rim", Quantity::Coordinate(1, None)),
            ("m1_z [mm]", "m1", Quantity::Coordinate(2, mm)),
            ("disc_qw", "disc", Quantity::Quaternion(0)),
            ("qz", "", Quantity::Quaternion(3)),
            ("TIME (US)", "", Quantity::Time(Some(TimeUnit::Microsecond))),
            ("M1_X_MM", "M1", Quantity::Coordinate(0, mm)),
            ("m1 - x (mm)", "m1", Quantity::Coordinate(0, mm)),
            ("m1X", "m1", Quantity::Coordinate(0, None)),
            ("left rimZ (mm)", "left rim", Quantity::Coordinate(2, mm)),
            ("qX", "", Quantity::Quaternion(1)),
            ("roll", "", Quantity::Other),
            ("m1_x (deg)", "m1", Quantity::Other),
        ];
        for (name, label, quantity) in cases {
            assert_eq!(parts(name), (label.to_owned(), quantity), "{name}");
        }
    }
}
