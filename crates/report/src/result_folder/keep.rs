//! Preservation of files in a folder of results that the program did not write: they are carried over, never deleted.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::ResultFile;
use super::manifest::{MANIFEST, Manifest};

/// Relative paths of all entries below a folder, recursively: first files and symbolic links, then folders, each
/// sorted.
pub(super) fn entries_below(folder: &Path) -> io::Result<(Vec<PathBuf>, Vec<PathBuf>)> {
    let (mut files, mut folders) = (Vec::new(), Vec::new());
    let mut left = vec![PathBuf::new()];
    while let Some(next) = left.pop() {
        for entry in fs::read_dir(folder.join(&next))? {
            let entry = entry?;
            let path = next.join(entry.file_name());
            if entry.file_type()?.is_dir() {
                folders.push(path.clone());
                left.push(path);
            } else {
                files.push(path);
            }
        }
    }
    files.sort();
    folders.sort();
    Ok((files, folders))
}

/// Whether hyzer wrote the file `path` of a results folder, and the file was not edited since then; always true
/// for the manifest (list of written files).
fn is_own(folder: &Path, manifest: &Manifest, path: &Path) -> bool {
    let name = path.to_string_lossy().replace('\\', "/");
    name == MANIFEST || manifest.wrote(folder, &name)
}

/// Preserves the files of the results folder `target` in the new results folder `part`, by hard links if possible,
/// otherwise by copies. Result files that were not edited since hyzer wrote them (according to the manifest
/// `earlier`) are omitted. A preserved file with the name of a new result is named `NAME.kept`.
pub(super) fn keep_foreign(target: &Path, earlier: &Manifest, part: &Path) -> io::Result<()> {
    let (files, folders) = entries_below(target)?;
    for folder in &folders {
        let is_of_results = earlier
            .paths()
            .any(|path| Path::new(path).starts_with(folder));
        if !is_of_results {
            fs::create_dir_all(part.join(folder))?;
        }
    }
    for path in &files {
        if !is_own(target, earlier, path) {
            let kept = free_name(part, path);
            if let Some(folder) = kept.parent() {
                fs::create_dir_all(folder)?;
            }
            let from = target.join(path);
            fs::hard_link(&from, &kept).or_else(|_| fs::copy(&from, &kept).map(|_| ()))?;
        }
    }
    Ok(())
}

/// Renames the files in `target` that `files` would overwrite to `NAME.kept`, except results that were not edited since
/// hyzer wrote them (according to the manifest `earlier`).
pub(super) fn set_edited_aside(
    target: &Path,
    earlier: &Manifest,
    files: &[ResultFile],
) -> io::Result<()> {
    for file in files {
        let path = Path::new(&file.path);
        if target.join(path).exists() && !is_own(target, earlier, path) {
            fs::rename(target.join(path), free_name(target, path))?;
        }
    }
    Ok(())
}

/// Removes the folder `old` of earlier results after it was replaced by `current`. Its result files that were not
/// edited since hyzer wrote them, and files that `current` also contains, are deleted; all other files are moved
/// to `current`.
pub(super) fn discard(old: &Path, current: &Path) -> io::Result<()> {
    let manifest = Manifest::read(old);
    let (files, folders) = entries_below(old)?;
    for path in files.iter().filter(|path| path.as_os_str() != MANIFEST) {
        let from = old.join(path);
        if is_own(old, &manifest, path) || is_kept(&from, current, path) {
            fs::remove_file(&from)?;
        } else {
            let to = free_name(current, path);
            if let Some(folder) = to.parent() {
                fs::create_dir_all(folder)?;
            }
            fs::rename(&from, to)?;
        }
    }
    match fs::remove_file(old.join(MANIFEST)) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
        _ => {}
    }
    for folder in folders.iter().rev() {
        fs::remove_dir(old.join(folder))?;
    }
    fs::remove_dir(old)
}

/// Whether the folder `current` contains a file with the same contents as `file`, under the name `path` or one of the
/// names of a preserved file (`NAME.kept`, `NAME.kept2`, and so on).
fn is_kept(file: &Path, current: &Path, path: &Path) -> bool {
    let same = |other: &Path| match (fs::read(file), fs::read(other)) {
        (Ok(a), Ok(b)) => a == b,
        _ => false,
    };
    kept_names(path).take(MAX_KEPT).any(|name| {
        let other = current.join(name);
        other.exists() && same(&other)
    })
}

/// Maximum number of names (`NAME`, `NAME.kept`, `NAME.kept2`, …) under which an already preserved copy of a file is
/// searched.
const MAX_KEPT: usize = 100;

/// Names under which a file can be preserved: `NAME`, `NAME.kept`, `NAME.kept2`, and so on.
fn kept_names(path: &Path) -> impl Iterator<Item = PathBuf> {
    (0_usize..).map(move |k| {
        let mut name = path.as_os_str().to_owned();
        match k {
            0 => {}
            1 => name.push(".kept"),
            _ => name.push(format!(".kept{k}")),
        }
        PathBuf::from(name)
    })
}

/// Path in `folder` under which a file can be preserved: the first of `NAME`, `NAME.kept`, `NAME.kept2`, … that does
/// not exist.
fn free_name(folder: &Path, path: &Path) -> PathBuf {
    let mut names = kept_names(path).map(|name| folder.join(name));
    let is_free = |name: &PathBuf| fs::symlink_metadata(name).is_err();
    names.find(is_free).unwrap_or_else(|| folder.join(path))
}

/// Removes the folders that are empty after `file` was removed: those that contained it, below `root`. `file` is a path
/// relative to `root`.
pub(super) fn remove_empty_folders(root: &Path, file: &Path) {
    for folder in file.ancestors().skip(1) {
        if folder.as_os_str().is_empty() || fs::remove_dir(root.join(folder)).is_err() {
            return;
        }
    }
}
