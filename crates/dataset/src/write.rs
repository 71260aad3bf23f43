//! Writes a dataset as a folder: atomically, and only if reading the folder gives an equal dataset.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};

use super::sensor::channels;
use super::{
    Dataset, Flight, Marker, Sensor, SensorKind, assemble, inputs, manifest, names, summary_text,
};
use crate::input_error::InputError;
use crate::toml_text::{key, known_text, list, quoted};
use flight::InputInterpolation;
use flight::files::{ResultFile, write_new_folder};

/// Writes a dataset as a folder with `dataset.toml` and one table per flight.
///
/// The folder is written atomically; an existing one is accepted if it is empty or already has this content.
///
/// # Errors
/// If reading the files would not give an equal dataset (for example because a flight is a C3D file or a marker has
/// no name), if the folder has other content, or on an I/O error.
pub fn write(folder: &Path, dataset: &Dataset) -> io::Result<()> {
    write_with(folder, dataset, &[])
}

/// Writes a dataset as [`write`](fn@write), with the files `beside` (name, text), which its reader ignores.
///
/// # Errors
/// Those of [`write`](fn@write), or if two files have the same name.
pub fn write_with(folder: &Path, dataset: &Dataset, beside: &[(String, String)]) -> io::Result<()> {
    write_commented(folder, dataset, beside, &[])
}

/// Writes a dataset as [`write_with`], with a comment from `comments` above the position of each marker.
///
/// # Errors
/// Those of [`write_with`].
pub fn write_commented(
    folder: &Path,
    dataset: &Dataset,
    beside: &[(String, String)],
    comments: &[String],
) -> io::Result<()> {
    let manifest = commented(&manifest_text(dataset), comments);
    let mut files = vec![("dataset.toml".to_owned(), manifest)];
    files.extend(tables(dataset));
    let text = |path: &Path| {
        if names::is_c3d(path) {
            let expected = "a table: C3D is read and not written";
            return Err(InputError::of_file(path, "a C3D file", expected));
        }
        Ok(text_of(&files[1..], path))
    };
    let read = read_back(&files[0].1, text).map_err(|error| invalid(error.to_string()))?;
    if read != *dataset {
        return Err(invalid(
            "the dataset holds values that no file does: a position or a time that is not finite, or too few of them".into(),
        ));
    }
    files.extend_from_slice(beside);
    let mut names = BTreeSet::new();
    if let Some((name, _)) = files.iter().find(|(name, _)| !names.insert(name.as_str())) {
        return Err(invalid(format!("two files {name} in one dataset")));
    }
    match files_below(folder, 2 * files.len())? {
        0 => {
            let files = files.into_iter();
            let files = files.map(|(name, text)| ResultFile::new(name, text));
            write_new_folder(folder, &files.collect::<Vec<_>>())
        }
        count if count == files.len() && files.iter().all(|file| is_written(folder, file)) => {
            Ok(())
        }
        _ => Err(io::Error::new(
            io::ErrorKind::AlreadyExists,
            "the folder holds something else, expected an empty or a new one",
        )),
    }
}

fn invalid(why: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, why)
}

fn is_written(folder: &Path, (name, text): &(String, String)) -> bool {
    std::fs::read(folder.join(name)).is_ok_and(|bytes| bytes == text.as_bytes())
}

/// Number of files in a folder and below it, counted to just above `most`; 0 for a folder that does not exist.
fn files_below(folder: &Path, most: usize) -> io::Result<usize> {
    let (mut count, mut left) = (0, vec![folder.to_path_buf()]);
    while let Some(next) = left.pop()
        && count + left.len() <= most
    {
        let entries = match std::fs::read_dir(&next) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            entries => entries?,
        };
        for entry in entries {
            let entry = entry?;
            match entry.file_type()?.is_dir() {
                true => left.push(entry.path()),
                false => count += 1,
            }
        }
    }
    Ok(count + left.len())
}

/// Names and texts of the tables of all flights, and of those of their inputs over time.
pub(super) fn tables(dataset: &Dataset) -> Vec<(String, String)> {
    let flights = dataset.flights.iter();
    let flights = flights.filter(|flight| !summary_text::is_of(flight, &dataset.sensors));
    let with_inputs = flights.clone().filter(|flight| !flight.inputs.is_empty());
    let of_inputs = with_inputs.map(|flight| (inputs_file(flight), inputs::text(&flight.inputs)));
    // Columns of summaries come last.
    let is_on_body = |sensor: &Sensor| !matches!(sensor.kind, SensorKind::Summary(_));
    let on_body = dataset.sensors.partition_point(is_on_body);
    let on_body = &dataset.sensors[..on_body];
    let of_flights = flights.map(|flight| {
        let text = table_text(flight, &dataset.markers, on_body);
        (flight.file.clone(), text)
    });
    let summaries = summary_text::tables(dataset);
    of_flights.chain(of_inputs).chain(summaries).collect()
}

/// Text of the table `path` among `tables`, as bytes; empty for another name.
pub(super) fn text_of<'t>(tables: &'t [(String, String)], path: &Path) -> Cow<'t, [u8]> {
    let own = tables.iter().find(|(name, _)| Path::new(name) == path);
    own.map_or(&[][..], |(_, text)| text.as_bytes()).into()
}

/// Reads a dataset without access to files.
pub(super) fn read_back<'t>(
    manifest: &str,
    table: impl Fn(&Path) -> Result<Cow<'t, [u8]>, InputError> + Sync,
) -> Result<Dataset, InputError> {
    let manifest = manifest::parse(Path::new("dataset.toml"), manifest)?;
    assemble(manifest, 1, |file| {
        let path = PathBuf::from(file);
        let text = table(&path)?;
        Ok((path, text, false))
    })
}

