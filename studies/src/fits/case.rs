//! One case of the study: effects of the built-in effects catalogue and their sizes, drawn from a seed.

use dataset::Dataset;
use dataset::synthesize::Corruption;
use model_spec::load::load;
use model_spec::model::Model;
use oracle::Law;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use crate::oracle_flights::{Plan, TWELVE};
use crate::seeded::law as effect;
use crate::seeded::{self, SeededEffects, greatest_angle_of_attack, strength};

/// Range, m, from which the marker displacement by one effect is drawn: RMS difference of the marker coordinates from
/// flights without the effect. The lower limit is just detectable in twelve flights.
const DISPLACEMENT: (f64, f64) = (5e-4, 1.0);

/// Maximum number of effects that are added to the simulated flights of one dataset.
const MAX_EFFECTS: usize = 3;

/// Maximum size of an effect, as a multiple of its strong value (near the largest that is met in practice).
const MAX_MULTIPLE: f64 = 12.0;

/// Maximum angle of attack in the simulated flights, rad. Near 90° the airspeed has almost no component in the plane of
/// the disc, so the direction of this component, in which forces are declared, is undefined. A strong negative lift can
/// keep the disc at 90°.
const MAX_ANGLE: f64 = 1.3;

/// Number of flights simulated in each iteration of the search for the size at which an effect displaces the markers by
/// a wanted amount.
const PROBE_FLIGHTS: usize = 4;

/// Tolerance of the search for an effect's size: the search ends when the marker displacement deviates from the wanted
/// displacement by less than this fraction of it.
const CLOSE: f64 = 0.25;

/// Maximum number of iterations of the search for the size at which an effect displaces the markers by a wanted amount.
const STEPS: usize = 7;

/// Number of the ChaCha random stream from which the effects and their sizes are drawn. The streams of the flights are
/// numbered from 1.
const SIZE_STREAM: u64 = u64::MAX - 3;

/// One case of the study: simulated flights with randomly drawn effects, which are then fitted with these effects in
/// the model.
#[derive(Clone, Debug, PartialEq)]
pub struct FitCase {
    /// Seed from which the effects and their values, the throws and the measurement noise are drawn.
    pub seed: u64,
    /// Effects (optional model extensions) added to the simulated flights: name, and values (SI) of the coefficients.
    pub effects: Vec<(String, Vec<f64>)>,
    /// RMS difference, m, between the marker coordinates of flights with all effects and of flights without effects
    /// that start from the same releases.
    pub displacement: f64,
}

impl FitCase {
    /// Draws the effects (optional extensions of the disc model) that are added to the flights of one case, one to
    /// three in number. The RMS marker displacement that an effect causes is drawn log-uniformly; values outside the
    /// bounds of their coefficients are clipped, which makes the displacement smaller. The values of all effects are
    /// then halved until all effects together displace the markers by at most one metre and no disc exceeds the maximum
    /// angle of attack.
    ///
    /// # Panics
    /// If the built-in disc does not load.
    pub fn of(seed: u64) -> Self {
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        random.set_stream(SIZE_STREAM);
        let (names, model) = effects(&mut random);
        let exact = flights(&[], PROBE_FLIGHTS, seed);
        let each = names.iter().map(|name| {
            let share: f64 = random.random();
            let wanted = DISPLACEMENT.0 * (DISPLACEMENT.1 / DISPLACEMENT.0).powf(share);
            let strong = strength(name).expect("a strength of every effect").strong;
            let signed = strong.iter().map(|value| match random.random::<bool>() {
                true => *value,
                false => -value,
            });
            let signed: Vec<f64> = signed.collect();
            let values = sized(&model, name, &signed, wanted, &exact, seed);
            ((*name).to_owned(), values)
        });
        let mut effects: Vec<(String, Vec<f64>)> = each.collect();
        // Effects that are small one by one can together make a body tumble or an equation diverge.
        let exact = flights(&[], TWELVE.flights, seed);
        loop {
            let displacement = displacement(&exact, &effects, seed);
            let angle = greatest_angle_of_attack(&TWELVE, &listed(&effects), seed);
            if displacement <= DISPLACEMENT.1 && angle <= MAX_ANGLE {
                return Self {
                    displacement,
                    effects,
                    seed,
                };
            }
            let values = effects.iter_mut().flat_map(|(_, values)| values);
            values.for_each(|value| *value /= 2.0);
        }
    }

    /// Names of the effects (optional model extensions) added to the simulated flights.
    pub fn names(&self) -> Vec<&str> {
        self.effects.iter().map(|(name, _)| name.as_str()).collect()
    }

    /// Simulates the flights with the added effects twice: without noise, and with white noise.
    pub fn datasets(&self) -> [Dataset; 2] {
        let seeded = listed(&self.effects);
        [
            seeded::dataset(&TWELVE, &seeded, self.seed),
            seeded::dataset(
                &TWELVE,
                &seeded.with_noise(Corruption::default()),
                self.seed,
            ),
        ]
    }
}

