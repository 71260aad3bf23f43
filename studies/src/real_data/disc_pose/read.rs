//! Reads poses of a tag on a disc and rotates them to upright axes, defined by a tag at rest on the ground.

use std::path::Path;

use dataset::{Flight, Reading};
use nalgebra::{Quaternion, Rotation3, UnitQuaternion, Vector3};

use crate::error::StudyError;
use crate::real_data::files::{absent, bad_line, rows, text_of};

/// Range of the time since the first sample of a file in which the poses are used, s. Poses after this range are wrong,
/// because the tracking of the printed tag was lost.
pub(super) const FOLLOWED: (f64, f64) = (0.03, 0.25);

/// Name of the file with the measured poses of the printed tag at rest on the ground.
const GROUND: &str = "groundplanesample_part.csv";

/// Names of files that are not used as throws: another processing of `drive16`, a file with angles instead of a
/// quaternion, and a file in which the label of the printed tag changed.
const LEFT_OUT: [&str; 3] = ["drive17.csv", "throw0.csv", "drive14fliplabel.csv"];

/// Header line of a table of measured poses (time, position, attitude quaternion).
const HEADER: &str = "t_s,x_m,y_m,z_m,qw,qx,qy,qz";

/// One row of a table of poses of the printed tag: time, s; position in camera axes, m; and attitude, as the rotation
/// from the tag's to the camera's axes.
type Row = (f64, Vector3<f64>, UnitQuaternion<f64>);

/// The measured throws in axes with z up. The upward direction is estimated from a tag at rest on the ground.
pub(super) struct Poses {
    /// Flights in axes with z up, with one pose per sample.
    pub flights: Vec<Flight>,
    /// Upward direction in the axes of the camera, from the poses of a tag at rest on the ground.
    pub up: [f64; 3],
    /// RMS angle between the measured normals of a tag at rest on the ground and their mean, rad.
    pub scatter: f64,
}

impl Poses {
    /// Reads the tables of poses in a folder: one of the tag on the ground, and one for each throw.
    pub fn read(folder: &Path) -> Result<Self, StudyError> {
        let ground = table(&folder.join(GROUND))?;
        // The third axis of the tag points into the surface to which the tag is attached.
        let normals = || ground.iter().map(|(.., turn)| -(turn * Vector3::z()));
        let up = normals().sum::<Vector3<f64>>().normalize();
        let squares: f64 = normals().map(|normal| normal.angle(&up).powi(2)).sum();
        let upright = Rotation3::rotation_between(&up, &Vector3::z())
            .ok_or_else(|| absent(&folder.join(GROUND), "a tag that lies flat"))?;
        let upright = UnitQuaternion::from_rotation_matrix(&upright);
        let is_throw = |name: &String| {
            name.ends_with(".csv") && name != GROUND && !LEFT_OUT.contains(&name.as_str())
        };
        let flights = names(folder)?.into_iter().filter(is_throw).map(|name| {
            let rows = table(&folder.join(&name))?;
            let start = rows.first().map_or(0.0, |row| row.0);
            let within = |row: &&Row| (FOLLOWED.0..=FOLLOWED.1).contains(&(row.0 - start));
            let rows: Vec<Row> = rows.iter().filter(within).copied().collect();
            // The body's third axis is the tag's third axis reversed, upwards.
            let over = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI);
            let reading = |(_, place, turn): &Row| -> Vec<Option<Reading>> {
                let place = upright * place;
                let turn = upright * turn * over;
                vec![
                    Some([place.x, place.y, place.z, 0.0]),
                    Some([turn.w, turn.i, turn.j, turn.k]),
                ]
            };
            Ok(Flight {
                file: name,
                times: rows.iter().map(|row| row.0 - start).collect(),
                positions: vec![Vec::new(); rows.len()],
                readings: rows.iter().map(reading).collect(),
                ..Flight::default()
            })
        });
        Ok(Self {
            flights: flights.collect::<Result<_, StudyError>>()?,
            up: up.into(),
            scatter: (squares / ground.len().max(1) as f64).sqrt(),
        })
    }
}

/// Names of the files in a folder, in alphabetical order.
fn names(folder: &Path) -> Result<Vec<String>, StudyError> {
    let failed = |source| StudyError::Unreadable {
        file: folder.to_owned(),
        source,
    };
    let entries = std::fs::read_dir(folder).map_err(failed)?;
    let name = |entry: std::io::Result<std::fs::DirEntry>| {
        Ok(entry?.file_name().to_string_lossy().into_owned())
    };
    let names: std::io::Result<Vec<String>> = entries.map(name).collect();
    let mut names = names.map_err(failed)?;
    names.sort();
    Ok(names)
}

/// Reads the rows of a table that contain a pose; rows without one and rows out of time order are skipped.
fn table(file: &Path) -> Result<Vec<Row>, StudyError> {
    let text = text_of(file)?;
    if text.lines().next().map(str::trim) != Some(HEADER) {
        return Err(absent(file, HEADER));
    }
    let mut found: Vec<Row> = Vec::new();
    for row in rows(&text, 1) {
        let cells = row.1.split(',').map(|cell| cell.trim().parse::<f64>());
        let Ok(cells) = cells.collect::<Result<Vec<f64>, _>>() else {
            return Err(bad_line(file, row, HEADER));
        };
        let &[time, x, y, z, qw, qx, qy, qz] = &cells[..] else {
            return Err(bad_line(file, row, HEADER));
        };
        let turn = UnitQuaternion::from_quaternion(Quaternion::new(qw, qx, qy, qz));
        let is_later = found.last().is_none_or(|before| time > before.0);
        if cells.iter().all(|cell| cell.is_finite()) && is_later {
            found.push((time, Vector3::new(x, y, z), turn));
        }
    }
    match found.is_empty() {
        true => Err(absent(file, "poses")),
        false => Ok(found),
    }
}
