//! Folders of computations that are done in parts: a description of the computation, its finished parts, and the
//! results.

use std::fmt::{self, Display};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use lanes::Isa;
use serde_json::Value;
use sha2::{Digest, Sha256};

use flight::files::{UNFINISHED, write_atomic};

/// Name of the JSON file that identifies the computation to which the parts in a folder belong, by a fingerprint (hash
/// of all inputs).
const BEGUN: &str = "parts.json";

/// Name of the JSON file with the summary of the results; it is written last, so its presence means that the
/// computation is complete.
const SUMMARY: &str = "summary.json";

/// Reason why a folder cannot be used for a computation that is done in parts.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FolderError {
    /// The folder holds parts or results of another computation: the fingerprint in the folder (a hash of all inputs)
    /// differs from that of this computation.
    #[error(
        "{} holds parts or results of other inputs, another model or machine; expected a new or empty folder, or the same inputs to go on",
        path.display()
    )]
    OtherWork {
        /// Path of the folder that holds another computation.
        path: PathBuf,
    },
    /// The folder is not empty, and its files are not those of a computation in parts.
    #[error("{} holds files that this command did not write; expected a new or empty folder", path.display())]
    Foreign {
        /// Path of the folder that holds unrelated files.
        path: PathBuf,
    },
    /// A file or folder cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// Path of the file or folder that cannot be read or written.
        path: PathBuf,
        /// Error that the operating system reported for this file or folder.
        source: io::Error,
    },
    /// The parts are divided into `of` shares for separate processes, and the requested share number `part` is not in
    /// 1 to `of`.
    #[error("part {part} of {of}; expected one from 1 to {of}")]
    NoPart {
        /// Share number that was requested.
        part: u64,
        /// Number of shares into which the parts are divided.
        of: u64,
    },
}

/// SHA-256 (hexadecimal) of the displayed text of `of` and of whether this machine fuses multiplications and
/// additions, on which the last bits of results depend. The text is hashed as it is formatted, without being stored.
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

/// Divides the part numbers 0 to `count` - 1 into `of` consecutive ranges (shares) of nearly equal size and returns
/// share number `share`, counted from 1.
///
/// # Errors
/// [`FolderError::NoPart`] if `share` is not in 1 to `of`.
pub fn share_of(count: u64, (share, of): (u64, u64)) -> Result<std::ops::Range<u64>, FolderError> {
    if !(1..=of).contains(&share) {
        return Err(FolderError::NoPart { part: share, of });
    }
    let bound = |k: u64| (u128::from(count) * u128::from(k) / u128::from(of)) as u64;
    Ok(bound(share - 1)..bound(share))
}

/// Folder of a computation that is divided into parts, each stored in its own file; holds the parts and the results.
pub struct PartsFolder {
    path: PathBuf,
    fingerprint: String,
}

impl PartsFolder {
    /// Opens a folder that is new, empty or holds parts of the same computation (equal `fingerprint`). In a new
    /// folder the description `begun` is written to `parts.json`, with the fingerprint added.
    ///
    /// # Errors
    /// [`FolderError`] if the folder cannot be read or written, or holds another computation or other files.
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
                // Another process may have begun the same computation in the meantime.
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

    /// Path of the file of part number `part`, with the given extension.
    pub fn part(&self, part: u64, extension: &str) -> PathBuf {
        self.path
            .join("parts")
            .join(format!("{part:06}.{extension}"))
    }

    /// Path of the result file `name` in the folder.
    pub fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Contents of `summary.json` if the computation is complete; `None` if it is not, or if the file belongs to
    /// another computation.
    pub fn summary(&self) -> Option<Value> {
        let text = fs::read_to_string(self.path.join(SUMMARY)).ok()?;
        let json: Value = serde_json::from_str(&text).ok()?;
        (json["fingerprint"].as_str() == Some(&self.fingerprint)).then_some(json)
    }

    /// Writes `summary.json` with the fingerprint added to `json`; from then on the computation counts as complete.
    ///
    /// # Errors
    /// [`FolderError::Io`] if the file cannot be written.
    pub fn write_summary(&self, json: &mut Value) -> Result<(), FolderError> {
        json["fingerprint"] = self.fingerprint.clone().into();
        self.write_json(SUMMARY, json)
    }

    /// Writes a text file atomically and syncs it to the disk.
    ///
    /// # Errors
    /// [`FolderError::Io`] if the file cannot be written.
    pub fn write(&self, path: &Path, text: &str) -> Result<(), FolderError> {
        write_atomic(path, text).map_err(|source| FolderError::Io {
            path: path.to_path_buf(),
            source,
        })
    }

    fn write_json(&self, name: &str, json: &Value) -> Result<(), FolderError> {
        self.write(&self.path.join(name), &format!("{json:#}\n"))
    }

    /// Removes the files of the parts of the computation, which are no longer needed once the results are written, and
    /// temporary files left by a killed process. Errors are ignored.
    pub fn discard_parts(&self) {
        // Files that could not be removed are removed by the next run.
        let _ = fs::remove_dir_all(self.path.join("parts"));
        for entry in fs::read_dir(&self.path).into_iter().flatten().flatten() {
            if entry.file_name().to_string_lossy().starts_with(UNFINISHED) {
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}
