//! Cells of a launch monitor's table: numbers with either decimal mark, with marks of thousands, a unit, or a side.

use flight::table::number;

use crate::summary::SummaryUnit;
use crate::words::shown;

/// How the numbers of a table are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Numerals {
    /// Decimal mark, `.` or `,`; the other of the two parts thousands.
    pub decimal: char,
}

/// A cell taken apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Parts<'c> {
    /// The number.
    pub digits: &'c str,
    /// The unit after the number; empty without one.
    pub unit: &'c str,
    /// Whether the side that the cell names is the right one; `None` without a side.
    pub is_right: Option<bool>,
}

/// Marks that part thousands besides `,` and `.`: apostrophes and narrow spaces.
const THOUSANDS: [char; 4] = ['\'', '\u{2019}', '\u{a0}', '\u{202f}'];

/// Takes a cell such as `4,367`, `81.2 mph`, `23.5R`, `R 3` or `1.8° L` apart; `None` if it has no number.
pub(super) fn parts(cell: &str) -> Option<Parts<'_>> {
    let (mut rest, mut is_right) = (cell.trim(), None);
    if let Some((side, after)) = rest.split_at_checked(1)
        && let Some(side) = side_of(side)
    {
        (rest, is_right) = (after.trim_start(), Some(side));
    }
    let is_numeral = |c: char| c.is_ascii_digit() || ".,+-".contains(c) || THOUSANDS.contains(&c);
    let end = rest.find(|c| !is_numeral(c)).unwrap_or(rest.len());
    let (digits, after) = rest.split_at(end);
    if !digits.contains(|c: char| c.is_ascii_digit()) {
        return None;
    }
    let mut unit = after.trim();
    let word = unit.rfind(|c: char| !c.is_alphabetic());
    let word = word.map_or(0, |at| {
        at + unit[at..].chars().next().map_or(0, char::len_utf8)
    });
    if is_right.is_none()
        && let Some(side) = side_of(&unit[word..])
    {
        (unit, is_right) = (unit[..word].trim_end(), Some(side));
    }
    Some(Parts {
        digits: digits.trim_matches(THOUSANDS),
        unit,
        is_right,
    })
}

/// Whether a word is the right side; `None` if it is none.
fn side_of(word: &str) -> Option<bool> {
    match word.to_ascii_lowercase().as_str() {
        "r" | "right" => Some(true),
        "l" | "left" => Some(false),
        _ => None,
    }
}

impl Numerals {
    /// The numerals of a table, by its cells and the separator of these: the first cell that allows one reading alone
    /// decides; otherwise the decimal mark is a point where commas separate cells or a cell has one, else a comma.
    pub fn of<'c>(cells: impl Iterator<Item = &'c str> + Clone, separator: char) -> Self {
        let digits = cells.filter_map(|cell| Some(parts(cell)?.digits));
        let decided = digits.clone().find_map(decimal_of);
        let has_point = || separator == ',' || digits.clone().any(|own| own.contains('.'));
        let usual = || match has_point() || !digits.clone().any(|own| own.contains(',')) {
            true => '.',
            false => ',',
        };
        Self {
            decimal: decided.unwrap_or_else(usual),
        }
    }

    /// Value of digits with the marks of the table; the error is what was expected.
    fn digits(self, digits: &str) -> Result<Option<f64>, &'static str> {
        const GROUPS: &str =
            "one decimal mark in a table, and marks of thousands between three digits";
        let (whole, part) = match digits.split_once(self.decimal) {
            Some((whole, part)) => (whole, Some(part)),
            None => (digits, None),
        };
        let is_mark = |c: char| c == other(self.decimal) || THOUSANDS.contains(&c);
        let mut groups = whole.split(is_mark);
        let first = groups.next().unwrap_or_default();
        let first = first.trim_start_matches(['-', '+']);
        let is_whole = groups.clone().next().is_none()
            || ((1..=3).contains(&first.len()) && groups.all(|own| own.len() == 3));
        if !is_whole || part.is_some_and(|part| part.contains(is_mark)) {
            return Err(GROUPS);
        }
        let mut text = whole.replace(is_mark, "");
        if let Some(part) = part {
            text = format!("{text}.{part}");
        }
        number(&text)
    }

    /// Number of a cell, whatever its unit and side; `None` if it has none.
    pub fn number(self, cell: &str) -> Option<f64> {
        let own = parts(cell)?;
        let is_number = own.unit.is_empty() || SummaryUnit::parse(own.unit).is_some();
        is_number.then(|| self.digits(own.digits).ok()?).flatten()
    }

    /// Value of a cell in `unit`, positive to the right where the column has sides; `None` if it is missing. The error is
    /// what was found and what was expected.
    pub fn value(
        self,
        cell: &str,
        unit: SummaryUnit,
        has_sides: bool,
    ) -> Result<Option<f64>, String> {
        let wrong = |expected: &str| format!("{}, expected {expected}", shown(cell));
        // A dash alone stands for a missing value in several exports; so do words that `number` knows.
        if matches!(number(cell), Ok(None)) || ["-", "--", "\u{2013}", "\u{2014}"].contains(&cell) {
            return Ok(None);
        }
        let is_power = cell.contains(['e', 'E']) && number(cell).is_ok();
        if is_power {
            return number(cell).map_err(wrong);
        }
        let Some(own) = parts(cell) else {
            return Err(wrong("a number"));
        };
        let Some(mut value) = self.digits(own.digits).map_err(wrong)? else {
            return Ok(None);
        };
        if !own.unit.is_empty() {
            match SummaryUnit::parse(own.unit) {
                Some(stated) if stated.dimension() == unit.dimension() => {
                    if stated != unit {
                        value *= stated.si() / unit.si();
                    }
                }
                _ => {
                    let expected = format!("a number in {}, or in a like unit", unit.name());
                    return Err(wrong(&expected));
                }
            }
        }
        match own.is_right {
            None => {}
            Some(_) if !has_sides => return Err(wrong("a number, which has no side here")),
            Some(_) if value < 0.0 => return Err(wrong("a sign or a side, not both")),
            Some(is_right) if !is_right => value = -value,
            Some(_) => {}
        }
        Ok(Some(value))
    }
}

