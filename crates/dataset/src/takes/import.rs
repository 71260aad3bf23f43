//! Import of one recording: the tracked body, its free flights, and the decisions made.

use std::collections::BTreeMap;
use std::path::Path;

use super::throws::GRAVITY;
use super::{
    Axis, LengthUnit, Motion, Pose, Take, TakeError, Throw, ThrowOptions, find_throws, motion,
    rotated,
};
use crate::sensor::{attitude, spin_axis};
use crate::statistics::median_of;
use crate::takes::{Fault, Location};
use crate::{Flight, Marker};
use flight::table::listed;
use nalgebra::Vector3;

/// Acceleration downwards of free flights, over that of gravity, by which an axis up or a unit of length is recognised: lift
/// bears most of the weight of a disc, and units differ by a factor of 2.5 at least.
const FALLS: std::ops::Range<f64> = 0.2..1.3;

/// Relative difference of distances between markers from those of the template up to which a unit of length is that of the
/// recording: less than half of that of the nearest unit.
const AS_IN_TEMPLATE: f64 = 0.3;

/// What the user states about the recordings of a body.
#[derive(Clone, Debug, Default)]
pub struct ImportOptions {
    /// Markers of the body: their names and positions in the body frame, m.
    pub markers: Vec<Marker>,
    /// Marker names of labels of the recordings, where the two differ.
    pub labels: BTreeMap<String, String>,
    /// Axis that points up; `None` for the one that the file states.
    pub up: Option<Axis>,
    /// Whether the axes of the recordings are left-handed.
    pub left_handed: bool,
}

/// A recording with z up, the tracked body in it, and its free flights.
#[derive(Clone, Debug)]
pub struct ImportedTake {
    /// The recording, with z up.
    pub take: Take,
    /// The points or the body from which the positions of the markers are obtained.
    pub followed: Followed,
    /// Motion of the body over the whole recording; `None` if it is seen in fewer than two samples.
    pub motion: Option<Motion>,
    /// The throws in the order of time.
    pub throws: Vec<Throw>,
    /// The flight of each throw, without a file name: positions of the markers, or poses of the tracked body.
    pub flights: Vec<Flight>,
    /// Pairs of a subject, such as `up`, and what was decided about it.
    pub decisions: Vec<(String, String)>,
    /// Notes on parts of the recording that were excluded or are uncertain.
    pub notes: Vec<String>,
}

/// Recorded points, or the recorded rigid body, from which the positions of the markers are obtained.
#[derive(Clone, Debug, PartialEq)]
pub enum Followed {
    /// For each marker, in its order, the index of a point of the recording.
    Points(Vec<usize>),
    /// Index of a tracked body of the recording, and the positions of the markers in its frame, m.
    Pose(usize, Vec<[f64; 3]>),
}

impl ImportedTake {
    /// Finds the body and its free flights in the recording `take`, which was read from `file`.
    ///
    /// # Errors
    /// [`TakeError`] if the axis that points up is not known or wrong, or if the markers are not found.
    pub fn new(take: &Take, file: &Path, options: &ImportOptions) -> Result<Self, TakeError> {
        let up = up_of(take, file, options.up)?;
        let followed =
            Followed::find(take, options).map_err(|fault| TakeError::new(file, fault))?;
        let labels = followed.labels(take);
        let mut turned = take.clone().with_z_up(up, options.left_handed);
        let found = find_throws(&turned, &labels, &ThrowOptions::default());
        if found.throws.is_empty()
            && let Some(error) = unit_by_template(take, &followed, options)
                .map(|fault| TakeError::new(file, fault))
                .or_else(|| found_otherwise(take, file, &labels, (up, options.left_handed)))
        {
            return Err(error);
        }
        let mut notes = take.notes.clone();
        if followed.is_pose() {
            notes.push("the poses are written as those of the body frame".into());
        }
        notes.extend(found.notes);
        let throws = found.throws.iter();
        let mut decisions = decisions(take, options, up, &labels);
        if let Followed::Pose(body, _) = &followed
            && up.index != 2
            && spin_axis(found.throws.iter().flat_map(|throw| {
                // Where the body was not seen, it may have turned any number of times.
                let seen = turned.bodies[*body].poses[throw.samples()].split(Option::is_none);
                seen.map(|poses| poses.iter().flatten().map(|pose| attitude(pose.quaternion)))
            })) == Some(up.index)
        {
            let poses = turned.bodies[*body].poses.iter_mut().flatten();
            for pose in poses {
                pose.quaternion = up.third_body_axis(pose.quaternion);
            }
            decisions.push((
                "body axes".to_owned(),
                format!("{up} of the body, about which it spins; written as the third axis"),
            ));
        }
        Ok(Self {
            flights: throws
                .map(|throw| followed.flight(&turned, throw))
                .collect(),
            motion: motion(&turned, &labels),
            throws: found.throws,
            decisions,
            take: turned,
            followed,
            notes,
        })
    }
}

