//! Parquet tables of flights: writes and reads the tables of parts, and joins them without decoding.

use std::fs::File;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as PhysicalType};
use parquet::column::reader::ColumnReader;
use parquet::column::writer::ColumnCloseResult;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, PrimitiveTypeBuilder, Type};

use crate::parquet_table::write_column;
use crate::sweep::rows::{Column, Rows, STATUSES};
use flight::files::{Durability, write_atomic_with};

/// Name of the first column of the table of flights: the flight number, from 0.
const FLIGHT: &str = "flight";
/// Name of the last column of the table of flights: how the flight ended, a value of [`STATUSES`].
const STATUS: &str = "status";

/// Writes the table of one part atomically, without a sync: a part that cannot be read is computed again.
pub(crate) fn write(path: &Path, rows: &Rows) -> Result<(), ParquetError> {
    let properties = properties(&rows.columns);
    let schema = schema(rows.columns.iter().map(|column| column.name.as_str()))?;
    write_atomic_with(path, Durability::Renamed, |file| {
        let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties))?;
        let mut group = writer.next_row_group()?;
        let len = rows.status.len() as i64;
        let first = rows.first as i64;
        let numbers: Vec<i64> = (first..first + len).collect();
        write_column::<Int64Type, _>(&mut group, &numbers, None)?;
        for own in &rows.columns {
            write_column::<DoubleType, _>(&mut group, &own.values, None)?;
        }
        let names = STATUSES.map(ByteArray::from);
        let of = |status: &u8| names[usize::from(*status).min(names.len() - 1)].clone();
        let texts: Vec<ByteArray> = rows.status.iter().map(of).collect();
        write_column::<ByteArrayType, _>(&mut group, &texts, None)?;
        group.close()?;
        writer.close()?;
        Ok(())
    })
}

fn schema<'n>(names: impl Iterator<Item = &'n str>) -> Result<Arc<Type>, ParquetError> {
    fn column(name: &str, kind: PhysicalType) -> PrimitiveTypeBuilder<'_> {
        Type::primitive_type_builder(name, kind).with_repetition(Repetition::REQUIRED)
    }
    let mut fields = vec![Arc::new(column(FLIGHT, PhysicalType::INT64).build()?)];
    for name in names {
        fields.push(Arc::new(column(name, PhysicalType::DOUBLE).build()?));
    }
    let status = column(STATUS, PhysicalType::BYTE_ARRAY);
    let status = status
        .with_logical_type(Some(LogicalType::String))
        .build()?;
    fields.push(Arc::new(status));
    let schema = Type::group_type_builder("flights")
        .with_fields(fields)
        .build()?;
    Ok(Arc::new(schema))
}

