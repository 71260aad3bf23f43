//! Formats a comparison of two models as text for a terminal.

use super::{Change, Difference, FlightShift, RowChange, Sameness, Statement};
use std::fmt::Write;

impl Difference {
    /// Summarises in one sentence whether the two models compute the same functions, and which rows (state derivatives,
    /// components of the observation, validity limits) differ.
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

    /// Names of the rows (such as state derivatives) whose comparison has the given result.
    pub(super) fn rows_that_are(&self, sameness: Sameness) -> Vec<&str> {
        let rows = self.rows.iter();
        rows.filter(|row| row.sameness == Some(sameness))
            .map(|row| row.row.as_str())
            .collect()
    }

    /// Formats all results of the comparison of the two models as text for a terminal.
    pub fn text(&self) -> String {
        let mut out = format!(
            "{} → {}: {}\n",
            self.models.old,
            self.models.new,
            self.sentence()
        );
        let changed: Vec<&RowChange> = self.rows.iter().filter(|row| row.is_changed()).collect();
        if !changed.is_empty() {
            out.push_str("\nanother function\n");
        }
        for row in changed {
            let _ = writeln!(out, "  {}", row.sentence());
            for cause in &row.causes {
                let _ = writeln!(out, "      by {cause}");
            }
        }
        let same = self.rows_that_are(Sameness::Same);
        if !same.is_empty() {
            let _ = writeln!(out, "\nexactly the same function: {}", same.join(", "));
        }
        if !self.renamed.is_empty() {
            let names = self
                .renamed
                .iter()
                .map(|r| format!("{} → {}", r.from, r.to));
            let names: Vec<String> = names.collect();
            let _ = writeln!(out, "\nrenamed: {}", names.join(", "));
        }
        if !self.statements.is_empty() {
            out.push_str("\nstatements\n");
        }
        for statement in &self.statements {
            let _ = writeln!(out, "  {:9} {}", statement.change.word(), statement.title());
            for (sign, text) in [('-', &statement.old), ('+', &statement.new)] {
                for line in text.iter().flat_map(|text| text.lines()) {
                    let _ = writeln!(out, "    {sign} {line}");
                }
            }
        }
        let units = &self.unit_faults;
        if !units.old.is_empty() || !units.new.is_empty() {
            out.push_str("\nunits\n");
        }
        for (word, faults) in [("mended", &units.old), ("fault", &units.new)] {
            for fault in faults {
                let _ = writeln!(out, "  {word:9} {fault}");
            }
        }
        if !self.restated.is_empty() {
            out.push_str("\nstated values\n");
        }
        for r in &self.restated {
            let _ = writeln!(out, "  {} of {}: {} → {}", r.what, r.name, r.old, r.new);
        }
        self.consequences(&mut out);
        out
    }

    fn consequences(&self, out: &mut String) {
        if let Some(cost) = &self.cost {
            out.push_str("\ncost\n");
            for (name, pair) in &cost.operations {
                let _ = writeln!(out, "  operations of {name}: {} → {}", pair.old, pair.new);
            }
            for (name, pair) in [("J", cost.j), ("Jp", cost.jp)] {
                let _ = writeln!(out, "  entries of {name}: {} → {}", pair.old, pair.new);
            }
            for (word, entries) in [
                ("new", &cost.entries_added),
                ("gone", &cost.entries_removed),
            ] {
                if !entries.is_empty() {
                    let _ = writeln!(out, "  {word}: {}", entries.join(", "));
                }
            }
        }
        if let Some(time) = &self.time {
            let ns = time.nanoseconds;
            let _ = writeln!(
                out,
                "  time of f on the tape: {:.0} → {:.0} ns, ratio {:.3}",
                ns.old, ns.new, time.ratio
            );
        }
        if !self.flights.is_empty() {
            out.push_str("\nflights\n");
        }
        for flight in &self.flights {
            let _ = writeln!(out, "  {}", flight.sentence());
        }
    }
}

impl RowChange {
    /// Describes in one sentence how the scalar function (such as a state derivative) differs between the two models.
    pub(super) fn sentence(&self) -> String {
        match (self.sameness, self.added) {
            (None, true) => format!("{} is new", self.row),
            (None, false) => format!("{} is gone", self.row),
            _ => {
                let mut text = format!("{} differs by {:.1e} of its terms", self.row, self.error);
                if self.same_at_stated_values {
                    text.push_str(
                        "; the same function where what was added or removed has its stated value",
                    );
                }
                text
            }
        }
    }
}

impl Statement {
    /// Class and name of the statement, such as `let alpha`; if they changed, in the form `old class and name → new
    /// class and name`.
    pub(super) fn title(&self) -> String {
        match &self.was {
            Some(was) => format!("{was} → {}", self.what),
            None => self.what.clone(),
        }
    }
}

impl Change {
    /// The kind of change as one word: `added`, `removed`, `changed`, `rewritten`, `renamed` or `restated`.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Added => "added",
            Self::Removed => "removed",
            Self::Changed => "changed",
            Self::Rewritten => "rewritten",
            Self::Renamed => "renamed",
            Self::Restated => "restated",
        }
    }
}

impl FlightShift {
    /// Describes in one sentence how the flights of the old and the new model differ.
    pub(super) fn sentence(&self) -> String {
        let name = &self.release;
        if let Some(why) = &self.failed {
            return format!("{name}: {why}");
        }
        let place = match self.distance_m {
            Some(distance) => format!("{distance:.3e} m from where it was; "),
            None => String::new(),
        };
        if self.old == self.new {
            return format!("{name}, after {} s: where it was", self.seconds);
        }
        format!(
            "{name}, after {} s: {place}{} differs most, {:.6} → {:.6}",
            self.seconds, self.state, self.old, self.new
        )
    }
}
