//! Manifest of a folder of results: the files that a run wrote, with hashes of their contents.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use model_spec::fingerprint;

use super::ResultFile;

/// Name of the manifest file in a folder of results, which lists the files that hyzer wrote.
pub const MANIFEST: &str = ".hyzer-results";

/// First line of a manifest (list of the files that hyzer wrote to a folder): a comment for the user.
const HEAD: &str =
    "# Files that hyzer wrote here, and replaces. Other files in this folder are kept.";

/// List of the files that a run of hyzer wrote to a results folder: path relative to the folder, and hash of the
/// contents.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Manifest {
    files: BTreeMap<String, u64>,
}

impl Manifest {
    pub fn of(files: &[ResultFile]) -> Manifest {
        let each = files
            .iter()
            .map(|file| (file.path.clone(), fingerprint(&file.contents)));
        Manifest {
            files: each.collect(),
        }
    }

    /// Reads the manifest (list of the files that hyzer wrote) of a folder; empty if it cannot be read. Malformed
    /// lines are ignored, as are paths that lead out of the folder.
    pub fn read(folder: &Path) -> Manifest {
        let text = std::fs::read_to_string(folder.join(MANIFEST)).unwrap_or_default();
        let lines = text.lines().filter_map(|line| {
            let (hex, path) = line.split_once("  ")?;
            let is_inside = Path::new(path)
                .components()
                .all(|part| matches!(part, std::path::Component::Normal(_)));
            let fingerprint = u64::from_str_radix(hex, 16).ok()?;
            is_inside.then(|| (path.to_owned(), fingerprint))
        });
        Manifest {
            files: lines.collect(),
        }
    }

    pub fn text(&self) -> String {
        let mut text = format!("{HEAD}\n");
        for (path, fingerprint) in &self.files {
            let _ = writeln!(text, "{fingerprint:016x}  {path}");
        }
        text
    }

    /// Relative paths of the files that the manifest lists, sorted.
    pub fn paths(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str)
    }

    /// Whether the file at the relative `path` in `folder` still has the contents that hyzer wrote, according to
    /// the hash in this manifest.
    pub fn wrote(&self, folder: &Path, path: &str) -> bool {
        let contents = || std::fs::read(folder.join(path)).ok();
        self.files
            .get(path)
            .is_some_and(|known| contents().is_some_and(|found| fingerprint(&found) == *known))
    }
}
