//! Verification of a model against its reference.

use verify::Options;
use verify::report::{Outcome, Report};

use crate::{Error, Model};

/// Result of the independent checks of a model.
pub struct Verification {
    report: Report,
}

impl Verification {
    /// Runs the independent checks of a model at `cases` random points.
    ///
    /// # Errors
    /// [`Error::Load`] if the text of the model cannot be read again.
    ///
    /// ```no_run
    /// # fn main() -> Result<(), hyzer::Error> {
    /// let disc = hyzer::Model::load("disc")?;
    /// let verification = hyzer::Verification::of(&disc, 40)?;
    /// assert_eq!(verification.outcome(), hyzer::Outcome::Verified);
    /// # Ok(())
    /// # }
    /// ```
    pub fn of(model: &Model, cases: usize) -> Result<Verification, Error> {
        let loaded = model_spec::load::inspect_text(model.name(), &model.text(), &[])?;
        let options = Options {
            cases,
            mutants: false,
            ..Options::default()
        };
        let report = verify::run(&loaded, &options);
        Ok(Verification { report })
    }

    /// Whether the model is verified, refuted, or neither.
    pub fn outcome(&self) -> Outcome {
        self.report.outcome()
    }

    /// Names of the checks with their verdicts, in the order in which they were made.
    pub fn checks(&self) -> impl Iterator<Item = (&str, String)> {
        let rows = self.report.rows.iter();
        rows.map(|row| (row.check, format!("{:?}", row.verdict).to_lowercase()))
    }

    /// Table of the checks as text.
    pub fn table(&self) -> String {
        self.report.table()
    }
}
