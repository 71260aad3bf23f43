//! The set of causes that the data do not reject.
//!
//! A cause is rejected where, with it allowed for, another candidate, or a term outside the catalogue, would still explain more
//! than chance does. What is left is the answer: one cause, or several that these flights cannot tell apart; where no
//! single one is left, two and three at once.

use identify::{FitError, FitProblem, Iterate, NoiseModel};

use crate::bench::Bench;
use crate::chance::thresholds;
use crate::kept::{Kept, Vantage, without_terms};
use crate::scores::{Score, Scores};

/// The probability that chance alone raises an alarm.
pub const ALARM: f64 = 0.004;

/// The probability that the true cause is rejected by chance.
const REJECT: f64 = 0.002;

/// A cause is refitted where its score says that it may come as near as this to the best: chi squared, and a part of the best
/// for what straight lines miss.
const NEAR: (f64, f64) = (30.0, 0.25);

/// Causes that are refitted at most, of each number of effects.
const MOST: usize = 6;

/// Effects at once.
const AT_ONCE: usize = 3;

/// Another estimate of the noise that differs by less says the same.
const SAME: f64 = 0.05;

/// Refits from which more effects are added.
const SEEDS: usize = 3;

/// What was found.
pub struct Found {
    /// The noise.
    pub noise: NoiseModel,
    /// The scores with every candidate off, and those of terms outside the catalogue.
    pub scores: Scores,
    /// The sum of squares that the base leaves under that noise.
    pub squares: f64,
    /// The limits of probabilities.
    pub limits: Limits,
    /// Whether anything explains more than chance.
    pub alarmed: bool,
    /// Causes that are not rejected, the best first.
    pub causes: Vec<Cause>,
    /// Those that are rejected, the best first, where all are.
    pub nearest: Vec<Cause>,
}

/// What the logarithm of a probability must be below.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// For an alarm.
    pub alarm: f64,
    /// For a cause to be rejected.
    pub reject: f64,
}

/// One or several effects that were fitted with the base.
pub struct Cause {
    /// The candidates.
    pub effects: Vec<usize>,
    /// The model in which they may be on.
    pub problem: FitProblem,
    /// All unknowns there.
    pub point: Iterate,
    /// The sum of squares that is left.
    pub squares: f64,
    /// The scores of the others there.
    pub scores: Scores,
    /// The other that would explain most, and the logarithm of its probability.
    pub rival: Option<(usize, f64)>,
    kept: Kept,
}

impl Cause {
    /// Where it is.
    pub(crate) fn vantage(&self) -> Vantage<'_> {
        Vantage {
            problem: &self.problem,
            point: &self.point,
            kept: &self.kept,
        }
    }
}

/// Searches single causes of what is left at the base's fit.
///
/// # Errors
/// Where a flight is impossible.
pub fn search(
    bench: &mut Bench,
    base: &Iterate,
    first_guess: &NoiseModel,
) -> Result<Found, FitError> {
    let problem = bench.problem.clone();
    let kept = Kept::of(bench.observation_sets.len());
    let base = Vantage {
        problem: &problem,
        point: base,
        kept: &kept,
    };
    let noise = bench.leftover(base, &[], first_guess)?;
    let (scores, limits, squares) = bench.scored(base, &noise)?;
    let mut found = Found {
        alarmed: scores.alarms(&limits),
        noise,
        scores,
        squares,
        limits,
        causes: Vec::new(),
        nearest: Vec::new(),
    };
    if !found.alarmed {
        return Ok(found);
    }
    let mut here: Vec<Cause> = Vec::new();
    for (index, effects) in singles(&found.scores).into_iter().enumerate() {
        // The likeliest is looked at again and again.
        let kept = Kept::of(if index == 0 {
            bench.observation_sets.len()
        } else {
            0
        });
        let Some(cause) = bench.cause_kept(&effects, base.point, &found.noise, kept) else {
            continue;
        };
        if index == 0 && bench.is_nearer(&cause, base, &mut found)? {
            here.extend(bench.cause(&effects, base.point, &found.noise));
        } else {
            here.push(cause);
        }
    }
    bench.take_standing(here, &mut found)?;
    Ok(found)
}

/// Searches causes of one more effect than those that were rejected.
///
/// # Errors
/// Where a flight is impossible.
pub fn search_on(bench: &Bench, found: &mut Found) -> Result<(), FitError> {
    let Some(count) = found.nearest.first().map(|cause| cause.effects.len() + 1) else {
        return Ok(());
    };
    if count > AT_ONCE {
        return Ok(());
    }
    let wanted = extended(&found.nearest, count);
    let here = wanted.iter();
    let here = here.filter_map(|(effects, seed)| {
        bench.cause(effects, &found.nearest[*seed].point, &found.noise)
    });
    let here = here.collect();
    bench.take_standing(here, found)?;
    // What stands may have one effect too many: a better start shows that fewer do.
    while let Some(fewer) = bench.pruned(found)? {
        found.causes = fewer;
    }
    Ok(())
}

