//! File or name from which a model or an effect is loaded.

use model_spec::load::LoadError;
use serde::{Deserialize, Serialize};
use std::path::{Component, Path, PathBuf};

/// File or name from which a model or an effect (optional model extension) is loaded.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// Path of a file, relative to the folder of the certificate, with `/` as separator.
    File(String),
    /// Name of a built-in model, of a built-in effect (optional model extension), or of an effect in the model's file.
    Name(String),
}

impl Origin {
    /// Classifies a name or path: [`Origin::File`] if a file of that path exists, otherwise [`Origin::Name`]. The path
    /// is stored relative to `folder`, the folder of the certificate.
    pub fn of(name_or_path: &str, folder: &Path) -> Self {
        let path = Path::new(name_or_path);
        if path.is_file() {
            Self::File(relative(path, folder))
        } else {
            Self::Name(name_or_path.to_owned())
        }
    }

    /// Name or full path of a model or of an effect (optional model extension), to be passed to the loader of models.
    /// `folder` is the folder of the certificate.
    ///
    /// # Errors
    /// [`OriginError::Missing`] if the file does not exist.
    pub(super) fn found(&self, folder: &Path) -> Result<String, OriginError> {
        match self {
            Self::Name(name) => Ok(name.clone()),
            Self::File(path) => {
                let full = folder.join(path);
                match full.to_str() {
                    Some(full) if Path::new(full).is_file() => Ok(full.to_owned()),
                    _ => Err(OriginError::Missing(path.clone())),
                }
            }
        }
    }
}

/// Reason why a model covered by a certificate (record of a verification) cannot be loaded.
#[derive(Debug, thiserror::Error)]
pub(super) enum OriginError {
    /// The file at this path, relative to the folder of the certificate, does not exist.
    #[error("{0} is not there")]
    Missing(String),
    /// The model or one of its effects (optional extensions) cannot be loaded; the message is the first line of the
    /// loader's message.
    #[error("cannot be loaded: {}", first_line(.0))]
    Load(#[from] LoadError),
}

fn first_line(error: &LoadError) -> String {
    let text = error.to_string();
    text.lines().next().unwrap_or_default().to_owned()
}

/// Path of a file relative to a folder. The path is returned unchanged if it cannot be resolved or has no common root
/// with the folder.
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

/// Folder that contains the file of the certificate (record of a verification); `.` if the path has no folder.
pub fn folder_of(certificate: &Path) -> PathBuf {
    match certificate.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}
