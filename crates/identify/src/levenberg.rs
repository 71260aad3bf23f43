//! Levenberg–Marquardt over all flights at once, within bounds.

mod step;

use flight::batch;
use nalgebra::DVector;

use crate::normal::{Block, Eliminated, Rest, Undetermined};
pub use step::shared_step;

/// A sum of squares with unknowns shared by all flights and unknowns of each flight.
pub trait Problem: Sync {
    /// How many flights there are.
    fn flights(&self) -> usize;

    /// Residuals of a flight and their derivatives, as normal equations.
    ///
    /// # Errors
    /// In words, where the flight cannot be predicted from these values.
    fn linearise(
        &self,
        flight: usize,
        shared: &DVector<f64>,
        own: &DVector<f64>,
    ) -> Result<Block, String>;

    /// A flight's own unknowns after a step.
    fn moved(&self, flight: usize, own: &DVector<f64>, step: &DVector<f64>) -> DVector<f64>;

    /// What is known of each shared unknown beforehand.
    fn known(&self) -> &[Known];

    /// How many flights may be worked on at once.
    fn threads(&self) -> usize {
        1
    }

    /// Whether the work is to be given up.
    fn is_stopped(&self) -> bool {
        false
    }
}

/// What is known of a shared unknown beforehand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Least and greatest value.
    pub bounds: (f64, f64),
    /// Value and standard deviation of a normal prior.
    pub prior: Option<(f64, f64)>,
}

impl Known {
    /// Nothing.
    pub const NOTHING: Known = Known {
        bounds: (f64::NEG_INFINITY, f64::INFINITY),
        prior: None,
    };

    /// What the prior adds to the sum of squares.
    fn squares(&self, value: f64) -> f64 {
        self.prior
            .map_or(0.0, |(centre, sigma)| ((value - centre) / sigma).powi(2))
    }
}

/// Values of all unknowns.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Shared by all flights.
    pub shared: DVector<f64>,
    /// Each flight's own.
    pub own: Vec<DVector<f64>>,
}

/// Where the iteration ended.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The unknowns.
    pub point: Point,
    /// Normal equations there, but for a negligible last step.
    pub blocks: Vec<Block>,
    /// The sum of squares with that of the priors; of a last step that nobody saw, as it promised.
    pub squares: f64,
    /// Steps that were tried.
    pub iterations: usize,
    /// Whether the steps had become negligible.
    pub converged: bool,
    /// By how much the last step that was not held back was to decrease the sum of squares.
    pub promised: Option<f64>,
}

impl Solution {
    /// Whether the last step, which nobody saw, was negligible in itself.
    pub fn is_there(&self, until: Until) -> bool {
        let negligible = |promised| until.is_negligible(promised, self.squares);
        self.converged && self.promised.is_some_and(negligible)
    }
}

/// Why there is no solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Failure {
    /// A flight cannot be predicted from its starting values.
    #[error("flight {flight} cannot be predicted from its starting values: {reason}")]
    Start {
        /// Index of the flight.
        flight: usize,
        /// In words.
        reason: String,
    },
    /// A flight's own unknowns are not determined.
    #[error(transparent)]
    Undetermined(#[from] Undetermined),
    /// It was told to stop.
    #[error("interrupted")]
    Stopped,
}

/// When the iteration ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Until {
    /// A step that promises no more of the sum of squares is negligible.
    pub gain: f64,
    /// A step that promises no more than this part of it is negligible.
    pub part: f64,
    /// A step that promises up to so many times more is taken unseen where the next would be negligible.
    pub unseen: f64,
    /// Steps after which the iteration is given up.
    pub steps: usize,
}

impl Until {
    /// Whitened residuals: the step that is then taken unseen is a standard error at most, and what it leaves a thirtieth.
    pub const DONE: Until = Until {
        gain: 1e-3,
        part: 1e-11,
        unseen: 1e3,
        steps: 100,
    };
    /// On the way, where the weights will change anyway.
    pub const ROUGHLY: Until = Until {
        gain: 1e-2,
        part: 1e-3,
        unseen: 1e3,
        steps: 30,
    };
    /// On the way to longer flights, which will tell more than is left here.
    pub const NEAR: Until = Until {
        part: 1e-2,
        unseen: f64::INFINITY,
        ..Until::ROUGHLY
    };
    /// After one step, unseen.
    pub const ONCE: Until = Until {
        gain: f64::INFINITY,
        steps: 1,
        ..Until::ROUGHLY
    };

    /// Whether a step promises so little of what is left that it is negligible.
    fn is_negligible(&self, promised: f64, squares: f64) -> bool {
        promised <= self.gain.max(self.part * squares)
    }

    /// Whether a step need not be seen: it is negligible, or the next will be, as the promises shrink from the one `before`.
    fn is_reached(&self, promised: f64, before: Option<f64>, squares: f64) -> bool {
        let next = before.map_or(f64::INFINITY, |before| promised * (promised / before));
        self.is_negligible(promised, squares)
            || self.is_negligible(promised / self.unseen, squares)
                && self.is_negligible(next, squares)
    }
}

