//! Bounds of a search: ranges of the quantities of a throw, an obstacle, a landing circle and the scatter of a
//! release.

use flight::throw::{FIELDS, Throw};
use nalgebra::DVector;

use crate::design::goal::Obstacle;
use crate::design::throw_flight::ThrownBody;

/// Ranges and constraints within which a throw is searched, and the random variation between repeated throws (of their
/// quantities, such as the speed, of the wind and of the parameters).
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// Minimum and maximum of each quantity that a throw of the body can have, in the unit that [`FIELDS`] (list of the
    /// quantities of a throw) states. Each entry is (index in [`FIELDS`], minimum, maximum). A quantity whose minimum
    /// and maximum are equal is fixed.
    pub ranges: Vec<(usize, f64, f64)>,
    /// Obstacle that the path of the thrown body must avoid; `None` without an obstacle.
    pub obstacle: Option<Obstacle>,
    /// Radius of the circle about the target within which a landing counts as good, m.
    pub circle: f64,
    /// Random variation between repeated throws: of their quantities, such as the speed, of the wind and of the
    /// parameters.
    pub scatter: Scatter,
}

/// Standard deviations of the quantities that differ from throw to throw; the quantities vary independently.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// Standard deviations of quantities of the throw, such as its speed: (index in [`FIELDS`], the list of these
    /// quantities; value in the unit that [`FIELDS`] states).
    pub release: Vec<(usize, f64)>,
    /// Standard deviations of the components x, y, z of the wind, m/s, in the frame in which the model declares its
    /// input `wind`. The wind is constant during a flight.
    pub wind: [f64; 3],
    /// Standard deviations of parameters and coefficients of the model: (index among the parameters of the compiled
    /// model, value in the parameter's unit).
    pub parameters: Vec<(usize, f64)>,
}

/// Default ranges of the quantities of a throw: name, minimum and maximum, in the units given in [`FIELDS`]. They are
/// typical of good throwers, with a release at the height of the hand.
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

/// Default standard deviations of the quantities of a throw, in the units given in [`FIELDS`]: an assumption of the
/// order of magnitude that launch monitors show for practised throwers, not a measurement.
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

    /// Sets the minimum and maximum of the quantity of a throw called `name`, such as `speed`, in the unit given in
    /// [`FIELDS`]; ignored if a throw of the body does not have this quantity.
    pub fn set(&mut self, name: &str, least: f64, greatest: f64) {
        for range in self
            .ranges
            .iter_mut()
            .filter(|range| FIELDS[range.0].0 == name)
        {
            (range.1, range.2) = (least, greatest);
        }
    }

    /// Returns the bounds with the minimum and maximum of the quantity of a throw called `name`, such as `speed`,
    /// replaced. They are in the unit given in [`FIELDS`], and ignored if a throw of the body does not have this
    /// quantity.
    pub fn with(mut self, name: &str, least: f64, greatest: f64) -> Bounds {
        self.set(name, least, greatest);
        self
    }

    /// The entries (index in [`FIELDS`], minimum, maximum) of `ranges` that the search for a throw may vary: those
    /// whose minimum is less than the maximum.
    pub fn free(&self) -> impl Iterator<Item = &(usize, f64, f64)> {
        self.ranges
            .iter()
            .filter(|(_, least, greatest)| least < greatest)
    }

    /// Maps a point of the unit box, whose coordinates are the free quantities scaled from their ranges to [0, 1], to a
    /// throw. All other quantities have their fixed values.
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
