//! The dataset as a folder, with comments on its markers.

use std::io;
use std::path::Path;

use identify::dataset::{Dataset, write_with};

/// Writes a dataset with other files (name, text), and with a comment line for each marker where there are some.
pub fn write(
    folder: &Path,
    dataset: &Dataset,
    other_files: &[(&str, String)],
    comments: &[String],
) -> io::Result<()> {
    if comments.is_empty() {
        return write_with(folder, dataset, other_files);
    }
    let Some(name) = folder.file_name().and_then(|name| name.to_str()) else {
        let why = format!("{} is no folder's name", folder.display());
        return Err(io::Error::new(io::ErrorKind::InvalidInput, why));
    };
    let part = folder.with_file_name(format!(".{name}.{}.commented", std::process::id()));
    let written = write_with(&part, dataset, other_files).and_then(|()| {
        let manifest = part.join("dataset.toml");
        let text = std::fs::read_to_string(&manifest)?;
        std::fs::write(&manifest, commented(&text, comments))?;
        // An empty folder gives way; one that holds files does not.
        match std::fs::remove_dir(folder) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        std::fs::rename(&part, folder)
    });
    if written.is_err() {
        // What went wrong first is what counts.
        let _ = std::fs::remove_dir_all(&part);
    }
    written
}

/// A manifest with a comment above the position of each marker.
fn commented(text: &str, comments: &[String]) -> String {
    let mut comments = comments.iter();
    let mut made = String::new();
    for line in text.lines() {
        if line.starts_with("position = ")
            && let Some(comment) = comments.next()
        {
            made += &format!("# {comment}\n");
        }
        made += line;
        made.push('\n');
    }
    made
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_marker_has_its_comment() {
        let text = "model = \"disc\"\n\n[[markers]]\nname = \"a\"\nposition = [0.1, 0.0, 0.0]\n\n[[markers]]\nname = \"b\"\nposition = [0.0, 0.1, 0.0]\n";
        let made = commented(text, &["one".to_owned(), "two".to_owned()]);
        assert!(made.contains("# one\nposition = [0.1"), "{made}");
        assert!(made.contains("# two\nposition = [0.0, 0.1"), "{made}");
    }
}
