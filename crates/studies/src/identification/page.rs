//! docs/identification.md: what a fit is worth, tried on flights that the oracle made.

use report::figures::{Dots, Line, Look, Panel, figure};

use crate::identification::coverage::{Coverage, TRUTH};
use crate::identification::paper_fits::{Replay, TABLE_1, Way};
use crate::markdown::{Text, mean_and_deviation, percent, three};
use crate::page::Page;

/// Dots that a way's estimates are drawn by at most.
const DRAWN: usize = 100;

/// The page of coverage and replay.
pub fn identification(coverages: &[Coverage], replay: &Replay) -> Page {
    let mut text = Text::default();
    text.paragraph("# What a fit is worth");
    text.paragraph("<!-- Written by `hyzer-studies identification`; do not edit. -->");
    text.paragraph(
        "Every flight on this page was made by the oracle: vector mechanics and an integration that share nothing with the \
         code that fits. Three markers on the disc are seen 120 times a second, through noise drawn from a seed. \
         `hyzer-studies identification --out docs/identification.md` makes the page again.",
    );
    covered(&mut text, coverages);
    replayed(&mut text, replay);
    Page {
        text: text.finish(),
        figures: vec![("identification-scatter.svg".into(), scatter(replay))],
    }
}

fn covered(text: &mut Text, coverages: &[Coverage]) {
    text.paragraph("## Do the intervals hold the truth?");
    let seeds = coverages.first().map_or(0, |coverage| coverage.seeds);
    text.paragraph(format!(
        "Twelve throws of a second, {seeds} seeds: other throws, other noise each. The true coefficients are {}; \
         the fit starts from the model's own, which are others. Noise of 1.5 mm; an outlier is off by 5 cm (standard \
         deviation along each axis). Stated is how many of the intervals of 95 % hold the true value; the band in which \
         that should lie is 93 to 97 % for white noise and above 90 % for correlated noise and outliers.",
        TRUTH.map(|(name, value)| format!("{name} {value}")).join(", ")
    ));
    let rows = coverages.iter().map(|coverage| {
        let worst = coverage
            .rows
            .iter()
            .map(|row| row.worst)
            .fold(0.0, f64::max);
        let covered = coverage
            .rows
            .iter()
            .map(|row| row.covered as f64 / coverage.seeds as f64);
        let (least, most) = covered.fold((1.0_f64, 0.0_f64), |(low, high), part| {
            (low.min(part), high.max(part))
        });
        vec![
            coverage.condition.name.to_owned(),
            percent(coverage.covered()),
            format!("{} to {}", percent(least), percent(most)),
            percent(coverage.covered_clustered()),
            format!("{worst:.1}"),
            coverage.failed.to_string(),
        ]
    });
    text.table(
        &[
            "noise",
            "intervals that hold",
            "by coefficient",
            "by the scatter of flights",
            "greatest error over its standard error",
            "failed fits",
        ],
        rows,
    );
    text.paragraph(
        "The fourth column is the check that needs no model of the noise: standard errors from the scatter of the twelve \
         flights alone. From so few flights they are known to come out small, and their intervals to hold less often.",
    );
    if let Some(white) = coverages.first() {
        text.paragraph(format!(
            "Under {} noise, coefficient by coefficient:",
            white.condition.name
        ));
        let rows = white.rows.iter().map(|row| {
            vec![
                format!("`{}`", row.name),
                percent(row.covered as f64 / white.seeds as f64),
                format!("{:+.2}", row.bias),
                format!("{:.2}", row.spread),
                format!("{:.1}", row.worst),
            ]
        });
        text.table(
            &[
                "coefficient",
                "intervals that hold",
                "mean error over its standard error",
                "its root mean square",
                "its greatest",
            ],
            rows,
        );
    }
}

