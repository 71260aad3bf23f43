//! What is tried: rows of runs that differ in nothing but their seeds.

use oracle::effect;
use oracle::reference::Law;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use crate::identification::coverage::{Condition, conditions};
use crate::seeded::input_errors::Told;
use crate::seeded::{strength, unlisted};

/// Kinds of rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// Nothing is hidden.
    Null,
    /// One effect of the catalogue.
    Effects,
    /// Two at once.
    Pairs,
    /// Effects that another one imitates.
    Equivalents,
    /// What is in no catalogue.
    Outside,
    /// A ball's.
    Ball,
    /// What is in no catalogue, in many flights.
    Many,
    /// What is told of flights beforehand is not quite so.
    Told,
}

impl Group {
    /// In a word.
    pub fn word(self) -> &'static str {
        match self {
            Group::Null => "null",
            Group::Effects => "effects",
            Group::Pairs => "pairs",
            Group::Equivalents => "equivalents",
            Group::Outside => "outside",
            Group::Ball => "ball",
            Group::Many => "many",
            Group::Told => "told",
        }
    }
}

/// How strong what is hidden is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// As little as one meets in practice.
    Weak,
    /// As much.
    Strong,
}

impl Size {
    /// In a word.
    pub fn word(self) -> &'static str {
        match self {
            Size::Weak => "weak",
            Size::Strong => "strong",
        }
    }
}

/// What is thrown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// The disc.
    Disc,
    /// A table-tennis ball.
    TableTennis,
    /// A football.
    Football,
}

impl Body {
    /// The model's name.
    pub fn model(self) -> &'static str {
        match self {
            Body::Disc => "disc",
            Body::TableTennis | Body::Football => "ball",
        }
    }
}

/// Runs that differ in nothing but their seeds.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its kind.
    pub group: Group,
    /// What is thrown.
    pub body: Body,
    /// Effects of the catalogue that are hidden.
    pub effects: Vec<&'static str>,
    /// What is hidden from outside it.
    pub outside: Option<&'static str>,
    /// What could be taken for it, in an equivalent.
    pub alike: Option<&'static str>,
    /// How strong it is; none where nothing is hidden.
    pub size: Option<Size>,
    /// The noise.
    pub noise: Condition,
    /// How many flights, where it is not as many as usual.
    pub flights: Option<usize>,
    /// How what is told of the flights departs from the truth.
    pub told: Option<Told>,
    /// How many runs.
    pub runs: usize,
}

impl Row {
    /// What is hidden, in words.
    pub fn hidden(&self) -> String {
        let mut names: Vec<&str> = self.effects.clone();
        names.extend(self.outside);
        if names.is_empty() {
            return "nothing".to_owned();
        }
        names.join(" with ")
    }

    /// All that tells it from other rows; the seeds come from it, and `--only` looks in it.
    pub fn key(&self) -> String {
        let size = self.size.map_or("", Size::word);
        let (group, hidden, noise) = (self.group.word(), self.hidden(), self.noise.name);
        let mut key = format!("{group} {:?} {hidden} {size} {noise}", self.body);
        if let Some(flights) = self.flights {
            key += &format!(" {flights} flights");
        }
        if let Some(told) = self.told {
            let [off, swapped] = [told.off, told.swapped].map(|part| (100.0 * part).round());
            key += &format!(" off{off}% swapped{swapped}%");
        }
        key.to_lowercase()
    }

    /// Whether all words stand in its key; hyphens are as good as underscores.
    pub fn has(&self, words: &str) -> bool {
        let key = self.key();
        words
            .to_lowercase()
            .replace('-', "_")
            .split_whitespace()
            .all(|word| key.contains(word))
    }
}

/// Runs of each row for every hundred of a null row.
struct Share {
    effects: usize,
    noisy: usize,
    pairs: usize,
    equivalents: usize,
    outside: usize,
    ball: usize,
    many: usize,
    told: usize,
}

const SHARE: Share = Share {
    effects: 5,
    noisy: 2,
    pairs: 2,
    equivalents: 5,
    outside: 4,
    ball: 4,
    many: 3,
    told: 10,
};

/// Pairs that are drawn.
const PAIRS: usize = 12;

/// The seed that draws them.
const PAIRED: u64 = 12;

/// An effect, and what imitates it.
const EQUIVALENTS: [(&str, &str); 7] = [
    ("gravity", "clock_rate"),
    ("clock_rate", "gravity"),
    ("air_density", "the coefficients"),
    ("marker_radius", "scale"),
    ("scale", "marker_radius"),
    ("tilted_vertical", "wind"),
    ("wind", "tilted_vertical"),
];

/// What is hidden in flights of a ball.
const BALLS: [(&[&str], Body); 5] = [
    (&["magnus"], Body::TableTennis),
    (&["drag_crisis"], Body::Football),
    (&["wind"], Body::TableTennis),
    (&["magnus", "spin_decay"], Body::TableTennis),
    (&["buoyancy"], Body::TableTennis),
];

/// Flights of rows that have many.
const MANY: usize = 48;

