//! docs/discovery.md: how often a diagnosis finds what was hidden.

use diagnose::report::Verdict;

use crate::discovery::Tried;
use crate::discovery::plan::{Group, Size};
use crate::discovery::rates::{
    FALSE_ALARMS, HELD_OUT, IN_SET, IN_SET_STRONG, Part, Rates, RowRates, STRONG, WRONG, said,
};
use crate::discovery::run::Outcome;
use crate::markdown::{Text, percent};
use crate::page::Page;

/// Answers that are told of a row.
const TOLD: usize = 3;

/// The page of a plan's runs.
pub fn discovery(tried: &[Tried]) -> Page {
    let mut text = Text::default();
    text.paragraph("# Does the diagnosis find what was hidden?");
    text.paragraph("<!-- Written by `hyzer-studies discovery`; do not edit. -->");
    told(&mut text);
    bars(&mut text, &Rates::of(tried));
    fails(&mut text, tried);
    equivalents(&mut text, tried);
    outside(&mut text, tried, Group::Outside);
    outside(&mut text, tried, Group::Many);
    told_wrong(&mut text, tried);
    table(&mut text, tried);
    Page {
        text: text.finish(),
        figures: Vec::new(),
    }
}

fn told(text: &mut Text) {
    text.paragraph(
        "Every flight on this page was made by the oracle, with something hidden in it that the model does not have; \
         effects are coded there by hand, in vectors, with an integration of their own, and nothing of it is shared with what \
         is tested. `hyzer diagnose`'s own code is given the flights and the plain model. A run is a dataset of its own seed: \
         twenty throws of a disc of a second each, four of them held out, three markers seen 120 times a second through \
         noise of 1.5 mm; or twelve flights of a ball whose spin is known, three held out. The true coefficients are other \
         than the model's. What is hidden has a random sign (where its bounds allow it) and 0.7 to 1.4 times the size that stands in \
         the catalogue of trials as weak or strong. An outlier is off by 5 cm.",
    );
    text.paragraph(
        "A run is *detected* where the verdict is not `none`. The truth is *in the set* where one of the causes in the answer \
         is exactly what was hidden, both effects of a pair. It is *unique and wrong* where the answer is one single cause of \
         the catalogue, and not the truth (of two effects, one of which is below the smallest detectable size, the other alone \
         is right). *Sizes* is the truth's size over the smallest that the report says would be found nine times in ten; of a pair the \
         lesser, and 0 where the report says that these flights cannot show it. The *held-out ratio* is the error of prediction on \
         held-out flights, with what the answer's first cause adds, over that of the model with the truth switched on. \
         Rows give counts, or medians over their runs. `hyzer-studies discovery --out docs/discovery.md` makes the page again; \
         `--only` with words of a row and `--details` shows its runs.",
    );
}

fn bars(text: &mut Text, rates: &Rates) {
    text.paragraph("## The bars");
    let row = |what: String, bar: String, part: &Part, holds: &dyn Fn(f64) -> bool| {
        let fraction = part.fraction();
        vec![
            what,
            bar,
            fraction.map_or("–".into(), percent),
            format!("{} of {}", part.these, part.of),
            fraction
                .map_or("–", |f| if holds(f) { "yes" } else { "**no**" })
                .into(),
        ]
    };
    let most = |bar: f64| format!("at most {}", percent(bar));
    let least = |bar: f64| format!("at least {}", percent(bar));
    let mut rows = vec![
        row(
            "one single cause, and wrong".into(),
            most(WRONG),
            &rates.wrong,
            &|f| f <= WRONG,
        ),
        row(
            "truth in the set, of 1 detectable size or more".into(),
            least(IN_SET),
            &rates.in_set,
            &|f| f >= IN_SET,
        ),
        row(
            format!("truth in the set, of {STRONG} or more"),
            least(IN_SET_STRONG),
            &rates.in_set_strong,
            &|f| f >= IN_SET_STRONG,
        ),
    ];
    for (noise, part) in &rates.false_alarms {
        rows.push(row(
            format!("false alarms, {noise}"),
            most(FALSE_ALARMS),
            part,
            &|f| f <= FALSE_ALARMS,
        ));
    }
    let together = rates.held_out_together;
    rows.push(vec![
        "held-out error over the true model's, all runs together".into(),
        format!("at most {HELD_OUT}"),
        together.map_or("–".into(), |ratio| format!("{ratio:.3}")),
        format!("{} within, of {}", rates.held_out.these, rates.held_out.of),
        together
            .map_or(
                "–",
                |ratio| if ratio <= HELD_OUT { "yes" } else { "**no**" },
            )
            .into(),
    ]);
    text.table(&["", "bar", "measured", "runs", "held"], rows);
    let seconds = rates.seconds.unwrap_or(f64::NAN);
    text.paragraph(format!(
        "The median of the held-out ratio is {:.3}. A diagnosis takes {seconds:.1} s on one thread (median, beside others), \
         and {} of {} failed.",
        rates.held_out_median.unwrap_or(f64::NAN),
        rates.failed.these,
        rates.failed.of
    ));
}

