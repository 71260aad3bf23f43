//! Columns of a launch monitor's table that are used, and their values.

use std::path::Path;

use super::cells::{Numerals, parts};
use super::headers::{quantity, read_header};
use super::{Row, ShotOptions};
use crate::input_error::InputError;
use crate::summary::{SummaryColumn, SummaryEvent, SummaryQuantity as Q, SummaryUnit};
use crate::summary_table::in_brackets;
use crate::words::{listed, shown};

/// A column that is used.
pub(super) struct Used {
    /// Where its values come from.
    pub source: Source,
    /// Its header in the table that is written.
    pub header: String,
    /// What it measures, in which unit.
    pub column: SummaryColumn,
}

/// Where the values of a column come from: the indices of columns of the export.
pub(super) enum Source {
    /// A column itself.
    Cell(usize),
    /// The root of the sum of the squares of backspin and sidespin, in the unit of the first.
    TotalSpin([Part; 2]),
    /// The angle from backspin to sidespin, deg.
    SpinAxis([Part; 2]),
}

/// A column of backspin or sidespin.
#[derive(Clone)]
pub(super) struct Part {
    /// Index of the column.
    pub place: usize,
    /// Its header.
    header: String,
    unit: SummaryUnit,
}

/// Columns of the options and those that are recognised, of a header, a row of units, and rows; of several of one
/// quantity the first.
pub(super) fn used(
    file: &Path,
    (headers, units, rows): (&[String], &[String], &[Row]),
    options: &ShotOptions,
) -> Result<Vec<Used>, InputError> {
    let fault = |found: String, expected: String| Err(InputError::of_file(file, found, expected));
    let mut used: Vec<Used> = Vec::new();
    for (header, is, unit) in &options.columns {
        let Some(place) = headers.iter().position(|own| own == header) else {
            return fault(format!("no column {}", shown(header)), listed(headers));
        };
        let names = || Q::all().map(Q::name);
        let Some(quantity) = Q::named(is) else {
            return fault(shown(is), format!("one of {}", listed(names())));
        };
        let stated = unit.as_deref().map(SummaryUnit::parse);
        let unit = match stated {
            Some(unit) => unit,
            None => {
                stated_unit(file, (headers, units), place)?.or_else(|| unit_in_cells(rows, place))
            }
        };
        used.push(Used::new(file, (place, header), quantity, unit)?);
    }
    for (place, header) in headers.iter().enumerate() {
        let (key, by_header) = read_header(header);
        let unit = unit_of(units, place)
            .or(by_header)
            .or_else(|| unit_in_cells(rows, place));
        let Some(quantity) = quantity(&key, unit) else {
            continue;
        };
        let is_taken = |other: &Used| other.reads(place) || other.column.quantity == quantity;
        if used.iter().any(is_taken) {
            continue;
        }
        stated_unit(file, (headers, units), place)?;
        let unit = unit.or_else(|| usual_unit(quantity));
        used.push(Used::new(file, (place, header), quantity, unit)?);
    }
    used.extend(of_parts(headers, units, &used));
    for part in used.iter().flat_map(Used::parts) {
        stated_unit(file, (headers, units), part.place)?;
    }
    let is_outcome = |own: &Used| own.column.quantity.event() != SummaryEvent::Release;
    if !used.iter().any(is_outcome) {
        let found = format!(
            "no column of what was seen after the release among {}",
            listed(headers)
        );
        let expected = "such as Carry or Max Height; --column \"HEADER=carry,yd\" names one";
        return fault(found, expected.to_owned());
    }
    used.sort_by_key(|own| own.column.quantity);
    Ok(used)
}

/// Unit that the row of units or the header states for a column.
///
/// # Errors
/// [`InputError`] if they state different ones.
fn stated_unit(
    file: &Path,
    (headers, units): (&[String], &[String]),
    place: usize,
) -> Result<Option<SummaryUnit>, InputError> {
    let (by_row, by_header) = (unit_of(units, place), read_header(&headers[place]).1);
    match (by_row, by_header) {
        (Some(own), Some(other)) if own != other => {
            let name = &headers[place];
            let found = format!("[{}] in the row of units below {}", own.name(), shown(name));
            let expected = format!("one unit: correct the table, or --column \"{name}=IS,UNIT\"");
            Err(InputError::of_file(file, found, expected))
        }
        _ => Ok(by_row.or(by_header)),
    }
}

/// Unit of a column by the row of units.
pub(super) fn unit_of(units: &[String], place: usize) -> Option<SummaryUnit> {
    SummaryUnit::parse(bare_unit(units.get(place)?))
}

/// Cell of a row of units without its brackets.
fn bare_unit(cell: &str) -> &str {
    cell.trim_matches(['[', ']', '(', ')'])
}

/// Unit of the first cell of a column that states one.
fn unit_in_cells(rows: &[Row], place: usize) -> Option<SummaryUnit> {
    let mut cells = rows.iter().filter_map(|(_, cells)| cells.get(place));
    cells.find_map(|cell| SummaryUnit::parse(parts(cell)?.unit))
}

