//! Causes that flights agree on, where none leaves only noise.
//!
//! Measured flights differ from one another by more than their noise: what was told of one is a little wrong, the air moves. A cause
//! stands here where the flights agree on it and, beside it, on nothing else; what it leaves then has no law that they share.

use identify::{FitError, Iterate};

use crate::bench::Bench;
use crate::causes::{Cause, Found};
use crate::common::Common;

/// The probability that flights which each bend their own way agree on anything by chance.
const ALARM: f64 = 0.01;

/// The probability that a cause is rejected by chance.
const REJECT: f64 = 0.002;

/// Flights of which fewer cannot agree so well that chance would not.
const FEWEST: usize = 20;

/// A cause explains the most part of what is more than noise, of flights that do not contradict it.
const MOST: f64 = 0.5;

/// Most flights go with a cause.
const GO_WITH_IT: f64 = 0.5;

/// What flights agree on.
pub struct Agreed {
    /// Causes that they agree on; each explains most of what is more than noise. None where that is so only without the flights that
    /// contradict.
    pub causes: Vec<Cause>,
    /// The part that is explained.
    pub part: f64,
    /// The probability that flights agree as well by chance.
    pub chance: f64,
    /// Flights that contradict, by index: the causes are to be looked for again without them.
    pub contradicting: Vec<usize>,
}

/// Looks for causes that the flights agree on; none where they agree on nothing, or on something that is no cause.
///
/// # Errors
/// Where a flight is impossible.
pub fn agreed(bench: &Bench, found: &Found, base: &Iterate) -> Result<Option<Agreed>, FitError> {
    let flights = bench.observation_sets.len();
    if flights < FEWEST {
        return Ok(None);
    }
    let Some(nothing) = bench.cause(&[], base, &found.noise) else {
        return Ok(None);
    };
    let common = bench.common(&nothing, found)?;
    let chances = common.chances(&bench.groups(&[]));
    let asked_for = (0..bench.candidates.len()).filter(|&index| {
        let candidate = &bench.candidates[index];
        candidate.states.is_empty() && !candidate.global.is_empty() && chances[index] < ALARM
    });
    let mut standing: Vec<(Cause, f64)> = Vec::new();
    for index in asked_for {
        let Some(cause) = bench.cause(&[index], &nothing.point, &found.noise) else {
            continue;
        };
        let beside = bench
            .common(&cause, found)?
            .chances(&bench.groups(&[index]));
        if beside.iter().all(|chance| *chance >= REJECT) {
            standing.push((cause, chances[index]));
        }
    }
    standing.sort_by(|a, b| a.0.squares.total_cmp(&b.0.squares));
    let excess = common.excess(0..flights);
    let part = |cause: &Cause| (nothing.squares - cause.squares) / excess;
    // Of what most flights go with, that which explains most of them.
    let mut chosen: Option<(f64, f64, Vec<usize>)> = None;
    for (cause, chance) in &standing {
        let [unknown] = bench.candidates[cause.effects[0]].global[..] else {
            continue;
        };
        let (without, gained) = common.contradicting(unknown);
        let with = (0..flights).filter(|flight| !without.contains(flight));
        let part = gained / common.excess(with);
        let many = flights - without.len();
        let enough = many >= FEWEST && many as f64 >= GO_WITH_IT * flights as f64;
        if enough && part >= MOST && chosen.as_ref().is_none_or(|(most, ..)| part > *most) {
            chosen = Some((part, *chance, without));
        }
    }
    standing.retain(|(cause, _)| part(cause) >= MOST);
    let best = standing.first().map(|(best, chance)| (part(best), *chance));
    let contradicting = chosen.as_ref().map(|(.., without)| without.clone());
    let of_most = chosen.map(|(part, chance, _)| (part, chance));
    Ok(best.or(of_most).map(|(part, chance)| Agreed {
        causes: standing.into_iter().map(|(cause, _)| cause).collect(),
        part,
        chance,
        contradicting: contradicting.unwrap_or_default(),
    }))
}

impl Bench {
    /// What each flight alone says where a cause is allowed for.
    fn common(&self, cause: &Cause, found: &Found) -> Result<Common, FitError> {
        let blocks = self.look_further(cause.vantage(), &found.noise)?;
        Common::new(self, &blocks, &cause.effects).map_err(FitError::Mismatch)
    }

    /// The shared unknowns of each candidate that is not allowed for, in order, and each term's.
    fn groups(&self, allowed: &[usize]) -> Vec<Vec<usize>> {
        let each = self.candidates.iter().enumerate();
        let of_candidates = each.map(|(index, columns)| match allowed.contains(&index) {
            true => Vec::new(),
            false => columns.global.clone(),
        });
        let known = self.problem.globals.len();
        let terms = self
            .grammar
            .as_ref()
            .map_or(0, |grammar| grammar.terms.len());
        of_candidates
            .chain((known..known + terms).map(|term| vec![term]))
            .collect()
    }
}