/// What fails, row by row, with what was said instead.
fn fails(text: &mut Text, tried: &[Tried]) {
    text.paragraph("## What fails");
    let mut lines = Vec::new();
    let mut list =
        |what: &str, is: &dyn Fn(&Outcome) -> bool, at_least: &dyn Fn(&Tried) -> usize| {
            for tried in tried {
                let answers = said(&tried.outcomes, is);
                let count: usize = answers.iter().map(|(_, count)| count).sum();
                if count == 0 || count < at_least(tried) {
                    continue;
                }
                let each = answers.iter().take(TOLD);
                let each: Vec<String> = each
                    .map(|(said, count)| format!("{said} ({count})"))
                    .collect();
                let of = tried.outcomes.len();
                lines.push(format!(
                    "- {}: {what} in {count} of {of}; said: {}",
                    name(tried),
                    each.join("; ")
                ));
            }
        };
    list("one single cause, and wrong,", &|o| o.wrong, &|_| 1);
    let missed = |o: &Outcome| !o.wrong && !o.in_set && o.has(1.0);
    list(
        "truth of a detectable size or more not in the set",
        &missed,
        &|tried| 1 + tried.outcomes.len() / 10,
    );
    if lines.is_empty() {
        text.paragraph("No row has a single wrong cause, and none misses what can be seen in more than one run of ten.");
        return;
    }
    text.paragraph(
        "Rows with a single wrong cause, and rows that miss in more than one run of ten what has a detectable size or more, with what \
         was said instead:",
    );
    lines.iter().for_each(|line| text.line(line));
    text.line("");
}

fn name(tried: &Tried) -> String {
    let row = &tried.row;
    let size = row
        .size
        .map_or(String::new(), |size| format!(", {}", size.word()));
    format!(
        "`{}`{size}, {} ({})",
        row.hidden(),
        row.noise.name,
        row.group.word()
    )
}

fn equivalents(text: &mut Text, tried: &[Tried]) {
    let of = tried
        .iter()
        .filter(|tried| tried.row.group == Group::Equivalents);
    let rows: Vec<Vec<String>> = of
        .map(|tried| {
            let count = |is: &dyn Fn(&Outcome) -> bool| {
                tried.outcomes.iter().filter(|o| is(o)).count().to_string()
            };
            vec![
                format!("`{}`", tried.row.hidden()),
                tried.row.alike.unwrap_or("").to_owned(),
                tried.outcomes.len().to_string(),
                count(&|o| o.undetectable && !o.alarmed()),
                count(&|o| o.causes.len() > 1 && o.in_set),
                count(&|o| o.causes.len() == 1 && o.in_set),
                count(&|o| o.wrong),
            ]
        })
        .collect();
    if rows.is_empty() {
        return;
    }
    text.paragraph("## What is hard to tell apart");
    text.paragraph(
        "An effect that another imitates must come out as undetectable, or in a set with the other, or alone where the flights do tell \
         them apart; never the other alone.",
    );
    let head = [
        "hidden",
        "imitated by",
        "runs",
        "undetectable",
        "in a set",
        "alone",
        "unique and wrong",
    ];
    text.table(&head, rows);
}