fn fault(found: String, expected: String) -> Fault {
    Fault::new(Location::File, found, expected)
}

fn decisions(
    take: &Take,
    options: &ImportOptions,
    up: Axis,
    labels: &[&str],
) -> Vec<(String, String)> {
    let by = match options.up {
        Some(_) => "by --up",
        None => "as the file states",
    };
    let hand = match (options.left_handed, take.left_handed) {
        (true, _) => "left-handed, by --left-handed",
        (false, Some(false)) => "right-handed",
        (false, _) => "taken as right-handed (otherwise --left-handed)",
    };
    let decisions = [
        ("format", take.format.to_string()),
        ("samples", take.times.len().to_string()),
        ("lengths", format!("in {}, written in m", take.length)),
        ("up", format!("{up}, {by}; written with z up")),
        ("axes", hand.to_owned()),
        ("followed", listed(labels)),
    ];
    decisions.map(|(what, text)| (what.to_owned(), text)).into()
}

/// Axis of the recording that points up: `stated`, or else the one that the file states.
///
/// # Errors
/// [`TakeError`] if neither states it.
pub fn up_of(take: &Take, file: &Path, stated: Option<Axis>) -> Result<Axis, TakeError> {
    stated.or(take.up).ok_or_else(|| {
        let expected = "the option --up, such as --up +z or --up +y";
        let found = "no statement of the axis that points up";
        TakeError::new(file, fault(found.into(), expected.into()))
    })
}

/// Error that tells with which other axis up, or unit of length, the points or body of `labels` fly freely in a recording
/// that has no throw with the axis `up` up and axes that are `left_handed` or not; `None` if there is none.
pub fn found_otherwise(
    take: &Take,
    file: &Path,
    labels: &[&str],
    (up, left_handed): (Axis, bool),
) -> Option<TakeError> {
    if let Some(other) = other_up(take, labels, left_handed, up) {
        let found = format!("no throw with {up} up, and free flights with {other} up");
        return Some(TakeError::new(file, fault(found, format!("--up {other}"))));
    }
    let turned = take.clone().with_z_up(up, left_handed);
    let others = other_lengths(&turned, labels);
    let each =
        |form: fn(&LengthUnit) -> String| others.iter().map(form).collect::<Vec<_>>().join(" or ");
    let (names, correction) = (
        each(LengthUnit::to_string),
        each(|unit| format!("--length {unit}")),
    );
    let own = take.length;
    let found = format!("no throw with lengths in {own}, and free flights with lengths in {names}");
    (!others.is_empty()).then(|| TakeError::new(file, fault(found, correction)))
}

