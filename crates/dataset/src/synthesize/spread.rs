//! Random variation of the initial states of synthetic flights around a release.

use flight::release::Vocabulary;
use model_spec::model::Model;
use model_spec::unit::Unit;
use rand::RngExt;
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;

use super::error::OutOfRange;

/// Random variation of initial states. Position states are not varied. Any other state s has a normal deviation with
/// standard deviation `fraction` · max(|s|, scale), with a scale that depends on its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Standard deviation of a state relative to max(|state|, scale); with 0, no state varies.
    pub fraction: f64,
    /// Scale for velocity states, m/s: `fraction` refers to this value if the magnitude of the state is smaller.
    pub speed: f64,
    /// Scale of angles, rad, for states of smaller magnitude; half of it for other units, such as quaternions.
    pub angle: f64,
    /// Scale for angular-rate states, rad/s: `fraction` refers to this value if the magnitude of the state is smaller.
    pub rate: f64,
}

impl Default for Spread {
    fn default() -> Self {
        Self {
            fraction: 0.1,
            speed: 5.0,
            angle: 1.0,
            rate: 10.0,
        }
    }
}

const MAX_FRACTION: f64 = 2.0;

impl Spread {
    /// Checks that `fraction` is within its allowed range.
    ///
    /// # Errors
    /// [`OutOfRange`] if `fraction` is not between 0 and its maximum.
    #[doc(hidden)]
    pub fn check(&self) -> Result<(), OutOfRange> {
        OutOfRange::check("spread", self.fraction, 0.0, MAX_FRACTION)
    }

    /// Standard deviation of the random variation of each state about its value in `state`, SI; 0 for positions.
    #[doc(hidden)]
    pub fn deviations(&self, model: &Model, state: &[f64]) -> Vec<f64> {
        let each = model.states.iter().zip(state);
        each.map(|(declared, value)| {
            let scale = match declared.unit {
                // A state with the unit of a length is a position.
                Unit::METRE => return 0.0,
                Unit::SPEED => self.speed,
                Unit::RATE => self.rate,
                Unit::RADIAN => self.angle,
                // Half an angle, as for the components of a quaternion.
                _ => self.angle / 2.0,
            };
            self.fraction * value.abs().max(scale)
        })
        .collect()
    }

    /// Draws a random state about the values in `state`; its quaternions are normalised.
    pub(crate) fn draw(&self, model: &Model, state: &[f64], random: &mut ChaCha12Rng) -> Vec<f64> {
        let deviations = self.deviations(model, state);
        let mut drawn: Vec<f64> = state
            .iter()
            .zip(deviations)
            .map(|(value, deviation)| {
                let normal: f64 = random.sample(StandardNormal);
                value + deviation * normal
            })
            .collect();
        for quaternion in Vocabulary::of(model).quaternions {
            let squares = quaternion.map(|place| drawn[place].powi(2));
            let length = squares.iter().sum::<f64>().sqrt();
            for place in quaternion {
                drawn[place] /= length;
            }
        }
        drawn
    }
}
