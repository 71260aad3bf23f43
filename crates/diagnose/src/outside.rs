//! What lies outside the catalogue: terms are taken one by one, each the one that explains most of what is left.

use identify::fit::FitError;
use identify::levenberg::Point;
use nalgebra::DVector;

use crate::bench::Bench;
use crate::causes::Found;
use crate::report;
use crate::scores::Scores;

/// Terms that are taken at most.
const MOST: usize = 4;

/// Terms that are told of.
const TOLD: usize = 12;

/// What was found.
pub struct Terms {
    /// Terms that were taken, by index in the grammar.
    pub taken: Vec<usize>,
    /// The terms with the greatest statistics, and those taken.
    pub told: Vec<report::Term>,
}

/// Looks for terms that explain what the base leaves; none where the model has no place for them.
///
/// # Errors
/// Where a flight is impossible.
pub fn terms(bench: &Bench, base: &Point, found: &Found) -> Result<Option<Terms>, FitError> {
    let Some(grammar) = &bench.grammar else {
        return Ok(None);
    };
    let blocks = bench.look_further(base, &found.noise)?;
    let scored = |taken: &[usize]| {
        Scores::new(bench, &blocks, (&[], taken), &base.shared).map_err(FitError::Mismatch)
    };
    let first = scored(&[])?;
    let mut taken: Vec<usize> = Vec::new();
    let mut last = scored(&[])?;
    while taken.len() < MOST {
        let best = last.best_term().filter(|(index, _)| !taken.contains(index));
        let Some((index, _)) = best.filter(|(_, score)| score.ln_p < found.limits.reject) else {
            break;
        };
        taken.push(index);
        last = scored(&taken)?;
    }
    let mut order: Vec<usize> = (0..first.terms.len())
        .filter(|&index| first.terms[index].freedom > 0)
        .collect();
    order.sort_by(|&a, &b| {
        first.terms[b]
            .statistic
            .total_cmp(&first.terms[a].statistic)
    });
    order.truncate(TOLD);
    order.extend(
        taken
            .iter()
            .filter(|index| !order.contains(index))
            .copied()
            .collect::<Vec<_>>(),
    );
    let told = order.into_iter().map(|index| {
        let score = &first.terms[index];
        let (value, std_error) = score.estimates.first().map_or((0.0, 0.0), |e| (e.1, e.2));
        report::Term {
            site: grammar.site(index).to_owned(),
            formula: grammar.formula(index),
            statistic: score.statistic,
            value,
            std_error,
            taken: taken.contains(&index),
        }
    });
    Ok(Some(Terms {
        told: told.collect(),
        taken,
    }))
}

/// What each channel alone would explain, as a part of what all terms together would.
pub fn channels(bench: &Bench, scores: &Scores) -> Vec<report::Channel> {
    let Some(grammar) = &bench.grammar else {
        return Vec::new();
    };
    let size = scores.information.nrows();
    let known = bench.setting.shared.len();
    let gain = |wanted: &dyn Fn(usize) -> bool| -> f64 {
        let at: Vec<usize> = (0..size)
            .filter(|&i| scores.columns[i].checked_sub(known).is_some_and(wanted))
            .collect();
        let part = nalgebra::DMatrix::from_fn(at.len(), at.len(), |i, j| {
            scores.information[(at[i], at[j])]
        });
        let score = DVector::from_fn(at.len(), |i, _| scores.score[at[i]]);
        crate::scores::inverse(&part).map_or(0.0, |inverse| score.dot(&(inverse * &score)))
    };
    let all = gain(&|_| true).max(f64::MIN_POSITIVE);
    let mut channels: Vec<report::Channel> = Vec::new();
    for (load, (_, site, _)) in grammar.channels.loads.iter().enumerate() {
        let explains = gain(&|term| grammar.terms[term].load == load) / all;
        channels.push(report::Channel {
            site: (*site).to_owned(),
            explains: explains.clamp(0.0, 1.0),
            histories: Vec::new(),
        });
    }
    channels
}