/// Fault that tells the unit of length in which the markers of a recording are as far apart as in the template; `None` if
/// they are so in the present one, or in none.
fn unit_by_template(take: &Take, followed: &Followed, options: &ImportOptions) -> Option<Fault> {
    let places: Vec<Option<[f64; 3]>> = options
        .markers
        .iter()
        .map(|own| Some(own.position))
        .collect();
    let template = size(&places)?;
    let sizes = (0..take.times.len()).filter_map(|sample| size(&followed.positions(take, sample)));
    let seen = median_of(sizes)? / template;
    let fits = |unit: &LengthUnit| {
        let ratio = seen * unit.metres() / take.length.metres();
        (ratio - 1.0).abs() < AS_IN_TEMPLATE
    };
    let other = LengthUnit::all()
        .find(fits)
        .filter(|unit| *unit != take.length)?;
    // Two digits.
    let times: f64 = format!("{seen:.1e}").parse().unwrap_or(seen);
    let own = take.length;
    let found =
        format!("markers {times} times as far apart as in the template with lengths in {own}");
    Some(fault(found, format!("--length {other}")))
}

/// Sum of the distances of all markers from their mean, m; `None` if one is not seen, or all are at one place.
fn size(places: &[Option<[f64; 3]>]) -> Option<f64> {
    let places = places.iter().map(|own| own.map(Vector3::from));
    let places: Vec<Vector3<f64>> = places.collect::<Option<_>>()?;
    let mean = places.iter().sum::<Vector3<f64>>() / places.len() as f64;
    let size = places.iter().map(|own| (own - mean).norm()).sum::<f64>();
    (size > 0.0).then_some(size)
}

/// First axis other than `up` with which throws are found when it points up.
fn other_up(take: &Take, labels: &[&str], left_handed: bool, up: Axis) -> Option<Axis> {
    let all = ["+z", "+y", "+x", "-z", "-y", "-x"]
        .into_iter()
        .filter_map(Axis::parse);
    all.filter(|axis| *axis != up)
        .find(|&axis| falls(&take.clone().with_z_up(axis, left_handed), labels))
}

/// The other units of the coordinates of a recording with z up in which throws are found.
fn other_lengths(take: &Take, labels: &[&str]) -> Vec<LengthUnit> {
    let scaled = |unit: LengthUnit| take.clone().scaled(unit.metres() / take.length.metres());
    let others = LengthUnit::all().filter(|unit| *unit != take.length);
    others
        .filter(|unit| falls(&scaled(*unit), labels))
        .collect()
}

/// Whether a throw is found in a recording with z up that falls about as gravity makes bodies fall.
fn falls(take: &Take, labels: &[&str]) -> bool {
    let found = find_throws(take, labels, &ThrowOptions::default());
    let mut falls = found
        .throws
        .iter()
        .map(|throw| -throw.acceleration[2] / GRAVITY);
    falls.any(|fall| FALLS.contains(&fall))
}

/// Whether a label of a recording is the one `stated`: as it stands, or after its subject, as `m1` of `Disc:m1`. Readers
/// leave the subject out where all labels have it.
fn is_stated(label: &str, stated: &str) -> bool {
    let after = stated.split_once(':').map(|(_, name)| name);
    label == stated || after == Some(label)
}

/// Name that `labels` give to a label of a recording, with or without its subject.
pub fn name_of_label<'l>(labels: &'l BTreeMap<String, String>, label: &str) -> Option<&'l String> {
    let with_subject = || labels.iter().find(|(stated, _)| is_stated(label, stated));
    labels
        .get(label)
        .or_else(|| with_subject().map(|(_, name)| name))
}

