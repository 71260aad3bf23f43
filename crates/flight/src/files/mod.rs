//! Files that appear whole or not at all: a temporary file or folder, then a rename.

mod atomic;
mod exchange;
mod folder;
mod manifest;
#[cfg(test)]
mod tests;

pub use atomic::{Durability, UNFINISHED, write_atomic, write_atomic_with};
pub use folder::{ResultFile, ResultFolder, ResultFolderError, write_new_folder};
pub use manifest::MANIFEST;
