//! Atomic writes of files: a reader sees the complete file or none.

use std::fs::File;
use std::io;
use std::path::Path;

/// Prefix of the names of temporary files whose content is not complete yet.
pub(crate) const UNFINISHED: &str = ".unfinished-";

/// Whether a file must survive a loss of power, or may be lost because it can be computed again.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Durability {
    /// The file is synced to the disk before it is renamed.
    Synced,
    /// The file is renamed without a sync: readers see it complete, but a loss of power may lose or damage it.
    Renamed,
}

/// Writes a file atomically: `write` fills a temporary file in the same folder, which is then renamed to `path`.
pub(crate) fn write_atomic<E: From<io::Error>>(
    path: &Path,
    durability: Durability,
    write: impl FnOnce(&mut File) -> Result<(), E>,
) -> Result<(), E> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut options = tempfile::Builder::new();
    options.prefix(UNFINISHED);
    // A temporary file is private by default; the result has the permissions that the umask leaves.
    #[cfg(unix)]
    options.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = options.tempfile_in(folder)?;
    write(file.as_file_mut())?;
    if durability == Durability::Synced {
        file.as_file().sync_all()?;
    }
    file.persist(path).map_err(|e| e.error)?;
    Ok(())
}