fn properties(columns: &[Column]) -> WriterProperties {
    let mut properties = WriterProperties::builder()
        .set_created_by(concat!("hyzer ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_dictionary_enabled(false)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_offset_index_disabled(true)
        .set_column_dictionary_enabled(ColumnPath::from(STATUS), true)
        .set_column_dictionary_enabled(ColumnPath::from("steps"), true);
    // Values of a grid repeat, random values do not.
    for column in columns.iter().filter(|column| column.is_input) {
        let distinct = column.values.iter().take(64).map(|v| v.to_bits());
        let is_grid = distinct.collect::<std::collections::BTreeSet<_>>().len() < 32;
        let path = ColumnPath::from(column.name.as_str());
        properties = properties.set_column_dictionary_enabled(path, is_grid);
    }
    properties.build()
}

/// Reads the table of one part; the first `inputs` numeric columns are inputs.
pub(crate) fn read(path: &Path, inputs: usize) -> Result<Rows, ParquetError> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let mut rows = Rows::default();
    for group in 0..reader.num_row_groups() {
        let part = row_group(&reader, group, inputs)?;
        if group == 0 {
            rows = part;
            continue;
        }
        for (column, more) in rows.columns.iter_mut().zip(part.columns) {
            column.values.extend(more.values);
        }
        rows.status.extend(part.status);
    }
    Ok(rows)
}

/// Reads one row group; the first `inputs` numeric columns are inputs.
fn row_group(
    reader: &SerializedFileReader<File>,
    group: usize,
    inputs: usize,
) -> Result<Rows, ParquetError> {
    let group = reader.get_row_group(group)?;
    let len = group.metadata().num_rows().max(0) as usize;
    let mut rows = Rows::default();
    for index in 0..group.num_columns() {
        let column = group.metadata().column(index).column_descr();
        let name = column.name().to_owned();
        match group.get_column_reader(index)? {
            ColumnReader::Int64ColumnReader(mut column) => {
                let mut numbers = Vec::with_capacity(1);
                column.read_records(1, None, None, &mut numbers)?;
                rows.first = numbers.first().map_or(0, |first| *first as u64);
            }
            ColumnReader::DoubleColumnReader(mut column) => {
                let mut values = Vec::with_capacity(len);
                column.read_records(len, None, None, &mut values)?;
                let is_input = rows.columns.len() < inputs;
                rows.columns.push(Column {
                    name,
                    is_input,
                    values,
                });
            }
            ColumnReader::ByteArrayColumnReader(mut column) => {
                let mut texts = Vec::with_capacity(len);
                column.read_records(len, None, None, &mut texts)?;
                let of = |text: &ByteArray| {
                    let mut statuses = STATUSES.iter();
                    let own = statuses.position(|status| status.as_bytes() == text.data());
                    own.unwrap_or(0) as u8
                };
                rows.status = texts.iter().map(of).collect();
            }
            _ => {
                return Err(ParquetError::General(format!(
                    "the column {name} has another type"
                )));
            }
        }
    }
    Ok(rows)
}

/// Joins the tables of the parts, one row group per part, without decoding the columns.
pub(crate) fn join(
    path: &Path,
    parts: impl Iterator<Item = std::path::PathBuf>,
) -> Result<(), ParquetError> {
    write_atomic_with(path, Durability::Synced, |file| {
        let mut writer = None;
        let mut file = Some(file);
        for part in parts {
            let source = File::open(part)?;
            let reader = SerializedFileReader::new(source.try_clone()?)?;
            let metadata = reader.metadata();
            if let Some(file) = file.take() {
                let schema = metadata.file_metadata().schema_descr().root_schema_ptr();
                let properties = Arc::new(properties(&[]));
                writer = Some(SerializedFileWriter::new(file, schema, properties)?);
            }
            let Some(writer) = &mut writer else { continue };
            for group in metadata.row_groups() {
                let mut to = writer.next_row_group()?;
                for column in group.columns() {
                    let close = ColumnCloseResult {
                        bytes_written: column.compressed_size() as u64,
                        rows_written: group.num_rows() as u64,
                        metadata: column.clone(),
                        bloom_filter: None,
                        column_index: None,
                        offset_index: None,
                    };
                    to.append_column(&source, close)?;
                }
                to.close()?;
            }
        }
        if let Some(writer) = writer {
            writer.close()?;
        }
        Ok(())
    })
}

/// Landing places, m, of about `most` of the flights in the table at `from`; empty if the model has no place.
pub(crate) fn landings(
    from: &Path,
    inputs: usize,
    most: usize,
) -> Result<Vec<[f64; 2]>, ParquetError> {
    let reader = SerializedFileReader::new(File::open(from)?)?;
    let flights = reader.metadata().file_metadata().num_rows().max(0) as usize;
    let share = most as f64 / flights.max(1) as f64;
    let mut landings = Vec::new();
    for group in 0..reader.num_row_groups() {
        let rows = row_group(&reader, group, inputs)?;
        let column = |name: &str| rows.columns.iter().find(|column| column.name == name);
        let (Some(x), Some(y)) = (column("landing_x"), column("landing_y")) else {
            continue;
        };
        let all = (rows.first..).zip(x.values.iter().zip(&y.values));
        let all = all.zip(&rows.status);
        let chosen = all.filter(|((flight, (x, y)), status)| {
            let has_landed = STATUSES[usize::from(**status)] == "landed";
            is_drawn(*flight, share) && has_landed && x.is_finite() && y.is_finite()
        });
        landings.extend(chosen.map(|((_, (x, y)), _)| [*x, *y]));
    }
    Ok(landings)
}

/// Whether a flight is in the share of all; its number is scattered, as equal steps would meet few grid points.
fn is_drawn(flight: u64, share: f64) -> bool {
    // Fibonacci hashing, Knuth, The Art of Computer Programming 3, 6.4.
    let scattered = flight.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (scattered as f64) < share * u64::MAX as f64
}

/// Converts the table of flights to CSV, one row group at a time; missing values become empty cells.
pub(crate) fn to_csv(from: &Path, to: &Path, inputs: usize) -> Result<(), ParquetError> {
    let reader = SerializedFileReader::new(File::open(from)?)?;
    write_atomic_with(to, Durability::Synced, |file| {
        let mut out = io::BufWriter::new(file);
        for group in 0..reader.num_row_groups() {
            let rows = row_group(&reader, group, inputs)?;
            if group == 0 {
                write!(out, "{FLIGHT}")?;
                for column in &rows.columns {
                    write!(out, ",{}", column.name)?;
                }
                writeln!(out, ",{STATUS}")?;
            }
            for (row, status) in rows.status.iter().enumerate() {
                write!(out, "{}", rows.first + row as u64)?;
                for column in &rows.columns {
                    let value = column.values[row];
                    // A missing value is an empty cell, as in datasets.
                    if value.is_nan() {
                        write!(out, ",")?;
                    } else {
                        write!(out, ",{value}")?;
                    }
                }
                writeln!(out, ",{}", STATUSES[usize::from(*status)])?;
            }
        }
        out.flush()?;
        Ok(())
    })
}
