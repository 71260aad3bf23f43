//! Parts of a step that its stages may have flown over: where the arguments of functions that switch pass their levels,
//! such as the knots of a table.

mod path;
#[cfg(test)]
mod tests;

pub(crate) use self::path::Path;
use crate::root::first_past_root;
use lanes::{Enclosure, Real, Switch};

/// Reach of an argument beyond its values at the ends and the middle of a step, in units of their second difference: a
/// parabola reaches at most an eighth beyond the three, a roof a half, and nothing that bends to one side alone reaches
/// further than one.
const REACH: f64 = 1.0;

/// Greatest number of parts of a step whose bounds are asked for: the passages of one feature need some forty, those of
/// a jump as many. A step whose arguments pass more levels ends where the bounds do. An argument that rests on a level, but
/// for rounding, would have all parts asked.
const MOST_BOUNDS: usize = 256;

/// Turn of the angle of a sine in a step, rad, beyond which three values of what depends on it do not show where that
/// bends: half a turn has one extreme of the sine.
const MAX_TURN: f64 = std::f64::consts::PI;

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

/// Least part of a step that bounds have to show: where they do not, the arguments are computed at some points instead.
const LEAST_EXAMINED: f64 = 1e-3;

/// A step that passes the error test.
pub(crate) trait Passed {
    /// Writes the arguments of switches at the fraction `s` of the step.
    fn arguments(&mut self, s: f64, to: &mut [f64]);
    /// Writes bounds of the arguments in a part of the step; whether they are known.
    fn bounds(&mut self, part: (f64, f64), to: &mut [Enclosure]) -> bool;
    /// Change of the state over the whole step that the difference between its rate at the fraction `s` and that of the
    /// dense output would make, in tolerated errors, of the component where it is greatest.
    fn deviation(&mut self, s: f64) -> f64;
}

/// Cell of a step between two passages, or between a kink and an end of the step: where it begins and ends, as fractions
/// of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cell {
    from: f64,
    until: f64,
}

impl Cell {
    fn middle(self) -> f64 {
        0.5 * (self.from + self.until)
    }

    fn width(self) -> f64 {
        self.until - self.from
    }

    /// Where a step is to end that has flown over the cell, in which the state changes by `change` tolerated errors. After
    /// a cell between two passages it then sees why. Before a kink it ends so near that the next one, which ends as far
    /// behind the kink, may fly over it.
    fn cut(self, change: f64) -> f64 {
        let near = (0.5 * MAX_OVERLOOKED / change).max(LEAST_CELL);
        match (self.from, self.until) {
            (kink, 1.0) => self.middle().min(near.max(2.0 * kink)),
            (0.0, kink) => kink * (1.0 - near),
            _ => self.middle(),
        }
    }
}

/// Number of passages of levels that are possible within a step, by the values of an argument at its start, in its middle
/// and at its end, each kink counted twice. One alone, of all arguments, is no cell: it shows in the derivatives at the ends,
/// but for a kink, of which the error test sees too little.
#[inline(always)]
pub(crate) fn possible_passages(switch: &Switch, [start, middle, end]: [f64; 3]) -> usize {
    let Switch { levels, .. } = switch;
    if switch.is_phase {
        return if (end - start).abs() > MAX_TURN { 2 } else { 0 };
    }
    let reach = REACH * (start - 2.0 * middle + end).abs();
    let least = start.min(middle).min(end) - reach;
    let greatest = start.max(middle).max(end) + reach;
    let rests = least == greatest;
    if rests || levels.last().is_none_or(|last| last.value < least) || levels[0].value > greatest {
        return 0;
    }
    let within = levels.get(switch.index(least)..switch.index(greatest));
    let within = within.unwrap_or_default();
    let kinks = within.iter().filter(|level| level.is_kink).count();
    let returns = !within.is_empty() && switch.index(start) == switch.index(end);
    within.len() + kinks + usize::from(returns)
}

