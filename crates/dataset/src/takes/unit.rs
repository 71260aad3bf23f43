//! Units of length and time in the file of a recording.

use std::fmt;

/// Unit of length of the coordinates in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthUnit {
    /// Metre.
    Metre,
    /// Centimetre, 0.01 m.
    Centimetre,
    /// Millimetre, 0.001 m.
    Millimetre,
    /// Inch, 0.0254 m.
    Inch,
    /// Foot, 0.3048 m.
    Foot,
}

/// Unit of the times in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeUnit {
    /// Second.
    Second,
    /// Millisecond, 0.001 s.
    Millisecond,
    /// Microsecond, 1e-6 s.
    Microsecond,
    /// Nanosecond, 1e-9 s.
    Nanosecond,
}

/// Minimum length of an abbreviated unit name, characters; a shorter text counts only if it is the symbol of a unit.
const SHORTEST_CUT: usize = 3;

impl LengthUnit {
    const ALL: [(Self, &'static str, f64, &'static [&'static str]); 5] = [
        (Self::Metre, "m", 1.0, &["meters", "metres"]),
        (
            Self::Centimetre,
            "cm",
            1e-2,
            &["centimeters", "centimetres"],
        ),
        (
            Self::Millimetre,
            "mm",
            1e-3,
            &["millimeters", "millimetres"],
        ),
        (Self::Inch, "in", 0.0254, &["inches"]),
        (Self::Foot, "ft", 0.3048, &["feet", "foot"]),
    ];

    /// Parses a unit from its symbol (`mm`) or the beginning of its name (`Millimeters`, `mete`), in any case.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim().to_ascii_lowercase();
        let is = |symbol: &str, names: &[&str]| {
            let begins = |name: &&str| text.len() >= SHORTEST_CUT && name.starts_with(&text);
            text == symbol || names.iter().any(begins)
        };
        let mut all = Self::ALL.iter();
        let found = all.find(|(_, symbol, _, names)| is(symbol, names));
        found.map(|&(unit, ..)| unit)
    }

    /// All units.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        Self::ALL.iter().map(|(unit, ..)| *unit)
    }

    /// Length of one unit, m.
    pub fn metres(self) -> f64 {
        Self::ALL[self as usize].2
    }

    /// Name of several of the unit, as in `millimetres`.
    pub(crate) fn plural(self) -> &'static str {
        match self {
            Self::Metre => "metres",
            Self::Centimetre => "centimetres",
            Self::Millimetre => "millimetres",
            Self::Inch => "inches",
            Self::Foot => "feet",
        }
    }

    /// Symbol of the unit: `m`, `cm`, `mm`, `in` or `ft`.
    pub fn symbol(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// Whether a text is the symbol or the full name of a unit of length, as opposed to an abbreviated name.
    pub(crate) fn is_whole_name(text: &str) -> bool {
        let text = text.trim().to_ascii_lowercase();
        Self::ALL.iter().any(|(_, symbol, _, names)| {
            let singular = |name: &&str| name.strip_suffix('s') == Some(text.as_str());
            text == *symbol || names.iter().any(|name| *name == text || singular(name))
        })
    }
}

impl fmt::Display for LengthUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.symbol())
    }
}

impl TimeUnit {
    /// Parses a unit from its symbol (`ms`) or its name (`Seconds`), ignoring case; `None` for any other text.
    pub fn parse(text: &str) -> Option<Self> {
        match text.trim().to_ascii_lowercase().as_str() {
            "s" | "sec" | "second" | "seconds" => Some(Self::Second),
            "ms" | "msec" | "millisecond" | "milliseconds" => Some(Self::Millisecond),
            "us" | "µs" | "μs" | "usec" | "microsecond" | "microseconds" => {
                Some(Self::Microsecond)
            }
            "ns" | "nsec" | "nanosecond" | "nanoseconds" => Some(Self::Nanosecond),
            _ => None,
        }
    }

    /// Duration of one unit, s.
    pub fn seconds(self) -> f64 {
        match self {
            Self::Second => 1.0,
            Self::Millisecond => 1e-3,
            Self::Microsecond => 1e-6,
            Self::Nanosecond => 1e-9,
        }
    }
}

/// Maximum frame rate of a recording, Hz; a greater one is an error.
const MAX_RATE: f64 = 1e6;

/// Checks that a frame rate (Hz) is positive and at most [`MAX_RATE`]; the error has what was found and expected.
pub(crate) fn checked_rate(rate: f64) -> Result<f64, (String, String)> {
    if rate > 0.0 && rate <= MAX_RATE {
        return Ok(rate);
    }
    let expected = format!("frames per second above 0, at most {MAX_RATE}");
    Err((format!("the rate {rate}"), expected))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_by_symbol_name_and_beginning_of_a_name() {
        let cases = [
            ("mm", LengthUnit::Millimetre),
            (" M ", LengthUnit::Metre),
            ("mete", LengthUnit::Metre),
            ("Millimeters", LengthUnit::Millimetre),
            ("centimetre", LengthUnit::Centimetre),
            ("inch", LengthUnit::Inch),
            ("Feet", LengthUnit::Foot),
        ];
        for (text, unit) in cases {
            assert_eq!(LengthUnit::parse(text), Some(unit), "{text}");
        }
        for text in ["", "me", "mmm", "deg", "milli metre", "furlong"] {
            assert_eq!(LengthUnit::parse(text), None, "{text}");
        }
        assert!(LengthUnit::is_whole_name("Meter") && !LengthUnit::is_whole_name("mete"));
        assert_eq!(
            LengthUnit::parse("ft").map(LengthUnit::metres),
            Some(0.3048)
        );
    }
}
