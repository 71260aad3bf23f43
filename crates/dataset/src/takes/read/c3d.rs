//! Reader of the points of a C3D file.

use crate::takes::c3d::Recording;
use crate::takes::{
    Axis, Fault, Format, LengthUnit, Location, MAX_COORDINATE, MAX_LABELS, MAX_POSITIONS, Point,
    ReadOptions, Take, shown, unique,
};

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<Take, Fault> {
    let recording = Recording::open(bytes)?;
    let mut notes = Vec::new();
    for deviation in &recording.deviations {
        notes.push(format!(
            "found {}, expected {}: read as {}",
            deviation.contradiction.found, deviation.contradiction.expected, deviation.read_as
        ));
    }
    let length = length(&recording, options, &mut notes)?;
    let rate = match (recording.rate(), options.rate) {
        (Ok(rate), _) => options.rate(Some(rate), Location::Byte(20), &mut notes)?,
        (Err(error), Some(_)) => {
            notes.push(format!("found {}: the option --rate was used", error.found));
            options.rate(None, Location::Byte(20), &mut notes)?
        }
        (Err(mut error), None) => {
            error.expected += ", or the option --rate";
            return Err(error);
        }
    };
    let named = recording.points.min(recording.labels.len());
    let labelled: Vec<usize> = (0..named)
        .filter(|&index| !recording.labels[index].is_empty())
        .collect();
    let unnamed = recording.points - labelled.len();
    if unnamed > 0 {
        notes.push(format!("{unnamed} points without a label were left out"));
    }
    let frames = recording.frames();
    let cells = frames.checked_mul(labelled.len().max(1));
    if labelled.len() > MAX_LABELS || cells.is_none_or(|cells| cells > MAX_POSITIONS) {
        let found = format!("{frames} frames of {} points", labelled.len());
        let expected = format!("at most {MAX_POSITIONS} positions of at most {MAX_LABELS} points");
        return Err(Fault::new(Location::Byte(0), found, expected));
    }
    let first = f64::from(recording.first_frame());
    let mut points = Vec::with_capacity(labelled.len());
    for index in labelled {
        let label = recording.labels[index].clone();
        let mut positions = Vec::with_capacity(frames);
        for frame in 0..frames {
            let position = recording.position(frame, index);
            let position = position.map(|raw| raw.map(|x| x * length.metres()));
            let is_far = |x: &f64| x.is_nan() || x.abs() > MAX_COORDINATE;
            if let Some(far) = position.iter().flatten().find(|x| is_far(x)) {
                let found = format!("{} at {far} m", shown(&label));
                let expected = format!("at most {MAX_COORDINATE} m (another unit?)");
                let byte = Location::Byte(recording.byte_of_frame(frame));
                return Err(Fault::new(byte, found, expected));
            }
            positions.push(position);
        }
        points.push(Point { label, positions });
    }
    let up = up(&recording, &mut notes);
    let mut take = Take {
        format: Format::C3d,
        times: (0..frames)
            .map(|frame| (first + frame as f64) / rate)
            .collect(),
        points,
        bodies: Vec::new(),
        length,
        up,
        left_handed: Some(false),
        notes,
    };
    unique(&mut take);
    Ok(take)
}

/// Axis that points up: from the force platforms, otherwise the one that `POINT:Y_SCREEN` draws upwards, or `None`.
fn up(recording: &Recording<'_>, notes: &mut Vec<String>) -> Option<Axis> {
    let drawn = recording.screen_up().and_then(|text| Axis::parse(&text));
    let floor = recording.floor_up();
    match (floor, drawn) {
        (Some(up), Some(drawn)) if up != drawn => notes.push(format!(
            "POINT:Y_SCREEN draws {drawn} upwards, and the corners of the force platforms say that {up} is up: read as {up} up"
        )),
        (Some(up), None) => notes.push(format!("{up} is up by the corners of the force platforms")),
        (None, Some(up)) => notes.push(format!(
            "{up} is up by POINT:Y_SCREEN, the axis that is drawn upwards; --up states another"
        )),
        _ => {}
    }
    floor.or(drawn)
}

/// Unit of the coordinates: the user's unit in `options` if it is given, otherwise the unit specified in the file.
fn length(
    recording: &Recording<'_>,
    options: &ReadOptions,
    notes: &mut Vec<String>,
) -> Result<LengthUnit, Fault> {
    match (recording.unit(), options.length) {
        (Ok((unit, text)), _) => {
            if !LengthUnit::is_whole_name(&text) {
                notes.push(format!("the unit {} was read as {unit}", shown(&text)));
            }
            options.length(Some(unit), Location::Byte(0), notes)
        }
        (Err(error), Some(unit)) => {
            notes.push(format!(
                "found {}: the option --length was used",
                error.found
            ));
            Ok(unit)
        }
        (Err(mut error), None) => {
            error.expected += ", or the option --length";
            Err(error)
        }
    }
}
