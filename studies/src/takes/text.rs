//! Writes takes in the text formats of laboratory programs: in mm, y up, with gaps.

use std::fmt::Write;

use super::session::Rows;

/// Program or library that writes a take (recording); each has its own file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Writer {
    Vicon,
    Qualisys,
    OptiTrack,
    /// The library ezc3d, which writes a C3D file from a table in Vicon's text format.
    C3d,
}

impl Writer {
    /// Name of the file format for the page of results, such as `"Qualisys TSV"`.
    pub fn label(self) -> &'static str {
        match self {
            Self::Vicon => "Vicon CSV",
            Self::Qualisys => "Qualisys TSV",
            Self::OptiTrack => "OptiTrack CSV",
            Self::C3d => "C3D by ezc3d",
        }
    }

    /// Formats the marker positions of a recording, sampled at `rate` (Hz), as the text of a file; for C3D, in Vicon's
    /// text format, which is converted to C3D afterwards.
    pub fn text(self, rows: &Rows, rate: f64) -> String {
        match self {
            Self::Vicon | Self::C3d => vicon(rows, rate),
            Self::Qualisys => qualisys(rows, rate),
            Self::OptiTrack => optitrack(rows, rate),
        }
    }
}

fn count(rows: &Rows) -> usize {
    rows.first().map_or(0, Vec::len)
}

/// Converts a position from metres with the z axis up to millimetres with the y axis up, by a rotation about the x
/// axis: (x, y, z) becomes (x, z, −y).
fn in_mm([x, y, z]: [f64; 3]) -> [f64; 3] {
    [1e3 * x, 1e3 * z, -1e3 * y]
}

/// Appends the marker coordinates of one sample, mm, to the text of a file, each preceded by `separator`. `gap` is
/// written for each coordinate of a missing marker.
fn add_cells(text: &mut String, row: &[Option<[f64; 3]>], separator: char, gap: &str) {
    for position in row {
        match position.map(in_mm) {
            Some(axes) => {
                for x in axes {
                    let _ = write!(text, "{separator}{x:.4}");
                }
            }
            None => {
                for _ in 0..3 {
                    let _ = write!(text, "{separator}{gap}");
                }
            }
        }
    }
}

fn vicon(rows: &Rows, rate: f64) -> String {
    let count = count(rows);
    let mut text = format!("Trajectories\n{rate}\n,");
    for k in 1..=count {
        let _ = write!(text, ",disc:m{k},,");
    }
    let _ = write!(text, "\nFrame,Sub Frame{}\n", ",X,Y,Z".repeat(count));
    let _ = writeln!(text, ",{}", ",mm,mm,mm".repeat(count));
    for (i, row) in rows.iter().enumerate() {
        let _ = write!(text, "{},0", i + 1);
        add_cells(&mut text, row, ',', "");
        text.push('\n');
    }
    text
}

fn qualisys(rows: &Rows, rate: f64) -> String {
    let names: Vec<String> = (1..=count(rows)).map(|k| format!("m{k}")).collect();
    let mut text = format!(
        "NO_OF_FRAMES\t{}\nNO_OF_CAMERAS\t8\nNO_OF_MARKERS\t{}\nFREQUENCY\t{rate}\nNO_OF_ANALOG\t0\nANALOG_FREQUENCY\t0\nDESCRIPTION\t--\nDATA_INCLUDED\t3D\nMARKER_NAMES\t{}\n",
        rows.len(),
        names.len(),
        names.join("\t")
    );
    for (i, row) in rows.iter().enumerate() {
        let _ = write!(text, "{}\t{:.5}", i + 1, i as f64 / rate);
        add_cells(&mut text, row, '\t', "0.000");
        text.push('\n');
    }
    text
}

fn optitrack(rows: &Rows, rate: f64) -> String {
    let count = count(rows);
    let frames = rows.len();
    let mut text = format!(
        "Format Version,1.23,Take Name,Take 1,Capture Frame Rate,{rate:.6},Export Frame Rate,{rate:.6},Total Frames in Take,{frames},Total Exported Frames,{frames},Rotation Type,Quaternion,Length Units,Millimeters,Coordinate Space,Global\n\n"
    );
    let mut line = |head: &str, cell: &dyn Fn(usize) -> String| {
        text += head;
        for k in 1..=count {
            for _ in 0..3 {
                let _ = write!(text, ",{}", cell(k));
            }
        }
        text.push('\n');
    };
    line(",Type", &|_| "Marker".into());
    line(",Name", &|k| format!("m{k}"));
    line(",ID", &|k| k.to_string());
    line(",", &|_| "Position".into());
    let _ = writeln!(text, "Frame,Time (Seconds){}", ",X,Y,Z".repeat(count));
    for (i, row) in rows.iter().enumerate() {
        let _ = write!(text, "{i},{:.6}", i as f64 / rate);
        add_cells(&mut text, row, ',', "");
        text.push('\n');
    }
    text
}
