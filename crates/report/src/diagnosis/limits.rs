//! Tables of effects that are not identifiable, minimum detectable effects and stepwise terms.

use diagnose::{NotIdentifiable, Report, StepwiseTerm};

use super::words;
use crate::html::Html;
use crate::table::Table;
use crate::thin::MAX_ROWS;
use identify::numbers::{Digits, significant, unit};
use identify::wording::names;

/// Number of effects that are not identifiable above which their table is folded.
const MAX_OPEN: usize = 12;

/// What the flights can and cannot show.
pub(super) fn section(report: &Report) -> Html {
    let mut content = Html::new();
    let hidden = &report.not_identifiable;
    if hidden.is_empty() {
        content.paragraph("Every tested effect is identifiable, if it is large enough.");
    } else {
        content.paragraph(
            "These flights cannot show whether the following effects act: they are not identifiable, being confounded \
             with others.",
        );
        let table = not_identifiable(report);
        let mut shown = Html::new();
        shown.table(&table);
        if table.len() > MAX_OPEN {
            content.folded(format!("{} effects", table.len()), shown);
        } else {
            content.push(shown);
        }
    }
    let table = Table::of(report.minimum_detectable_effects.iter().take(MAX_ROWS))
        .name("effect", |effect| &effect.name)
        .plain("coefficient", |effect| &effect.coefficient)
        .number("minimum", |effect| significant(effect.value, 2))
        .plain("unit", |effect| unit(&effect.unit))
        .table();
    let mut detectable = Html::new();
    detectable.table(&table);
    if !detectable.is_empty() {
        detectable.note(
            "The size at which the score test is significant with a probability of 0.9 in these flights.",
        );
    }
    content.folded("Minimum detectable effects", detectable);
    content
}

/// Table of the effects that the flights cannot identify.
pub(super) fn not_identifiable(report: &Report) -> Table {
    let by = |effect: &NotIdentifiable| match names(&effect.confounded_with).as_str() {
        "" => "nothing: it has no influence in these flights".to_owned(),
        names => names.to_owned(),
    };
    Table::of(report.not_identifiable.iter().take(MAX_ROWS))
        .name("effect", |effect| &effect.name)
        .text("confounded with", |effect| by(effect))
        .table()
}

/// Table of the library terms tested by stepwise regression, in the order of the tests.
pub(super) fn terms(terms: &[StepwiseTerm]) -> Table {
    let digits = |term: &StepwiseTerm| Digits::of(term.value, term.std_error);
    Table::of(terms.iter().take(MAX_ROWS))
        .code("term", |term| &term.formula)
        .plain("acts on", |term| words::site(&term.site))
        .number("χ²", |term| significant(term.score_chi2, 4))
        .number("coefficient", |term| digits(term).one(term.value))
        .number("standard error", |term| digits(term).one(term.std_error))
        .plain("", |term| {
            let tag = term.selected.then(|| Html::tag("selected"));
            tag.unwrap_or_default()
        })
        .table()
}