/// Whether a row is one of units: a cell is in brackets; or one is a unit, and none has a number.
pub(super) fn is_units(cells: &[String]) -> bool {
    let is_unit = |cell: &String| SummaryUnit::parse(bare_unit(cell)).is_some();
    cells.iter().any(|cell| in_brackets(cell).is_some())
        || (cells.iter().any(is_unit)
            && cells
                .iter()
                .all(|cell| is_unit(cell) || parts(cell).is_none()))
}

/// Total spin and spin axis from backspin and sidespin, as far as the export has no column of these.
fn of_parts(headers: &[String], units: &[String], used: &[Used]) -> Vec<Used> {
    let part = |key: &str| {
        let mut all = headers.iter().enumerate();
        all.find_map(|(place, header)| {
            let (own, by_header) = read_header(header);
            let unit = unit_of(units, place).or(by_header);
            let unit = unit.or_else(|| usual_unit(Q::Spin))?;
            let is_part = own == key
                && unit.dimension() == Q::Spin.dimension()
                && !used.iter().any(|used| used.reads(place));
            is_part.then(|| Part {
                place,
                header: header.clone(),
                unit,
            })
        })
    };
    let (Some(back), Some(side)) = (part("backspin"), part("sidespin")) else {
        return Vec::new();
    };
    let spin_unit = back.unit;
    let parts = [back, side];
    let all = [
        (
            Q::Spin,
            "Total Spin",
            Some(spin_unit),
            Source::TotalSpin(parts.clone()),
        ),
        (
            Q::SpinAxis,
            "Spin Axis",
            usual_unit(Q::SpinAxis),
            Source::SpinAxis(parts),
        ),
    ];
    let own = all
        .into_iter()
        .filter_map(|(quantity, name, unit, source)| {
            let is_taken = |used: &Used| used.column.quantity == quantity || used.header == name;
            let column = SummaryColumn {
                quantity,
                unit: unit?,
                is_mirrored: false,
            };
            (!used.iter().any(is_taken)).then(|| Used {
                source,
                header: name.to_owned(),
                column,
            })
        });
    own.collect()
}

/// Unit that angles and spins have in every export; lengths and speeds need theirs.
fn usual_unit(quantity: Q) -> Option<SummaryUnit> {
    match quantity.dimension().si() {
        "rad" => SummaryUnit::parse("deg"),
        "rad/s" => SummaryUnit::parse("rpm"),
        "s" => SummaryUnit::parse("s"),
        _ => None,
    }
}

impl Used {
    /// Whether the column reads the one with the index `place` of the export.
    pub fn reads(&self, place: usize) -> bool {
        match &self.source {
            Source::Cell(own) => *own == place,
            _ => self.parts().iter().any(|part| part.place == place),
        }
    }

    /// The columns from which this one is made; none for a column of the export.
    fn parts(&self) -> &[Part] {
        match &self.source {
            Source::Cell(_) => &[],
            Source::TotalSpin(parts) | Source::SpinAxis(parts) => parts,
        }
    }

    /// Text on the columns from which this one is made; empty for a column of the export.
    pub fn origin(&self) -> String {
        match self.parts() {
            [back, side] => format!(", from {} and {}", shown(&back.header), shown(&side.header)),
            _ => String::new(),
        }
    }

    /// Value of the column in a row, in its unit; the error tells the cell, what was found and what was expected.
    pub fn value(&self, cells: &[String], numerals: Numerals) -> Result<Option<f64>, String> {
        let read = |place: usize, unit: SummaryUnit, has_sides: bool| {
            let cell = cells.get(place).map_or("", String::as_str);
            let value = numerals.value(cell, unit, has_sides);
            value.map_err(|why| format!("cell {}, {why}", place + 1))
        };
        let both = |[back, side]: &[Part; 2]| {
            let back_value = read(back.place, back.unit, false)?;
            let side_value = read(side.place, side.unit, true)?;
            let ratio = side.unit.si() / back.unit.si();
            let side_value = side_value.map(|value| value * ratio);
            Ok::<_, String>(back_value.zip(side_value))
        };
        Ok(match &self.source {
            Source::Cell(place) => {
                let has_sides = self.column.quantity.is_positive_right().is_some();
                read(*place, self.column.unit, has_sides)?
            }
            Source::TotalSpin(parts) => both(parts)?.map(|(back, side)| back.hypot(side)),
            Source::SpinAxis(parts) => {
                let axis = |(back, side): (f64, f64)| side.atan2(back) / self.column.unit.si();
                both(parts)?.map(axis)
            }
        })
    }

    fn new(
        file: &Path,
        (place, header): (usize, &str),
        quantity: Q,
        unit: Option<SummaryUnit>,
    ) -> Result<Self, InputError> {
        let unit = unit.filter(|unit| unit.dimension() == quantity.dimension());
        let Some(unit) = unit else {
            let name = quantity.name();
            let found = format!(
                "no unit of the column {}, which is the {name}",
                shown(header)
            );
            let units = listed(SummaryUnit::of(quantity.dimension()));
            let expected =
                format!("a second row of units, or --column \"{header}={name},UNIT\" with {units}");
            return Err(InputError::of_file(file, found, expected));
        };
        // Launch monitors count what has sides positive to the right.
        let is_mirrored = quantity.is_positive_right() == Some(false);
        Ok(Self {
            source: Source::Cell(place),
            header: header.to_owned(),
            column: SummaryColumn {
                quantity,
                unit,
                is_mirrored,
            },
        })
    }
}