fn other(decimal: char) -> char {
    if decimal == '.' { ',' } else { '.' }
}

/// The decimal mark of a number that has one reading alone.
fn decimal_of(digits: &str) -> Option<char> {
    let digits = digits.trim_start_matches(['-', '+']);
    let last = digits.rfind(['.', ','])?;
    let mark = if digits[last..].starts_with('.') {
        '.'
    } else {
        ','
    };
    if digits.contains(other(mark)) {
        return Some(mark);
    }
    if digits.matches(mark).count() > 1 {
        return Some(other(mark));
    }
    let is_group = digits.len() - last == 4 && (1..=3).contains(&last) && !digits.starts_with('0');
    (!is_group).then_some(mark)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_decimal_mark_of_a_table() {
        for (cells, separator, decimal) in [
            (&["150,947", "4367,636"][..], ';', ','),
            (&["150,947", "4,367"], ';', ','),
            (&["150.947", "4,367"], ';', '.'),
            (&["150.947", "4,367"], ',', '.'),
            (&["150,9", "4.367"], ';', ','),
            (&["1.234,5"], ';', ','),
            (&["1,234.5"], ';', '.'),
            (&["4,367"], ',', '.'),
            (&["0,5"], ',', ','),
            (&["12"], ';', '.'),
        ] {
            let numerals = Numerals::of(cells.iter().copied(), separator);
            assert_eq!(numerals.decimal, decimal, "{cells:?}");
        }
    }

    #[test]
    fn cells_with_marks_units_and_sides() {
        let unit = |name| SummaryUnit::parse(name).expect(name);
        let point = Numerals { decimal: '.' };
        let read = |cell| point.value(cell, unit("yd"), true);
        for (cell, value) in [
            ("23.5R", 23.5),
            ("5.8 L", -5.8),
            ("L5.8", -5.8),
            ("3 yds left", -3.0),
            ("3 ft R", 1.0),
            ("-3.0", -3.0),
            ("1,234.5", 1234.5),
            ("1'234", 1234.0),
            ("1e1", 10.0),
        ] {
            let found = read(cell).expect(cell).expect(cell);
            assert!((found - value).abs() < 1e-12, "{cell}: {found}");
        }
        for missing in ["", "-", "NA", "nan"] {
            assert_eq!(read(missing), Ok(None), "{missing}");
        }
        for wrong in ["-3 L", "3 mph", "1,23", "12,34.5", "x", "R", "3 X", "1.2.3"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
        assert!(point.value("3 R", unit("mph"), false).is_err());
        let comma = Numerals { decimal: ',' };
        assert_eq!(comma.value("1.234,5", unit("yd"), true), Ok(Some(1234.5)));
        assert_eq!(comma.number("4367,5 rpm"), Some(4367.5));
        let metres = point.value("10 m/s", unit("km/h"), false);
        assert!((metres.expect("a speed").expect("a value") - 36.0).abs() < 1e-12);
    }
}
