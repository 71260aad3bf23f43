//! What lies outside the catalogue: terms are taken one by one, each the one that explains most of what is left.

use identify::dataset::Dataset;
use identify::{Fit, fit};
use model_spec::model::Model;
use nalgebra::DVector;

use crate::bench::Bench;
use crate::catalogue::{Catalogue, underscored};
use crate::causes::{Cause, Found};
use crate::diagnosis::{Asked, DiagnosisError};
use crate::extend::Extension;
use crate::kept::{Kept, Vantage};
use crate::scores::Scores;
use crate::terms::Grammar;
use crate::{report, words};

/// Terms that are taken at most.
const MOST: usize = 4;

/// Terms that are told of.
const TOLD: usize = 12;

/// A model with terms that were written for these flights.
pub struct Written {
    /// Effects of the catalogue that they stand beside, with underscores.
    pub effects: Vec<String>,
    /// How many unknowns those have in all flights.
    pub beside: usize,
    /// Terms that were taken, by index in the grammar, in the order in which they were.
    pub taken: Vec<usize>,
    /// The terms with the greatest statistics, and those taken.
    pub told: Vec<report::Term>,
    /// The model with them, and its fit; none where no term explains anything.
    pub model: Option<(Extension, Fit)>,
    /// The sum of squares that they leave, under the noise of the search.
    pub squares: f64,
    /// Whether nothing explains more than chance once they are in.
    pub stands: bool,
}

/// What terms are looked for in.
#[derive(Clone, Copy)]
pub struct Place<'a> {
    /// The model.
    pub model: &'a Model,
    /// The flights.
    pub dataset: &'a Dataset,
    /// What was asked.
    pub asked: &'a Asked<'a>,
}

/// Takes terms one by one, each the one that explains most of what is left, and fits anew with each; beside the effects of a
/// cause that does not stand by itself, where one is given. None where the model has no place for terms.
///
/// # Errors
/// Where a flight is impossible.
pub fn write(
    place: Place<'_>,
    bench: &Bench,
    found: &Found,
    beside: Option<&Cause>,
) -> Result<Option<Written>, DiagnosisError> {
    let Some(grammar) = &bench.grammar else {
        return Ok(None);
    };
    let name = |&index: &usize| underscored(&bench.candidates[index].candidate.name);
    let effects: Vec<String> = beside.iter().flat_map(|c| &c.effects).map(name).collect();
    let first = match beside {
        Some(cause) => Some(bench.scored_beside(cause, &found.noise)?),
        None => None,
    };
    let first = first.as_ref().unwrap_or(&found.scores);
    let mut written = Written {
        effects: effects.clone(),
        beside: beside.map_or(0, |cause| bench.size_of(&cause.effects)),
        taken: Vec::new(),
        told: told(grammar, first),
        model: None,
        squares: beside.map_or(found.squares, |cause| cause.squares),
        stands: false,
    };
    let mut next = best(first, found, &[]);
    while let Some(term) = next.filter(|_| written.taken.len() < MOST) {
        let mut taken = written.taken.clone();
        taken.push(term);
        let evidence = |term: &usize| {
            let told = written.told.iter().find(|t| t.name == grammar.name(*term));
            grammar.effect(*term, &words::evidence(place.asked.dataset, bench, told))
        };
        let of_terms = taken.iter().map(|&term| underscored(&grammar.name(term)));
        let names = effects.iter().cloned().chain(of_terms);
        let texts = taken.iter().map(evidence).collect();
        let with = place.asked.with;
        let Ok(extension) = Extension::new(place.model, with, names.collect(), texts) else {
            break;
        };
        let Ok(fitted) = fit(&extension.model, place.dataset, &place.asked.fit) else {
            break;
        };
        let all: Vec<String> = with.iter().chain(&extension.effects).cloned().collect();
        let catalogue = Catalogue::new(&extension.model, &all, place.asked.without)?;
        let (mut there, point) = Bench::new(&catalogue, place.dataset, &fitted, &place.asked.fit)?;
        for (to, from) in there
            .observation_sets
            .iter_mut()
            .zip(&bench.observation_sets)
        {
            to.outlier.clone_from(&from.outlier);
        }
        let once = Vantage {
            problem: &there.problem,
            point: &point,
            kept: &Kept::default(),
        };
        let (scores, _, squares) = there.scored(once, &found.noise)?;
        // A term that takes nothing from the squares was none.
        if squares > written.squares {
            break;
        }
        written.squares = squares;
        written.model = Some((extension, fitted));
        written.taken = taken;
        let rival = scores
            .best()
            .is_some_and(|(_, score)| score.ln_p < found.limits.reject);
        next = best(&scores, found, &written.taken);
        written.stands = !rival && next.is_none();
        if written.stands {
            break;
        }
    }
    for term in &written.taken {
        let name = grammar.name(*term);
        match written.told.iter_mut().find(|told| told.name == name) {
            Some(told) => told.taken = true,
            None => written.told.push(term_of(grammar, first, *term, true)),
        }
    }
    Ok(Some(written))
}

/// The term that explains most, where that is more than chance.
fn best(scores: &Scores, found: &Found, taken: &[usize]) -> Option<usize> {
    let best = scores.best_term()?;
    (best.1.ln_p < found.limits.reject && !taken.contains(&best.0)).then_some(best.0)
}

fn told(grammar: &Grammar, scores: &Scores) -> Vec<report::Term> {
    let mut order: Vec<usize> = (0..scores.terms.len())
        .filter(|&index| scores.terms[index].freedom > 0)
        .collect();
    order.sort_by(|&a, &b| {
        scores.terms[b]
            .statistic
            .total_cmp(&scores.terms[a].statistic)
    });
    order.truncate(TOLD);
    let each = order.into_iter();
    each.map(|term| term_of(grammar, scores, term, false))
        .collect()
}

fn term_of(grammar: &Grammar, scores: &Scores, term: usize, taken: bool) -> report::Term {
    let score = &scores.terms[term];
    let (value, std_error) = score.estimates.first().map_or((0.0, 0.0), |e| (e.1, e.2));
    report::Term {
        name: grammar.name(term),
        site: grammar.site(term).to_owned(),
        formula: grammar.formula(term),
        statistic: score.statistic,
        value,
        std_error,
        taken,
    }
}

/// What each channel alone would explain, as a part of what all terms together would.
pub fn channels(bench: &Bench, scores: &Scores) -> Vec<report::Channel> {
    let Some(grammar) = &bench.grammar else {
        return Vec::new();
    };
    let size = scores.information.nrows();
    let known = bench.problem.globals.len();
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
