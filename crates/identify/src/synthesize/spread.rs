//! How the flights of a made dataset differ: their initial states vary around a release.

use flight::release::Vocabulary;
use model_spec::model::Model;
use model_spec::unit::Unit;
use rand::RngExt;
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;

/// The variation of initial states. A state s of the body's position stays; any other gets a normal deviation of
/// standard deviation `fraction` · max(|s|, scale), where the scale is that of its kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Fraction; 0 throws all flights alike.
    pub fraction: f64,
    /// Scale of a velocity, m/s.
    pub speed: f64,
    /// Scale of an angle, rad.
    pub angle: f64,
    /// Scale of a rate of turn, rad/s.
    pub rate: f64,
}

impl Default for Spread {
    /// A tenth; of 5 m/s, 1 rad and 10 rad/s where the state is smaller.
    fn default() -> Self {
        Self {
            fraction: 0.1,
            speed: 5.0,
            angle: 1.0,
            rate: 10.0,
        }
    }
}

/// Greatest fraction.
const MOST: f64 = 2.0;

impl Spread {
    /// Checks the fraction.
    ///
    /// # Errors
    /// In words: what was found and what was expected.
    pub fn check(&self) -> Result<(), String> {
        if (0.0..=MOST).contains(&self.fraction) {
            Ok(())
        } else {
            let found = self.fraction;
            Err(format!("spread: found {found}, expected 0 to {MOST}"))
        }
    }

    /// The standard deviation of each state of a model around these values.
    pub fn deviations(&self, model: &Model, state: &[f64]) -> Vec<f64> {
        let each = model.states.iter().zip(state);
        each.map(|(declared, value)| {
            let scale = match declared.unit {
                // What is a length is a position.
                Unit::METRE => return 0.0,
                Unit::SPEED => self.speed,
                Unit::RATE => self.rate,
                Unit::RADIAN => self.angle,
                // Half of an angle, as the components of a quaternion are.
                _ => self.angle / 2.0,
            };
            self.fraction * value.abs().max(scale)
        })
        .collect()
    }

    /// A state drawn around another.
    pub fn draw(&self, model: &Model, state: &[f64], random: &mut ChaCha12Rng) -> Vec<f64> {
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