/// Text of the file `dataset.toml` that describes a dataset, without the samples of its flights.
pub fn manifest_text(dataset: &Dataset) -> String {
    let mut text = format!("model = {}\n", quoted(&dataset.model));
    for (index, (name, value)) in dataset.parameters.iter().enumerate() {
        let head = if index == 0 { "\n[parameters]\n" } else { "" };
        let _ = writeln!(text, "{head}{} = {value:?}", key(name));
    }
    if dataset.unknown_vertical {
        text.push_str("\n[recording]\nup = \"unknown\"\n");
    }
    if dataset.origin_error.is_some() || dataset.axis_error.is_some() {
        text.push_str("\n[template]\n");
    }
    if let Some(errors) = &dataset.origin_error {
        let _ = writeln!(text, "origin_error = {errors:?}");
    }
    if let Some(error) = &dataset.axis_error {
        let _ = writeln!(text, "axis_error = {error:?}");
    }
    for marker in &dataset.markers {
        let (name, position) = (quoted(&marker.name), &marker.position);
        let _ = writeln!(
            text,
            "\n[[markers]]\nname = {name}\nposition = {position:?}"
        );
    }
    let on_body = dataset.sensors.iter();
    for sensor in on_body.filter(|sensor| !matches!(sensor.kind, SensorKind::Summary(_))) {
        let (name, kind) = (quoted(&sensor.name), sensor.kind.name());
        let position = match sensor.position_is_unknown {
            true => quoted("unknown"),
            false => format!("{:?}", sensor.position),
        };
        let _ = writeln!(
            text,
            "\n[[sensors]]\nname = {name}\nkind = \"{kind}\"\nposition = {position}"
        );
        if let Some(sigma) = sensor.sigma {
            let _ = writeln!(text, "sigma = {sigma:?}");
        }
        if let Some(sigma) = sensor.sigma_angle {
            let _ = writeln!(text, "sigma_angle = {sigma:?}");
        }
    }
    if let Some(sigma) = dataset.sigma {
        let _ = writeln!(text, "\n[noise]\nsigma = {sigma:?}");
    }
    if let Some(names) = list(&dataset.unknown) {
        text.insert_str(0, &format!("unknown = {names}\n"));
    }
    if dataset.input_interpolation != InputInterpolation::default() {
        let mut words = InputInterpolation::NAMES.iter();
        let word = words.find(|(_, own)| *own == dataset.input_interpolation);
        let word = word.map_or("linear", |(word, _)| word);
        let _ = writeln!(text, "\n[inputs]\ninterpolation = \"{word}\"");
    }
    let tracks = dataset.flights.iter();
    for flight in tracks.filter(|flight| !summary_text::is_of(flight, &dataset.sensors)) {
        let role = flight.role.name();
        let file = quoted(&flight.file);
        let _ = writeln!(text, "\n[[flights]]\nfile = {file}\nrole = \"{role}\"");
        text += &known_text(flight);
        if let Some(names) = list(&flight.unknown) {
            let _ = writeln!(text, "unknown = {names}");
        }
        if !flight.inputs.is_empty() {
            let _ = writeln!(text, "inputs = {}", quoted(&inputs_file(flight)));
        }
    }
    text + &summary_text::manifest_text(dataset)
}

/// Name of the file with the inputs over time of a flight.
fn inputs_file(flight: &Flight) -> String {
    let stem = flight
        .file
        .rsplit_once('.')
        .map_or(&*flight.file, |(stem, _)| stem);
    format!("{stem}-inputs.csv")
}

/// Text of a flight's table without its inputs over time; each value has enough digits to be read back exactly.
pub fn table_text(flight: &Flight, markers: &[Marker], sensors: &[Sensor]) -> String {
    let mut text = "t".to_owned();
    for marker in markers {
        let name = &marker.name;
        let _ = write!(text, ",{name}_x,{name}_y,{name}_z");
    }
    let mut widths = Vec::new();
    for (sensor, endings) in channels(sensors) {
        widths.push(endings.len());
        for ending in endings {
            let _ = write!(text, ",{}{ending}", sensor.name);
        }
    }
    text.push('\n');
    for (sample, (time, row)) in flight.times.iter().zip(&flight.positions).enumerate() {
        let _ = write!(text, "{time}");
        for point in row {
            let _ = match point {
                Some([x, y, z]) => write!(text, ",{x},{y},{z}"),
                None => write!(text, ",,,"),
            };
        }
        let readings = flight.readings.get(sample).into_iter().flatten();
        for (reading, width) in readings.zip(&widths) {
            for part in 0..*width {
                let _ = match reading {
                    Some(reading) => write!(text, ",{}", reading[part]),
                    None => write!(text, ","),
                };
            }
        }
        text.push('\n');
    }
    text
}

/// The text of `dataset.toml` with a comment line inserted above the position of each marker.
fn commented(text: &str, comments: &[String]) -> String {
    let mut comments = comments.iter();
    let mut made = String::new();
    for line in text.lines() {
        if line.starts_with("position = ")
            && let Some(comment) = comments.next()
        {
            made += &format!("# {comment}\n");
        }
        made += line;
        made.push('\n');
    }
    made
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_marker_has_its_comment() {
        let text = "model = \"disc\"\n\n[[markers]]\nname = \"a\"\nposition = [0.1, 0.0, 0.0]\n\n[[markers]]\nname = \"b\"\nposition = [0.0, 0.1, 0.0]\n";
        let made = commented(text, &["one".to_owned(), "two".to_owned()]);
        assert!(made.contains("# one\nposition = [0.1"), "{made}");
        assert!(made.contains("# two\nposition = [0.0, 0.1"), "{made}");
    }
}
