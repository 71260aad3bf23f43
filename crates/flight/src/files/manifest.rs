//! Manifest of a folder of results: the files that a run wrote, with hashes of their contents.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use model_spec::fingerprint;

use super::ResultFile;

/// Name of the manifest file in a folder of results, which lists the files that hyzer wrote.
pub const MANIFEST: &str = ".hyzer-results";

/// First line of a manifest: a comment for the user.
const HEAD: &str = "# Files that hyzer wrote here. The next run replaces them, if there is no other file and none was edited.";

/// Files that hyzer wrote to a results folder: relative path and hashes, several only while replaced in place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Manifest {
    files: BTreeMap<String, Vec<u64>>,
}

impl Manifest {
    pub fn of(files: &[ResultFile]) -> Manifest {
        let each = files.iter();
        let each = each.map(|file| (file.path.clone(), vec![fingerprint(&file.contents)]));
        Manifest {
            files: each.collect(),
        }
    }

    /// Reads the manifest of a folder; empty if unreadable. Malformed lines and paths out of the folder are ignored.
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
        let mut manifest = Manifest::default();
        for (path, fingerprint) in lines {
            manifest.files.entry(path).or_default().push(fingerprint);
        }
        manifest
    }

    pub fn text(&self) -> String {
        let mut text = format!("{HEAD}\n");
        for (path, fingerprints) in &self.files {
            for fingerprint in fingerprints {
                let _ = writeln!(text, "{fingerprint:016x}  {path}");
            }
        }
        text
    }

    /// The files of both manifests; of a file in both, either content is known.
    pub fn and(mut self, other: &Manifest) -> Manifest {
        for (path, prints) in &other.files {
            self.files.entry(path.clone()).or_default().extend(prints);
        }
        self
    }

    /// Relative paths of the files that the manifest lists, sorted.
    pub fn paths(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str)
    }

    /// Whether the file at the relative `path` still has the contents that hyzer wrote, by its hash.
    pub fn wrote(&self, folder: &Path, path: &str) -> bool {
        let contents = || std::fs::read(folder.join(path)).ok();
        self.files.get(path).is_some_and(|known| {
            contents().is_some_and(|found| known.contains(&fingerprint(&found)))
        })
    }
}
