//! A folder of results that is replaced as a whole: at any moment it holds the earlier results or the new ones.
//!
//! The files are written to a hidden folder beside the target, which then changes places with it. A manifest in the
//! folder lists what was written, so that a later run removes it again. Other files in the folder, and results that
//! were edited, stay.

mod exchange;
mod keep;
mod manifest;

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::write_atomic;
use exchange::exchange;
use keep::{discard, keep_foreign};
pub use manifest::MANIFEST;
use manifest::Manifest;

/// Maximum number of foreign files that a message names.
const MAX_NAMED: usize = 3;

/// A file of results: path relative to the folder, with `/` between names, and contents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ResultFile {
    /// Path relative to the folder.
    pub path: String,
    /// Contents of the file.
    pub contents: Vec<u8>,
}

impl ResultFile {
    /// A file with this relative path and these contents.
    pub fn new(path: impl Into<String>, contents: impl Into<Vec<u8>>) -> ResultFile {
        ResultFile {
            path: path.into(),
            contents: contents.into(),
        }
    }
}

/// Why a folder cannot take results.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ResultFolderError {
    /// A file has the path of the folder, or of a folder that would contain it.
    #[error("{} is a file, expected a folder", path.display())]
    IsFile {
        /// Path of the file.
        path: PathBuf,
    },
    /// The folder holds files, none of them results.
    #[error(
        "{} holds files that hyzer did not write ({}); expected a new or empty folder, or one of earlier results",
        path.display(), names.join(", ")
    )]
    Foreign {
        /// Path of the folder.
        path: PathBuf,
        /// Names of some of the files.
        names: Vec<String>,
    },
    /// The path ends in no name of a folder, such as `x/..`.
    #[error("{} is no name of a folder", path.display())]
    NoName {
        /// Path that was given.
        path: PathBuf,
    },
    /// A file or folder cannot be read or written.
    #[error("{} cannot be written: {source}", path.display())]
    Io {
        /// Path of the folder.
        path: PathBuf,
        /// Error of the operating system.
        source: io::Error,
    },
}

/// A folder that can take results; nothing in it changes before [`ResultFolder::replace`].
#[derive(Clone, Debug)]
pub struct ResultFolder {
    /// The folder, with symbolic links resolved.
    target: PathBuf,
    /// Hidden folder beside the target; `None` where the target cannot be renamed, such as the current folder.
    part: Option<PathBuf>,
}

impl ResultFolder {
    /// Tries a folder before any work: it must be new, empty, or hold earlier results, and be writable. Remains of
    /// interrupted runs are removed.
    ///
    /// # Errors
    /// [`ResultFolderError`].
    pub fn open(path: &Path) -> Result<ResultFolder, ResultFolderError> {
        let failed = |source| ResultFolderError::Io {
            path: path.to_path_buf(),
            source,
        };
        let target = absolute(path).map_err(failed)?;
        let (Some(parent), Some(name)) = (target.parent(), target.file_name()) else {
            return Err(ResultFolderError::NoName {
                path: path.to_path_buf(),
            });
        };
        let name = name.to_string_lossy();
        exchange::recover(parent, &name, &target);
        if !target.exists() {
            let mut above = parent;
            while let (false, Some(next)) = (above.exists(), above.parent()) {
                above = next;
            }
            is_folder(above)?;
            try_writing(above).map_err(failed)?;
        } else {
            is_folder(&target)?;
            refuse_foreign(&target, path)?;
        }
        let part = parent.join(exchange::part_name(&name));
        let is_replaceable = match target.exists() {
            true => !is_current(&target) && is_same_device(&target, parent),
            false => true,
        };
        let has_part = is_replaceable && (!parent.exists() || try_writing(parent).is_ok());
        if !has_part {
            try_writing(&target).map_err(failed)?;
        }
        Ok(ResultFolder {
            target,
            part: has_part.then_some(part),
        })
    }

    /// Replaces the results in the folder by these files. An interruption at any moment leaves either the earlier
    /// results or the new ones; only in a folder that cannot be renamed (the current folder, a mount point) files are
    /// replaced one by one.
    ///
    /// # Errors
    /// [`ResultFolderError::Io`]; the earlier results are then unchanged.
    pub fn replace(&self, files: &[ResultFile]) -> Result<(), ResultFolderError> {
        let done = match &self.part {
            Some(part) => self.swap(part, files).or_else(|error| {
                let _ = std::fs::remove_dir_all(part);
                match error.kind() {
                    io::ErrorKind::CrossesDevices | io::ErrorKind::ResourceBusy => {
                        self.one_by_one(files)
                    }
                    _ => Err(error),
                }
            }),
            None => self.one_by_one(files),
        };
        done.map_err(|source| ResultFolderError::Io {
            path: self.target.clone(),
            source,
        })
    }

