//! Tables of columns as Parquet.

use std::io::Write;
use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as PhysicalType};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;

/// Cells of a column; `None` for an empty one.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Numbers.
    Numbers(Vec<Option<f64>>),
    /// Texts.
    Texts(Vec<Option<String>>),
}

impl Cells {
    /// Numbers if every cell that is not empty is one, else texts.
    pub fn of(cells: Vec<Option<String>>) -> Cells {
        let number = |cell: &Option<String>| cell.as_ref().map(|text| text.parse::<f64>());
        let numbers: Option<Vec<Option<f64>>> = cells
            .iter()
            .map(|cell| number(cell).transpose().ok())
            .collect();
        match numbers {
            Some(numbers) if numbers.iter().any(Option::is_some) => Cells::Numbers(numbers),
            _ => Cells::Texts(cells),
        }
    }
}

/// Bytes of a Parquet file with named columns of equal length, each with empty cells or without.
///
/// # Errors
/// If the columns cannot be a table: two names alike, or lengths that differ.
pub fn parquet_table(columns: &[(String, Cells)]) -> Result<Vec<u8>, ParquetError> {
    let field = |(name, cells): &(String, Cells)| {
        let (kind, logical) = match cells {
            Cells::Numbers(_) => (PhysicalType::DOUBLE, None),
            Cells::Texts(_) => (PhysicalType::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let field = Type::primitive_type_builder(name, kind)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(logical)
            .build()?;
        Ok(Arc::new(field))
    };
    let fields = columns.iter().map(field);
    let fields = fields.collect::<Result<Vec<_>, ParquetError>>()?;
    let schema = Type::group_type_builder("table")
        .with_fields(fields)
        .build()?;
    let properties = WriterProperties::builder()
        .set_created_by(concat!("hyzer ", env!("CARGO_PKG_VERSION")).to_owned())
        .build();
    let mut writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    for (_, cells) in columns {
        match cells {
            Cells::Numbers(cells) => {
                let (values, levels) = present(cells);
                write_column::<DoubleType, _>(&mut group, &values, Some(&levels))?;
            }
            Cells::Texts(cells) => {
                let (texts, levels) = present(cells);
                let texts = texts.iter().map(|text| ByteArray::from(text.as_str()));
                let texts: Vec<ByteArray> = texts.collect();
                write_column::<ByteArrayType, _>(&mut group, &texts, Some(&levels))?;
            }
        }
    }
    group.close()?;
    writer.into_inner()
}

/// Writes the next column of a group, with the definition levels of its cells if they may be empty.
pub(crate) fn write_column<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[T::T],
    levels: Option<&[i16]>,
) -> Result<(), ParquetError> {
    if let Some(mut column) = group.next_column()? {
        column.typed::<T>().write_batch(values, levels, None)?;
        column.close()?;
    }
    Ok(())
}

/// The cells that are not empty, and for each cell the definition level of Parquet: 1, or 0 if it is empty.
fn present<T: Clone>(cells: &[Option<T>]) -> (Vec<T>, Vec<i16>) {
    let levels = cells.iter().map(|cell| i16::from(cell.is_some()));
    (cells.iter().flatten().cloned().collect(), levels.collect())
}

#[cfg(test)]
mod tests {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;

    use super::*;

    #[test]
    fn numbers_texts_and_empty_cells_are_read_back() {
        let cells = |texts: &[&str]| {
            let cell = |text: &&str| Some((*text).to_owned()).filter(|text| !text.is_empty());
            Cells::of(texts.iter().map(cell).collect())
        };
        assert_eq!(cells(&["", ""]), Cells::Texts(vec![None, None]));
        let columns = [
            ("name".to_owned(), cells(&["C_L0", "", "1"])),
            ("value".to_owned(), cells(&["1e-3", "", "2"])),
        ];
        let bytes = parquet_table(&columns).unwrap();
        let file = tempfile::tempfile().unwrap();
        std::io::Write::write_all(&mut &file, &bytes).unwrap();
        let reader = SerializedFileReader::new(file).unwrap();
        let rows: Vec<_> = reader.get_row_iter(None).unwrap().flatten().collect();
        assert_eq!(rows.len(), 3);
        assert_eq!(rows[0].get_string(0).unwrap(), "C_L0");
        assert_eq!(rows[0].get_double(1).unwrap(), 1e-3);
        assert!(rows[1].get_double(1).is_err() && rows[1].get_string(0).is_err());
        assert_eq!(rows[2].get_string(0).unwrap(), "1");
    }
}