/// Damping at which no step is tried any more.
const MOST_DAMPING: f64 = 1e8;

/// Damping up to which a step is as long as it would be without.
const FREE_DAMPING: f64 = 1e-6;

/// Damping below which it makes no difference.
const LEAST_DAMPING: f64 = 1e-12;

/// Minimises the sum of squares from a starting point.
///
/// # Errors
/// See [`Failure`].
pub fn solve(problem: &impl Problem, start: Point, until: Until) -> Result<Solution, Failure> {
    solve_after(problem, start, until, None)
}

/// The same from where another iteration ended, by what its last step had promised of nearly the same sum of squares.
///
/// # Errors
/// See [`Failure`].
pub fn solve_after(
    problem: &impl Problem,
    start: Point,
    until: Until,
    mut last_promised: Option<f64>,
) -> Result<Solution, Failure> {
    let mut point = start;
    let mut damping = 1e-9;
    let mut look = look_at(problem, &point, damping)?;
    let mut before = squares(problem, &point, &look.blocks);
    let mut iterations = 0;
    let mut converged = false;
    while iterations < until.steps {
        iterations += 1;
        let Some((candidate, promised)) = stepped(problem, &point, &mut look, damping) else {
            if damping >= MOST_DAMPING {
                break;
            }
            damping *= 10.0;
            continue;
        };
        // A negligible step is taken, and is not worth the look that it would cost.
        if until.is_reached(promised, last_promised, before) {
            point = candidate;
            before -= promised;
            last_promised = Some(promised);
            converged = true;
            break;
        }
        let less = (damping * 0.1).max(LEAST_DAMPING);
        let there = match look_at(problem, &candidate, less) {
            Ok(there) => Some(there),
            Err(Failure::Stopped) => return Err(Failure::Stopped),
            Err(_) => None,
        };
        let after = there.as_ref().map_or(f64::INFINITY, |there| {
            squares(problem, &candidate, &there.blocks)
        });
        match there {
            Some(there) if after < before => {
                (point, look, before) = (candidate, there, after);
                // Where steps are held back, how they shrink says nothing of what is left.
                last_promised = Some(promised).filter(|_| damping <= FREE_DAMPING);
                damping = less;
            }
            _ if damping < MOST_DAMPING => damping = (damping * 10.0).max(1e-6),
            _ => break,
        }
    }
    Ok(Solution {
        point,
        blocks: look.blocks,
        squares: before,
        iterations,
        converged,
        promised: last_promised,
    })
}

/// The flights at a point.
struct Look {
    blocks: Vec<Block>,
    /// What is left of each once its own unknowns are eliminated, by this damping; taken by the first who steps.
    rests: (f64, Option<Vec<Option<Rest>>>),
}

fn look_at(problem: &impl Problem, point: &Point, damping: f64) -> Result<Look, Failure> {
    let each = batch::each_on(problem.threads(), problem.flights(), |flight| {
        if problem.is_stopped() {
            return Err(Failure::Stopped);
        }
        let block = problem.linearise(flight, &point.shared, &point.own[flight]);
        let block = block.map_err(|reason| Failure::Start { flight, reason })?;
        let rest = Rest::new(&block, damping);
        Ok((block, rest))
    });
    let (blocks, rests) = each.into_iter().collect::<Result<_, _>>()?;
    Ok(Look {
        blocks,
        rests: (damping, Some(rests)),
    })
}

fn squares(problem: &impl Problem, point: &Point, blocks: &[Block]) -> f64 {
    let known = problem.known().iter().zip(point.shared.iter());
    let priors: f64 = known.map(|(known, &value)| known.squares(value)).sum();
    let sum = blocks.iter().map(|block| block.squares).sum::<f64>() + priors;
    if sum.is_nan() { f64::INFINITY } else { sum }
}

/// The point after a step, and the decrease of the squares that the step promises; none where the damping is too
/// small for there to be a step.
fn stepped(
    problem: &impl Problem,
    point: &Point,
    look: &mut Look,
    damping: f64,
) -> Option<(Point, f64)> {
    let made = look.rests.1.take_if(|_| look.rests.0 == damping);
    let anew = || {
        let each = look.blocks.iter();
        each.map(|block| Rest::new(block, damping)).collect()
    };
    let system = Eliminated::new(&look.blocks, made.unwrap_or_else(anew)).ok()?;
    let (step, prior_gain) = shared_step(
        &system.reduced,
        &system.gradient,
        &point.shared,
        problem.known(),
        damping,
    )?;
    let own_steps = system.own_steps(&step);
    let promised = system.promised(&step, &own_steps) + prior_gain;
    let steps = own_steps.iter().zip(&point.own).enumerate();
    let own = steps
        .map(|(flight, (step, own))| problem.moved(flight, own, step))
        .collect();
    let shared = &point.shared + step;
    Some((Point { shared, own }, promised))
}

#[cfg(test)]
mod tests;
