//! Template of the tracked body, as the file of the option `--markers` states it: markers, known parameters, the
//! model.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, bail};
use dataset::Marker;

/// Maximum size of a template file, bytes.
const MAX_FILE_BYTES: u64 = 4 << 20;

/// The contents of a `dataset.toml` that are valid for any recording of the same body: model, parameters and markers.
pub struct Template {
    /// Name or path of the model of the body; `None` if the file specifies none.
    pub model: Option<String>,
    /// Known parameters of the body or its environment, by name, SI.
    pub parameters: BTreeMap<String, f64>,
    /// Names of the markers and their positions in the model's marker frame, m.
    pub markers: Vec<Marker>,
}

impl Template {
    /// Reads a template file: a `dataset.toml`, or only its `[[markers]]` with optional `[parameters]` and `model`.
    pub fn read(file: &Path) -> anyhow::Result<Self> {
        let bytes =
            dataset::takes::file::bytes(file, MAX_FILE_BYTES, "a TOML file with [[markers]]")?;
        let name = file.display();
        let text = String::from_utf8(bytes).with_context(|| name.to_string())?;
        let table: toml::Table = text.parse().with_context(|| name.to_string())?;
        let number = |value: &toml::Value| {
            value
                .as_float()
                .or_else(|| value.as_integer().map(|whole| whole as f64))
        };
        let mut parameters = BTreeMap::new();
        for (key, value) in table
            .get("parameters")
            .and_then(toml::Value::as_table)
            .into_iter()
            .flatten()
        {
            match number(value) {
                Some(value) => parameters.insert(key.clone(), value),
                None => bail!("{name}: found {key} = {value}, expected a number"),
            };
        }
        let mut markers = Vec::new();
        let listed = table.get("markers").and_then(toml::Value::as_array);
        for marker in listed.into_iter().flatten() {
            let label = marker.get("name").and_then(toml::Value::as_str);
            let position = marker.get("position").and_then(toml::Value::as_array);
            let position: Option<Vec<f64>> = position.and_then(|p| p.iter().map(number).collect());
            match (label, position.as_deref()) {
                (Some(label), Some(&[x, y, z])) => markers.push(Marker {
                    name: label.to_owned(),
                    position: [x, y, z],
                }),
                _ => bail!(
                    "{name}: found the marker {marker}, expected name = \"…\" and position = [x, y, z] in m"
                ),
            }
        }
        if markers.is_empty() {
            bail!(
                "{name}: found no [[markers]], expected the name and position of each tracked point"
            );
        }
        let model = table
            .get("model")
            .and_then(toml::Value::as_str)
            .map(str::to_owned);
        Ok(Self {
            model,
            parameters,
            markers,
        })
    }
}
