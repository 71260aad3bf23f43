//! Whether flights agree on what they lack. Where something bends each flight in a way of its own, no law that they share leaves only
//! noise, and chi squared refuses every one in turn; what all flights ask for alike still stands out by its sign.

use identify::{NormalBlock, ReducedSystem, eliminate};
use nalgebra::DMatrix;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use crate::bench::Bench;
use crate::scores::{inverse, local_block};

/// Draws of signs, and their seed.
const DRAWS: usize = 10_000;
const SEED: u64 = 1;

/// The part of an unknown's squared effect on a flight that must be left of it once the flight's own unknowns are allowed for.
const VISIBLE: f64 = 1e-8;

/// What each flight alone says of each shared unknown and each term, once the flights' own unknowns and the base are allowed for.
pub struct Common {
    /// Score of a flight (a row) for an unknown (a column): positive where it asks for more of it.
    scores: DMatrix<f64>,
    /// Squared size of what the unknown would do to the flight.
    sizes: DMatrix<f64>,
    /// What is left of each flight: its weighted sum of squares, and what that would be of noise.
    left: Vec<(f64, f64)>,
}

impl Common {
    /// Looks at flights by their normal equations, with some candidates allowed for.
    ///
    /// # Errors
    /// In words, where a flight does not determine its own unknowns.
    pub fn new(bench: &Bench, blocks: &[NormalBlock], allowed: &[usize]) -> Result<Self, String> {
        let size = blocks.first().map_or(0, |block| block.global.nrows());
        let free = bench.unknowns(allowed);
        // Twice over the flights, so that no flight's matrix need be kept.
        let each_flight = |take: &mut dyn FnMut(usize, &ReducedSystem<'_>)| -> Result<(), String> {
            for (flight, block) in blocks.iter().enumerate() {
                let (_, local) = bench.directions(flight, allowed);
                let blocks = [local_block(block, &local, &[])];
                let rest = eliminate(&blocks, 0.0).map_err(|_| {
                    let file = &bench.observation_sets[flight].file;
                    format!("{file}: its samples do not determine its initial state")
                })?;
                take(flight, &rest);
            }
            Ok(())
        };
        let mut total = DMatrix::zeros(size, size);
        each_flight(&mut |_, rest| total += &rest.reduced)?;
        let base = DMatrix::from_fn(free.len(), free.len(), |i, j| total[(free[i], free[j])]);
        let cross = DMatrix::from_fn(free.len(), size, |i, j| total[(free[i], j)]);
        let inverse = inverse(&base).ok_or("the base's unknowns are not determined")?;
        let leaning = inverse * cross;
        let columns: Vec<usize> = (0..size).filter(|column| !free.contains(column)).collect();
        let mut common = Self {
            scores: DMatrix::zeros(blocks.len(), size),
            sizes: DMatrix::zeros(blocks.len(), size),
            left: blocks.iter().map(|b| (b.squares, b.count as f64)).collect(),
        };
        each_flight(&mut |flight, rest| {
            let (matrix, gradient) = (&rest.reduced, &rest.gradient);
            let part = DMatrix::from_fn(free.len(), free.len(), |i, j| matrix[(free[i], free[j])]);
            let leant = part * &leaning;
            for &column in &columns {
                let raw = matrix[(column, column)];
                let (mut score, mut length) = (-gradient[column], raw);
                for (row, &i) in free.iter().enumerate() {
                    let lean = leaning[(row, column)];
                    score += lean * gradient[i];
                    length += lean * (leant[(row, column)] - 2.0 * matrix[(i, column)]);
                }
                if length > VISIBLE * raw {
                    common.scores[(flight, column)] = score;
                    common.sizes[(flight, column)] = length;
                }
            }
        })?;
        Ok(common)
    }

    /// By how much more than noise is left of some flights: weighted squares.
    pub fn excess(&self, flights: impl Iterator<Item = usize>) -> f64 {
        flights.map(|f| self.left[f].0 - self.left[f].1).sum()
    }

