//! Numbers from outside: a table cell as a number.

/// Words of other programs for a missing value, besides NaN; in any case.
const MISSING: [&str; 4] = ["NA", "N/A", "#N/A", "null"];

/// Parses a cell as a finite number, or `None` if a word or nothing stands for it; the error is what was expected.
pub fn number(cell: &str) -> Result<Option<f64>, &'static str> {
    const EXPECTED: &str = "a finite number, or nothing for a dropout";
    if cell.is_empty() {
        return Ok(None);
    }
    let is_missing = |word: &&str| word.eq_ignore_ascii_case(cell);
    match cell.parse::<f64>() {
        Ok(value) if value.is_nan() => Ok(None),
        Ok(value) if value.is_finite() => Ok(Some(value)),
        Ok(_) => Err(EXPECTED),
        Err(_) if MISSING.iter().any(is_missing) => Ok(None),
        Err(_) => Err(hint(cell).unwrap_or(EXPECTED)),
    }
}

/// Hint for a common notation of numbers that is not accepted (decimal comma, hexadecimal, Unicode minus sign).
fn hint(cell: &str) -> Option<&'static str> {
    let reads = |text: &str| text.parse::<f64>().is_ok_and(f64::is_finite);
    let unsigned = cell.trim_start_matches(['-', '+']);
    if cell.matches(',').count() == 1 && reads(&cell.replace(',', ".")) {
        Some("a decimal point, as in 1.5, not a comma")
    } else if unsigned.starts_with("0x") || unsigned.starts_with("0X") {
        Some("a decimal number, not a hexadecimal one")
    } else if reads(&cell.replace('\u{2212}', "-")) {
        Some("the minus sign of the keyboard, -")
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_dropouts() {
        assert_eq!(number("-1.5e-3"), Ok(Some(-1.5e-3)));
        assert_eq!(number(".5"), Ok(Some(0.5)));
        assert_eq!(number(""), Ok(None));
        for missing in ["NaN", "nan", "NA", "n/a", "NULL"] {
            assert_eq!(number(missing), Ok(None), "{missing}");
        }
        for bad in [
            "inf",
            "-Infinity",
            "1e999",
            "one",
            "1 5",
            "0x1p3",
            "NAN1",
            "-",
            ".",
        ] {
            assert!(number(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn foreign_notations_have_a_hint() {
        let told = |cell| number(cell).expect_err(cell);
        assert!(told("1,5").contains("not a comma"));
        assert!(told("0x1F").contains("hexadecimal"));
        assert!(told("\u{2212}1.5").contains("minus"));
    }
}
