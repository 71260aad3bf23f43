//! Where a model or an effect is found.

use serde::{Deserialize, Serialize};
use std::path::{Component, Path, PathBuf};

/// Where a model or an effect is found.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// Path of a file, relative to the folder of the certificate, with `/` between names.
    File(String),
    /// Name of a built-in model or effect, or of an effect in the model's file.
    Name(String),
}

impl Origin {
    /// Origin of a name or path; an existing file takes precedence.
    pub fn of(name_or_path: &str, folder: &Path) -> Self {
        let path = Path::new(name_or_path);
        if path.is_file() {
            Self::File(relative(path, folder))
        } else {
            Self::Name(name_or_path.to_owned())
        }
    }

    /// Name or path, for the loader of models; an error if the file does not exist.
    pub(super) fn found(&self, folder: &Path) -> Result<String, String> {
        match self {
            Self::Name(name) => Ok(name.clone()),
            Self::File(path) => {
                let full = folder.join(path);
                match full.to_str() {
                    Some(full) if Path::new(full).is_file() => Ok(full.to_owned()),
                    _ => Err(format!("{path} is not there")),
                }
            }
        }
    }
}

/// Path of a file from a folder; the unchanged path where the two have nothing in common.
pub(super) fn relative(path: &Path, folder: &Path) -> String {
    let folder = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    let (Ok(file), Ok(base)) = (path.canonicalize(), folder.canonicalize()) else {
        return path.to_string_lossy().into_owned();
    };
    let (file, base): (Vec<Component<'_>>, Vec<Component<'_>>) =
        (file.components().collect(), base.components().collect());
    let common = file.iter().zip(&base).take_while(|(a, b)| a == b).count();
    if common == 0 {
        return path.to_string_lossy().into_owned();
    }
    let up = base[common..].iter().map(|_| "..".to_owned());
    let down = file[common..].iter();
    let down = down.map(|part| part.as_os_str().to_string_lossy().into_owned());
    up.chain(down).collect::<Vec<_>>().join("/")
}

/// Folder of a certificate.
pub fn folder_of(certificate: &Path) -> PathBuf {
    match certificate.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}