/// The greater of two numbers; one that is none counts as the greatest.
pub(crate) fn greatest(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// Whether a step may have cells.
pub(crate) fn may_have_cells(switches: &[Switch], points: Points<'_>) -> bool {
    let of_argument =
        |(j, own): (usize, &Switch)| possible_passages(own, points.map(|values| values[j]));
    switches.iter().enumerate().map(of_argument).sum::<usize>() > 1
}

/// Fraction of a step at which it is to end instead, as the state has changed within a cell by more than the tolerance
/// allows, or as no more of it could be examined.
#[cold]
pub(crate) fn overlooked(switches: &[Switch], step: &mut dyn Passed) -> Option<f64> {
    let (cells, examined) = cells(switches, step);
    for cell in cells {
        let change = cell.width() * step.deviation(cell.middle());
        // Not a number counts as seen too little of.
        let is_seen = change <= MAX_OVERLOOKED;
        if !is_seen {
            return Some(cell.cut(change));
        }
    }
    (examined < 1.0).then_some(examined)
}

/// Cells of a step, in order of time, and the fraction of it up to which they were sought.
fn cells(switches: &[Switch], step: &mut dyn Passed) -> (Vec<Cell>, f64) {
    let mut search = Search {
        samples: Vec::with_capacity(2 * PARTS),
        count: switches.len(),
        step,
    };
    for s in [0.0, 0.5, 1.0] {
        search.add(s);
    }
    let mut examined = search.part(switches);
    if examined < LEAST_EXAMINED {
        examined = 1.0;
        for k in 1..PARTS {
            search.add(k as f64 / PARTS as f64);
        }
        for (j, own) in switches.iter().enumerate() {
            search.add_extremes(j, own);
        }
    }
    let mut passages = Vec::new();
    let mut has_kink = false;
    for (j, own) in switches.iter().enumerate() {
        has_kink |= search.add_passages(j, own, &mut passages);
    }
    if has_kink {
        passages.extend([0.0, 1.0]);
    }
    passages.retain(|s| *s <= examined);
    passages.sort_by(f64::total_cmp);
    let pairs = passages.windows(2).map(|pair| Cell {
        from: pair[0],
        until: pair[1],
    });
    let cells = pairs.filter(|cell| cell.width() > LEAST_CELL).collect();
    (cells, examined)
}

struct Search<'a> {
    /// Fractions of the step, increasing, with the arguments there.
    samples: Vec<(f64, Vec<f64>)>,
    /// Number of arguments.
    count: usize,
    step: &'a mut dyn Passed,
}

impl Search<'_> {
    /// Adds the arguments at a fraction of the step, unless they are known there.
    fn add(&mut self, s: f64) {
        let place = self.samples.partition_point(|sample| sample.0 < s);
        if self.samples.get(place).is_some_and(|sample| sample.0 == s) {
            return;
        }
        let mut values = vec![0.0; self.count];
        self.step.arguments(s, &mut values);
        self.samples.insert(place, (s, values));
    }

    /// Adds points until each argument passes no level between two neighbours, or is monotone there; the fraction of the
    /// step up to which the bounds of the arguments show that within [`MOST_BOUNDS`].
    fn part(&mut self, switches: &[Switch]) -> f64 {
        let may_pass = |(j, own): &(usize, &Switch)| {
            let points = [0, 1, 2].map(|k| self.samples[k].1[*j]);
            possible_passages(own, points) > 0
        };
        let all = || switches.iter().enumerate();
        let turns = all().any(|own| own.1.is_phase && may_pass(&own));
        let watched: Vec<_> = all().filter(|own| turns || may_pass(own)).collect();
        let mut bounds = vec![Enclosure::splat(0.0); self.count];
        let mut open = vec![(0.0, 1.0)];
        for _ in 0..MOST_BOUNDS {
            let Some(part) = open.pop() else {
                return 1.0;
            };
            if !self.step.bounds(part, &mut bounds) {
                return 0.0;
            }
            let passing = watched.iter().filter(|(j, own)| {
                let [low, high] = bounds[*j].range();
                own.index(low) != own.index(high)
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
        open.pop().map_or(1.0, |(from, _)| from)
    }

    /// Adds points at the extremes of argument `j` that may pass a level between the samples.
    fn add_extremes(&mut self, j: usize, own: &Switch) {
        let mut k = 1;
        let mut refined = 0;
        while k + 1 < self.samples.len() {
            match self.extreme(j, k, own) {
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
    fn extreme(&self, j: usize, k: usize, own: &Switch) -> Option<f64> {
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
        (own.index(reached) != own.index(known)).then_some(s)
    }

    /// Appends the fractions at which argument `j` passes a level, and adds them to the samples: a function of this one
    /// may have a kink there. Whether one of the levels is a kink.
    fn add_passages(&mut self, j: usize, own: &Switch, passages: &mut Vec<f64>) -> bool {
        let first = passages.len();
        let mut has_kink = false;
        for pair in self.samples.windows(2) {
            let [a, b] = [&pair[0], &pair[1]].map(|sample| (sample.0, sample.1[j]));
            let [from, to] = [a.1, b.1].map(|value| own.index(value));
            let mut values = vec![0.0; self.count];
            for level in &own.levels[from.min(to)..from.max(to)] {
                let value = |s: f64| {
                    self.step.arguments(s, &mut values);
                    values[j] - level.value
                };
                // A level at the start of a rise is passed there.
                let at_start = match a.1 == level.value {
                    true => -f64::MIN_POSITIVE,
                    false => a.1 - level.value,
                };
                let ends = (at_start, b.1 - level.value);
                passages.push(first_past_root(value, (a.0, b.0), ends, PASSAGE_WIDTH));
                has_kink |= level.is_kink;
            }
        }
        for s in &passages[first..] {
            self.add(*s);
        }
        has_kink
    }
}
