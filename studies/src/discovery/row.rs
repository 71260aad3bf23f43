//! Rows of the discovery study. A row is a set of runs that differ only in their seeds.

use crate::oracle_flights::NoiseCondition;
use crate::seeded::{InputErrors, unlisted};

/// Kind of a row of the study's table: which effects or errors are introduced into the simulated flights of its runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// No effect is added to the simulated flights.
    Null,
    /// One effect of the built-in effects catalogue is added to the simulated flights.
    Single,
    /// Two effects of the built-in effects catalogue are added to the simulated flights, drawn without regard to their
    /// identifiability.
    Pair,
    /// Two or three effects of the built-in effects catalogue are added to the simulated flights. None of them can be
    /// replaced by another cause with the same influence on flights.
    Several,
    /// The effect added to the simulated flights changes them in the same way as another cause, so that the diagnosis
    /// cannot distinguish the two.
    Confounded,
    /// An effect outside the built-in effects catalogue is added to the simulated flights.
    Unlisted,
    /// Effects of the built-in effects catalogue are added to simulated flights of a ball, not of a disc.
    Ball,
    /// An effect outside the built-in effects catalogue is added to the simulated flights, of which there are 48
    /// instead of the default number.
    UnlistedManyFlights,
    /// The spins specified in the dataset for the flights contain errors.
    InputErrors,
}

impl Group {
    /// Name of this group of simulation settings on documentation pages.
    pub(super) fn label(self) -> &'static str {
        match self {
            Group::Null => "no effect",
            Group::Single => "one effect",
            Group::Pair => "pair",
            Group::Several => "combination",
            Group::Confounded => "confounded",
            Group::Unlisted => "unlisted",
            Group::Ball => "ball",
            Group::UnlistedManyFlights => "unlisted, 48 flights",
            Group::InputErrors => "input errors",
        }
    }

    /// Name of the group in the text from which the seeds of the simulated datasets are derived. Changing it would
    /// change the datasets.
    fn key(self) -> &'static str {
        match self {
            Group::Null => "null",
            Group::Single => "effects",
            Group::Pair => "pairs",
            Group::Several => "combinations",
            Group::Confounded => "equivalents",
            Group::Unlisted => "outside",
            Group::Ball => "ball",
            Group::UnlistedManyFlights => "many",
            Group::InputErrors => "told",
        }
    }
}

/// Size of an effect added to simulated flights, relative to the sizes of this effect that are met in practice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// Near the smallest size of the effect that is met in practice.
    Weak,
    /// Near the largest size of the effect that is met in practice.
    Strong,
    /// Four times the size [`Size::Strong`]: the model without the effect is badly wrong.
    Severe,
}

/// Ratio of the value of an effect at [`Size::Severe`] to its value at [`Size::Strong`].
const SEVERE: f64 = 4.0;

impl Size {
    /// Name of the size (`"weak"`, …) on documentation pages and in [`Row::key`], the text from which the seeds are
    /// derived.
    pub(super) fn label(self) -> &'static str {
        match self {
            Size::Weak => "weak",
            Size::Strong => "strong",
            Size::Severe => "severe",
        }
    }

    /// Value of an effect's coefficient at this size, given the coefficient's values for a weak effect (`weak`) and for
    /// a strong effect (`strong`).
    pub(super) fn of(self, weak: f64, strong: f64) -> f64 {
        match self {
            Size::Weak => weak,
            Size::Strong => strong,
            Size::Severe => SEVERE * strong,
        }
    }
}

/// Body that is thrown. The seeds of the simulated datasets are derived from the names of the variants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// A disc with the constants of Hubbard & Hummel (2000), model `disc`.
    Disc,
    /// A table-tennis ball, model `ball`.
    TableTennis,
    /// A football, model `ball`.
    Football,
}

impl Body {
    /// Name of the built-in model of the body.
    pub(super) fn model(self) -> &'static str {
        match self {
            Body::Disc => "disc",
            Body::TableTennis | Body::Football => "ball",
        }
    }
}

/// A row of the study's table: simulation settings of a set of runs (simulated and diagnosed datasets) that differ only
/// in their seeds.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Kind of effects or errors that are introduced into the simulated flights of the runs.
    pub group: Group,
    /// Body that is thrown.
    pub body: Body,
    /// Names of the effects of the built-in effects catalogue that are added to the simulated flights.
    pub effects: Vec<&'static str>,
    /// Name of the effect outside the built-in effects catalogue that is added to the simulated flights; `None` if
    /// there is none.
    pub unlisted: Option<&'static str>,
    /// Name of the effect or quantity that imitates the effect added to the simulated flights; `None` unless the group
    /// is [`Group::Confounded`].
    pub confounded_with: Option<&'static str>,
    /// Size of the effects added to the simulated flights; `None` if there are none.
    pub size: Option<Size>,
    /// Noise that is added to the simulated marker positions.
    pub noise: NoiseCondition,
    /// Number of flights per dataset; `None` for the default number, which depends on the body.
    pub flights: Option<usize>,
    /// Errors introduced into the spins specified in the dataset; `None` if the specified spins are exact.
    pub input_errors: Option<InputErrors>,
    /// Number of runs (simulated and diagnosed datasets) with these settings, each with a different seed.
    pub runs: usize,
}

impl Row {
    /// Names of the effects added to the simulated flights as one text; "nothing" if there are none.
    pub(super) fn seeded(&self) -> String {
        let mut names: Vec<&str> = self.effects.clone();
        names.extend(self.unlisted);
        if names.is_empty() {
            return "nothing".to_owned();
        }
        names.join(" with ")
    }

    /// Quantity of the model (site) on which the effect outside the built-in effects catalogue acts; empty for a row
    /// without such an effect.
    pub(super) fn site(&self) -> &'static str {
        let effect = self.unlisted.and_then(unlisted);
        effect.map_or("", |effect| effect.site)
    }

    /// Unique text for these simulation settings. The seeds of the runs are derived from it.
    pub fn key(&self) -> String {
        let size = self.size.map_or("", Size::label);
        let (group, seeded, noise) = (self.group.key(), self.seeded(), self.noise.name);
        let mut key = format!("{group} {:?} {seeded} {size} {noise}", self.body);
        if let Some(flights) = self.flights {
            key += &format!(" {flights} flights");
        }
        if let Some(errors) = self.input_errors {
            let percents = [errors.relative_error, errors.exchanged].map(|f| (100.0 * f).round());
            key += &format!(" off{}% swapped{}%", percents[0], percents[1]);
        }
        key.to_lowercase()
    }

    /// Whether each of the space-separated `words` occurs in the row's key (text of its simulation settings) or in the
    /// label of the row's group. Case is ignored, and hyphens match underscores.
    pub fn has(&self, words: &str) -> bool {
        let text = format!("{} {}", self.key(), self.group.label());
        words
            .to_lowercase()
            .replace('-', "_")
            .split_whitespace()
            .all(|word| text.contains(word))
    }
}
