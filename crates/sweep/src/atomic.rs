//! Files that appear whole, written as a stream.

use std::fs::File;
use std::io;
use std::path::Path;

/// Prefix of files that are not yet whole.
pub(crate) const UNFINISHED: &str = ".unfinished-";

/// Whether a file must outlast a loss of power, or can be made again.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Durability {
    /// Synced to the disk before it is renamed.
    Synced,
    /// Renamed alone: whole for every reader, but a loss of power may lose or damage it.
    Renamed,
}

/// Writes a file by a function of its stream, to a temporary file beside it that is then renamed.
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
