//! Template of a tracked body: what a `dataset.toml` says of any recording of the same body.

use std::collections::BTreeMap;
use std::path::Path;

use crate::fields::Fields;
use crate::manifest::{MAX_BYTES, parsed};
use crate::{InputError, Marker, file};

/// Contents of a `dataset.toml` that are valid for any recording of the same body.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodyTemplate {
    /// Name or path of the model of the body; `None` if the file specifies none.
    pub model: Option<String>,
    /// Known parameters of the body or its environment, by name, SI.
    pub parameters: BTreeMap<String, f64>,
    /// Names of the markers and their positions in the model's marker frame, m.
    pub markers: Vec<Marker>,
}

impl BodyTemplate {
    /// Reads a template file: a `dataset.toml`, or only its `[[markers]]` with optional `[parameters]` and `model`.
    ///
    /// # Errors
    /// [`InputError`] for the first fault of the file, or if it declares no marker or one without a position.
    pub fn read(path: &Path) -> Result<BodyTemplate, InputError> {
        let bytes = file::bytes(path, MAX_BYTES, "a TOML file with [[markers]]")?;
        let text = file::text(path, &bytes)?;
        let document = parsed(path, text)?;
        let (document, mut unplaced) = (document.get_ref(), Vec::new());
        let checker = Fields { file: path, text };
        let markers = checker.markers(document, &mut unplaced)?;
        if let Some(first) = unplaced.first() {
            let found = format!("no position of the marker {}", markers[first.marker].name);
            return Err(InputError::of_file(path, found, "x, y and z in m"));
        }
        if markers.is_empty() {
            let expected = "the name and position of each tracked point";
            return Err(InputError::of_file(path, "no [[markers]]", expected));
        }
        let model = document.get("model");
        Ok(BodyTemplate {
            model: model.map(|_| checker.model(document)).transpose()?,
            parameters: checker.parameters(document)?,
            markers,
        })
    }
}