fn replayed(text: &mut Text, replay: &Replay) {
    text.paragraph("## The paper's two flights, one by one");
    text.paragraph(format!(
        "Hubbard & Hummel fitted each of their flights alone, and got two sets of coefficients that cannot both be right. \
         Here their releases (Table 3, with the disc of Table 2) are flown with one known set, the disc's own, and seen with \
         the paper's 1.4 mm; then fitted as the paper did, each alone, free of bounds, {} seeds each. Standard deviations \
         of the estimates over the seeds:",
        replay.seeds
    ));
    let mut head = vec!["", "true", "Table 1: fssh3", "Table 1: bffl8"];
    head.extend(replay.ways.iter().map(|way| way.name));
    let rows = replay.truth.iter().enumerate().map(|(k, (name, truth))| {
        let mut row = vec![format!("`{name}`"), three(*truth)];
        let printed = TABLE_1.iter().find(|(printed, ..)| printed == name);
        row.extend(printed.map_or([String::new(), String::new()], |(_, a, b)| {
            [three(*a), three(*b)]
        }));
        row.extend(
            replay
                .ways
                .iter()
                .map(|way| three(mean_and_deviation(&way.estimates[k]).1)),
        );
        row
    });
    text.table(&head, rows);
    text.paragraph("![Estimates over the seeds, by way](identification-scatter.svg)");
    text.paragraph(
        "How often a coefficient came out that cannot be (a drag that pushes, a lift that falls with the angle of attack, a \
         damping that drives), and how often the report said by itself that the flights do not determine some:",
    );
    let rows = replay.ways.iter().map(|way| {
        let part = |count: usize| percent(count as f64 / replay.seeds as f64);
        let named: Vec<String> = replay
            .truth
            .iter()
            .zip(&way.undetermined)
            .filter(|(_, count)| 2 * **count > replay.seeds)
            .map(|((name, _), _)| format!("`{name}`"))
            .collect();
        vec![
            way.name.to_owned(),
            part(way.any_impossible),
            part(way.any_undetermined),
            named.join(" "),
            way.failed.to_string(),
        ]
    });
    text.table(
        &[
            "way",
            "impossible values",
            "said to be undetermined",
            "which, in most seeds",
            "failed fits",
        ],
        rows,
    );
    if let Some(alone) = replay.ways.first() {
        text.paragraph("What the report says of the first seed of fssh3 alone:");
        for told in &alone.told {
            text.line(format!("- {told}"));
        }
        text.line("");
    }
    verdict(text, replay);
}

/// What of the paper's disagreement such scatter explains.
fn verdict(text: &mut Text, replay: &Replay) {
    let find = |name: &str| replay.ways.iter().find(|way| way.name == name);
    let (Some(fssh3), Some(bffl8)) = (
        find("fssh3 alone, 0.5 s, AR(0.6)"),
        find("bffl8 alone, its first 0.5 s, AR(0.6)"),
    ) else {
        return;
    };
    text.paragraph("## What of Table 1 this explains");
    text.paragraph(
        "The difference of the two columns of Table 1 over the standard deviation that the difference of two such fits has, \
         for flights of half a second with correlated noise, the least that the paper's own flights can have told. Up to about 2 the \
         scatter of single fits explains the disagreement; far above, it does not, and something else is wrong: the order of \
         the columns, the units (docs/paper.md), or the model.",
    );
    let deviation = |way: &Way, k: usize| mean_and_deviation(&way.estimates[k]).1;
    let rows = replay
        .truth
        .iter()
        .enumerate()
        .filter_map(|(k, (name, _))| {
            let (_, a, b) = TABLE_1.iter().find(|(printed, ..)| printed == name)?;
            let expected = deviation(fssh3, k).hypot(deviation(bffl8, k));
            Some(vec![
                format!("`{name}`"),
                three((a - b).abs()),
                three(expected),
                format!("{:.1}", (a - b).abs() / expected),
            ])
        });
    text.table(
        &[
            "coefficient",
            "difference in Table 1",
            "standard deviation expected",
            "ratio",
        ],
        rows,
    );
    let last = replay.ways.last();
    if let Some(spread) = last {
        let worst = replay
            .truth
            .iter()
            .enumerate()
            .map(|(k, (name, _))| (name, deviation(fssh3, k) / deviation(spread, k)));
        let (name, gain) = worst.fold((&replay.truth[0].0, f64::INFINITY), |least, next| {
            if next.1 < least.1 { next } else { least }
        });
        text.paragraph(format!(
            "Fitted together over twelve throws that differ in speed, angle and spin, every coefficient scatters at least \
             {gain:.0} times less than from fssh3 alone (the least gain is that of `{name}`). Impossible values came out in {} of {} seeds, and \
             the report named something undetermined in {}.",
            spread.any_impossible, replay.seeds, spread.any_undetermined
        ));
    }
}

/// Every coefficient's estimates, a column of dots for each way.
fn scatter(replay: &Replay) -> String {
    let panels: Vec<Panel> = replay
        .truth
        .iter()
        .enumerate()
        .map(|(k, (name, truth))| {
            let dots = replay.ways.iter().enumerate().map(|(place, way)| {
                let estimates = way.estimates[k].iter().take(DRAWN).enumerate();
                // A little to the side of each other, always in the same way.
                let beside = |index: usize| 0.6 * ((index as f64 * 0.618_034).fract() - 0.5);
                Dots {
                    look: Look::Pale,
                    points: estimates
                        .map(|(index, value)| (place as f64 + 1.0 + beside(index), *value))
                        .collect(),
                }
            });
            let ends = [0.5, replay.ways.len() as f64 + 0.5];
            Panel {
                title: name.clone(),
                across: "way, in the order of the table".into(),
                lines: vec![Line {
                    name: "true".into(),
                    points: ends.map(|x| (x, *truth)).to_vec(),
                }],
                thin: true,
                dots: dots.collect(),
                ..Panel::default()
            }
        })
        .collect();
    figure("Estimates of single seeds", &panels)
}
