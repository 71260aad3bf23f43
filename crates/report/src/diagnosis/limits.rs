//! Tables of effects that are not identifiable, minimum detectable effects and stepwise terms.

use diagnose::{Report, StepwiseTerm};

use super::{MAX_ROWS, words};
use crate::html::Html;
use crate::table::{Column, Table};
use identify::numbers::{Digits, significant, unit};
use identify::wording::names;

/// Number of effects that are not identifiable above which their table is folded.
const MAX_OPEN: usize = 12;

/// What the flights can and cannot show.
pub(super) fn section(report: &Report) -> Html {
    use Column::{Name, Number, Plain};
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
    let mut table = Table::new()
        .with(Name, &["effect"])
        .with(Plain, &["coefficient"])
        .with(Number, &["minimum"])
        .with(Plain, &["unit"]);
    for effect in report.minimum_detectable_effects.iter().take(MAX_ROWS) {
        table.row([
            (&effect.name).into(),
            (&effect.coefficient).into(),
            significant(effect.value, 2).into(),
            unit(&effect.unit).into(),
        ]);
    }
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
    let mut table = Table::new()
        .with(Column::Name, &["effect"])
        .with(Column::Text, &["confounded with"]);
    for effect in report.not_identifiable.iter().take(MAX_ROWS) {
        let by = match names(&effect.confounded_with).as_str() {
            "" => "nothing: it has no influence in these flights".to_owned(),
            names => names.to_owned(),
        };
        table.row([(&effect.name).into(), by.into()]);
    }
    table
}

/// Table of the library terms tested by stepwise regression, in the order of the tests.
pub(super) fn terms(terms: &[StepwiseTerm]) -> Table {
    use Column::{Code, Number, Plain};
    let mut table = Table::new()
        .with(Code, &["term"])
        .with(Plain, &["acts on"])
        .with(Number, &["χ²", "coefficient", "standard error"])
        .with(Plain, &[""]);
    for term in terms.iter().take(MAX_ROWS) {
        let digits = Digits::of(term.value, term.std_error);
        let mut tag = Html::new();
        if term.selected {
            tag = Html::tag("selected");
        }
        table.row([
            (&term.formula).into(),
            words::site(&term.site).into(),
            significant(term.score_chi2, 4).into(),
            digits.one(term.value).into(),
            digits.one(term.std_error).into(),
            tag.into(),
        ]);
    }
    table
}
