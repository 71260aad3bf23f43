//! Tables of flights, and files that are written whole or not at all.

use ode::Trajectory;
use std::io::{self, Write};
use std::path::Path;

/// `trajectory.csv`: a header `t` and the states' names, the states at an even rate (1/s) from the start,
/// and the end. Numbers are SI, in as many digits as give them back.
///
/// # Panics
/// Where there are not as many names as states, or the rate is not positive.
pub fn trajectory_csv(flight: &Trajectory, names: &[impl AsRef<str>], rate: f64) -> String {
    assert_eq!(names.len(), flight.states(), "a name for each state");
    let mut text = String::from("t");
    for name in names {
        text.push(',');
        text.push_str(name.as_ref());
    }
    text.push('\n');
    for (t, state) in flight.at_rate(rate) {
        text.push_str(&number(t));
        for value in state {
            text.push(',');
            text.push_str(&number(value));
        }
        text.push('\n');
    }
    text
}

/// The shortest text that reads as the same number.
fn number(value: f64) -> String {
    // Debug, since Display writes 1e-300 in three hundred digits.
    format!("{value:?}")
}

/// Writes a file whole: to a file beside it first, which then takes its name, so that an interrupted run
/// leaves either what was there or what is new.
pub fn write_atomic(path: &Path, contents: impl AsRef<[u8]>) -> io::Result<()> {
    let name = path
        .file_name()
        .ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "no file name"))?;
    let beside = path.with_file_name(format!(
        ".{}.{}.part",
        name.to_string_lossy(),
        std::process::id()
    ));
    let written = std::fs::File::create(&beside).and_then(|mut file| {
        file.write_all(contents.as_ref())?;
        file.sync_all()?;
        std::fs::rename(&beside, path)
    });
    if written.is_err() {
        // The first error is the one to report.
        let _ = std::fs::remove_file(&beside);
    }
    written
}
