//! Designs of regressions that windows of a flight share.

use super::motion::Point;

/// Maximum number of stored designs. For evenly spaced samples, the designs of different ranges differ only by the
/// rounding of the times, whose pattern repeats after a few samples.
const MAX_DESIGNS: usize = 8;
/// Maximum difference between times that are considered equal, s. A body moves by only some nanometres in this time.
const SAME_TIME: f64 = 1e-9;

/// Recently used designs for ranges of points. Ranges whose samples have the same times relative to a reference time
/// share one design.
#[derive(Debug)]
pub struct Designs<D> {
    recent: Vec<(Vec<(usize, f64)>, D)>,
    /// Index of the oldest stored design, which the next new design replaces.
    oldest: usize,
}

impl<D> Designs<D> {
    /// Creates a collection without designs.
    pub fn new() -> Self {
        Self {
            recent: Vec::new(),
            oldest: 0,
        }
    }

    /// Returns the design of a range of points, with times relative to `about`, s: a stored design for the same times,
    /// or the result of `make`, which is then stored. `None` if `make` returns `None` or there are no points.
    pub fn of<'p>(
        &mut self,
        points: impl ExactSizeIterator<Item = &'p Point> + Clone,
        about: f64,
        make: impl FnOnce() -> Option<D>,
    ) -> Option<&D> {
        let first = points.clone().next()?.sample;
        let times = points.map(|point| (point.sample.wrapping_sub(first), point.time - about));
        let is_same = |known: &[(usize, f64)]| {
            let mut pairs = known.iter().zip(times.clone());
            known.len() == times.len()
                && pairs.all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() < SAME_TIME)
        };
        if let Some(known) = self.recent.iter().position(|(known, _)| is_same(known)) {
            return Some(&self.recent[known].1);
        }
        let made = (times.collect(), make()?);
        if self.recent.len() < MAX_DESIGNS {
            self.recent.push(made);
            return self.recent.last().map(|(_, design)| design);
        }
        let at = self.oldest;
        self.oldest = (at + 1) % MAX_DESIGNS;
        self.recent[at] = made;
        Some(&self.recent[at].1)
    }
}
