//! Times of day as text, such as `12:31:05.250`.

/// Length of a day, s.
const DAY: f64 = 86_400.0;

/// Seconds since midnight of a text in hours, minutes and seconds; `None` for another text.
pub(crate) fn seconds(text: &str) -> Option<f64> {
    let mut parts = text.splitn(3, ':');
    let mut whole = |most: u32| {
        let digits = parts.next()?;
        let is_number =
            (1..=2).contains(&digits.len()) && digits.bytes().all(|b| b.is_ascii_digit());
        let value: u32 = digits.parse().ok()?;
        (is_number && value < most).then_some(f64::from(value))
    };
    let (hours, minutes) = (whole(24)?, whole(60)?);
    let seconds = parts.next()?.replace(',', ".");
    let is_decimal = seconds.bytes().all(|b| b.is_ascii_digit() || b == b'.');
    let seconds: f64 = seconds
        .parse()
        .ok()
        .filter(|own| is_decimal && *own < 60.0)?;
    Some(3600.0 * hours + 60.0 * minutes + seconds)
}

/// The time of day `time`, s, that follows `before`, perhaps after midnight: seconds since the first midnight.
pub(crate) fn after(time: f64, before: Option<f64>) -> f64 {
    let days = before.map_or(0.0, |before| ((before - time) / DAY).round());
    time + DAY * days
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hours_minutes_and_seconds_are_read_and_days_counted() {
        assert_eq!(seconds("12:31:05.250"), Some(45_065.25));
        assert_eq!(seconds("0:00:01,5"), Some(1.5));
        for text in [
            "12:31",
            "25:00:00",
            "12:60:00",
            "12:31:60",
            "12:31:-1",
            "a:b:c",
            "1.5",
            "12:31:1e1",
        ] {
            assert_eq!(seconds(text), None, "{text}");
        }
        assert_eq!(after(0.5, Some(86_399.5)), 86_400.5);
        assert_eq!(after(10.0, Some(9.0)), 10.0);
        assert_eq!(after(10.0, None), 10.0);
    }
}
