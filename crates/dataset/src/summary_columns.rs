//! The `[[summaries]]` entries of `dataset.toml`.

use std::collections::{BTreeMap, BTreeSet};

use toml::de::DeTable;

use crate::fields::{Fields, Value};
use crate::input_error::InputError;
use crate::stated;
use crate::summary::{SummaryColumn, SummaryQuantity, SummaryUnit};
use crate::words::{listed, meant, shown};
use crate::{KnownValue, Sensor, SensorKind};

const KEYS: [&str; 6] = ["file", "columns", "held_out", "known", "unknown", "notes"];
const COLUMN_KEYS: [&str; 4] = ["is", "unit", "sigma", "positive"];

/// One `[[summaries]]` entry of `dataset.toml`: a table with a row per flight.
#[derive(Debug, PartialEq)]
pub(crate) struct SummariesEntry {
    pub file: String,
    /// A sensor for each column that is used, named by its header.
    pub columns: Vec<Sensor>,
    /// Lines of the rows that are held out.
    pub held_out: BTreeSet<usize>,
    pub known: BTreeMap<String, KnownValue>,
    pub unknown: Vec<String>,
    /// What the reports say of the recordings.
    pub notes: Vec<String>,
}

impl Fields<'_> {
    /// Reads the entries of `[[summaries]]`; empty if there are none.
    pub(crate) fn summaries(
        &self,
        document: &DeTable<'_>,
    ) -> Result<Vec<SummariesEntry>, InputError> {
        let tables = self.entries(document, "summaries")?;
        let mut found: Vec<SummariesEntry> = Vec::with_capacity(tables.len());
        for entry in &tables {
            self.keys(entry.1, " in [[summaries]]", &KEYS)?;
            let value = self.needed(entry, "file", "the table of the flights")?;
            let file = self.file_name(value, "file", "the table of the flights in quotes")?;
            if found.iter().any(|other| other.file == file) {
                let found = format!("a second table {}", shown(&file));
                return Err(self.fault(value.span(), found, "each file once"));
            }
            let expected = "the columns, as in { \"Carry\" = { is = \"carry\", unit = \"yd\" } }";
            let value = self.needed(entry, "columns", expected)?;
            let columns = self.columns(value)?;
            let stated = self.stated(entry.1)?;
            let spin = columns.iter().filter(|own| own.is_spin());
            let spin: Vec<&str> = spin.map(|own| own.name.as_str()).collect();
            if !spin.is_empty() {
                let also = format!("as the spin by the columns {}", listed(spin));
                let known = stated.iter().filter(|own| own.is_known);
                stated::check(known, Sensor::SPIN, &also, stated::ONCE)?;
            }
            found.push(SummariesEntry {
                file,
                columns,
                held_out: self.held_out(entry.1)?,
                known: self.known(entry.1)?,
                unknown: self.unknown(entry.1)?,
                notes: self.notes(entry.1)?,
            });
        }
        Ok(found)
    }

    fn notes(&self, table: &DeTable<'_>) -> Result<Vec<String>, InputError> {
        let expected = "a list of sentences in quotes";
        let items = self.items(table, "notes", expected)?;
        let each = items.iter();
        each.map(|item| self.text(item, "notes", expected))
            .collect()
    }

    fn columns(&self, value: &Value<'_>) -> Result<Vec<Sensor>, InputError> {
        let wrong = |found: &str, expected: &str| Err(self.fault(value.span(), found, expected));
        let Some(table) = value.get_ref().as_table() else {
            return wrong("columns that are no table", "a header and what it is, each");
        };
        let mut columns: Vec<Sensor> = Vec::with_capacity(table.len());
        for (header, value) in table {
            let header = header.get_ref().trim().to_owned();
            let column = self.column(&header, value)?;
            // The name of the kind of a column is that of its quantity.
            let quantity = column.kind.name();
            let same = columns.iter().find(|other| other.kind.name() == quantity);
            if let Some(other) = same {
                let names = [&other.name, &header].map(|name| shown(name));
                let found = format!("{}, both {quantity}", names.join(" and "));
                return Err(self.fault(value.span(), found, "each quantity once"));
            }
            columns.push(column);
        }
        match columns.iter().any(Sensor::is_outcome) {
            true => Ok(columns),
            false => wrong(
                "columns of the release alone",
                "what was seen of the rest of the flight, such as carry or apex_height",
            ),
        }
    }

    /// Reads what one column is.
    fn column(&self, header: &str, value: &Value<'_>) -> Result<Sensor, InputError> {
        let Some(table) = value.get_ref().as_table() else {
            let expected = "a table, as in { is = \"carry\", unit = \"yd\" }";
            return Err(self.refused(value, header, "no table", expected));
        };
        self.keys(
            table,
            &format!(" of the column {}", shown(header)),
            &COLUMN_KEYS,
        )?;
        let entry = (value.span(), table);
        let names = || SummaryQuantity::all().map(SummaryQuantity::name);
        let expected = format!("is, one of {}", listed(names()));
        let stated = self.needed(&entry, "is", &expected)?;
        let name = self.text(stated, "is", &expected)?;
        let Some(quantity) = SummaryQuantity::named(&name) else {
            let expected = format!("one of {}{}", listed(names()), meant(&name, names()));
            return Err(self.refused(stated, "is", shown(&name), expected));
        };
        let units = || SummaryUnit::of(quantity.dimension());
        let expected = format!("unit, one of {}", listed(units()));
        let stated = self.needed(&entry, "unit", &expected)?;
        let text = self.text(stated, "unit", &expected)?;
        let unit = SummaryUnit::parse(&text);
        let unit = unit.filter(|unit| unit.dimension() == quantity.dimension());
        let Some(unit) = unit else {
            let expected = format!(
                "for {name} one of {}{}",
                listed(units()),
                meant(&text, units())
            );
            return Err(self.refused(stated, "unit", shown(&text), expected));
        };
        let is_mirrored = self.is_mirrored(table, quantity)?;
        let column = SummaryColumn {
            quantity,
            unit,
            is_mirrored,
        };
        Ok(Sensor {
            sigma: self.deviation(table, "sigma")?,
            ..Sensor::new(header, SensorKind::Summary(column), [0.0; 3])
        })
    }

    /// Whether a column is positive to the other side than its quantity.
    fn is_mirrored(
        &self,
        table: &DeTable<'_>,
        quantity: SummaryQuantity,
    ) -> Result<bool, InputError> {
        let Some(value) = table.get("positive") else {
            return Ok(false);
        };
        let expected = "\"left\" or \"right\"";
        let text = self.text(value, "positive", expected)?;
        match (quantity.is_positive_right(), text.as_str()) {
            (Some(own), "right") => Ok(!own),
            (Some(own), "left") => Ok(own),
            (Some(_), _) => Err(self.refused(value, "positive", shown(&text), expected)),
            (None, _) => {
                let expected = "positive with heading, side and spin_axis alone";
                Err(self.refused(value, "positive", shown(&text), expected))
            }
        }
    }

    fn held_out(&self, table: &DeTable<'_>) -> Result<BTreeSet<usize>, InputError> {
        let expected = "the lines of the rows that are held out, as in [3, 7]";
        let items = self.items(table, "held_out", expected)?;
        let mut lines = BTreeSet::new();
        for item in items {
            let line = self.number(item, "held_out")?;
            if !(line >= 2.0 && line.fract() == 0.0 && line < 1e9) {
                return Err(self.refused(item, "held_out", line, expected));
            }
            if !lines.insert(line as usize) {
                let found = format!("line {line} twice");
                return Err(self.refused(item, "held_out", found, "each line once"));
            }
        }
        Ok(lines)
    }
}
