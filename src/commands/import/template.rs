//! Template of the tracked body, as the file of the option `--markers` states it: markers, known parameters, the
//! model.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, bail};
use dataset::Marker;
use dataset::takes::words::listed;
use dataset::takes::{Pose, Take, rotated};

/// Maximum size of a template file (model, parameters and declared markers of a body), bytes.
const MAX_FILE_BYTES: u64 = 4 << 20;

/// The contents of a `dataset.toml` that are valid for any recording of the same body: model, parameters and markers.
pub struct Template {
    /// Name or path of the model of the body; `None` if the file specifies none.
    pub model: Option<String>,
    /// Known parameters of the body or its environment, by name, SI.
    pub parameters: BTreeMap<String, f64>,
    /// Names of the markers and their positions in the model's marker frame (usually the body frame), m.
    pub markers: Vec<Marker>,
}

/// Recorded points, or the recorded rigid body, from which the positions of the declared markers of the thrown body
/// (the template) are obtained.
pub enum Followed {
    /// For each marker of the template (declared markers of the thrown body), in its order, the index of a point of the
    /// recording.
    Points(Vec<usize>),
    /// Index of a tracked body of the recording, and the positions of the declared markers (the template) in the frame
    /// of this tracked body, m.
    Pose(usize, Vec<[f64; 3]>),
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

    /// Selects the points of the recording `take` that are the template's markers: the label of such a point, or the
    /// name to which `labels` maps the label, is the name of the marker. If no point matches, selects the recording's
    /// only body. An error if only some markers match, or if there is not exactly one body.
    pub fn followed(
        &self,
        take: &Take,
        labels: &BTreeMap<String, String>,
    ) -> anyhow::Result<Followed> {
        if let Some(label) = labels
            .keys()
            .find(|label| !take.labels().any(|known| known == *label))
        {
            bail!(
                "--label: found {label:?}, expected one of the labels {}",
                listed(take.labels())
            );
        }
        let name = |label: &str| labels.get(label).map_or(label, String::as_str).to_owned();
        let mut points = Vec::new();
        let mut missing = Vec::new();
        for marker in &self.markers {
            let found = take
                .points
                .iter()
                .position(|point| name(&point.label) == marker.name);
            match found {
                Some(point) => points.push(point),
                None => missing.push(marker.name.as_str()),
            }
        }
        if missing.is_empty() {
            return Ok(Followed::Points(points));
        }
        if let ([_], true) = (&take.bodies[..], points.is_empty()) {
            let markers = self.markers.iter().map(|marker| marker.position);
            return Ok(Followed::Pose(0, markers.collect()));
        }
        bail!(
            "found the labels {}, and none for {}; expected --label FILE_LABEL=NAME for each",
            listed(take.labels()),
            listed(missing)
        );
    }
}

impl Followed {
    /// Whether the positions of the markers are obtained from the pose of a body instead of from recorded points.
    pub fn is_pose(&self) -> bool {
        matches!(self, Self::Pose(..))
    }

    /// Labels, in the recording `take`, of the points or of the body from which the marker positions are obtained.
    pub fn labels<'t>(&self, take: &'t Take) -> Vec<&'t str> {
        match self {
            Self::Points(points) => points
                .iter()
                .map(|&i| take.points[i].label.as_str())
                .collect(),
            Self::Pose(body, _) => vec![take.bodies[*body].label.as_str()],
        }
    }

    /// Pose of the tracked body in a sample of the recording `take`; `None` if the marker positions are obtained from
    /// points instead, or if the body was not seen.
    pub fn pose(&self, take: &Take, sample: usize) -> Option<Pose> {
        match self {
            Self::Points(_) => None,
            Self::Pose(body, _) => take.bodies[*body].poses[sample],
        }
    }

    /// Positions of the declared markers (the template) in a sample of the recording `take`, along the axes of the
    /// recording, m; `None` for a marker that was not seen.
    pub fn positions(&self, take: &Take, sample: usize) -> Vec<Option<[f64; 3]>> {
        match self {
            Self::Points(points) => points
                .iter()
                .map(|&i| take.points[i].positions[sample])
                .collect(),
            Self::Pose(body, markers) => {
                let pose = take.bodies[*body].poses[sample];
                let each = markers.iter().map(|&marker| {
                    pose.map(|pose| {
                        let arm = rotated(pose.quaternion, marker);
                        [0, 1, 2].map(|axis| pose.position[axis] + arm[axis])
                    })
                });
                each.collect()
            }
        }
    }
}
