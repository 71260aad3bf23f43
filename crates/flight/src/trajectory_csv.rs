//! Formatting of trajectories as CSV tables.

use ode::Trajectory;

/// Formats a trajectory as CSV: a header (`t` and the states), then `rate` rows per second from the start, and one at
/// the end; in SI units, with the fewest digits that read back exactly.
///
/// # Panics
/// If the number of `names` is not the number of states, or `rate` is not positive.
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

/// Shortest text that reads back as exactly the given number.
fn number(value: f64) -> String {
    // Debug formatting, since Display writes 1e-300 with three hundred digits.
    format!("{value:?}")
}
