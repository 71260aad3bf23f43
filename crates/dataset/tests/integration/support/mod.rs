//! Datasets made for tests.

pub mod c3d;

use std::path::Path;

use dataset::{Dataset, load};

/// Valid text of `dataset.toml` for a dataset of one flight.
pub const MANIFEST: &str = r#"model = "ball"
[parameters]
m = 0.0027
[[markers]]
name = "centre"
position = [0.0, 0.0, 0.0]
[[flights]]
file = "a.csv"
role = "held-out"
known = { omega = [1.0, 2.0, 3.0] }
"#;

/// CSV table of the single flight of the dataset described by [`MANIFEST`]: time, s, and marker position, m.
pub const TABLE: &str = "t,centre_x,centre_y,centre_z\n0.0,1,2,3\n0.1,1.1,2,3\n";

/// Temporary folder that contains the given files (name, content).
pub fn folder(files: &[(&str, &[u8])]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, bytes) in files {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        std::fs::write(path, bytes).expect("written");
    }
    folder
}

/// Reads a dataset folder; error messages contain file names relative to this folder.
pub fn read(folder: &Path) -> Result<Dataset, String> {
    load(folder).map_err(|mut error| {
        if let Ok(file) = error.file.strip_prefix(folder)
            && file != Path::new("")
        {
            error.file = file.to_path_buf();
        }
        error.to_string()
    })
}

/// Reads a dataset of one flight from the contents of `dataset.toml` and of the flight's table.
pub fn read_both(manifest: &[u8], table: &[u8]) -> Result<Dataset, String> {
    read(folder(&[("dataset.toml", manifest), ("a.csv", table)]).path())
}
