//! Folders of computations that are done in parts: a description of the computation, its finished parts, and the
//! results.
use std::fmt::{self, Display};
use std::path::{Path, PathBuf};
use std::{fs, io};

use flight::files::{UNFINISHED, write_atomic};
use lanes::Isa;
use serde_json::Value;
use sha2::{Digest, Sha256};

/// Name of the JSON file that identifies the computation in a folder by its fingerprint.
const BEGUN: &str = "parts.json";

/// Name of the file among the parts that is locked as long as somebody computes.
const LOCK: &str = ".lock";

/// Name of the JSON file with the summary of the results; it is written last.
const SUMMARY: &str = "summary.json";

/// Reason why a folder cannot be used for a computation that is done in parts.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FolderError {
    /// The folder holds parts or results of another computation, by its fingerprint.
    #[error(
        "{} holds parts or results of other inputs, another model or machine; expected a new or empty folder, or the same inputs to go on",
        .0.display()
    )]
    OtherWork(PathBuf),
    /// The folder holds other files.
    #[error("{} holds files that this command did not write; expected a new or empty folder", .0.display())]
    Foreign(PathBuf),
    /// A file or folder cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// Path of the file or folder.
        path: PathBuf,
        /// Error of the operating system.
        source: io::Error,
    },
    /// Another process or thread computes in the folder.
    #[error(
        "{} is in use: another run computes there, and loses nothing; expected its end, then the same command again, or another folder",
        .0.display()
    )]
    InUse(PathBuf),
    /// There is no share of this number.
    #[error("part {part} of {of}; expected one from 1 to {of}")]
    NoPart {
        /// Number of the share.
        part: u64,
        /// Number of shares.
        of: u64,
    },
}

/// SHA-256 (hexadecimal) of the text of `of` and of whether this machine fuses multiplications and additions.
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

/// Part numbers of the share number `share`, from 1, of `of` consecutive shares of `count` parts.
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

/// Folder of a computation in parts, each in a file of its own.
pub struct PartsFolder {
    path: PathBuf,
    fingerprint: String,
    /// Open as long as the computation runs.
    lock: Option<fs::File>,
}

impl PartsFolder {
    /// Opens a folder that is new, empty or holds parts of the same computation (equal `fingerprint`). In a new folder the
    /// description `begun` and the fingerprint are written to `parts.json`. Shares may be computed side by side; who joins
    /// them removes the parts, and must be alone.
    ///
    /// # Errors
    /// [`FolderError`] if the folder cannot be read or written, is in use, or holds another computation or other files.
    pub fn open(
        path: &Path,
        fingerprint: String,
        mut begun: Value,
        is_share: bool,
    ) -> Result<Self, FolderError> {
        let io = |source| FolderError::Io {
            path: path.to_path_buf(),
            source,
        };
        fs::create_dir_all(path).map_err(io)?;
        let mut folder = PartsFolder {
            path: path.to_path_buf(),
            fingerprint,
            lock: None,
        };
        let file = path.join(BEGUN);
        match fs::read_to_string(&file) {
            Ok(text) if folder.own(&text).is_some() => {}
            Ok(_) => return Err(FolderError::OtherWork(folder.path)),
            Err(e) if e.kind() == io::ErrorKind::NotFound => {
                let mut entries = fs::read_dir(path).map_err(io)?.flatten();
                // Another process may have begun the same computation in the meantime.
                if entries.any(|entry| !is_unfinished(&entry)) && !file.is_file() {
                    return Err(FolderError::Foreign(folder.path));
                }
                folder.write_json(BEGUN, &mut begun)?;
            }
            Err(e) => return Err(io(e)),
        }
        fs::create_dir_all(path.join("parts")).map_err(io)?;
        folder.lock(is_share)?;
        Ok(folder)
    }

    /// Locks the folder until this value is dropped; where the file system has no locks, it stays without.
    fn lock(&mut self, is_share: bool) -> Result<(), FolderError> {
        let path = self.path.join("parts").join(LOCK);
        let mut options = fs::OpenOptions::new();
        let options = options.create(true).truncate(false).write(true);
        let file = options
            .open(&path)
            .map_err(|source| FolderError::Io { path, source })?;
        let locked = match is_share {
            true => file.try_lock_shared(),
            false => file.try_lock(),
        };
        match locked {
            Err(fs::TryLockError::WouldBlock) => Err(FolderError::InUse(self.path.clone())),
            _ => {
                self.lock = Some(file);
                Ok(())
            }
        }
    }

    /// A JSON text of this computation, by its fingerprint.
    fn own(&self, text: &str) -> Option<Value> {
        let json: Value = serde_json::from_str(text).ok()?;
        (json["fingerprint"].as_str() == Some(&self.fingerprint)).then_some(json)
    }

    /// Path of the file of a part.
    pub fn part(&self, part: u64, extension: &str) -> PathBuf {
        self.path.join(format!("parts/{part:06}.{extension}"))
    }

    /// Path of a result file.
    pub fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Contents of `summary.json` if the computation is complete.
    pub fn summary(&self) -> Option<Value> {
        self.own(&fs::read_to_string(self.path.join(SUMMARY)).ok()?)
    }

    /// Writes `summary.json`, and adds the fingerprint to `json`; from then on the computation is complete.
    ///
    /// # Errors
    /// [`FolderError::Io`] if the file cannot be written.
    pub fn write_summary(&self, json: &mut Value) -> Result<(), FolderError> {
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

    fn write_json(&self, name: &str, json: &mut Value) -> Result<(), FolderError> {
        json["fingerprint"] = self.fingerprint.clone().into();
        self.write(&self.path.join(name), &format!("{json:#}\n"))
    }

    /// Removes the files of the parts, and temporary files of a killed process, as far as possible.
    pub fn discard_parts(&self) {
        let _ = fs::remove_dir_all(self.path.join("parts"));
        let entries = fs::read_dir(&self.path).into_iter().flatten().flatten();
        for entry in entries.filter(is_unfinished) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn is_unfinished(entry: &fs::DirEntry) -> bool {
    entry.file_name().to_string_lossy().starts_with(UNFINISHED)
}
