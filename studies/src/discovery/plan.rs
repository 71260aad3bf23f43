//! Plan of the discovery study: all its rows.

use oracle::Law;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::row::{Body, Group, Row, Size};
use crate::oracle_flights::{NoiseCondition, noise_conditions};
use crate::seeded::law as effect;
use crate::seeded::{InputErrors, UNLISTED};

/// Number of runs of one row of the results table, for each [`Group`] of rows. A row is one combination of simulation
/// settings (body, effects, size, noise), a run one simulated and diagnosed dataset. The numbers hold if a row whose
/// simulated flights contain no added effect has 100 runs, and scale with that number.
struct RunCounts {
    single: usize,
    /// Number of runs of a row whose flights contain one effect of the catalogue and whose noise is not white
    /// (correlated noise, outliers or gaps). `single` is the number for white noise.
    single_noisy: usize,
    pair: usize,
    several: usize,
    severe: usize,
    confounded: usize,
    unlisted: usize,
    ball: usize,
    unlisted_many_flights: usize,
    input_errors: usize,
}

const RUNS: RunCounts = RunCounts {
    single: 5,
    single_noisy: 2,
    pair: 2,
    several: 2,
    severe: 5,
    confounded: 5,
    unlisted: 4,
    ball: 4,
    unlisted_many_flights: 3,
    input_errors: 10,
};

/// Number of random pairs of effects that the study adds to simulated flights.
const PAIRS: usize = 12;

/// Seed with which the random pairs of effects that are added to simulated flights are drawn.
const PAIR_SEED: u64 = 12;

/// Random combinations of effects that the study adds to simulated flights: number of effects in a combination, and
/// number of combinations with that many effects.
const SEVERAL: [(usize, usize); 2] = [(2, 10), (3, 10)];

/// Seed with which the random combinations of two or three effects are drawn.
const SEVERAL_SEED: u64 = 23;

/// Names of effects that are also added to simulated flights at severe size (four times the size "strong"), so that the
/// model without the effect is badly wrong.
const SEVERE: [&str; 3] = ["stall", "zero_lift_drag_angle", "cubic_pitching_moment"];

/// Pairs of names: first an effect that is added to simulated flights, then another cause with the same influence on
/// flights. The flights alone do not allow the diagnosis to distinguish the two.
const CONFOUNDED: [(&str, &str); 7] = [
    ("gravity", "clock_rate"),
    ("clock_rate", "gravity"),
    ("air_density", "the coefficients"),
    ("marker_radius", "scale"),
    ("scale", "marker_radius"),
    ("tilted_vertical", "wind"),
    ("wind", "tilted_vertical"),
];

/// Sets of effects that are added together to simulated flights of a ball, each with the kind of ball.
const BALL_EFFECTS: [(&[&str], Body); 5] = [
    (&["magnus"], Body::TableTennis),
    (&["drag_crisis"], Body::Football),
    (&["wind"], Body::TableTennis),
    (&["magnus", "spin_decay"], Body::TableTennis),
    (&["buoyancy"], Body::TableTennis),
];

/// Number of flights per dataset in those rows that test effects outside the built-in effects catalogue with more
/// flights than the default.
const MANY_FLIGHTS: usize = 48;

/// Errors introduced into the spins that the dataset states, as pairs: standard deviation relative to the spin, and
/// fraction of the flights whose spins are exchanged among each other.
const INPUT_ERRORS: [(f64, f64); 4] = [(0.2, 0.0), (0.0, 0.33), (0.2, 0.33), (0.0, 1.0)];

const BOTH_SIZES: [Size; 2] = [Size::Weak, Size::Strong];

/// Builds the rows of the study's table; each row is one combination of simulation settings. `seeds` is the number of
/// runs (simulated and diagnosed datasets) of a row whose flights contain no added effect; other rows have a fraction
/// of this number.
struct Planner {
    seeds: usize,
    noises: Vec<NoiseCondition>,
}

impl Planner {
    fn noise(&self, name: &str) -> NoiseCondition {
        let mut noises = self.noises.iter();
        let found = noises.find(|noise| noise.name == name);
        found.expect("a noise of that name").clone()
    }

