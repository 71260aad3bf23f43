//! Recordings made for tests: one motion in every format.

pub mod clean;
pub mod spun;
pub mod thrown;

use std::path::Path;

pub use crate::support::c3d;

use dataset::takes::{ReadOptions, Take, parse};

/// Number of samples of the example recording.
pub const SAMPLES: usize = 12;
/// Frame rate of the example recording, Hz.
pub const RATE: f64 = 120.0;
/// Labels of the points in the example recording.
pub const LABELS: [&str; 3] = ["m1", "m2", "rim left"];

/// Position of a point in a sample of the example recording, m. The second point is missing in sample 4.
pub fn truth(sample: usize, point: usize) -> Option<[f64; 3]> {
    if (sample, point) == (4, 1) {
        return None;
    }
    let (s, p) = (sample as f64, point as f64);
    Some([
        0.125 * s + 0.0625 * p,
        -0.5 + 0.25 * p,
        1.5 + 0.03125 * s - 0.125 * p,
    ])
}

/// Attitude of the body in a sample of the example recording, as unit quaternion w, x, y, z.
pub fn attitude(sample: usize) -> [f64; 4] {
    let half = 0.1 * sample as f64;
    [half.cos(), 0.6 * half.sin(), 0.0, 0.8 * half.sin()]
}

/// Table cells of all point coordinates in a sample of the example recording, multiplied by `scale`. `gap` is written
/// for each coordinate of a missing point.
pub fn cells(sample: usize, scale: f64, gap: &str) -> Vec<String> {
    let mut cells = Vec::new();
    for point in 0..LABELS.len() {
        match truth(sample, point) {
            Some(position) => cells.extend(position.map(|x| (x * scale).to_string())),
            None => cells.extend([gap; 3].map(str::to_owned)),
        }
    }
    cells
}

fn rows(separator: &str, mut row: impl FnMut(usize) -> Vec<String>) -> String {
    (0..SAMPLES)
        .map(|sample| row(sample).join(separator) + "\n")
        .collect()
}

/// Example recording as a table of Vicon Nexus.
pub fn vicon() -> String {
    let mut text = "Trajectories\n120\n,".to_owned();
    for label in LABELS {
        text += &format!(",disc:{label},,");
    }
    text += "\nFrame,Sub Frame,X,Y,Z,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm,mm,mm,mm\n";
    text + &rows(",", |sample| {
        let mut row = vec![(sample + 1).to_string(), "0".into()];
        row.extend(cells(sample, 1e3, ""));
        row
    })
}

/// Example recording as a table of Qualisys, optionally with columns of frame number and time and with a line of column
/// titles.
pub fn qualisys(with_times: bool, with_titles: bool) -> String {
    let labels = LABELS.join("\t");
    let mut text = format!(
        "NO_OF_FRAMES\t{SAMPLES}\nNO_OF_CAMERAS\t8\nNO_OF_MARKERS\t3\nFREQUENCY\t120\nNO_OF_ANALOG\t0\n\
         ANALOG_FREQUENCY\t0\nDESCRIPTION\t--\nTIME_STAMP\t2026-01-01, 10:00:00.000\t1.5\nDATA_INCLUDED\t3D\n\
         MARKER_NAMES\t{labels}\n"
    );
    if with_titles {
        let axes = LABELS
            .iter()
            .flat_map(|label| ["X", "Y", "Z"].map(|a| format!("{label} {a}")));
        let mut titles: Vec<String> = axes.collect();
        if with_times {
            titles.splice(0..0, ["Frame".to_owned(), "Time".to_owned()]);
        }
        text += &(titles.join("\t") + "\n");
    }
    text + &rows("\t", |sample| {
        let mut row = Vec::new();
        if with_times {
            row.extend([(sample + 1).to_string(), (sample as f64 / RATE).to_string()]);
        }
        row.extend(cells(sample, 1e3, "0.000"));
        row
    })
}

/// Rotation matrix of a unit quaternion w, x, y, z, row by row.
pub fn matrix([w, x, y, z]: [f64; 4]) -> [f64; 9] {
    [
        1.0 - 2.0 * (y * y + z * z),
        2.0 * (x * y - w * z),
        2.0 * (x * z + w * y),
        2.0 * (x * y + w * z),
        1.0 - 2.0 * (x * x + z * z),
        2.0 * (y * z - w * x),
        2.0 * (x * z - w * y),
        2.0 * (y * z + w * x),
        1.0 - 2.0 * (x * x + y * y),
    ]
}