fn outside(text: &mut Text, tried: &[Tried], group: Group) {
    let of = tried.iter().filter(|tried| tried.row.group == group);
    let rows: Vec<Vec<String>> = of
        .map(|tried| {
            let name = tried.row.outside.unwrap_or("");
            let found = crate::seeded::unlisted::by_name(name);
            let site = found.map_or("", |found| found.site);
            let rates = RowRates::of(&tried.outcomes);
            let mut sites: Vec<&str> = tried
                .outcomes
                .iter()
                .flat_map(|o| o.sites.iter().map(String::as_str))
                .collect();
            sites.sort_unstable();
            sites.dedup();
            let right = tried
                .outcomes
                .iter()
                .filter(|o| o.sites.iter().any(|s| s == site));
            let answers = said(&tried.outcomes, |_| true);
            vec![
                format!("`{name}`"),
                tried.row.size.map_or("", Size::word).to_owned(),
                site.to_owned(),
                tried.outcomes.len().to_string(),
                rates.detected.to_string(),
                rates.in_set.to_string(),
                right.count().to_string(),
                sites.join(", "),
                rates.wrong.to_string(),
                rates.gain.map_or("–".into(), |gain| format!("{gain:.2}")),
                answers
                    .first()
                    .map_or(String::new(), |(said, _)| said.clone()),
            ]
        })
        .collect();
    if rows.is_empty() {
        return;
    }
    if group == Group::Many {
        text.paragraph("## The same in many flights");
        text.paragraph("48 flights, 9 or 12 of them held out. With more flights a wrong cause is seen to be wrong more clearly; what flights agree on is looked for as well.");
    } else {
        text.paragraph("## What is in no catalogue");
        text.paragraph(
        "Here the right answer is the verdict `outside`, best with terms at the site where the effect acts. A set of several causes from \
         the catalogue is not wrong alone; one single cause is. There is no true model; the gain is the error on held-out flights \
         over that of the plain model.",
        );
    }
    let head = [
        "hidden",
        "size",
        "site",
        "runs",
        "detected",
        "said to be outside",
        "term at its site",
        "sites written",
        "unique and wrong",
        "held-out error, after over before",
        "said most often",
    ];
    text.table(&head, rows);
}

/// What is told of flights and is not quite so.
fn told_wrong(text: &mut Text, tried: &[Tried]) {
    let of = tried
        .iter()
        .filter_map(|tried| Some((tried, tried.row.told?)));
    let rows: Vec<Vec<String>> = of
        .map(|(tried, told)| {
            let count = |is: &dyn Fn(&Outcome) -> bool| {
                tried.outcomes.iter().filter(|o| is(o)).count().to_string()
            };
            let sum = |part: fn(&Outcome) -> usize| tried.outcomes.iter().map(part).sum::<usize>();
            let rates = RowRates::of(&tried.outcomes);
            vec![
                format!("{:.0} %", 100.0 * told.off),
                format!("{:.0} %", 100.0 * told.swapped),
                tried.outcomes.len().to_string(),
                count(&|o| o.in_set && o.causes.len() == 1),
                count(&|o| o.in_set && o.causes.len() > 1),
                count(&|o| o.verdict == Some(Verdict::Outside)),
                count(&|o| o.wrong),
                sum(|o| o.contradicting.0).to_string(),
                sum(|o| o.contradicting.1).to_string(),
                rates.gain.map_or("–".into(), |gain| format!("{gain:.2}")),
            ]
        })
        .collect();
    if rows.is_empty() {
        return;
    }
    text.paragraph("## What is told of flights, and is not quite so");
    text.paragraph(
        "48 flights of a ball, 12 of them held out, lifted by its spin (`magnus`, strong). The spins that are told are off by so much \
         in each component, or are those of other flights, as happens where two measurements are put together. No cause then leaves \
         noise alone. Right is to name what the flights agree on, best with the flights that contradict it; where every \
         flight was told another's spin there is nothing to name. The error on held-out flights is that of the extension on all of them, \
         those that were told another's spin too.",
    );
    let head = [
        "spins off by",
        "another flight's",
        "runs",
        "named alone",
        "in a set",
        "said to be outside",
        "unique and wrong",
        "flights said to contradict",
        "of them with another's spin",
        "held-out error, after over before",
    ];
    text.table(&head, rows);
}

