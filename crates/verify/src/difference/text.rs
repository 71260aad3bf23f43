//! Formats a comparison of two models as text for a terminal.

use super::{Change, Difference, End, Flown, Landing, Pair, RowChange, Sameness, Statement};
use std::fmt::Write;

impl Difference {
    /// Sentence on whether the models compute the same functions.
    pub fn sentence(&self) -> String {
        let changed = self.changed_rows();
        if changed.is_empty() {
            let open = self.rows_that_are(Sameness::Agrees);
            let mut text = String::from("the same function");
            if !open.is_empty() {
                let _ = write!(
                    text,
                    "; not decided exactly, and equal to rounding at random points: {}",
                    open.join(", ")
                );
            }
            return text;
        }
        format!("another function: {}", changed.join(", "))
    }

    /// Names of the rows with the given result.
    fn rows_that_are(&self, sameness: Sameness) -> Vec<&str> {
        let rows = self.rows.iter();
        rows.filter(|row| row.sameness == Some(sameness))
            .map(|row| row.row.as_str())
            .collect()
    }

    /// The comparison as text for a terminal.
    pub fn text(&self) -> String {
        let Pair { old, new } = &self.models;
        let mut out = format!("{old} → {new}: {}\n", self.sentence());
        let changed = self.rows.iter().filter(|row| row.is_changed());
        section(&mut out, "another function", changed, |row| {
            let causes = row.causes.iter().map(|cause| format!("\n      by {cause}"));
            row.sentence() + &causes.collect::<String>()
        });
        let same = self.rows_that_are(Sameness::Same);
        if !same.is_empty() {
            let _ = writeln!(out, "\nexactly the same function: {}", same.join(", "));
        }
        section(
            &mut out,
            "statements",
            self.statements.iter(),
            Statement::text,
        );
        let faults = |word, faults: &[String]| -> Vec<String> {
            let lines = faults.iter().map(|fault| format!("{word:9} {fault}"));
            lines.collect()
        };
        let units = &self.unit_faults;
        let units = [faults("mended", &units.old), faults("fault", &units.new)].concat();
        section(&mut out, "units", units.into_iter(), |line| line);
        let operations = self.operations.iter();
        section(&mut out, "operations", operations, |(name, pair)| {
            format!("{name}: {} → {}", pair.old, pair.new)
        });
        section(&mut out, "flights", self.landings.iter(), Landing::text);
        out
    }
}

/// Appends a heading and a line for each item, if there are any.
fn section<T>(
    out: &mut String,
    heading: &str,
    items: impl Iterator<Item = T>,
    line: impl Fn(T) -> String,
) {
    let lines: Vec<String> = items.map(|item| format!("  {}\n", line(item))).collect();
    if !lines.is_empty() {
        let _ = write!(out, "\n{heading}\n{}", lines.concat());
    }
}

impl RowChange {
    fn sentence(&self) -> String {
        match (self.sameness, self.added) {
            (None, true) => format!("{} is new", self.row),
            (None, false) => format!("{} is gone", self.row),
            _ => format!("{} differs by {:.1e} of its terms", self.row, self.error),
        }
    }
}

impl Statement {
    fn text(&self) -> String {
        let mut out = format!("{:9} {}", self.change.word(), self.what);
        for (sign, text) in [('-', &self.old), ('+', &self.new)] {
            for line in text.iter().flat_map(|text| text.lines()) {
                let _ = write!(out, "\n    {sign} {line}");
            }
        }
        out
    }
}

impl Change {
    /// The kind of change as one word: `added`, `removed`, `changed`, `rewritten` or `restated`.
    fn word(self) -> &'static str {
        match self {
            Self::Added => "added",
            Self::Removed => "removed",
            Self::Changed => "changed",
            Self::Rewritten => "rewritten",
            Self::Restated => "restated",
        }
    }
}

impl Landing {
    fn text(&self) -> String {
        let end = |flown: &Flown| match flown {
            Flown::End(end) => end.text(),
            Flown::Failed(why) => why.clone(),
        };
        let (old, new) = (end(&self.old), end(&self.new));
        format!("{}\n    - {old}\n    + {new}", self.release)
    }
}

impl End {
    fn text(&self) -> String {
        let values = self
            .state
            .iter()
            .map(|(name, value)| format!("{name} = {value:.6}"));
        let values: Vec<String> = values.collect();
        format!(
            "{:.6} s, {}: {}",
            self.time_s,
            self.reason,
            values.join(", ")
        )
    }
}
