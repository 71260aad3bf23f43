//! Recognition of the format of a recording by its content.

use std::fmt;

use crate::takes::c3d::is_c3d;
use crate::takes::columns::{Column, Quantity};
use crate::takes::commented::with_bare_header;
use crate::takes::neighbours::columns_of;
use crate::takes::two_headers::joined;
use crate::takes::{Fault, Location, separator, shown};

/// File format of a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// C3D, the binary format of most motion-capture laboratories.
    C3d,
    /// CSV table of Vicon Nexus, of which the section `Trajectories` is read.
    Vicon,
    /// Table of point trajectories from Qualisys Track Manager.
    Qualisys,
    /// Table of rigid-body poses (6DOF) from Qualisys Track Manager.
    QualisysPoses,
    /// CSV table of OptiTrack Motive.
    OptiTrack,
    /// Points digitised in video by DLTdv8, with columns such as `pt1_X,pt1_Y,pt1_Z`.
    Dltdv,
    /// Table of rigid-body poses, whose header line names the columns of positions and quaternions.
    Poses,
    /// Table of point positions, whose header line names the column of each coordinate.
    Plain,
}

/// Maximum number of header lines before the first row of data in a Qualisys table.
pub(crate) const QUALISYS_HEADER: usize = 40;

/// First bytes of files that are not read, what they are, and what to do with them.
const OTHERS: [(&[u8], &str, &str); 8] = [
    (
        b"PK\x03\x04",
        "a ZIP archive",
        "a workbook is exported as CSV first",
    ),
    (
        b"\xD0\xCF\x11\xE0",
        "an Excel workbook",
        "it is exported as CSV first",
    ),
    (b"\x1F\x8B", "a gzip archive", "it is unpacked first"),
    (
        b"MATLAB 5.0",
        "a MATLAB file",
        "its arrays are written by `writetable` first",
    ),
    (
        b"\x89HDF",
        "an HDF5 file",
        "its arrays are written as CSV first",
    ),
    (
        b"PAR1",
        "a Parquet file",
        "it is written as CSV first, or given to `Dataset.from_pandas`",
    ),
    (
        b"\x93NUMPY",
        "a NumPy array",
        "it is written as CSV first, or given to `Dataset.from_arrays`",
    ),
    (
        b"Kaydara FBX",
        "an FBX scene",
        "its markers are exported as C3D or CSV first",
    ),
];

impl Format {
    /// All formats, each with its name in the option `--format` and its name in messages.
    pub const ALL: [(Self, &'static str, &'static str); 8] = [
        (Self::C3d, "c3d", "C3D"),
        (Self::Vicon, "vicon", "Vicon CSV"),
        (Self::Qualisys, "qualisys", "Qualisys TSV"),
        (Self::QualisysPoses, "qualisys-6dof", "Qualisys 6DOF TSV"),
        (Self::OptiTrack, "optitrack", "OptiTrack CSV"),
        (Self::Dltdv, "dltdv", "DLTdv8"),
        (Self::Poses, "poses", "table of poses"),
        (Self::Plain, "csv", "table of points"),
    ];

    /// Name of the format as a value of the option `--format`.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// Format whose name in the option `--format` is `name`, ignoring case; `None` for an unknown name.
    pub fn parse(name: &str) -> Option<Self> {
        let mut all = Self::ALL.iter();
        all.find(|(_, known, _)| known.eq_ignore_ascii_case(name))
            .map(|&(format, ..)| format)
    }

    /// Recognises the format of a file by its content: the first bytes and, for text, the first lines.
    pub(crate) fn recognise(bytes: &[u8]) -> Result<Self, Fault> {
        const EXPECTED: &str = "a recording: C3D, or a table of Vicon, Qualisys, OptiTrack, DLTdv8, of poses or of points \
                                (or its name in the option --format)";
        if is_c3d(bytes) {
            return Ok(Self::C3d);
        }
        let mut others = OTHERS.iter();
        if let Some((_, found, first)) = others.find(|(start, ..)| bytes.starts_with(start)) {
            let expected = format!("a recording; {first}");
            return Err(Fault::new(Location::Byte(0), *found, expected));
        }
        let text = joined(with_bare_header(crate::takes::file::text(bytes)?));
        let lines = || text.lines().zip(1..);
        let filled = |line: &str| !line.trim_matches([',', ';', '\t', ' ', '\r']).is_empty();
        let Some((first, line)) = lines().find(|(line, _)| filled(line) && !line.starts_with('#'))
        else {
            return Err(Fault::new(Location::Line(1), "an empty file", EXPECTED));
        };
        let keyword = first.split([',', ';', '\t']).next().unwrap_or_default();
        match keyword.trim().trim_matches('"') {
            "Trajectories" | "Devices" | "Model Outputs" | "Segments" | "Objects" | "Joints"
            | "Events" => Ok(Self::Vicon),
            "Format Version" => Ok(Self::OptiTrack),
            keyword if keyword.starts_with("NO_OF_") => {
                let has_bodies = lines().take(QUALISYS_HEADER).any(|(line, _)| {
                    line.starts_with("BODY_NAMES") || line.starts_with("NO_OF_BODIES")
                });
                Ok(if has_bodies {
                    Self::QualisysPoses
                } else {
                    Self::Qualisys
                })
            }
            "PathFileType" => {
                let found = "a TRC file";
                let expected = "another export of the recording, as C3D or CSV";
                Err(Fault::new(Location::Line(line), found, expected))
            }
            _ => by_columns(first).ok_or_else(|| {
                let found = if first.contains("speedMph") {
                    "releases (TechDisc), no tracks".to_owned()
                } else {
                    format!("the first line {}", shown(first))
                };
                Fault::new(Location::Line(line), found, EXPECTED)
            }),
        }
    }
}

/// Recognises the format of a table by the column names in its header line.
fn by_columns(header: &str) -> Option<Format> {
    let separator = separator(header);
    let names = header
        .split(separator)
        .map(|name| name.trim().trim_matches('"'));
    let names: Vec<&str> = names
        .filter(|name| separator != ' ' || !name.is_empty())
        .collect();
    let columns: Vec<Column> = columns_of(&names);
    let has = |wanted: fn(&Quantity) -> bool| columns.iter().any(|c| wanted(&c.quantity));
    if has(|q| matches!(q, Quantity::Quaternion(_))) {
        Some(Format::Poses)
    } else if !has(|q| matches!(q, Quantity::Coordinate(..))) {
        None
    } else if names.iter().all(|name| is_digitised(name)) {
        Some(Format::Dltdv)
    } else {
        Some(Format::Plain)
    }
}

/// Whether a column name has the form that DLTdv8 writes: `pt`, a number, `_`, and `X`, `Y` or `Z`.
pub(crate) fn is_digitised(name: &str) -> bool {
    let number = name
        .strip_prefix("pt")
        .and_then(|rest| rest.split_once('_'));
    number.is_some_and(|(number, axis)| {
        !number.is_empty()
            && number.bytes().all(|b| b.is_ascii_digit())
            && matches!(axis, "X" | "Y" | "Z")
    })
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(Self::ALL[*self as usize].2)
    }
}
