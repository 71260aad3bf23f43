//! Atomic file writes.

use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

/// Prefix of the names of temporary files whose content is not complete yet.
pub const UNFINISHED: &str = ".unfinished-";

/// Whether a file must survive a loss of power, or may be lost because it can be computed again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Durability {
    /// The file is synced to the disk before it is renamed.
    Synced,
    /// The file is renamed without a sync: readers see it complete, but a loss of power may lose or damage it.
    Renamed,
}

/// Writes a file atomically: an interruption leaves either the old file or the new one.
///
/// # Errors
/// [`io::Error`] if the folder does not exist or is not writable, or `path` is a folder.
pub fn write_atomic(path: &Path, contents: impl AsRef<[u8]>) -> io::Result<()> {
    let write = |file: &mut File| file.write_all(contents.as_ref());
    write_atomic_with(path, Durability::Synced, write)
}

/// Writes a file atomically as [`write_atomic`] does; `write` fills the temporary file.
///
/// # Errors
/// The error of `write`, and those of [`write_atomic`].
pub fn write_atomic_with<E: From<io::Error>>(
    path: &Path,
    durability: Durability,
    write: impl FnOnce(&mut File) -> Result<(), E>,
) -> Result<(), E> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut options = tempfile::Builder::new();
    options.prefix(UNFINISHED);
    // A temporary file is private by default; this sets the permissions that the umask allows.
    #[cfg(unix)]
    options.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = options.tempfile_in(folder)?;
    write(file.as_file_mut())?;
    if durability == Durability::Synced {
        file.as_file().sync_all()?;
    }
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Durability, UNFINISHED, write_atomic, write_atomic_with};

    /// A rename does not lead to another file system.
    #[test]
    fn an_unfinished_file_lies_beside_its_target() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("trajectory.csv");
        let mut beside = Vec::new();
        write_atomic_with::<std::io::Error>(&path, Durability::Renamed, |_| {
            let entries = std::fs::read_dir(folder.path())?;
            beside.extend(entries.map(|entry| entry.unwrap().file_name()));
            Ok(())
        })
        .unwrap();
        assert_eq!(beside.len(), 1);
        assert!(beside[0].to_str().unwrap().starts_with(UNFINISHED));
    }

    #[test]
    fn a_file_is_replaced_as_a_whole_and_no_temporary_file_remains() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("trajectory.csv");
        write_atomic(&path, "old").unwrap();
        write_atomic(&path, "new").unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "new");
        assert!(write_atomic(&folder.path().join("absent/trajectory.csv"), "x").is_err());
        // A folder at the target path cannot be replaced.
        std::fs::create_dir(folder.path().join("taken")).unwrap();
        assert!(write_atomic(&folder.path().join("taken"), "x").is_err());
        let entries = std::fs::read_dir(folder.path()).unwrap();
        let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["taken", "trajectory.csv"]);
    }

    #[cfg(unix)]
    #[test]
    fn the_permissions_are_those_of_a_new_file() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (plain, atomic) = (folder.path().join("plain"), folder.path().join("atomic"));
        std::fs::write(&plain, "x").unwrap();
        write_atomic(&atomic, "x").unwrap();
        let mode = |path| std::fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&plain), mode(&atomic));
    }
}