/// Draws one to three effects of the disc that can be combined, and returns their names and the model with them.
fn effects(random: &mut impl Rng) -> (Vec<&'static str>, Model) {
    let all = effect::all().filter(|effect| effect.laws.contains(&Law::Disc));
    let all: Vec<&'static str> = all.map(|effect| effect.name).collect();
    loop {
        let count = random.random_range(1..=MAX_EFFECTS);
        let draw = |_| all[random.random_range(0..all.len())];
        let mut names: Vec<&'static str> = (0..count).map(draw).collect();
        names.sort_unstable();
        names.dedup();
        if names.len() == count
            && let Ok(model) = load("disc", &names)
        {
            return (names, model);
        }
    }
}

/// Returns the values of one effect that displaces the markers by about `wanted` (m, RMS over the coordinates) relative
/// to the flights `exact`, which contain no effects. The values are a multiple of `strong` (values of a strong effect)
/// that is found by bracketing. They are clipped to the bounds of their coefficients.
fn sized(
    model: &Model,
    name: &str,
    strong: &[f64],
    wanted: f64,
    exact: &Dataset,
    seed: u64,
) -> Vec<f64> {
    let at = |multiple: f64| within_bounds(model, name, strong, multiple);
    let (mut low, mut high) = (0.0, MAX_MULTIPLE);
    let mut multiple = 1.0;
    for _ in 0..STEPS {
        let moved = displacement(exact, &[(name.to_owned(), at(multiple))], seed);
        if (moved / wanted - 1.0).abs() < CLOSE {
            break;
        }
        match moved <= wanted {
            true => low = multiple,
            false => high = multiple,
        }
        // Displacements are nearly proportional to the size.
        let proportional = multiple * wanted / moved;
        let inside = low < proportional && proportional < high;
        multiple = if inside {
            proportional
        } else {
            f64::midpoint(low, high)
        };
    }
    at(multiple)
}

/// Multiplies `strong` (values of a strong effect) by `multiple`, and clips each value to 0.9 times the bounds of its
/// coefficient. A value whose sign the bounds exclude is negated first.
fn within_bounds(model: &Model, name: &str, strong: &[f64], multiple: f64) -> Vec<f64> {
    let effect = model.effects.iter().find(|effect| effect.name == name);
    let coefficients = effect.map_or(&[][..], |effect| &effect.coefficients);
    let each = strong.iter().enumerate().map(|(k, value)| {
        let value = multiple * value;
        let bounds = coefficients
            .get(k)
            .and_then(|coefficient| model.coefficients[coefficient.index].bounds);
        match bounds {
            Some((low, _)) if low >= 0.0 => value.abs().min(0.9 * bounds.map_or(1.0, |b| b.1)),
            Some((_, high)) if high <= 0.0 => -value.abs().min(0.9 * -bounds.map_or(-1.0, |b| b.0)),
            Some((low, high)) => value.clamp(0.9 * low, 0.9 * high),
            None => value,
        }
    });
    each.collect()
}

/// Simulates the first `flights` throws drawn from a seed, with the effects `effects` (names and values) and without
/// noise.
fn flights(effects: &[(String, Vec<f64>)], flights: usize, seed: u64) -> Dataset {
    let plan = Plan { flights, ..TWELVE };
    seeded::dataset(&plan, &listed(effects), seed)
}

fn listed(effects: &[(String, Vec<f64>)]) -> SeededEffects {
    SeededEffects {
        listed: effects.to_vec(),
        ..SeededEffects::default()
    }
}

/// RMS difference, per coordinate, between the marker positions of the flights `plain`, which contain no effects, and
/// of the same throws with `effects`, m; infinite if a simulated position is not finite.
fn displacement(plain: &Dataset, effects: &[(String, Vec<f64>)], seed: u64) -> f64 {
    let with = flights(effects, plain.flights.len(), seed);
    rms_distance(plain, &with).unwrap_or(f64::INFINITY)
}

/// RMS difference, per coordinate, between corresponding marker positions of two datasets, m; `None` if it is not
/// finite.
pub(super) fn rms_distance(a: &Dataset, b: &Dataset) -> Option<f64> {
    let points = |dataset: &Dataset| -> Vec<[f64; 3]> {
        let rows = dataset.flights.iter().flat_map(|f| f.positions.iter());
        rows.flatten().flatten().copied().collect()
    };
    let (a, b) = (points(a), points(b));
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    let squares: f64 = pairs.map(|(a, b)| (a - b).powi(2)).sum();
    let rms = (squares / (3 * a.len()).max(1) as f64).sqrt();
    rms.is_finite().then_some(rms)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn displacements_cover_the_range_and_seeds_repeat() {
        let cases: Vec<FitCase> = (0..12).map(FitCase::of).collect();
        let moved: Vec<f64> = cases.iter().map(|case| case.displacement).collect();
        assert!(moved.iter().all(|d| (2e-4..3.0).contains(d)), "{moved:?}");
        assert!(moved.iter().any(|d| *d < 0.03), "{moved:?}");
        assert!(moved.iter().any(|d| *d > 0.2), "{moved:?}");
        assert!((1..=3).all(|n| cases.iter().any(|case| case.effects.len() == n)));
        assert_eq!(FitCase::of(4), cases[4]);
    }
}
