//! Takes as C3D, written by ezc3d in a Python of the user's.

use std::path::Path;
use std::process::Command;

use crate::error::StudyError;

/// The script that turns tables of Vicon into C3D.
const SCRIPT: &str = include_str!("../../../../benches/takes/write_c3d.py");

/// Turns tables of Vicon into C3D files.
///
/// # Errors
/// [`StudyError::Absent`] where Python or ezc3d fails, [`StudyError::Unreadable`] where a file does.
pub(super) fn written(
    python: &Path,
    seed: u64,
    tables: &[String],
) -> Result<Vec<Vec<u8>>, StudyError> {
    let folder = std::env::temp_dir().join(format!("hyzer-takes-{}-{seed}", std::process::id()));
    let made = in_folder(python, &folder, tables);
    // What went wrong first is what counts.
    let _ = std::fs::remove_dir_all(&folder);
    made
}

fn in_folder(python: &Path, folder: &Path, tables: &[String]) -> Result<Vec<Vec<u8>>, StudyError> {
    let failed = |file: &Path| {
        let file = file.to_path_buf();
        move |source| StudyError::Unreadable { file, source }
    };
    std::fs::create_dir_all(folder).map_err(failed(folder))?;
    let script = folder.join("write_c3d.py");
    std::fs::write(&script, SCRIPT).map_err(failed(&script))?;
    let mut command = Command::new(python);
    command.arg(&script);
    let mut files = Vec::new();
    for (k, table) in tables.iter().enumerate() {
        let file = folder.join(format!("take{k}.csv"));
        std::fs::write(&file, table).map_err(failed(&file))?;
        files.push(file.with_extension("c3d"));
        command.arg(file);
    }
    let output = command.output().map_err(failed(python))?;
    if !output.status.success() {
        let told = String::from_utf8_lossy(&output.stderr);
        return Err(StudyError::Absent {
            file: python.to_path_buf(),
            expected: format!("ezc3d that writes a file: {}", told.trim()),
        });
    }
    let each = files.iter();
    each.map(|file| std::fs::read(file).map_err(failed(file)))
        .collect()
}