fn table(text: &mut Text, tried: &[Tried]) {
    text.paragraph("## Every row");
    let rows = tried.iter().map(|tried| {
        let rates = RowRates::of(&tried.outcomes);
        let number = |value: Option<f64>, decimals: usize| {
            value.map_or("–".into(), |value| format!("{value:.decimals$}"))
        };
        let row = &tried.row;
        vec![
            row.group.word().to_owned(),
            row.hidden(),
            row.size.map_or("–", Size::word).to_owned(),
            row.noise.name.to_owned(),
            tried.outcomes.len().to_string(),
            number(rates.sizes, 1),
            rates.detected.to_string(),
            match row.group {
                Group::Null => "–".into(),
                _ => rates.in_set.to_string(),
            },
            number(rates.set_size, 1),
            rates.wrong.to_string(),
            number(rates.held_out, 3),
            number(rates.seconds, 1),
        ]
    });
    let head = [
        "group",
        "effect",
        "strength",
        "noise",
        "runs",
        "sizes",
        "detected",
        "in set",
        "mean set size",
        "unique and wrong",
        "held-out ratio",
        "seconds",
    ];
    text.table(&head, rows);
}

/// A line for each run, and one for what rejects its truth where that is known.
pub fn details(tried: &Tried, rejections: &[Option<String>]) -> Vec<String> {
    let mut lines = vec![tried.row.key()];
    for (run, outcome) in tried.outcomes.iter().enumerate() {
        let hidden = &outcome.case.hidden;
        let of = hidden.effects.iter().map(|(name, values)| {
            let values: Vec<String> = values.iter().map(|v| format!("{v:.3e}")).collect();
            format!("{name}({})", values.join(", "))
        });
        let mut truth: Vec<String> = of.collect();
        truth.extend(
            hidden
                .outside
                .iter()
                .map(|(name, size)| format!("{name}({size:.3e})")),
        );
        let rivals = outcome.rivals.iter().flatten();
        let rivals: Vec<String> = rivals
            .map(|(name, p)| format!("{name} p={p:.1e}"))
            .collect();
        let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.2}"));
        let mark = match () {
            () if outcome.failed.is_some() => "FAILED",
            () if outcome.wrong => "WRONG",
            () if outcome.in_set => "found",
            () if outcome.has(1.0) => "MISSED",
            () if outcome.alarmed() => "alarm",
            () => "quiet",
        };
        lines.push(format!(
            "  {run} seed {} {mark} [{}] said {}; rivals {}; own {} sigmas, {} sizes{}; held out {:.2} -> {:.2} mm, truly {} mm; {:.1} s{}",
            outcome.case.seed,
            truth.join(" "),
            outcome.said(),
            if rivals.is_empty() { "–".to_owned() } else { rivals.join(", ") },
            number(outcome.sigmas),
            number(outcome.detectable_sizes),
            if outcome.undetectable { " (undetectable)" } else { "" },
            1e3 * outcome.held_out_before,
            1e3 * outcome.held_out_after,
            number(outcome.held_out_true.map(|rms| 1e3 * rms)),
            outcome.seconds,
            outcome.failed.as_ref().map_or(String::new(), |why| format!("; {}", first_line(why))),
        ));
        if let Some(why) = rejections.get(run).and_then(Option::as_ref) {
            lines.push(format!("      {why}"));
        }
    }
    lines
}

/// A message may go on with a text and its marks.
fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or("")
}
