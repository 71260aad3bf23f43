//! What these flights cannot show, and the smallest that they can.

use crate::bench::Bench;
use crate::chance::normal_size;
use crate::report::{Detectable, Undetectable};
use crate::scores::Scores;

/// Of an effect that is this part of its squared size once flights' own unknowns are allowed for, those took the rest.
const OWN: f64 = 1e-9;

/// The quantile that is exceeded nine times in ten.
const POWER: f64 = 1.281_551_565_544_6;

/// What takes up this part of what takes up most is named.
const SHARE: f64 = 0.25;

/// Names of what absorbs an effect.
const NAMED: usize = 8;

/// An effect is as good as invisible where the smallest size that would be found is this part of its bounds' width.
const BEYOND: f64 = 0.5;

/// The effects that are invisible, and the smallest detectable sizes of the others.
pub fn detectable(
    bench: &Bench,
    scores: &Scores,
    alarm: f64,
) -> (Vec<Undetectable>, Vec<Detectable>) {
    let needed = normal_size(alarm) + POWER;
    let (mut hidden, mut shown) = (Vec::new(), Vec::new());
    for (columns, score) in bench.candidates.iter().zip(&scores.each) {
        let Some(score) = score else { continue };
        let mut seen = Vec::new();
        for part in &columns.candidate.coefficients {
            let place = bench.problem.body.layout().coefficient(part.index).index();
            let unknown = bench.problem.globals.iter().position(|s| s.param == place);
            let column = unknown.and_then(|u| scores.columns.iter().position(|&c| c == u));
            let Some(column) = column else { continue };
            let information = scores.information[(column, column)];
            let size = scores.sizes[column].1;
            let value = needed / (information.max(0.0) * size).sqrt();
            let width = part.bounds.map_or(f64::INFINITY, |(low, high)| high - low);
            if value.is_finite() && value < BEYOND * width {
                seen.push(Detectable {
                    name: columns.candidate.name.clone(),
                    coefficient: part.name.clone(),
                    value,
                    unit: part.unit.clone(),
                });
            }
        }
        let invisible = score.freedom == 0 || (seen.is_empty() && columns.states.is_empty());
        if invisible {
            hidden.push(Undetectable {
                name: columns.candidate.name.clone(),
                absorbed_by: absorbed_by(bench, scores, &columns.global),
            });
        } else {
            shown.extend(seen);
        }
    }
    (hidden, shown)
}

/// What takes up the columns of an effect.
fn absorbed_by(bench: &Bench, scores: &Scores, local: &[usize]) -> Vec<String> {
    let mut names: Vec<(String, f64)> = Vec::new();
    for (column, unknown) in scores.columns.iter().enumerate() {
        if !local.contains(unknown) {
            continue;
        }
        let (raw, size) = scores.sizes[column];
        if raw <= 0.0 {
            continue;
        }
        if size <= OWN * raw {
            return vec!["initial states".to_owned()];
        }
        for (row, &base) in scores.base.0.iter().enumerate() {
            let share = scores.leaning[(row, column)].abs() * scores.base.1[(row, row)].sqrt();
            let name = bench
                .problem
                .globals
                .get(base)
                .map_or_else(String::new, |global| global.name.clone());
            match names.iter_mut().find(|(same, _)| *same == name) {
                Some((_, most)) => *most = most.max(share),
                None => names.push((name, share)),
            }
        }
    }
    names.sort_by(|a, b| b.1.total_cmp(&a.1));
    let most = names.first().map_or(0.0, |name| name.1);
    names
        .into_iter()
        .filter(|(_, share)| *share >= SHARE * most && *share > 0.0)
        .take(NAMED)
        .map(|(name, _)| name)
        .collect()
}
