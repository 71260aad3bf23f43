//! Parts of a step that its stages may have flown over: where the arguments of functions that switch pass their levels,
//! such as the knots of a table.

mod path;

pub(crate) use self::path::Path;
use crate::root::first_past_root;
use lanes::{Enclosure, Real};

/// Reach of an argument beyond its values at the ends and the middle of a step, in units of their second difference: a
/// parabola reaches at most an eighth beyond the three, a roof a half, and nothing that bends to one side alone reaches
/// further than one.
const REACH: f64 = 1.0;

/// Greatest number of parts of a step whose bounds are asked for: the passages of one feature need some forty, those of
/// a jump as many. An argument that rests on a level, but for rounding, would have all parts asked.
const MOST_BOUNDS: usize = 256;

/// Number of equal parts of a step at whose ends the arguments are computed where their bounds do not tell enough.
const PARTS: usize = 8;

/// Number of points that are added near an extreme of an argument; the first is exact for a parabola.
const REFINEMENTS: usize = 4;

/// Least distance of an added point from its neighbours, as a fraction of the step.
const LEAST_DISTANCE: f64 = 1e-6;

/// Bracket width to which the passage of a level is located, as a fraction of the step.
const PASSAGE_WIDTH: f64 = 1e-8;

/// Least width of a cell that is asked for, as a fraction of the step: what happens within a narrower one would have to
/// exceed the rates beside it by a factor of its inverse to be more than a small part of the step.
const LEAST_CELL: f64 = 1e-7;

/// Largest change of the state by a cell, in tolerated errors, that may be flown over: the dense output, with whose rate
/// the cell is compared, is itself off by up to ten.
pub(crate) const MAX_OVERLOOKED: f64 = 10.0;

/// Arguments at the start, in the middle and at the end of a step.
pub(crate) type Points<'a> = [&'a [f64]; 3];

/// Arguments of switches over a step.
pub(crate) trait Arguments {
    /// Writes the arguments at the fraction `s` of the step.
    fn at(&mut self, s: f64, to: &mut [f64]);
    /// Writes bounds of the arguments in a part of the step; whether they are known.
    fn bounds(&mut self, part: (f64, f64), to: &mut [Enclosure]) -> bool;
}

/// Cell of a step between two passages: its middle and its width, as fractions of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cell {
    pub middle: f64,
    pub width: f64,
}

/// Number of passages of levels that are possible within a step, by the values of an argument at its start, in its middle
/// and at its end. One alone, of all arguments, is no cell: it shows in the derivatives at the ends.
#[inline(always)]
pub(crate) fn possible_passages(levels: &[f64], [start, middle, end]: [f64; 3]) -> usize {
    let reach = REACH * (start - 2.0 * middle + end).abs();
    let least = start.min(middle).min(end) - reach;
    let greatest = start.max(middle).max(end) + reach;
    let rests = least == greatest;
    if rests || levels.last().is_none_or(|last| *last < least) || levels[0] > greatest {
        return 0;
    }
    let within = index(levels, greatest).saturating_sub(index(levels, least));
    let returns = within > 0 && index(levels, start) == index(levels, end);
    within + usize::from(returns)
}

/// Whether two passages of levels are possible within a step.
pub(crate) fn may_have_cells(levels: &[Vec<f64>], points: Points<'_>) -> bool {
    let of_argument =
        |(j, levels): (usize, &Vec<f64>)| possible_passages(levels, points.map(|values| values[j]));
    levels.iter().enumerate().map(of_argument).sum::<usize>() > 1
}

/// Cells of a step, in order of time.
#[cold]
pub(crate) fn cells(levels: &[Vec<f64>], arguments: &mut dyn Arguments) -> Vec<Cell> {
    let mut search = Search {
        samples: Vec::with_capacity(2 * PARTS),
        count: levels.len(),
        arguments,
    };
    for s in [0.0, 0.5, 1.0] {
        search.add(s);
    }
    if !search.part(levels) {
        for k in 1..PARTS {
            search.add(k as f64 / PARTS as f64);
        }
        for (j, levels) in levels.iter().enumerate() {
            search.add_extremes(j, levels);
        }
    }
    let mut passages = Vec::new();
    for (j, levels) in levels.iter().enumerate() {
        search.add_passages(j, levels, &mut passages);
    }
    passages.sort_by(f64::total_cmp);
    let pairs = passages.windows(2).map(|pair| Cell {
        middle: 0.5 * (pair[0] + pair[1]),
        width: pair[1] - pair[0],
    });
    pairs.filter(|cell| cell.width > LEAST_CELL).collect()
}

/// Number of the increasing `levels` below a value.
#[inline]
fn index(levels: &[f64], value: f64) -> usize {
    levels.partition_point(|level| *level < value)
}

