//! Columns of an export that hold numbers and are not read.

use super::Row;
use super::cells::Numerals;
use super::columns::{Used, unit_of};
use super::headers::{quantity, read_header};
use crate::summary::{SummaryQuantity as Q, SummaryUnit};
use crate::words::shown;

/// Headers of columns that number the shots, as the keys of headers.
const COUNTS: [&str; 7] = ["", "shot", "shotno", "shotnumber", "no", "number", "id"];

/// Lines on what is not read: the columns of numbers, each with the option that would read it, and speed and spin.
pub(super) fn unread(
    headers: &[String],
    units: &[String],
    rows: &[Row],
    used: &[Used],
    numerals: Numerals,
) -> Vec<String> {
    let mut lines = Vec::new();
    for (place, header) in headers.iter().enumerate() {
        let (key, by_header) = read_header(header);
        let cells = rows.iter().filter_map(|(_, cells)| cells.get(place));
        let is_number = |cell: &String| numerals.number(cell).is_some();
        let filled = cells.clone().filter(|cell| !cell.is_empty()).count();
        let numbers = cells.filter(|cell| is_number(cell)).count();
        let is_read = used.iter().any(|own| own.reads(place));
        if is_read || COUNTS.contains(&&*key) || numbers == 0 || 2 * numbers < filled {
            continue;
        }
        let unit = unit_of(units, place).or(by_header);
        let same = quantity(&key, unit);
        let same = same.and_then(|own| used.iter().find(|used| used.column.quantity == own));
        let (header, option) = (shown(header), option(header, unit, used));
        lines.push(match same {
            Some(other) => {
                let (is, other) = (other.column.quantity.name(), shown(&other.header));
                format!("{header}: not read, as {other} is the {is}")
            }
            None => format!("{header}: not read; {option}"),
        });
    }
    for (quantity, unit) in [(Q::Speed, "mph"), (Q::Spin, "rpm")] {
        if used.iter().all(|own| own.column.quantity != quantity) {
            let name = quantity.name();
            lines.push(format!(
                "no column is the {name} of the release, which each shot has by assumption then, or as in the model, and what a fit finds rests on that: \
                 export it, or name its column, --column \"HEADER={name},{unit}\""
            ));
        }
    }
    lines
}

/// Text on the option that would read a column, with the quantities of the unit that it states.
fn option(header: &str, unit: Option<SummaryUnit>, used: &[Used]) -> String {
    let Some(unit) = unit else {
        return format!("--column \"{header}=IS,UNIT\" reads it");
    };
    let is_free = |quantity: &Q| {
        quantity.dimension() == unit.dimension()
            && used.iter().all(|own| own.column.quantity != *quantity)
    };
    let free: Vec<&str> = Q::all().filter(is_free).map(Q::name).collect();
    let of_unit = match free.as_slice() {
        [] => "IS".to_owned(),
        [one] => (*one).to_owned(),
        _ => {
            return format!(
                "--column \"{header}=IS,{}\" reads it, where IS is {}",
                unit.name(),
                free.join(" or ")
            );
        }
    };
    format!("--column \"{header}={of_unit},{}\" reads it", unit.name())
}
