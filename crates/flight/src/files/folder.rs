//! Folder of results that is replaced as a whole: at any time it contains either the earlier results or the new ones.
//!
//! The files are written to a hidden folder beside the target, and the two folders are then exchanged. A manifest in
//! the folder lists the files written. A folder with any other file, or with a result that was edited, is refused.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::ResultFile;
use super::atomic::write_atomic;
use super::exchange::{self, exchange};
use super::manifest::{MANIFEST, Manifest};

/// Maximum number of files named in the error about a folder with files that hyzer did not write.
const MAX_NAMED: usize = 3;

/// Reason why results cannot be written to a folder.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ResultFolderError {
    /// The path is that of a file, or leads through a file, instead of a folder.
    #[error("{} is a file, expected a folder", .0.display())]
    IsFile(PathBuf),
    /// The folder contains files that no earlier run wrote, or results that were edited since.
    #[error(
        "{} holds files that hyzer did not write or that were edited ({}); expected a new or empty folder, or one of earlier results: move the files or choose another folder",
        path.display(), names.join(", ")
    )]
    Foreign {
        /// Path of the folder that contains files of unknown origin.
        path: PathBuf,
        /// Names of at most three of the files that hyzer did not write, sorted; followed by `…` if there are more.
        names: Vec<String>,
    },
    /// The last component of the path is not a folder name, as in `x/..`.
    #[error("{} is not a valid folder name", .0.display())]
    NoName(PathBuf),
    /// A file or folder cannot be read or written.
    #[error("{} cannot be written: {source}", path.display())]
    Io {
        /// Path of the folder of results in which the error occurred.
        path: PathBuf,
        /// Error reported by the operating system.
        source: io::Error,
    },
}

/// Folder of results that was checked to be usable. Its contents change only when [`ResultFolder::replace`] is called.
#[derive(Clone, Debug)]
pub struct ResultFolder {
    /// Absolute path of the folder, with symbolic links resolved.
    target: PathBuf,
    /// Hidden folder beside the target folder in which new results are prepared.
    part: Option<PathBuf>,
}

impl ResultFolder {
    /// Checks a folder before any computation: it must be writable, and either new, empty, or contain earlier results.
    /// Temporary folders that interrupted runs left beside the folder are removed.
    ///
    /// # Errors
    /// [`ResultFolderError`] if the folder cannot accept results.
    pub fn open(path: &Path) -> Result<ResultFolder, ResultFolderError> {
        let failed = |source| ResultFolderError::Io {
            path: path.to_path_buf(),
            source,
        };
        let target = absolute(path).map_err(failed)?;
        let (Some(parent), Some(name)) = (target.parent(), target.file_name()) else {
            return Err(ResultFolderError::NoName(path.to_path_buf()));
        };
        let name = name.to_string_lossy();
        exchange::recover(parent, &name, &target);
        let existing = target.ancestors().find(|path| path.exists());
        let existing = existing.unwrap_or(&target);
        if !existing.is_dir() {
            let path = existing.to_path_buf();
            return Err(ResultFolderError::IsFile(path));
        }
        refuse_foreign(&target, path)?;
        try_writing(existing).map_err(failed)?;
        let part = (!is_current(&target)).then(|| parent.join(exchange::part_name(&name)));
        Ok(ResultFolder { target, part })
    }

    #[cfg(test)]
    pub(super) fn part(&self) -> Option<&Path> {
        self.part.as_deref()
    }

    /// The folder as if it could not be renamed.
    #[cfg(test)]
    pub(super) fn without_part(mut self) -> ResultFolder {
        self.part = None;
        self
    }

