//! Folders of work that is done in parts: what was begun, the parts that are whole, and the results.

use std::fmt::{self, Display};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use lanes::Isa;
use serde_json::Value;
use sha2::{Digest, Sha256};

use crate::atomic::{Durability, UNFINISHED, write_atomic};

/// File that says which work the parts belong to.
const BEGUN: &str = "parts.json";

/// File whose presence says that the work is complete.
const SUMMARY: &str = "summary.json";

/// Reason why a folder cannot hold parts of some work.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FolderError {
    /// The folder holds other work.
    #[error(
        "{} holds parts or results of other inputs, another model or machine; expected a new or empty folder, or the same inputs to go on",
        path.display()
    )]
    OtherWork {
        /// The folder.
        path: PathBuf,
    },
    /// The folder holds other files.
    #[error("{} holds files that this command did not write; expected a new or empty folder", path.display())]
    Foreign {
        /// The folder.
        path: PathBuf,
    },
    /// A file or folder cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// Its cause.
        source: io::Error,
    },
    /// A part out of range.
    #[error("part {part} of {of}; expected one from 1 to {of}")]
    NoPart {
        /// Number that was found.
        part: u64,
        /// Number of parts.
        of: u64,
    },
}

/// SHA-256 (hexadecimal) of a text, which is not held, and of whether this machine fuses multiplications and additions, on
/// which the last bits of results depend.
pub fn fingerprint(of: impl Display) -> String {
    struct Hasher(Sha256);
    impl fmt::Write for Hasher {
        fn write_str(&mut self, text: &str) -> fmt::Result {
            self.0.update(text.as_bytes());
            Ok(())
        }
    }
    let mut hasher = Hasher(Sha256::new());
    // The hasher has no errors.
    let _ = fmt::write(&mut hasher, format_args!("{} {of}", Isa::best().fuses()));
    let digest = hasher.0.finalize();
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Range of the parts 0 to `count` - 1 that belong to share `share` (counted from 1) of `of` equal shares.
///
/// # Errors
/// [`FolderError::NoPart`].
pub fn share_of(count: u64, (share, of): (u64, u64)) -> Result<std::ops::Range<u64>, FolderError> {
    if !(1..=of).contains(&share) {
        return Err(FolderError::NoPart { part: share, of });
    }
    let bound = |k: u64| (u128::from(count) * u128::from(k) / u128::from(of)) as u64;
    Ok(bound(share - 1)..bound(share))
}

/// Folder of the parts and results of one piece of work.
pub struct PartsFolder {
    path: PathBuf,
    fingerprint: String,
}

impl PartsFolder {
    /// Opens a new or empty folder, or that of the same work; `begun` describes it for readers, with its fingerprint.
    ///
    /// # Errors
    /// [`FolderError`].
    pub fn open(path: &Path, fingerprint: String, mut begun: Value) -> Result<Self, FolderError> {
        let at = |source| FolderError::Io {
            path: path.to_path_buf(),
            source,
        };
        fs::create_dir_all(path).map_err(at)?;
        let folder = PartsFolder {
            path: path.to_path_buf(),
            fingerprint,
        };
        let file = path.join(BEGUN);
        match fs::read_to_string(&file) {
            Ok(text) => {
                let json: Value = serde_json::from_str(&text).unwrap_or(Value::Null);
                if json["fingerprint"].as_str() != Some(&folder.fingerprint) {
                    return Err(FolderError::OtherWork {
                        path: path.to_path_buf(),
                    });
                }
            }
            Err(e) if e.kind() == io::ErrorKind::NotFound => {
                let mut entries = fs::read_dir(path).map_err(at)?;
                let is_foreign = |entry: io::Result<fs::DirEntry>| {
                    entry.is_ok_and(|e| !e.file_name().to_string_lossy().starts_with(UNFINISHED))
                };
                // Another process may begin the same work at the same time.
                if entries.any(is_foreign) && !file.is_file() {
                    return Err(FolderError::Foreign {
                        path: path.to_path_buf(),
                    });
                }
                begun["fingerprint"] = folder.fingerprint.clone().into();
                folder.write_json(BEGUN, &begun)?;
            }
            Err(e) => return Err(at(e)),
        }
        fs::create_dir_all(path.join("parts")).map_err(at)?;
        Ok(folder)
    }

    /// File of a part, with this extension.
    pub fn part(&self, part: u64, extension: &str) -> PathBuf {
        self.path
            .join("parts")
            .join(format!("{part:06}.{extension}"))
    }

    /// A file of the results.
    pub fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// The summary, if the work is complete.
    pub fn summary(&self) -> Option<Value> {
        let text = fs::read_to_string(self.path.join(SUMMARY)).ok()?;
        let json: Value = serde_json::from_str(&text).ok()?;
        (json["fingerprint"].as_str() == Some(&self.fingerprint)).then_some(json)
    }

    /// Writes the summary with the fingerprint: the work is complete then.
    ///
    /// # Errors
    /// [`FolderError::Io`].
    pub fn write_summary(&self, json: &mut Value) -> Result<(), FolderError> {
        json["fingerprint"] = self.fingerprint.clone().into();
        self.write_json(SUMMARY, json)
    }

    /// Writes a text to a file that appears whole.
    ///
    /// # Errors
    /// [`FolderError::Io`].
    pub fn write(&self, path: &Path, text: &str) -> Result<(), FolderError> {
        let write = |file: &mut fs::File| file.write_all(text.as_bytes());
        write_atomic(path, Durability::Synced, write).map_err(|source| FolderError::Io {
            path: path.to_path_buf(),
            source,
        })
    }

    fn write_json(&self, name: &str, json: &Value) -> Result<(), FolderError> {
        self.write(&self.path.join(name), &format!("{json:#}\n"))
    }

    /// Removes the parts, which the results replace, and what a kill left unfinished.
    pub fn discard_parts(&self) {
        // What remains is removed by the next run.
        let _ = fs::remove_dir_all(self.path.join("parts"));
        for entry in fs::read_dir(&self.path).into_iter().flatten().flatten() {
            if entry.file_name().to_string_lossy().starts_with(UNFINISHED) {
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}