/// How what is told of flights departs from the truth.
const TOLD: [Told; 4] = [
    told(0.2, 0.0),
    told(0.0, 0.33),
    told(0.2, 0.33),
    told(0.0, 1.0),
];

const fn told(off: f64, swapped: f64) -> Told {
    Told { off, swapped }
}

/// The whole plan, with so many seeds of each null row and fewer of the others.
///
/// # Panics
/// Where a built-in effect cannot be switched on.
pub fn plan(seeds: usize) -> Vec<Row> {
    let share = |part: usize| (seeds * part).div_ceil(100).max(1);
    let noises = conditions();
    let noise = |name: &str| {
        let found = noises.iter().find(|noise| noise.name == name);
        found.expect("a noise of that name").clone()
    };
    let row = |group, body, effects: &[&'static str], size, noise, runs| Row {
        group,
        body,
        effects: effects.to_vec(),
        outside: None,
        alike: None,
        size,
        noise,
        flights: None,
        told: None,
        runs,
    };
    let (white, disc) = (noise("white"), Body::Disc);
    let both = [Size::Weak, Size::Strong];
    let mut rows = Vec::new();
    for name in ["white", "AR(0.6)", "1 % outliers", "12 % dropouts"] {
        rows.push(row(Group::Null, disc, &[], None, noise(name), seeds));
    }
    let of_disc = || effect::ALL.iter().filter(|e| e.laws.contains(&Law::Disc));
    for found in of_disc() {
        for size in both {
            let runs = share(SHARE.effects);
            let noise = white.clone();
            rows.push(row(
                Group::Effects,
                disc,
                &[found.name],
                Some(size),
                noise,
                runs,
            ));
        }
        for name in ["AR(0.6)", "1 % outliers"] {
            let (runs, noise) = (share(SHARE.noisy), noise(name));
            let size = Some(Size::Strong);
            rows.push(row(Group::Effects, disc, &[found.name], size, noise, runs));
        }
    }
    let names: Vec<&'static str> = of_disc().map(|e| e.name).collect();
    for pair in pairs(&names) {
        let (runs, noise) = (share(SHARE.pairs), white.clone());
        let size = Some(Size::Strong);
        rows.push(row(Group::Pairs, disc, &pair, size, noise, runs));
    }
    for (name, alike) in EQUIVALENTS {
        let (runs, noise) = (share(SHARE.equivalents), white.clone());
        let size = Some(Size::Strong);
        rows.push(Row {
            alike: Some(alike),
            ..row(Group::Equivalents, disc, &[name], size, noise, runs)
        });
    }
    let of_outside = [
        (Group::Outside, None, SHARE.outside),
        (Group::Many, Some(MANY), SHARE.many),
    ];
    for (group, flights, part) in of_outside {
        for found in unlisted::ALL {
            let body = match found.laws.contains(&Law::Disc) {
                true => disc,
                false => Body::TableTennis,
            };
            for size in both {
                let (runs, noise) = (share(part), white.clone());
                rows.push(Row {
                    outside: Some(found.name),
                    flights,
                    ..row(group, body, &[], Some(size), noise, runs)
                });
            }
        }
    }
    for told in TOLD {
        let (runs, noise) = (share(SHARE.told), white.clone());
        let size = Some(Size::Strong);
        rows.push(Row {
            flights: Some(MANY),
            told: Some(told),
            ..row(
                Group::Told,
                Body::TableTennis,
                &["magnus"],
                size,
                noise,
                runs,
            )
        });
    }
    for (effects, body) in BALLS {
        for size in both {
            let (runs, noise) = (share(SHARE.ball), white.clone());
            rows.push(row(Group::Ball, body, effects, Some(size), noise, runs));
        }
    }
    rows
}

/// Pairs of effects that act at different sites, none twice.
fn pairs(names: &[&'static str]) -> Vec<[&'static str; 2]> {
    let mut random = ChaCha12Rng::seed_from_u64(PAIRED);
    let mut pairs: Vec<[&'static str; 2]> = Vec::new();
    while pairs.len() < PAIRS {
        let mut draw = || names[random.random_range(0..names.len())];
        let mut pair = [draw(), draw()];
        pair.sort_unstable();
        if pair[0] == pair[1] || pairs.contains(&pair) {
            continue;
        }
        let model = model_spec::load::load("disc", &pair).expect("two built-in effects");
        if model.effects[0].site != model.effects[1].site {
            pairs.push(pair);
        }
    }
    pairs
}

/// The numbers of an effect at a size.
pub(super) fn numbers(effect: &str, size: Size) -> &'static [f64] {
    let found = strength::of(effect).expect("a strength of every effect");
    match size {
        Size::Weak => found.weak,
        Size::Strong => found.strong,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_told_apart_and_found_by_words() {
        let rows = plan(100);
        let mut keys: Vec<String> = rows.iter().map(Row::key).collect();
        keys.sort();
        keys.dedup();
        assert_eq!(keys.len(), rows.len());
        let found: Vec<&Row> = rows.iter().filter(|r| r.has("Stall weak")).collect();
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].effects, ["stall"]);
        assert!(rows.iter().any(|r| r.has("marker-radius equivalents")));
        assert!(!rows.iter().any(|r| r.has("stall ball")));
    }
}
