//! Atomic exchange of two folders, and removal of the remains of interrupted runs beside a folder.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Suffix of the earlier results folder while it is replaced, where two folders cannot be exchanged in one step.
const OLD: &str = ".old";

/// Name of the hidden folder in which this process prepares the results for the folder `name`.
pub(super) fn part_name(name: &str) -> String {
    format!(".{name}.hyzer-{}", std::process::id())
}

/// Exchanges the names of the folders `part` and `target`, in one step if the file system supports it.
pub(super) fn exchange(part: &Path, target: &Path) -> io::Result<PathBuf> {
    match in_one_step(part, target) {
        Ok(()) => Ok(part.to_path_buf()),
        Err(_) => in_two_steps(part, target),
    }
}

#[cfg(any(target_os = "linux", target_vendor = "apple"))]
fn in_one_step(part: &Path, target: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    renameat_with(CWD, part, CWD, target, RenameFlags::EXCHANGE).map_err(io::Error::from)
}

#[cfg(not(any(target_os = "linux", target_vendor = "apple")))]
fn in_one_step(_: &Path, _: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

fn in_two_steps(part: &Path, target: &Path) -> io::Result<PathBuf> {
    let mut old = part.as_os_str().to_owned();
    old.push(OLD);
    let old = PathBuf::from(old);
    fs::rename(target, &old)?;
    if let Err(error) = fs::rename(part, target) {
        fs::rename(&old, target)?;
        return Err(error);
    }
    Ok(old)
}

/// Removes temporary folders that interrupted runs left in `parent` for the results folder `name`, whose path is
/// `target`. If a run was interrupted after it renamed the results folder, that folder is renamed back to `target`.
pub(super) fn recover(parent: &Path, name: &str, target: &Path) {
    let prefix = format!(".{name}.hyzer-");
    let entries = fs::read_dir(parent).into_iter().flatten().flatten();
    let mut remains: Vec<(bool, PathBuf)> = entries
        .filter_map(|entry| {
            let found = entry.file_name();
            let id = found.to_str()?.strip_prefix(&prefix)?;
            let is_old = id.ends_with(OLD);
            let id: u32 = id.trim_end_matches(OLD).parse().ok()?;
            (!is_running(id)).then(|| (is_old, entry.path()))
        })
        .collect();
    // Renamed earlier folders come first, since one of them may have to be restored.
    remains.sort_by(|a, b| b.cmp(a));
    for (is_old, folder) in remains {
        // If this fails, the next run tries again.
        let _ = match is_old && !target.exists() {
            true => fs::rename(&folder, target),
            false => fs::remove_dir_all(&folder),
        };
    }
}

/// Whether a process with this id is running; true if unknown, false for the current process.
#[cfg(unix)]
fn is_running(id: u32) -> bool {
    let id = i32::try_from(id)
        .ok()
        .and_then(rustix::process::Pid::from_raw);
    let Some(id) = id else { return false };
    match rustix::process::test_kill_process(id) {
        Err(error) => error != rustix::io::Errno::SRCH,
        Ok(()) => id != rustix::process::getpid(),
    }
}

#[cfg(not(unix))]
fn is_running(_: u32) -> bool {
    true
}
