//! Rows of the study: runs that differ only in their seeds.

use crate::oracle_flights::NoiseCondition;
use crate::seeded::InputErrors;

/// Kind of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// No seeded effect.
    Null,
    /// One effect of the catalogue.
    Single,
    /// Two effects of the catalogue.
    Pair,
    /// Two or three effects of the catalogue that flights can tell apart, in other combinations than the pairs.
    Several,
    /// An effect that another one imitates.
    Confounded,
    /// An effect outside the catalogue.
    Unlisted,
    /// Effects of a ball.
    Ball,
    /// An effect outside the catalogue, in 48 flights.
    UnlistedManyFlights,
    /// Errors in the spins that the dataset states.
    InputErrors,
}

impl Group {
    /// Name in pages.
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

    /// Name in [`Row::key`], from which the seeds follow: another one would give other datasets.
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

/// Size of a seeded effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// Near the least that is met in practice.
    Weak,
    /// Near the greatest that is met in practice.
    Strong,
    /// Four times that: the model is badly wrong.
    Severe,
}

/// Size of a severe effect over that of a strong one.
const SEVERE: f64 = 4.0;

impl Size {
    /// Name in pages and keys.
    pub(super) fn label(self) -> &'static str {
        match self {
            Size::Weak => "weak",
            Size::Strong => "strong",
            Size::Severe => "severe",
        }
    }

    /// The value of this size, of an effect with a weak and a strong one.
    pub(super) fn of(self, weak: f64, strong: f64) -> f64 {
        match self {
            Size::Weak => weak,
            Size::Strong => strong,
            Size::Severe => SEVERE * strong,
        }
    }
}

/// Body that is thrown; the names of the variants are part of [`Row::key`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// Disc.
    Disc,
    /// Table-tennis ball.
    TableTennis,
    /// Football.
    Football,
}

impl Body {
    /// Name of the built-in model.
    pub(super) fn model(self) -> &'static str {
        match self {
            Body::Disc => "disc",
            Body::TableTennis | Body::Football => "ball",
        }
    }
}

/// Runs that differ only in their seeds.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Kind of the row.
    pub group: Group,
    /// Body that is thrown.
    pub body: Body,
    /// Seeded effects of the catalogue.
    pub effects: Vec<&'static str>,
    /// Seeded effect outside the catalogue.
    pub unlisted: Option<&'static str>,
    /// What imitates the effect; only of [`Group::Confounded`].
    pub confounded_with: Option<&'static str>,
    /// Size of the effects; `None` without a seeded effect.
    pub size: Option<Size>,
    /// Noise.
    pub noise: NoiseCondition,
    /// Number of flights; `None` for the default of the body.
    pub flights: Option<usize>,
    /// Errors in the stated spins.
    pub input_errors: Option<InputErrors>,
    /// Number of runs.
    pub runs: usize,
}

impl Row {
    /// Names of the seeded effects.
    pub(super) fn seeded(&self) -> String {
        let mut names: Vec<&str> = self.effects.clone();
        names.extend(self.unlisted);
        if names.is_empty() {
            return "nothing".to_owned();
        }
        names.join(" with ")
    }

    /// Text that identifies the row among all; the seeds of its runs follow from it.
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

    /// Whether all words occur in the key or the group's name in pages; hyphens match underscores.
    pub fn has(&self, words: &str) -> bool {
        let text = format!("{} {}", self.key(), self.group.label());
        words
            .to_lowercase()
            .replace('-', "_")
            .split_whitespace()
            .all(|word| text.contains(word))
    }
}
