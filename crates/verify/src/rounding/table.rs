//! Formats rounding errors as text.

use super::statements::{Loss, REPORTED_BITS};
use super::{Error, MEASURE, Rounding};
use crate::table::plain_table;

/// Maximum number of statements with lost digits that the text report lists.
const LISTED: usize = 10;

impl Loss {
    /// Sentence on the loss: file, line, name, bits and point.
    pub fn sentence(&self) -> String {
        format!(
            "{}, line {}: `{}` loses {:.0} of 53 bits at {} (median {:.0}): {}",
            self.source, self.line, self.name, self.bits, self.place, self.median_bits, self.text
        )
    }
}

impl Rounding {
    /// Tables of the rounding errors, one for backends with equal errors, and the statements that lose digits.
    pub fn table(&self) -> String {
        let [random, flown] = self.points;
        let mut text = format!(
            "Rounding errors against arithmetic of {} bits, in {MEASURE}.\n{random} random points and {flown} states of \
             flights; {} left out, where rounding may decide a branch.\n",
            oracle::scalar::PRECISION,
            self.left_out
        );
        let mut groups: Vec<(Vec<&str>, Vec<&Error>)> = Vec::new();
        let mut rest = self.errors.as_slice();
        while let Some(first) = rest.first() {
            let (own, after) = rest.split_at(rest.partition_point(|e| e.backend == first.backend));
            rest = after;
            let same = groups.iter_mut().find(|(_, errors)| {
                errors.len() == own.len() && errors.iter().zip(own).all(|(a, b)| is_same(a, b))
            });
            match same {
                Some((backends, _)) => backends.push(&first.backend),
                None => groups.push((vec![&first.backend], own.iter().collect())),
            }
        }
        for (backends, errors) in groups {
            let mut table = plain_table(&[
                "function", "values", "compared", "worst", "median", "worst at",
            ]);
            for error in errors {
                table.add_row(vec![
                    error.function.to_owned(),
                    error.values.to_owned(),
                    error.compared.to_string(),
                    format!("{:.2}", error.worst),
                    format!("{:.3}", error.median),
                    error.place.clone(),
                ]);
            }
            text.push_str(&format!("\n{}\n{table}\n", backends.join(", ")));
        }
        if self.losses.is_empty() {
            text.push_str("\nNo statement of the model loses a bit.\n");
            return text;
        }
        text.push_str(&format!(
            "\nStatements by the bits that they lose (named in the report from {REPORTED_BITS} bits):\n"
        ));
        for loss in self.losses.iter().take(LISTED) {
            text.push_str(&format!("  {}\n", loss.sentence()));
        }
        text
    }
}

/// Whether two records of rounding errors are equal except for the name of the backend.
fn is_same(a: &Error, b: &Error) -> bool {
    let without = |e: &Error| Error {
        backend: String::new(),
        ..e.clone()
    };
    without(a) == without(b)
}