    /// The cosine between what is left of a flight and what an unknown would do to it.
    fn cosine(&self, flight: usize, unknown: usize) -> f64 {
        let both = (self.sizes[(flight, unknown)] * self.left[flight].0).sqrt();
        if both > 0.0 {
            (self.scores[(flight, unknown)] / both).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    }

    /// The probability, over all groups of unknowns at once, that flights of which each bends its own way, to a side that chance
    /// gives it, agree on one of them as well as these do on each.
    pub fn chances(&self, groups: &[Vec<usize>]) -> Vec<f64> {
        let flights = self.scores.nrows();
        let normed = |&unknown: &usize| {
            let cosines: Vec<f64> = (0..flights).map(|f| self.cosine(f, unknown)).collect();
            let size = cosines.iter().map(|c| c * c).sum::<f64>().sqrt();
            let scale = if size > 0.0 { 1.0 / size } else { 0.0 };
            cosines.iter().map(|c| c * scale).collect::<Vec<f64>>()
        };
        let groups: Vec<Vec<Vec<f64>>> = groups
            .iter()
            .map(|group| group.iter().map(normed).collect())
            .collect();
        let agreement = |signs: &[f64], group: &[Vec<f64>]| {
            let along = |cosines: &Vec<f64>| -> f64 {
                let each = cosines.iter().zip(signs);
                each.map(|(cosine, sign)| cosine * sign).sum()
            };
            group.iter().map(|c| along(c).abs()).fold(0.0, f64::max)
        };
        let mut signs = vec![1.0; flights];
        let seen: Vec<f64> = groups.iter().map(|g| agreement(&signs, g)).collect();
        let mut random = ChaCha12Rng::seed_from_u64(SEED);
        let mut greatest = Vec::with_capacity(DRAWS);
        for _ in 0..DRAWS {
            signs.fill_with(|| if random.random::<bool>() { 1.0 } else { -1.0 });
            let each = groups.iter().map(|group| agreement(&signs, group));
            greatest.push(each.fold(0.0, f64::max));
        }
        greatest.sort_by(f64::total_cmp);
        let as_well = |seen: f64| DRAWS - greatest.partition_point(|drawn| *drawn < seen);
        seen.into_iter()
            .map(|seen| (1 + as_well(seen)) as f64 / (1 + DRAWS) as f64)
            .collect()
    }

    /// Flights that have little of one unknown or the opposite, at a size of it that the others ask for and that they would show; and how
    /// much it takes from what is left of the others then.
    pub fn contradicting(&self, unknown: usize) -> (Vec<usize>, f64) {
        let flights = 0..self.scores.nrows();
        let score = |flight: usize| self.scores[(flight, unknown)];
        let size = |flight: usize| self.sizes[(flight, unknown)];
        // The side that most flights ask for, each by its cosine.
        let sum: f64 = flights.clone().map(|f| self.cosine(f, unknown)).sum();
        let side = sum.signum();
        let mut with: Vec<usize> = flights.clone().filter(|&f| side * score(f) > 0.0).collect();
        let mut value = 0.0;
        for _ in 0..ROUNDS {
            let all: f64 = with.iter().map(|&f| size(f)).sum();
            if all <= 0.0 {
                break;
            }
            value = with.iter().map(|&f| score(f)).sum::<f64>() / all;
            let goes_with_it = |f: &usize| {
                let shown = value * value * size(*f);
                shown < SHOWN || value * score(*f) > LITTLE * shown
            };
            let next: Vec<usize> = flights.clone().filter(goes_with_it).collect();
            if next == with {
                break;
            }
            with = next;
        }
        let gain = |f: &usize| value * (2.0 * score(*f) - value * size(*f));
        let gained = with.iter().map(gain).sum();
        (flights.filter(|f| !with.contains(f)).collect(), gained)
    }
}

/// Rounds of size and flights that ask for it.
const ROUNDS: usize = 20;

/// A flight in which the unknown would make a smaller difference to the weighted squares says nothing of it.
const SHOWN: f64 = 10.0;

/// A flight that has less than this part of what the others ask for contradicts them.
const LITTLE: f64 = 0.25;

#[cfg(test)]
mod tests {
    use super::*;
    use rand_distr::{Distribution, StandardNormal};

    /// Flights of which each has its own amount of two unknowns: about 1 of the first, but for the last `against`, and about 0 of
    /// the other.
    fn flights(count: usize, against: usize) -> Common {
        let mut random = ChaCha12Rng::seed_from_u64(4);
        let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
        let mut scores = DMatrix::zeros(count, 2);
        for flight in 0..count {
            let side = if flight + against < count { 1.0 } else { -1.0 };
            scores[(flight, 0)] = 1000.0 * (side + 0.3 * normal());
            scores[(flight, 1)] = 1000.0 * normal();
        }
        Common {
            scores,
            sizes: DMatrix::from_element(count, 2, 1000.0),
            left: vec![(2500.0, 100.0); count],
        }
    }

    #[test]
    fn flights_agree_on_what_they_share_and_on_nothing_else() {
        let groups = [vec![0], vec![1], vec![]];
        let chances = flights(24, 0).chances(&groups);
        assert!(chances[0] < 0.001 && chances[1] > 0.05, "{chances:?}");
        assert_eq!(chances[2], 1.0);
        // Where half of them ask for the opposite they agree on nothing.
        let chances = flights(24, 12).chances(&groups);
        assert!(chances[0] > 0.05, "{chances:?}");
    }

    #[test]
    fn chance_is_as_often_below_a_level_as_the_level_says() {
        let mut below = 0;
        let mut random = ChaCha12Rng::seed_from_u64(9);
        for _ in 0..300 {
            let mut none = flights(20, 0);
            for score in none.scores.iter_mut() {
                *score = StandardNormal.sample(&mut random);
            }
            let least = none.chances(&[vec![0], vec![1]]);
            below += usize::from(least.iter().any(|chance| *chance < 0.1));
        }
        // 30 of them, ± 5.
        assert!((12..=48).contains(&below), "{below}");
    }

    #[test]
    fn flights_that_contradict_are_those_on_the_other_side() {
        let (without, gained) = flights(24, 7).contradicting(0);
        assert_eq!(without, (17..24).collect::<Vec<_>>());
        // Each of the 17 has about 1000 to give.
        assert!((gained / 17_000.0 - 1.0).abs() < 0.3, "{gained}");
        assert!(flights(24, 0).contradicting(0).0.is_empty());
    }
}