    /// Builds a row of the study's table (combination of simulation settings) with effects of strong size under white
    /// noise. `percent` is the number of runs of the row as a percentage of the planner's `seeds`.
    fn row(&self, group: Group, body: Body, effects: &[&'static str], percent: usize) -> Row {
        Row {
            group,
            body,
            effects: effects.to_vec(),
            unlisted: None,
            confounded_with: None,
            size: Some(Size::Strong),
            noise: self.noise("white"),
            flights: None,
            input_errors: None,
            runs: (self.seeds * percent).div_ceil(100).max(1),
        }
    }

    fn null_rows(&self) -> Vec<Row> {
        let names = ["white", "AR(0.6)", "1 % outliers", "12 % dropouts"];
        let rows = names.map(|name| Row {
            size: None,
            noise: self.noise(name),
            runs: self.seeds,
            ..self.row(Group::Null, Body::Disc, &[], 100)
        });
        rows.into()
    }

    fn single_rows(&self, effect: &'static str) -> Vec<Row> {
        let row = |percent| self.row(Group::Single, Body::Disc, &[effect], percent);
        let sizes = BOTH_SIZES.map(|size| Row {
            size: Some(size),
            ..row(RUNS.single)
        });
        let noisy = ["AR(0.6)", "1 % outliers"].map(|name| Row {
            noise: self.noise(name),
            ..row(RUNS.single_noisy)
        });
        [sizes, noisy].concat()
    }

    fn unlisted_rows(&self, group: Group, flights: Option<usize>, percent: usize) -> Vec<Row> {
        let rows = UNLISTED.iter().flat_map(|effect| {
            let body = match effect.laws.contains(&Law::Disc) {
                true => Body::Disc,
                false => Body::TableTennis,
            };
            BOTH_SIZES.map(|size| Row {
                unlisted: Some(effect.name),
                flights,
                size: Some(size),
                ..self.row(group, body, &[], percent)
            })
        });
        rows.collect()
    }

    fn input_error_rows(&self) -> Vec<Row> {
        let rows = INPUT_ERRORS.map(|(relative_error, exchanged)| {
            let (body, percent) = (Body::TableTennis, RUNS.input_errors);
            Row {
                flights: Some(MANY_FLIGHTS),
                input_errors: Some(InputErrors {
                    relative_error,
                    exchanged,
                }),
                ..self.row(Group::InputErrors, body, &["magnus"], percent)
            }
        });
        rows.into()
    }

    fn ball_rows(&self) -> Vec<Row> {
        let rows = BALL_EFFECTS.iter().flat_map(|(effects, body)| {
            BOTH_SIZES.map(|size| Row {
                size: Some(size),
                ..self.row(Group::Ball, *body, effects, RUNS.ball)
            })
        });
        rows.collect()
    }
}

/// Returns all rows (combinations of simulation settings) of the study's table. A row whose simulated flights contain
/// no added effect has `seeds` runs (simulated and diagnosed datasets); the other rows have fewer.
///
/// # Panics
/// If a built-in effect does not load.
pub fn plan(seeds: usize) -> Vec<Row> {
    let planner = Planner {
        seeds,
        noises: noise_conditions(),
    };
    let disc_effects = effect::all().filter(|e| e.laws.contains(&Law::Disc));
    let names: Vec<&'static str> = disc_effects.map(|effect| effect.name).collect();
    let mut rows = planner.null_rows();
    rows.extend(names.iter().flat_map(|name| planner.single_rows(name)));
    for pair in pairs(&names) {
        rows.push(planner.row(Group::Pair, Body::Disc, &pair, RUNS.pair));
    }
    for (number, count) in SEVERAL {
        for effects in combinations(&names, number, count) {
            rows.push(planner.row(Group::Several, Body::Disc, &effects, RUNS.several));
        }
    }
    for name in SEVERE {
        rows.push(Row {
            size: Some(Size::Severe),
            ..planner.row(Group::Single, Body::Disc, &[name], RUNS.severe)
        });
    }
    for (name, confounded_with) in CONFOUNDED {
        rows.push(Row {
            confounded_with: Some(confounded_with),
            ..planner.row(Group::Confounded, Body::Disc, &[name], RUNS.confounded)
        });
    }
    rows.extend(planner.unlisted_rows(Group::Unlisted, None, RUNS.unlisted));
    rows.extend(planner.unlisted_rows(
        Group::UnlistedManyFlights,
        Some(MANY_FLIGHTS),
        RUNS.unlisted_many_flights,
    ));
    rows.extend(planner.input_error_rows());
    rows.extend(planner.ball_rows());
    rows
}

/// Draws [`PAIRS`] different random pairs from the effects `names`. The two effects of a pair act on different
/// quantities of the model (sites), such as lift and drag.
fn pairs(names: &[&'static str]) -> Vec<[&'static str; 2]> {
    let mut random = ChaCha12Rng::seed_from_u64(PAIR_SEED);
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

/// Draws `count` different random combinations of `number` effects from `names`. The effects of a combination act on
/// different quantities of the model (sites). Effects whose influence on flights equals that of another cause are not
/// drawn.
fn combinations(names: &[&'static str], number: usize, count: usize) -> Vec<Vec<&'static str>> {
    let mut random = ChaCha12Rng::seed_from_u64(SEVERAL_SEED + number as u64);
    let imitated = |name: &str| CONFOUNDED.iter().any(|(of, _)| *of == name);
    let names: Vec<&'static str> = names
        .iter()
        .copied()
        .filter(|name| !imitated(name))
        .collect();
    let mut found: Vec<Vec<&'static str>> = Vec::new();
    while found.len() < count {
        let draw = |_| names[random.random_range(0..names.len())];
        let mut drawn: Vec<&'static str> = (0..number).map(draw).collect();
        drawn.sort_unstable();
        drawn.dedup();
        if drawn.len() < number || found.contains(&drawn) {
            continue;
        }
        let Ok(model) = model_spec::load::load("disc", &drawn) else {
            continue;
        };
        let sites: Vec<_> = model.effects.iter().map(|effect| &effect.site).collect();
        if (1..number).all(|k| !sites[..k].contains(&sites[k])) {
            found.push(drawn);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_unique_and_rows_are_found_by_words() {
        let rows = plan(100);
        let mut keys: Vec<String> = rows.iter().map(Row::key).collect();
        keys.sort();
        keys.dedup();
        assert_eq!(keys.len(), rows.len());
        let found: Vec<&Row> = rows.iter().filter(|r| r.has("Stall weak")).collect();
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].effects, ["stall"]);
        assert!(rows.iter().any(|r| r.has("marker-radius equivalents")));
        assert!(rows.iter().any(|r| r.has("marker-radius confounded")));
        assert!(!rows.iter().any(|r| r.has("stall ball")));
    }
}