/// Example recording of one rigid body, which is missing in sample 4, as a table of Qualisys.
pub fn qualisys_poses() -> String {
    let mut text = format!(
        "NO_OF_FRAMES\t{SAMPLES}\nNO_OF_CAMERAS\t8\nNO_OF_BODIES\t1\nFREQUENCY\t120\nDATA_INCLUDED\t6D\nBODY_NAMES\tdisc\n\
         Frame\tTime\tdisc X\tY\tZ\tRoll\tPitch\tYaw\tResidual"
    );
    for entry in 0..9 {
        text += &format!("\tRot[{entry}]");
    }
    text.push('\n');
    text + &rows("\t", |sample| {
        let mut row = vec![(sample + 1).to_string(), (sample as f64 / RATE).to_string()];
        if sample == 4 {
            row.extend(["0.000"; 6].map(str::to_owned));
            row.push("-1".into());
            row.extend(["0.000"; 9].map(str::to_owned));
            return row;
        }
        let position = truth(sample, 0).expect("seen");
        row.extend(position.map(|x| (1e3 * x).to_string()));
        row.extend(["1.0", "2.0", "3.0", "0.1"].map(str::to_owned));
        let m = matrix(attitude(sample));
        let by_columns = [0, 3, 6, 1, 4, 7, 2, 5, 8].map(|i| format!("{:.9}", m[i]));
        row.extend(by_columns);
        row
    })
}

/// Example recording of a rigid body and its markers as a table of OptiTrack Motive.
pub fn optitrack() -> String {
    let kinds = |first: &str, body: &str, error: &str, point: &str| {
        let mut row = vec![String::new(), first.to_owned()];
        row.extend([body; 7].map(str::to_owned));
        row.push(error.to_owned());
        let points = LABELS.iter().flat_map(|label| {
            let cell = if point.is_empty() {
                (*label).to_owned()
            } else {
                point.to_owned()
            };
            [cell.clone(), cell.clone(), cell]
        });
        row.extend(points);
        row.join(",") + "\n"
    };
    let mut text = format!(
        "Format Version,1.23,Take Name,Take 1,Capture Frame Rate,120.000000,Export Frame Rate,120.000000,\
         Total Frames in Take,{SAMPLES},Total Exported Frames,{SAMPLES},Rotation Type,Quaternion,Length Units,Meters,\
         Coordinate Space,Global\n\n"
    );
    text += &kinds("Type", "Rigid Body", "Rigid Body", "Marker");
    text += &kinds("Name", "disc", "disc", "");
    text += &kinds("ID", "1", "1", "2");
    let position = ["Position"; 9].join(",");
    text += &format!(
        ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Mean Marker Error,{position}\n"
    );
    text += "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,,X,Y,Z,X,Y,Z,X,Y,Z\n";
    text + &rows(",", |sample| {
        let mut row = vec![sample.to_string(), (sample as f64 / RATE).to_string()];
        if sample == 4 {
            row.extend([""; 8].map(str::to_owned));
        } else {
            let [w, x, y, z] = attitude(sample);
            row.extend([x, y, z, w].map(|q| q.to_string()));
            row.extend(truth(sample, 0).expect("seen").map(|x| x.to_string()));
            row.push("0.0002".into());
        }
        row.extend(cells(sample, 1.0, ""));
        row
    })
}

/// Example recording as a table of DLTdv8.
pub fn dltdv() -> String {
    let head: Vec<String> = (1..=3)
        .flat_map(|point| ["X", "Y", "Z"].map(|axis| format!("pt{point}_{axis}")))
        .collect();
    head.join(",") + "\n" + &rows(",", |sample| cells(sample, 1.0, "NaN"))
}

/// Example recording of poses as a table with units in its header line.
pub fn poses() -> String {
    let head = "t_s,x_m,y_m,z_m,qw,qx,qy,qz\n".to_owned();
    head + &rows(",", |sample| {
        let mut row = vec![(sample as f64 / RATE).to_string()];
        if sample == 4 {
            row.extend([""; 7].map(str::to_owned));
            return row;
        }
        row.extend(truth(sample, 0).expect("seen").map(|x| x.to_string()));
        row.extend(attitude(sample).map(|x| x.to_string()));
        row
    })
}

/// Example recording of points as a table with units in its header line.
pub fn plain() -> String {
    let names = LABELS
        .iter()
        .flat_map(|label| ["x", "y", "z"].map(|a| format!("{label}_{a} (mm)")));
    let names: Vec<String> = names.collect();
    let head = format!("time (ms),{}\n", names.join(","));
    head + &rows(",", |sample| {
        let mut row = vec![(1e3 * sample as f64 / RATE).to_string()];
        row.extend(cells(sample, 1e3, ""));
        row
    })
}

/// Example recording as a C3D file.
pub fn c3d() -> c3d::File {
    let row = |sample| {
        let position = |point| truth(sample, point).map(|p| p.map(|x| (1e3 * x) as f32));
        (0..LABELS.len()).map(position).collect()
    };
    c3d::File::new(&LABELS, (0..SAMPLES).map(row).collect())
}

/// Parses the bytes of a recording under the file name `take`; returns the error as text.
pub fn read(bytes: &[u8], options: &ReadOptions) -> Result<Take, String> {
    parse(Path::new("take"), bytes, options).map_err(|error| error.to_string())
}
