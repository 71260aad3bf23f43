//! Unit symbols of model files, with their conversion factors to SI units.

use super::Unit;

/// SI unit and conversion factor of a unit symbol.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symbol {
    /// SI unit of the same dimension as the symbol.
    pub unit: Unit,
    /// Conversion factor: SI value of one unit of the symbol, such as 0.001 for `mm`.
    pub factor: f64,
    /// `factor` as an exact fraction (numerator, denominator), such as (1, 1000) for `mm`; `None` if it contains π.
    pub exact: Option<(i128, i128)>,
}

/// Unit symbols without prefixes: symbol, SI unit, rational conversion factor, and whether π multiplies that factor.
const TABLE: [(&str, Unit, (i128, i128), bool); 34] = [
    ("m", Unit::METRE, (1, 1), false),
    ("g", Unit::KILOGRAM, (1, 1000), false),
    ("s", Unit::SECOND, (1, 1), false),
    ("A", Unit::of([0, 0, 0, 1, 0, 0, 0, 0]), (1, 1), false),
    ("K", Unit::of([0, 0, 0, 0, 1, 0, 0, 0]), (1, 1), false),
    ("mol", Unit::of([0, 0, 0, 0, 0, 1, 0, 0]), (1, 1), false),
    ("cd", Unit::of([0, 0, 0, 0, 0, 0, 1, 0]), (1, 1), false),
    ("rad", Unit::RADIAN, (1, 1), false),
    ("N", Unit::NEWTON, (1, 1), false),
    ("J", Unit::NEWTON_METRE, (1, 1), false),
    ("W", Unit::of([2, 1, -3, 0, 0, 0, 0, 0]), (1, 1), false),
    ("Pa", Unit::of([-1, 1, -2, 0, 0, 0, 0, 0]), (1, 1), false),
    ("Hz", Unit::of([0, 0, -1, 0, 0, 0, 0, 0]), (1, 1), false),
    (
        "bar",
        Unit::of([-1, 1, -2, 0, 0, 0, 0, 0]),
        (100_000, 1),
        false,
    ),
    ("V", Unit::of([2, 1, -3, -1, 0, 0, 0, 0]), (1, 1), false),
    ("C", Unit::of([0, 0, 1, 1, 0, 0, 0, 0]), (1, 1), false),
    ("T", Unit::of([0, 1, -2, -1, 0, 0, 0, 0]), (1, 1), false),
    ("L", Unit::of([3, 0, 0, 0, 0, 0, 0, 0]), (1, 1000), false),
    ("t", Unit::KILOGRAM, (1000, 1), false),
    ("min", Unit::SECOND, (60, 1), false),
    ("h", Unit::SECOND, (3600, 1), false),
    ("deg", Unit::RADIAN, (1, 180), true),
    ("°", Unit::RADIAN, (1, 180), true),
    ("rev", Unit::RADIAN, (2, 1), true),
    ("rpm", Unit::RATE, (2, 60), true),
    ("ft", Unit::METRE, (3048, 10_000), false),
    ("mi", Unit::METRE, (1_609_344, 1000), false),
    ("lb", Unit::KILOGRAM, (45_359_237, 100_000_000), false),
    ("oz", Unit::KILOGRAM, (45_359_237, 1_600_000_000), false),
    ("mph", Unit::SPEED, (44_704, 100_000), false),
    ("in", Unit::METRE, (254, 10_000), false),
    ("yd", Unit::METRE, (9144, 10_000), false),
    ("kn", Unit::SPEED, (1852, 3600), false),
    (
        "lbf",
        Unit::NEWTON,
        (44_482_216_152_605, 10_000_000_000_000),
        false,
    ),
];

/// Number of leading entries of [`TABLE`] that accept an SI prefix.
const PREFIXED: usize = 19;

/// SI prefixes, each with its power of ten, such as 3 for `k`.
const PREFIXES: [(&str, i32); 12] = [
    ("k", 3),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("M", 6),
    ("G", 9),
    ("µ", -6),
    ("μ", -6),
    ("u", -6),
    ("n", -9),
    ("da", 1),
];

/// SI unit and factor of a unit symbol, with or without a prefix; `None` if the symbol is unknown.
pub fn find(name: &str) -> Option<Symbol> {
    if let Some(&(_, unit, fraction, pi)) = TABLE.iter().find(|(symbol, ..)| *symbol == name) {
        return Some(symbol(unit, fraction, pi));
    }
    PREFIXES.iter().find_map(|&(prefix, ten)| {
        let rest = name.strip_prefix(prefix)?;
        let &(_, unit, (above, below), pi) = TABLE[..PREFIXED]
            .iter()
            .find(|(symbol, ..)| *symbol == rest)?;
        let power = 10_i128.pow(ten.unsigned_abs());
        let fraction = if ten > 0 {
            (above * power, below)
        } else {
            (above, below * power)
        };
        Some(symbol(unit, fraction, pi))
    })
}

