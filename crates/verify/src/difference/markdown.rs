//! Formats a comparison of two models as Markdown, for example for a pull request.

use super::{Difference, Sameness};
use std::fmt::Write;

impl Difference {
    /// Formats the comparison of the two models as Markdown.
    pub fn markdown(&self) -> String {
        let mut out = format!(
            "## `{}` → `{}`: {}\n",
            self.models.old,
            self.models.new,
            self.sentence()
        );
        let mut changed = self.rows.iter().filter(|row| row.is_changed()).peekable();
        if changed.peek().is_some() {
            out.push_str("\n| row | what happened | by |\n|---|---|---|\n");
        }
        for row in changed {
            let causes: Vec<String> = row.causes.iter().map(|cause| cell(cause)).collect();
            let (name, says) = (&row.row, cell(&row.sentence()));
            let _ = writeln!(out, "| `{name}` | {says} | {} |", causes.join("<br>"));
        }
        let same = self.rows_that_are(Sameness::Same);
        if !same.is_empty() {
            let rows: Vec<String> = same.iter().map(|row| format!("`{row}`")).collect();
            let _ = writeln!(out, "\nExactly the same function: {}", rows.join(", "));
        }
        if !self.renamed.is_empty() {
            let names = self.renamed.iter();
            let names: Vec<String> = names
                .map(|r| format!("`{}` → `{}`", r.from, r.to))
                .collect();
            let _ = writeln!(out, "\nRenamed: {}", names.join(", "));
        }
        if !self.statements.is_empty() {
            out.push_str("\n```diff\n");
            for statement in &self.statements {
                let _ = writeln!(out, "# {} {}", statement.change.word(), statement.title());
                for (sign, text) in [('-', &statement.old), ('+', &statement.new)] {
                    for line in text.iter().flat_map(|text| text.lines()) {
                        // A code fence in the text would end the block.
                        let _ = writeln!(out, "{sign} {}", line.replace("```", "'''"));
                    }
                }
            }
            out.push_str("```\n");
        }
        for (word, faults) in [
            ("Units mended", &self.unit_faults.old),
            ("Units that do not agree", &self.unit_faults.new),
        ] {
            for fault in faults {
                let _ = writeln!(out, "\n{word}: {fault}");
            }
        }
        if !self.restated.is_empty() {
            out.push_str("\n| stated | old | new |\n|---|---|---|\n");
        }
        for r in &self.restated {
            let (old, new) = (cell(&r.old), cell(&r.new));
            let _ = writeln!(out, "| {} of `{}` | {old} | {new} |", r.what, r.name);
        }
        self.costs(&mut out);
        for (k, flight) in self.flights.iter().enumerate() {
            if k == 0 {
                out.push('\n');
            }
            let _ = writeln!(out, "- {}", flight.sentence());
        }
        out
    }

    fn costs(&self, out: &mut String) {
        let Some(cost) = &self.cost else {
            return;
        };
        out.push_str("\n| cost | old | new |\n|---|---|---|\n");
        for (name, pair) in &cost.operations {
            let _ = writeln!(
                out,
                "| operations of `{name}` | {} | {} |",
                pair.old, pair.new
            );
        }
        for (name, pair) in [("J", cost.j), ("Jp", cost.jp)] {
            let _ = writeln!(out, "| entries of {name} | {} | {} |", pair.old, pair.new);
        }
        if let Some(time) = &self.time {
            let ns = time.nanoseconds;
            let _ = writeln!(
                out,
                "| ns of `f` on the tape (ratio {:.3}) | {:.0} | {:.0} |",
                time.ratio, ns.old, ns.new
            );
        }
    }
}

/// Escapes a text for a cell of a Markdown table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}
