//! Recordings with physics that the fitted model lacks.

use dataset::Dataset;
use dataset::synthesize::Corruption;
use model_spec::load::load;
use rand::{Rng, RngExt};

use super::mistakes::uniform;
use super::setting::Setting;
use crate::own_models::{Hidden, Subject, flights};
use crate::seeded::{self, SeededEffects, greatest_angle_of_attack};

/// Maximum angle of attack, rad: beyond it the axis along which the model declares its forces vanishes.
const MAX_ANGLE: f64 = 1.3;

/// How strong hidden physics is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Severity {
    Mild,
    Severe,
}

impl Severity {
    pub(super) fn label(self) -> &'static str {
        match self {
            Self::Mild => "mild",
            Self::Severe => "severe",
        }
    }

    fn of(self, weak: f64, strong: f64) -> f64 {
        match self {
            Self::Mild => weak,
            Self::Severe => strong,
        }
    }
}

/// Hides an effect of the catalogue in the flights of a setting, or one outside of it. Its sizes are 0.7 to 2 times the
/// weak or strong ones of the discovery study, halved until no disc falls flat.
pub(super) fn hide(
    setting: &mut Setting,
    effect: &'static str,
    severity: Severity,
    seed: u64,
    random: &mut impl Rng,
) {
    let mut draw = |weak: f64, strong: f64| severity.of(weak, strong) * uniform(random, 0.7, 2.0);
    setting.hidden = match seeded::unlisted(effect) {
        Some(found) => {
            let [weak, strong] = found.strength;
            let size = draw(weak, strong);
            let sign = if random.random::<bool>() { 1.0 } else { -1.0 };
            SeededEffects::unlisted(effect, sign * size)
        }
        None => {
            let found = seeded::strength(effect).expect("a strength of every effect");
            let values = found
                .weak
                .iter()
                .zip(found.strong)
                .map(|(w, s)| draw(*w, *s));
            let values: Vec<f64> = values.collect();
            let values = signed(effect, values, random);
            SeededEffects::listed(effect, &values)
        }
    };
    while greatest_angle_of_attack(&setting.plan(), &setting.hidden, seed) > MAX_ANGLE {
        let listed = setting
            .hidden
            .listed
            .iter_mut()
            .flat_map(|(_, values)| values);
        let unlisted = setting.hidden.unlisted.iter_mut().map(|(_, size)| size);
        listed.chain(unlisted).for_each(|value| *value /= 2.0);
    }
}

/// Gives each coefficient of an effect a random sign, where its bounds allow the other one.
fn signed(effect: &str, mut values: Vec<f64>, random: &mut impl Rng) -> Vec<f64> {
    let model = load("disc", &[effect]).expect("a built-in effect");
    for (value, own) in values.iter_mut().zip(&model.effects[0].coefficients) {
        let bounds = model.coefficients[own.index].bounds;
        let other = -*value;
        if random.random::<bool>() && bounds.is_none_or(|(low, high)| (low..=high).contains(&other))
        {
            *value = other;
        }
    }
    values
}

/// Factor by which a hidden effect multiplies all coefficients of pressure: flights do not tell the density of the air
/// from these coefficients. 1 for every other effect.
pub(super) fn factor_of_coefficients(hidden: &SeededEffects) -> f64 {
    let mut listed = hidden.listed.iter();
    let density = listed.find(|(name, _)| name == "air_density");
    density.map_or(1.0, |(_, values)| 1.0 + values[0])
}

/// Flights of a user's model, `count` of them, with noise and optionally an effect of a signed size.
pub(super) fn own_flights(
    subject: &Subject,
    hidden: Option<(Hidden, f64)>,
    count: usize,
    sigma: f64,
    seed: u64,
) -> Dataset {
    let noise = (sigma > 0.0).then(|| Corruption {
        sigma,
        ..Corruption::default()
    });
    let mut dataset = flights(subject, &subject.model(), hidden, noise, seed);
    dataset.flights.truncate(count);
    dataset
}
