//! Files that appear whole or not at all: a temporary file or folder, then a rename.

mod atomic;
mod exchange;
mod folder;
mod manifest;
#[cfg(test)]
mod tests;
mod text;

pub use atomic::{Durability, UNFINISHED, write_atomic, write_atomic_with};
pub use folder::{ResultFolder, ResultFolderError, write_new_folder};
pub use manifest::MANIFEST;
pub use text::{Unreadable, bounded_text, json};

/// A result file to be written to a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ResultFile {
    /// Path relative to the folder of results, with `/` between names.
    pub path: String,
    /// Contents of the file.
    pub contents: Vec<u8>,
}

impl ResultFile {
    /// Creates a result file from its path relative to the folder and its contents.
    pub fn new(path: impl Into<String>, contents: impl Into<Vec<u8>>) -> ResultFile {
        ResultFile {
            path: path.into(),
            contents: contents.into(),
        }
    }
}