/// Text that lists all symbols: those that accept a prefix, then the others.
pub fn listed() -> String {
    let symbols = TABLE.map(|(symbol, ..)| symbol);
    let (prefixed, others) = symbols.split_at(PREFIXED);
    format!(
        "{} with prefixes, and {}",
        prefixed.join(", "),
        others.join(", ")
    )
}

fn symbol(unit: Unit, (above, below): (i128, i128), pi: bool) -> Symbol {
    let scale = if pi { std::f64::consts::PI } else { 1.0 };
    Symbol {
        unit,
        factor: above as f64 * scale / below as f64,
        exact: (!pi).then_some((above, below)),
    }
}

/// Suggests a symbol for a name (`meter`) or a wrong letter case (`KG`).
pub fn suggest(name: &str) -> Option<&'static str> {
    const WORDS: [(&str, &str); 37] = [
        ("meter", "m"),
        ("metre", "m"),
        ("mtr", "m"),
        ("second", "s"),
        ("sec", "s"),
        ("minute", "min"),
        ("hour", "h"),
        ("hr", "h"),
        ("gram", "g"),
        ("gramme", "g"),
        ("kilogram", "kg"),
        ("kilo", "kg"),
        ("kgs", "kg"),
        ("newton", "N"),
        ("joule", "J"),
        ("watt", "W"),
        ("pascal", "Pa"),
        ("hertz", "Hz"),
        ("radian", "rad"),
        ("degree", "deg"),
        ("revolution", "rev"),
        ("turn", "rev"),
        ("rp", "rpm"),
        ("kph", "km/h"),
        ("kmh", "km/h"),
        ("nm", "N*m"),
        ("nms", "N*m*s"),
        ("foot", "ft"),
        ("feet", "ft"),
        ("pound", "lb"),
        ("mp", "mph"),
        ("kelvin", "K"),
        ("inch", "in"),
        ("inche", "in"),
        ("yard", "yd"),
        ("knot", "kn"),
        ("kt", "kn"),
    ];
    let lower = name.to_lowercase();
    let singular = lower.strip_suffix('s').unwrap_or(&lower);
    if let Some((_, symbol)) = WORDS
        .iter()
        .find(|(word, _)| *word == lower || *word == singular)
    {
        return Some(symbol);
    }
    const COMMON: [&str; 14] = [
        "kg", "m", "s", "rad", "N", "J", "W", "Pa", "Hz", "deg", "rev", "rpm", "mm", "cm",
    ];
    COMMON
        .into_iter()
        .find(|symbol| symbol.to_lowercase() == lower)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_and_names_are_found() {
        for (name, factor, unit) in [
            ("kg", 1.0, Unit::KILOGRAM),
            ("g", 0.001, Unit::KILOGRAM),
            ("mm", 0.001, Unit::METRE),
            ("min", 60.0, Unit::SECOND),
            ("µm", 1e-6, Unit::METRE),
            ("kN", 1000.0, Unit::NEWTON),
            ("deg", std::f64::consts::PI / 180.0, Unit::RADIAN),
            ("in", 0.0254, Unit::METRE),
            ("kn", 1852.0 / 3600.0, Unit::SPEED),
            // 0.45359237 kg under the standard gravity of 9.80665 m/s².
            ("lbf", 4.448_221_615_260_5, Unit::NEWTON),
            ("rpm", 2.0 * std::f64::consts::PI / 60.0, Unit::RATE),
        ] {
            let found = find(name).unwrap();
            assert_eq!((found.factor, found.unit), (factor, unit), "{name}");
        }
        assert_eq!(find("kdeg"), None);
        assert_eq!(find("furlong"), None);
    }

    #[test]
    fn words_lead_to_symbols() {
        assert_eq!(suggest("meters"), Some("m"));
        assert_eq!(suggest("KG"), Some("kg"));
        assert_eq!(suggest("Degrees"), Some("deg"));
        assert_eq!(suggest("furlong"), None);
    }

    #[test]
    fn no_prefixed_symbol_hides_a_plain_one() {
        // `min`, `mol`, `cd` and `ft` must win over milli-inch, milli-ol, centi-d and femto-tonne.
        for (name, ..) in TABLE {
            assert_eq!(
                find(name).unwrap().unit,
                TABLE.iter().find(|t| t.0 == name).unwrap().1
            );
        }
    }
}