impl Followed {
    /// Selects the points that are the markers, by label or by the name given to it; if none matches, the only point for
    /// the only marker, or the only body.
    fn find(take: &Take, options: &ImportOptions) -> Result<Self, Fault> {
        let is_unknown = |label: &&String| !take.labels().any(|known| is_stated(known, label));
        if let Some(label) = options.labels.keys().find(is_unknown) {
            let expected = format!("one of the labels {}", listed(take.labels()));
            return Err(fault(format!("{label:?} in --label"), expected));
        }
        let mut points = Vec::new();
        let mut missing = Vec::new();
        for marker in &options.markers {
            let name = |label: &String| {
                name_of_label(&options.labels, label).unwrap_or(label) == &marker.name
            };
            match take.points.iter().position(|point| name(&point.label)) {
                Some(point) => points.push(point),
                None => missing.push(marker.name.as_str()),
            }
        }
        if missing.is_empty() && !points.is_empty() {
            return Ok(Self::Points(points));
        }
        let is_only = (take.points.len(), options.markers.len()) == (1, 1);
        if is_only && take.bodies.is_empty() {
            return Ok(Self::Points(vec![0]));
        }
        if take.bodies.len() == 1 && points.is_empty() {
            let markers = options.markers.iter().map(|marker| marker.position);
            return Ok(Self::Pose(0, markers.collect()));
        }
        Err(fault(
            format!(
                "the labels {}, and none for {}",
                listed(take.labels()),
                listed(missing)
            ),
            "--label FILE_LABEL=NAME for each".into(),
        ))
    }

    /// Whether the positions of the markers are obtained from the pose of a body instead of from recorded points.
    pub fn is_pose(&self) -> bool {
        matches!(self, Self::Pose(..))
    }

    /// Labels of the points or of the body from which the positions of the markers are obtained.
    pub fn labels<'t>(&self, take: &'t Take) -> Vec<&'t str> {
        match self {
            Self::Points(points) => {
                let points = points.iter();
                points.map(|&i| take.points[i].label.as_str()).collect()
            }
            Self::Pose(body, _) => vec![take.bodies[*body].label.as_str()],
        }
    }

    /// Positions of the markers in a sample of a recording, along its axes, m; `None` for a marker that was not seen.
    pub fn positions(&self, take: &Take, sample: usize) -> Vec<Option<[f64; 3]>> {
        match self {
            Self::Points(points) => {
                let points = points.iter();
                points.map(|&i| take.points[i].positions[sample]).collect()
            }
            Self::Pose(body, markers) => {
                let pose = take.bodies[*body].poses[sample];
                let position = |marker: &[f64; 3]| {
                    let Pose {
                        position,
                        quaternion,
                    } = pose?;
                    let arm = rotated(quaternion, *marker);
                    Some([0, 1, 2].map(|axis| position[axis] + arm[axis]))
                };
                markers.iter().map(position).collect()
            }
        }
    }

    /// Flight of a throw: positions of the markers or, if a body is followed, its poses.
    fn flight(&self, take: &Take, throw: &Throw) -> Flight {
        let times = take.times[throw.samples()].to_vec();
        let Self::Pose(body, _) = self else {
            return Flight {
                positions: throw.samples().map(|i| self.positions(take, i)).collect(),
                times,
                ..Flight::default()
            };
        };
        let poses = take.bodies[*body].poses[throw.samples()].iter();
        let readings = poses.map(|pose| {
            let Some(pose) = pose else {
                return vec![None; 2];
            };
            let [x, y, z] = pose.position;
            vec![Some([x, y, z, 0.0]), Some(pose.quaternion)]
        });
        Flight {
            positions: vec![Vec::new(); times.len()],
            readings: readings.collect(),
            times,
            ..Flight::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_label_is_named_as_it_stands_in_the_file() {
        let stated = [("Disc:m1", "front"), ("m2", "left"), ("Other:m2", "none")];
        let labels = stated.map(|(label, name)| (label.to_owned(), name.to_owned()));
        let labels = BTreeMap::from(labels);
        let name = |label| name_of_label(&labels, label).map(String::as_str);
        assert_eq!(name("m1"), Some("front"));
        assert_eq!(name("Disc:m1"), Some("front"));
        assert_eq!(name("m2"), Some("left"));
        assert_eq!(name("m3"), None);
    }
}