/// Single candidates that may be the cause, the likeliest first.
fn singles(scores: &Scores) -> Vec<Vec<usize>> {
    let each = scores.each.iter().enumerate();
    let mut gains: Vec<(usize, f64)> = each
        .filter_map(|(index, score)| Some((index, score.as_ref()?)))
        .filter(|(_, score)| score.freedom > 0)
        .map(|(index, score)| (index, score.statistic - 2.0 * score.freedom as f64))
        .collect();
    gains.sort_by(|a, b| b.1.total_cmp(&a.1));
    let best = gains.first().map_or(0.0, |gain| gain.1);
    let near = gains
        .into_iter()
        .filter(|(_, gain)| *gain > best - NEAR.0 - NEAR.1 * best);
    near.take(MOST).map(|(index, _)| vec![index]).collect()
}

/// The best causes with one more effect each, the likeliest first, and which cause that was.
fn extended(fitted: &[Cause], count: usize) -> Vec<(Vec<usize>, usize)> {
    let mut all: Vec<(Vec<usize>, usize, f64)> = Vec::new();
    for (seed, cause) in fitted.iter().enumerate().take(SEEDS) {
        for (index, score) in cause.scores.each.iter().enumerate() {
            let Some(score) = score.as_ref().filter(|score| score.freedom > 0) else {
                continue;
            };
            let mut effects = cause.effects.clone();
            effects.push(index);
            effects.sort_unstable();
            let left = cause.squares - score.statistic + 2.0 * score.freedom as f64;
            match all.iter_mut().find(|(same, ..)| *same == effects) {
                Some((_, from, least)) if left < *least => (*from, *least) = (seed, left),
                Some(_) => {}
                None if effects.len() == count => all.push((effects, seed, left)),
                None => {}
            }
        }
    }
    all.sort_by(|a, b| a.2.total_cmp(&b.2));
    let least = all.first().map_or(0.0, |all| all.2);
    let gained = fitted.first().map_or(0.0, |cause| cause.squares) - least;
    let near = all
        .into_iter()
        .filter(|(.., left)| *left < least + NEAR.0 + NEAR.1 * gained);
    near.take(MOST)
        .map(|(effects, seed, _)| (effects, seed))
        .collect()
}

impl Scores {
    /// Whether anything explains more than chance.
    pub(crate) fn alarms(&self, limits: &Limits) -> bool {
        let least = |best: Option<(usize, &Score)>| best.map_or(0.0, |(_, score)| score.ln_p);
        least(self.best()).min(least(self.best_term())) < limits.alarm
    }
}

impl Bench {
    pub(crate) fn scored(
        &self,
        from: Vantage<'_>,
        noise: &NoiseModel,
    ) -> Result<(Scores, Limits, f64), FitError> {
        let blocks = self.look_further(from, noise)?;
        let squares = blocks.iter().map(|block| block.squares).sum();
        let scores = Scores::new(self, &blocks, (&[], &[]), &from.point.global)
            .map_err(FitError::Mismatch)?;
        let limits = thresholds(
            &scores.information,
            &scores.groups,
            scores.others,
            &[ALARM, REJECT],
            1,
        );
        let limits = Limits {
            alarm: limits[0],
            reject: limits[1],
        };
        Ok((scores, limits, squares))
    }

    /// Fits some candidates with the base; none where that is impossible.
    pub fn cause(&self, effects: &[usize], from: &Iterate, noise: &NoiseModel) -> Option<Cause> {
        self.cause_kept(effects, from, noise, Kept::default())
    }

    /// The same, with flights from there kept where there is room for them.
    fn cause_kept(
        &self,
        effects: &[usize],
        from: &Iterate,
        noise: &NoiseModel,
        kept: Kept,
    ) -> Option<Cause> {
        let problem = self.setting_with(effects);
        let (point, squares) = self.refit(&problem, effects, from, noise).ok()?;
        let blocks = match kept.is_empty() {
            true => self.look(&problem, &point, noise).ok()?,
            false => {
                let from = Vantage {
                    problem: &problem,
                    point: &point,
                    kept: &kept,
                };
                let blocks = self.look_further(from, noise).ok()?;
                let global = point.global.len();
                let each = blocks.iter().map(|block| without_terms(block, global));
                each.collect()
            }
        };
        let scores = Scores::new(self, &blocks, (effects, &[]), &point.global).ok()?;
        let rival = scores.best().map(|(index, score)| (index, score.ln_p));
        Some(Cause {
            problem,
            effects: effects.to_vec(),
            point,
            squares,
            scores,
            rival,
            kept,
        })
    }