    /// Replaces the contents of the folder by `files`, all at once.
    ///
    /// # Errors
    /// [`ResultFolderError`] if the folder has got other files since it was opened, or cannot be written.
    pub fn replace(&self, files: &[ResultFile]) -> Result<(), ResultFolderError> {
        refuse_foreign(&self.target, &self.target)?;
        let done = match &self.part {
            Some(part) => self.swap(part, files).or_else(|error| {
                use io::ErrorKind as Kind;
                let _ = std::fs::remove_dir_all(part);
                match error.kind() {
                    // The folder is a file system of its own, or the one above is not writable.
                    Kind::CrossesDevices
                    | Kind::ResourceBusy
                    | Kind::PermissionDenied
                    | Kind::ReadOnlyFilesystem
                        if self.target.exists() =>
                    {
                        self.in_place(files)
                    }
                    _ => Err(error),
                }
            }),
            None => self.in_place(files),
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
        write_part(part, files)?;
        write_atomic(&part.join(MANIFEST), Manifest::of(files).text())?;
        if !self.target.exists() {
            return std::fs::rename(part, &self.target);
        }
        std::fs::set_permissions(part, std::fs::metadata(&self.target)?.permissions())?;
        let old = exchange(part, &self.target)?;
        // The new results are complete; the next run removes remains of the earlier ones if this fails.
        let _ = std::fs::remove_dir_all(old);
        Ok(())
    }

    /// Writes the files one by one, each atomically, into a folder that cannot be renamed, such as the current one.
    fn in_place(&self, files: &[ResultFile]) -> io::Result<()> {
        let earlier = Manifest::read(&self.target);
        // Until all files are written, both the earlier and the new ones are known.
        let both = Manifest::of(files).and(&earlier);
        write_atomic(&self.target.join(MANIFEST), both.text())?;
        for file in files {
            let path = self.target.join(&file.path);
            if let Some(folder) = path.parent() {
                std::fs::create_dir_all(folder)?;
            }
            write_atomic(&path, &file.contents)?;
        }
        for path in earlier.paths() {
            if !files.iter().any(|file| file.path == path) {
                std::fs::remove_file(self.target.join(path))?;
            }
        }
        write_atomic(&self.target.join(MANIFEST), Manifest::of(files).text())
    }
}

/// Writes files to a folder that is new or empty: to a hidden folder beside it, which is then renamed.
///
/// # Errors
/// [`io::Error`] if the path has no name, or the folder cannot be written or has been filled in the meantime.
pub fn write_new_folder(folder: &Path, files: &[ResultFile]) -> io::Result<()> {
    let target = absolute(folder)?;
    let (Some(parent), Some(name)) = (target.parent(), target.file_name()) else {
        let message = format!("{} is not a valid folder name", folder.display());
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    };
    std::fs::create_dir_all(parent)?;
    let part = parent.join(exchange::part_name(&name.to_string_lossy()));
    let written = write_part(&part, files).and_then(|()| {
        match std::fs::remove_dir(&target) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        std::fs::rename(&part, &target)
    });
    if written.is_err() {
        // An error here is ignored in favour of the first error.
        let _ = std::fs::remove_dir_all(&part);
    }
    written
}

fn write_part(part: &Path, files: &[ResultFile]) -> io::Result<()> {
    std::fs::create_dir(part)?;
    for file in files {
        let path = part.join(&file.path);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        write_synced(&path, &file.contents)?;
    }
    Ok(())
}

/// Number of bytes written to the disk at a time; small enough that a write takes well below a second.
const CHUNK: usize = 1 << 20;

/// Writes a new file, flushed after each chunk: a process cannot be terminated during a write.
fn write_synced(path: &Path, contents: &[u8]) -> io::Result<()> {
    let mut file = std::fs::File::create(path)?;
    for chunk in contents.chunks(CHUNK) {
        file.write_all(chunk)?;
        file.sync_data()?;
    }
    Ok(())
}

/// Absolute path, with symbolic links resolved in the part of the path that exists.
fn absolute(path: &Path) -> io::Result<PathBuf> {
    match path.canonicalize() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            let path = std::path::absolute(path)?;
            match (path.parent(), path.file_name()) {
                (Some(parent), Some(name)) => Ok(absolute(parent)?.join(name)),
                _ => Err(error),
            }
        }
        // A file among the parent folders is reported later.
        Err(error) if error.kind() == io::ErrorKind::NotADirectory => std::path::absolute(path),
        found => found,
    }
}

/// Returns an error if a folder contains a file that its manifest does not list, or one that was edited.
fn refuse_foreign(target: &Path, shown: &Path) -> Result<(), ResultFolderError> {
    let manifest = Manifest::read(target);
    let files = files_below(target).map_err(|source| ResultFolderError::Io {
        path: shown.to_path_buf(),
        source,
    })?;
    let is_own = |name: &String| name == MANIFEST || manifest.wrote(target, name);
    let mut names: Vec<String> = files.into_iter().filter(|name| !is_own(name)).collect();
    if names.is_empty() {
        return Ok(());
    }
    names.sort();
    if names.len() > MAX_NAMED {
        names.truncate(MAX_NAMED);
        names.push("…".to_owned());
    }
    Err(ResultFolderError::Foreign {
        path: shown.to_path_buf(),
        names,
    })
}

/// Paths of the files in a folder and below, with `/` between names; without a manifest no subfolder is entered.
pub(super) fn files_below(folder: &Path) -> io::Result<Vec<String>> {
    let is_ours = folder.join(MANIFEST).is_file();
    let (mut files, mut pending) = (Vec::new(), vec![String::new()]);
    while let Some(within) = pending.pop() {
        let entries = match std::fs::read_dir(folder.join(&within)) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            entries => entries?,
        };
        for entry in entries {
            let entry = entry?;
            let name = within.clone() + &entry.file_name().to_string_lossy();
            if entry.file_type()?.is_dir() && is_ours {
                pending.push(name + "/");
            } else {
                files.push(name);
            }
        }
    }
    Ok(files)
}

fn try_writing(folder: &Path) -> io::Result<()> {
    let prefix = ".hyzer-trial-";
    let tried = tempfile::Builder::new().prefix(prefix).tempdir_in(folder);
    let tried = tried.and_then(tempfile::TempDir::close);
    tried.map_err(|error| {
        // The name of the temporary file says nothing to a user.
        let text = error.to_string();
        let own = text.split(" at path ").next().unwrap_or(&text);
        io::Error::new(error.kind(), own.to_owned())
    })
}

/// Whether a folder is the current working directory or contains it, so that processes may be using it.
fn is_current(folder: &Path) -> bool {
    let current = std::env::current_dir().and_then(|current| current.canonicalize());
    current.is_ok_and(|current| current.starts_with(folder))
}
