//! Bounds of a search: ranges of the quantities of a throw, an obstacle, a landing circle and the scatter of a
//! release.

use flight::throw::{FIELDS, Throw};
use nalgebra::DVector;

use crate::design::goal::Obstacle;
use crate::design::throw_flight::ThrownBody;

/// Ranges and constraints of a search, and the random variation between repeated throws.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// Range of each quantity that a throw of the body can have: index in [`FIELDS`], minimum, maximum (equal: fixed).
    pub ranges: Vec<(usize, f64, f64)>,
    /// Obstacle that the path must avoid.
    pub obstacle: Option<Obstacle>,
    /// Radius of the circle about the target within which a landing counts as good, m.
    pub circle: f64,
    /// Random variation between repeated throws.
    pub scatter: Scatter,
}

/// Standard deviations of the quantities that differ from throw to throw; the quantities vary independently.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// Of quantities of the throw: index in [`FIELDS`], and value in its unit.
    pub release: Vec<(usize, f64)>,
    /// Of the constant wind: x, y, z in the frame of the model's input `wind`, m/s.
    pub wind: [f64; 3],
    /// Of parameters and coefficients: index among the parameters of the compiled model, and value in its unit.
    pub parameters: Vec<(usize, f64)>,
}

/// Default ranges, typical of good throwers with a release at the height of the hand.
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

/// Default standard deviations, of the order that launch monitors show for practised throwers; not a measurement.
const SCATTER: [(&str, f64); 6] = [
    ("speed", 0.5),
    ("heading", 2.0),
    ("launch", 1.5),
    ("nose", 2.0),
    ("hyzer", 3.0),
    ("spin", 40.0),
];

/// Default radius of the circle about the target within which a landing counts as good, m.
const CIRCLE: f64 = 3.0;

impl Bounds {
    /// Default bounds of the throws of a body, which apply to everything that is not specified in a bounds file.
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

    /// Sets the range of the quantity called `name`; ignored if a throw of the body does not have it.
    pub fn set(&mut self, name: &str, least: f64, greatest: f64) {
        let own = |range: &&mut (usize, f64, f64)| FIELDS[range.0].0 == name;
        if let Some(range) = self.ranges.iter_mut().find(own) {
            (range.1, range.2) = (least, greatest);
        }
    }

    /// The bounds with the range of one quantity replaced, as by [`Bounds::set`].
    pub fn with(mut self, name: &str, least: f64, greatest: f64) -> Bounds {
        self.set(name, least, greatest);
        self
    }

    /// A quantity whose minimum and maximum are no range, with both.
    pub(super) fn no_range(&self) -> Option<(&'static str, f64, f64)> {
        let is_range = |least: f64, most: f64| least <= most && (most - least).is_finite();
        let mut ranges = self.ranges.iter();
        let found = ranges.find(|(_, least, most)| !is_range(*least, *most));
        found.map(|(field, least, most)| (FIELDS[*field].0, *least, *most))
    }

    /// Ranges that the search may vary: those whose minimum is less than the maximum.
    pub fn free(&self) -> impl Iterator<Item = &(usize, f64, f64)> {
        let ranges = self.ranges.iter();
        ranges.filter(|(_, least, greatest)| least < greatest)
    }

    /// Throw at a point of the unit box, whose coordinates are the free quantities scaled to [0, 1].
    pub fn throw(&self, at: &DVector<f64>) -> Throw {
        let mut throw = Throw::at_speed(1.0);
        let mut free = at.iter();
        for (field, least, greatest) in &self.ranges {
            let name = FIELDS[*field].0;
            let value = match least < greatest {
                true => least + (greatest - least) * free.next().copied().unwrap_or(0.5),
                false => *least,
            };
            // A throw without spin has no wobble, not even a wobble of 0.
            if name != "wobble" || value != 0.0 {
                throw.set(name, value);
            }
        }
        throw
    }
}
