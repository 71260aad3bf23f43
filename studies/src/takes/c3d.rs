//! Writes takes as C3D with ezc3d, in the user's Python.

use std::path::Path;
use std::process::Command;

use crate::error::StudyError;

/// Python script that converts tables of marker positions in Vicon's text format to C3D.
const SCRIPT: &str = include_str!("../../../benches/takes/write_c3d.py");

/// Converts tables of marker positions in Vicon's text format to C3D files, and returns the contents of the files.
///
/// # Errors
/// [`StudyError::Absent`] if the script fails in Python, [`StudyError::Unreadable`] if Python cannot be started or a
/// file cannot be written or read.
pub(super) fn written(
    python: &Path,
    seed: u64,
    tables: &[String],
) -> Result<Vec<Vec<u8>>, StudyError> {
    let folder = std::env::temp_dir().join(format!("hyzer-takes-{}-{seed}", std::process::id()));
    let made = in_folder(python, &folder, tables);
    // An error of the conversion matters more than one of the removal.
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