struct Search<'a> {
    /// Fractions of the step, increasing, with the arguments there.
    samples: Vec<(f64, Vec<f64>)>,
    /// Number of arguments.
    count: usize,
    arguments: &'a mut dyn Arguments,
}

impl Search<'_> {
    /// Adds the arguments at a fraction of the step, unless they are known there.
    fn add(&mut self, s: f64) {
        let place = self.samples.partition_point(|sample| sample.0 < s);
        if self.samples.get(place).is_some_and(|sample| sample.0 == s) {
            return;
        }
        let mut values = vec![0.0; self.count];
        self.arguments.at(s, &mut values);
        self.samples.insert(place, (s, values));
    }

    /// Adds points until each argument passes no level between two neighbours, or is monotone there; whether the bounds
    /// of the arguments show that within [`MOST_BOUNDS`].
    fn part(&mut self, levels: &[Vec<f64>]) -> bool {
        let may_pass = |(j, own): &(usize, &Vec<f64>)| {
            let points = [0, 1, 2].map(|k| self.samples[k].1[*j]);
            possible_passages(own, points) > 0
        };
        let watched: Vec<_> = levels.iter().enumerate().filter(may_pass).collect();
        let mut bounds = vec![Enclosure::splat(0.0); self.count];
        let mut open = vec![(0.0, 1.0)];
        for _ in 0..MOST_BOUNDS {
            let Some(part) = open.pop() else {
                return true;
            };
            if !self.arguments.bounds(part, &mut bounds) {
                return false;
            }
            let passing = watched.iter().filter(|(j, levels)| {
                let [low, high] = bounds[*j].range();
                index(levels, low) != index(levels, high)
            });
            let (mut passes, mut is_plain) = (false, true);
            for (j, _) in passing {
                passes = true;
                is_plain &= bounds[*j].is_monotone();
            }
            let (from, until) = part;
            if !is_plain && until - from > LEAST_CELL {
                let middle = 0.5 * (from + until);
                open.extend([(middle, until), (from, middle)]);
            } else if passes {
                self.add(from);
                self.add(until);
            }
        }
        open.is_empty()
    }

    /// Adds points at the extremes of argument `j` that may pass a level between the samples.
    fn add_extremes(&mut self, j: usize, levels: &[f64]) {
        let mut k = 1;
        let mut refined = 0;
        while k + 1 < self.samples.len() {
            match self.extreme(j, k, levels) {
                Some(s) if refined < REFINEMENTS => {
                    self.add(s);
                    refined += 1;
                }
                _ => (k, refined) = (k + 1, 0),
            }
        }
    }

    /// Extreme of the parabola through argument `j` at the sample `k` and its neighbours, if it may pass a level beyond
    /// these.
    fn extreme(&self, j: usize, k: usize, levels: &[f64]) -> Option<f64> {
        let [a, b, c] = [k - 1, k, k + 1].map(|k| (self.samples[k].0, self.samples[k].1[j]));
        let [first, second] = [(a, b), (b, c)].map(|(p, q)| (q.1 - p.1) / (q.0 - p.0));
        let bend = (second - first) / (c.0 - a.0);
        let s = 0.5 * (a.0 + b.0) - 0.5 * first / bend;
        let is_apart = |point: (f64, f64)| (s - point.0).abs() > LEAST_DISTANCE;
        if !(a.0 < s && s < c.0 && [a, b, c].into_iter().all(is_apart)) {
            return None;
        }
        let at = a.1 + (s - a.0) * (first + bend * (s - b.0));
        let known = match bend < 0.0 {
            true => a.1.max(b.1).max(c.1),
            false => a.1.min(b.1).min(c.1),
        };
        // A function that is no parabola may reach as far again.
        let reached = at + (at - known);
        (index(levels, reached) != index(levels, known)).then_some(s)
    }

    /// Appends the fractions at which argument `j` passes a level, and adds them to the samples: a function of this one
    /// may have a kink there.
    fn add_passages(&mut self, j: usize, levels: &[f64], passages: &mut Vec<f64>) {
        let first = passages.len();
        for pair in self.samples.windows(2) {
            let [a, b] = [&pair[0], &pair[1]].map(|sample| (sample.0, sample.1[j]));
            let [from, to] = [a.1, b.1].map(|value| index(levels, value));
            let mut values = vec![0.0; self.count];
            for level in &levels[from.min(to)..from.max(to)] {
                let value = |s: f64| {
                    self.arguments.at(s, &mut values);
                    values[j] - level
                };
                // A level at the start of a rise is passed there.
                let at_start = match a.1 == *level {
                    true => -f64::MIN_POSITIVE,
                    false => a.1 - level,
                };
                let ends = (at_start, b.1 - level);
                passages.push(first_past_root(value, (a.0, b.0), ends, PASSAGE_WIDTH));
            }
        }
        for s in &passages[first..] {
            self.add(*s);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One argument, by its values and, if known, by its bounds.
    struct One(fn(f64) -> f64, Option<fn(Enclosure) -> Enclosure>);

    impl Arguments for One {
        fn at(&mut self, s: f64, to: &mut [f64]) {
            to[0] = self.0(s);
        }

        fn bounds(&mut self, (from, until): (f64, f64), to: &mut [Enclosure]) -> bool {
            let s = Enclosure::polynomial(&[0.5 * (from + until), 0.5 * (until - from)]);
            self.1.is_some_and(|of| {
                to[0] = of(s);
                true
            })
        }
    }

    fn found(levels: &[f64], argument: fn(f64) -> f64) -> Vec<Cell> {
        found_in(levels, One(argument, None))
    }

    fn found_in(levels: &[f64], mut argument: One) -> Vec<Cell> {
        let levels = [levels.to_vec()];
        let points = [0.0, 0.5, 1.0].map(|s| [argument.0(s)]);
        let points = points.each_ref().map(|values| &values[..]);
        if !may_have_cells(&levels, points) {
            return Vec::new();
        }
        cells(&levels, &mut argument)
    }

    /// Distances from a line and products, whose extreme no parabola through samples shows.
    #[test]
    fn narrow_extremes_are_found_by_bounds() {
        macro_rules! cell {
            ($levels:expr, |$s:ident| $value:expr) => {{
                fn of<T: Real>($s: T) -> T {
                    $value
                }
                let cells = found_in($levels, One(of::<f64>, Some(of::<Enclosure>)));
                let widths = cells.iter().map(|cell| (cell.middle, cell.width));
                widths.collect::<Vec<(f64, f64)>>()
            }};
        }
        fn number<T: Real>(value: f64) -> T {
            T::splat(value)
        }
        let near = |cells: &[(f64, f64)], expected: &[(f64, f64)]| {
            assert_eq!(cells.len(), expected.len(), "{cells:?}");
            for (a, b) in cells.iter().zip(expected) {
                assert!(
                    (a.0 - b.0).abs() < 1e-7 && (a.1 - b.1).abs() < 1e-7,
                    "{cells:?}"
                );
            }
        };
        // 5e-6 of the step wide: a distance that comes to 4e-6 of it.
        let cells = cell!(&[0.0], |s| {
            let x = s - number(0.7313);
            number::<T>(5e-6) - (x * x + number(1.6e-11)).sqrt()
        });
        near(&cells, &[(0.7313, 6e-6)]);
        let cells = cell!(&[0.0], |s| (s - number(0.31)) * (number::<T>(0.31001) - s));
        near(&cells, &[(0.310005, 1e-5)]);
        // Just too far away.
        let cells = cell!(&[0.0], |s| {
            let x = s - number(0.7313);
            number::<T>(3.9e-6) - (x * x + number(1.6e-11)).sqrt()
        });
        near(&cells, &[]);
        let cells = cell!(&[0.5], |s| (s - number(0.2)).heaviside()
            - (s - number(0.20003)).heaviside());
        near(&cells, &[]);
    }

    #[test]
    fn a_cell_is_between_two_passages() {
        let near = |cells: Vec<Cell>, middle: f64, width: f64| {
            let [cell] = cells[..] else {
                panic!("{cells:?}")
            };
            assert!((cell.middle - middle).abs() < 1e-6 && (cell.width - width).abs() < 1e-6);
        };
        near(found(&[3.0, 3.01], |s| 10.0 * s), 0.3005, 0.001);
        near(found(&[3.0, 3.01], |s| 10.0 - 10.0 * s), 0.6995, 0.001);
        // An extreme between the samples, of a parabola and of a function with a kink that is not at a sample.
        near(
            found(&[-1.0], |s| -(1e3 * (s - 0.333)).powi(2)),
            0.333,
            0.002,
        );
        near(found(&[0.0], |s| 1e-6 - (s - 0.01).powi(2)), 0.01, 0.002);
        // From a level at the start.
        near(found(&[0.0, 1.0], |s| 5.0 * s), 0.1, 0.2);
        // One passage, none, and an argument that rests on its level.
        assert!(found(&[0.3], |s| s).is_empty());
        assert!(found(&[2.0, 3.0], |s| s).is_empty());
        assert!(found(&[0.0], |_| 0.0).is_empty());
        assert!(found(&[0.0], |_| f64::NAN).is_empty());
    }
}