    /// Keeps the causes that stand; all of them as the nearest where none does.
    fn take_standing(&self, mut here: Vec<Cause>, found: &mut Found) -> Result<(), FitError> {
        here.sort_by(|a, b| a.squares.total_cmp(&b.squares));
        let mut standing = Vec::new();
        for (index, cause) in here.iter().enumerate() {
            if self.stands(cause, found)? {
                standing.push(index);
            }
        }
        if standing.is_empty() {
            found.nearest = here;
        } else {
            let each = here.into_iter().enumerate();
            let kept = each.filter(|(index, _)| standing.contains(index));
            found.causes = kept.map(|(_, cause)| cause).collect();
        }
        Ok(())
    }

    /// Causes that stand with one effect fewer, fitted from where the causes are; none where all are needed.
    fn pruned(&self, found: &Found) -> Result<Option<Vec<Cause>>, FitError> {
        let mut fewer: Vec<Cause> = Vec::new();
        for cause in found.causes.iter().filter(|cause| cause.effects.len() > 1) {
            for dropped in &cause.effects {
                let kept = cause.effects.iter().copied().filter(|e| e != dropped);
                let kept: Vec<usize> = kept.collect();
                if fewer.iter().any(|known| known.effects == kept) {
                    continue;
                }
                let from = self.without(&cause.point, *dropped);
                let Some(less) = self.cause(&kept, &from, &found.noise) else {
                    continue;
                };
                if self.stands(&less, found)? {
                    fewer.push(less);
                }
            }
        }
        fewer.sort_by(|a, b| a.squares.total_cmp(&b.squares));
        Ok((!fewer.is_empty()).then_some(fewer))
    }

    /// A point with one candidate off.
    fn without(&self, point: &Iterate, dropped: usize) -> Iterate {
        let columns = &self.candidates[dropped];
        let mut point = point.clone();
        let parts = &columns.candidate.coefficients;
        for (&unknown, part) in columns.global.iter().zip(parts) {
            point.global[unknown] = part.null_value;
        }
        for part in &columns.candidate.states {
            for local in &mut point.local {
                local[part.index] = part.null_value;
            }
        }
        point
    }

    /// How many unknowns some candidates have in all flights.
    pub fn size_of(&self, effects: &[usize]) -> usize {
        let each = effects.iter().map(|&e| &self.candidates[e]);
        each.map(|c| c.global.len() + c.states.len() * self.observation_sets.len())
            .sum()
    }

    /// Estimates the noise from what the best cause leaves, which is nearer to it still, and scores anew where that
    /// makes a difference.
    fn is_nearer(
        &mut self,
        cause: &Cause,
        base: Vantage<'_>,
        found: &mut Found,
    ) -> Result<bool, FitError> {
        let nearer = self.leftover(cause.vantage(), &cause.effects, &found.noise)?;
        let same = |axis: usize| {
            (nearer.sigma[axis] / found.noise.sigma[axis] - 1.0).abs() < SAME
                && (nearer.ar1[axis] - found.noise.ar1[axis]).abs() < SAME
        };
        if (0..3).all(same) {
            return Ok(false);
        }
        found.noise = nearer;
        (found.scores, found.limits, found.squares) = self.scored(base, &found.noise)?;
        Ok(true)
    }

    /// The scores of everything, terms too, where a cause is allowed for.
    pub(crate) fn scored_beside(
        &self,
        cause: &Cause,
        noise: &NoiseModel,
    ) -> Result<Scores, FitError> {
        let blocks = self.look_further(cause.vantage(), noise)?;
        let allowed = (cause.effects.as_slice(), &[][..]);
        Scores::new(self, &blocks, allowed, &cause.point.global).map_err(FitError::Mismatch)
    }

    /// Whether with a cause allowed for nothing explains more than chance, neither a candidate nor a term outside the catalogue.
    fn stands(&self, cause: &Cause, found: &Found) -> Result<bool, FitError> {
        if cause
            .rival
            .is_some_and(|(_, ln_p)| ln_p < found.limits.reject)
        {
            return Ok(false);
        }
        let scores = self.scored_beside(cause, &found.noise)?;
        let best = scores.best_term();
        Ok(best.is_none_or(|(_, score)| score.ln_p >= found.limits.reject))
    }
}