    fn swap(&self, part: &Path, files: &[ResultFile]) -> io::Result<()> {
        if let Some(parent) = self.target.parent() {
            std::fs::create_dir_all(parent)?;
        }
        std::fs::create_dir(part)?;
        for file in files {
            let path = part.join(&file.path);
            if let Some(folder) = path.parent() {
                std::fs::create_dir_all(folder)?;
            }
            write_synced(&path, &file.contents)?;
        }
        // Last: a part without a manifest is known to be incomplete.
        std::fs::write(part.join(MANIFEST), Manifest::of(files).text())?;
        if !self.target.exists() {
            return std::fs::rename(part, &self.target);
        }
        let earlier = Manifest::read(&self.target);
        std::fs::set_permissions(part, std::fs::metadata(&self.target)?.permissions())?;
        keep_foreign(&self.target, &earlier, part)?;
        let old = exchange(part, &self.target)?;
        // The results are there; remains of the earlier ones are removed by the next run at the latest.
        let _ = discard(&old, &self.target);
        Ok(())
    }

    fn one_by_one(&self, files: &[ResultFile]) -> io::Result<()> {
        let earlier = Manifest::read(&self.target);
        keep::set_edited_aside(&self.target, &earlier, files)?;
        for file in files {
            let path = self.target.join(&file.path);
            if let Some(folder) = path.parent() {
                std::fs::create_dir_all(folder)?;
            }
            write_atomic(&path, &file.contents)?;
        }
        for path in earlier.paths() {
            let is_new = files.iter().any(|file| file.path == path);
            if !is_new && earlier.wrote(&self.target, path) {
                std::fs::remove_file(self.target.join(path))?;
                keep::remove_empty_folders(&self.target, Path::new(path));
            }
        }
        write_atomic(&self.target.join(MANIFEST), Manifest::of(files).text())
    }
}

/// Number of bytes that are written to the disk at a time, which takes well below a second.
const CHUNK: usize = 1 << 20;

/// Writes a new file through to the disk, in chunks: a process cannot end while one is on its way.
fn write_synced(path: &Path, contents: &[u8]) -> io::Result<()> {
    let mut file = std::fs::File::create(path)?;
    for chunk in contents.chunks(CHUNK) {
        file.write_all(chunk)?;
        file.sync_data()?;
    }
    Ok(())
}

/// The absolute path, with symbolic links resolved as far as the path exists.
fn absolute(path: &Path) -> io::Result<PathBuf> {
    match path.canonicalize() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            let path = std::path::absolute(path)?;
            match (path.parent(), path.file_name()) {
                (Some(parent), Some(name)) => Ok(absolute(parent)?.join(name)),
                _ => Err(error),
            }
        }
        // A file among the parents is reported as such.
        Err(error) if error.kind() == io::ErrorKind::NotADirectory => std::path::absolute(path),
        found => found,
    }
}

fn is_folder(path: &Path) -> Result<(), ResultFolderError> {
    // Of `file/out`, the file is what exists.
    let existing = path.ancestors().find(|path| path.exists());
    match existing {
        Some(path) if !path.is_dir() => Err(ResultFolderError::IsFile {
            path: path.to_path_buf(),
        }),
        _ => Ok(()),
    }
}

/// Returns an error if a folder holds files and no manifest of results.
fn refuse_foreign(target: &Path, shown: &Path) -> Result<(), ResultFolderError> {
    if target.join(MANIFEST).is_file() {
        return Ok(());
    }
    let failed = |source| ResultFolderError::Io {
        path: shown.to_path_buf(),
        source,
    };
    let mut names = Vec::new();
    for entry in std::fs::read_dir(target).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        names.push(entry.file_name().to_string_lossy().into_owned());
    }
    if names.is_empty() {
        return Ok(());
    }
    names.sort();
    let rest = names.len() > MAX_NAMED;
    names.truncate(MAX_NAMED);
    if rest {
        names.push("…".to_owned());
    }
    Err(ResultFolderError::Foreign {
        path: shown.to_path_buf(),
        names,
    })
}

/// Creates a temporary folder in `folder` and removes it again.
fn try_writing(folder: &Path) -> io::Result<()> {
    let prefix = ".hyzer-trial-";
    tempfile::Builder::new()
        .prefix(prefix)
        .tempdir_in(folder)?
        .close()
}

/// Whether a folder is the current one or contains it: it cannot change places under those who are in it.
fn is_current(folder: &Path) -> bool {
    let current = std::env::current_dir().and_then(|current| current.canonicalize());
    current.is_ok_and(|current| current.starts_with(folder))
}

#[cfg(unix)]
fn is_same_device(folder: &Path, parent: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let device = |path: &Path| std::fs::metadata(path).map(|metadata| metadata.dev()).ok();
    device(folder) == device(parent)
}

#[cfg(not(unix))]
fn is_same_device(_: &Path, _: &Path) -> bool {
    true
}

#[cfg(test)]
mod tests;
