//! Trajectory table in CSV.

use ode::Trajectory;

/// Trajectory as CSV: a header (`t` and the names of the states) and a row per sample, at `rate` samples per second from
/// the start, and at the end. SI units; numbers have as many digits as needed to read them back exactly.
///
/// # Panics
/// Where the number of names is not that of the states, or the rate is not positive.
pub fn trajectory_csv(trajectory: &Trajectory, names: &[impl AsRef<str>], rate: f64) -> String {
    assert_eq!(names.len(), trajectory.states(), "one name per state");
    let mut text = String::from("t");
    for name in names {
        text.push(',');
        text.push_str(name.as_ref());
    }
    text.push('\n');
    for (t, state) in trajectory.at_rate(rate) {
        text.push_str(&number(t));
        for value in state {
            text.push(',');
            text.push_str(&number(value));
        }
        text.push('\n');
    }
    text
}

/// Shortest text that reads back as the same number.
fn number(value: f64) -> String {
    // Debug formatting, since Display writes 1e-300 with three hundred digits.
    format!("{value:?}")
}
