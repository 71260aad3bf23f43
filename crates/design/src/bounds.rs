//! Bounds of a search: ranges of the numbers of a throw, an obstacle, a landing circle and the scatter of a release.

use flight::throw::{FIELDS, Throw};
use nalgebra::DVector;

use crate::goal::Obstacle;
use crate::throw_flight::ThrownBody;

/// What a search may choose, and what it must respect.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// Least and greatest value of each number that a throw of the body can have: its index in [`FIELDS`], in the unit there. A
    /// number whose ends are equal is held.
    pub ranges: Vec<(usize, f64, f64)>,
    /// What the path must go round.
    pub obstacle: Option<Obstacle>,
    /// Radius of the circle about the target within which a landing is good, m.
    pub circle: f64,
    /// How a thrower scatters.
    pub scatter: Scatter,
}

/// Standard deviations of what differs from throw to throw, independent of one another.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// Of the numbers of the throw: the index in [`FIELDS`], in the unit there.
    pub release: Vec<(usize, f64)>,
    /// Of the components of a constant wind, m/s.
    pub wind: [f64; 3],
    /// Of parameters and coefficients: the index in the model's layout, in the unit there.
    pub parameters: Vec<(usize, f64)>,
}

/// Ranges where nothing is stated: those of good throwers, from the height of the hand.
const RANGES: [(&str, f64, f64); 8] = [
    ("speed", 8.0, 27.0),
    ("heading", -45.0, 45.0),
    ("launch", -10.0, 60.0),
    ("nose", -10.0, 30.0),
    ("hyzer", -60.0, 60.0),
    ("spin", 300.0, 1200.0),
    ("height", 1.3, 1.3),
    ("wobble", 0.0, 0.0),
];

/// Standard deviations where nothing is stated: an assumption of the order of what launch monitors show of practised throwers, not
/// a measurement.
const SCATTER: [(&str, f64); 6] = [
    ("speed", 0.5),
    ("heading", 2.0),
    ("launch", 1.5),
    ("nose", 2.0),
    ("hyzer", 3.0),
    ("spin", 40.0),
];

/// Radius of the landing circle where none is stated, m.
const CIRCLE: f64 = 3.0;

impl Bounds {
    /// The bounds that hold where a file states nothing.
    pub fn standard(body: &ThrownBody) -> Bounds {
        let fields = body.fields();
        let range = |field: &usize| {
            let own = RANGES.iter().find(|(name, ..)| *name == FIELDS[*field].0);
            own.map(|(_, least, greatest)| (*field, *least, *greatest))
        };
        let sd = |field: &usize| {
            let own = SCATTER.iter().find(|(name, _)| *name == FIELDS[*field].0);
            own.map(|(_, sd)| (*field, *sd))
        };
        Bounds {
            ranges: fields.iter().filter_map(range).collect(),
            obstacle: None,
            circle: CIRCLE,
            scatter: Scatter {
                release: fields.iter().filter_map(sd).collect(),
                wind: [0.0; 3],
                parameters: Vec::new(),
            },
        }
    }

    /// Sets the range of a number; one that the body does not have is ignored.
    pub fn set(&mut self, name: &str, least: f64, greatest: f64) {
        for range in self
            .ranges
            .iter_mut()
            .filter(|range| FIELDS[range.0].0 == name)
        {
            (range.1, range.2) = (least, greatest);
        }
    }

    /// The bounds with the range of a number replaced.
    pub fn with(mut self, name: &str, least: f64, greatest: f64) -> Bounds {
        self.set(name, least, greatest);
        self
    }

    /// Numbers that the search chooses.
    pub fn free(&self) -> impl Iterator<Item = &(usize, f64, f64)> {
        self.ranges
            .iter()
            .filter(|(_, least, greatest)| least < greatest)
    }

    /// The throw at a point of the unit box of the free numbers.
    pub fn throw(&self, at: &DVector<f64>) -> Throw {
        let mut throw = Throw::at_speed(1.0);
        let mut free = at.iter();
        for (field, least, greatest) in &self.ranges {
            let name = FIELDS[*field].0;
            let value = match least < greatest {
                true => least + (greatest - least) * free.next().copied().unwrap_or(0.5),
                false => *least,
            };
            // A throw without spin has no wobble, not even one of 0.
            if name != "wobble" || value != 0.0 {
                throw.set(name, value);
            }
        }
        throw
    }
}
