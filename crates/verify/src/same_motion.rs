//! Compares several models of the same body: accelerations at equal physical states, and flights from equal releases.

use crate::options::{Options, TOLERANCE};
use crate::random::Random;
use crate::row::{Row, Verdict, Worst, plain_table, rate_differences};
use crate::sample;
use crate::subject::Subject;
use serde::Serialize;

/// Comparison of the motions of two models that should describe the same motion.
#[derive(Clone, Debug, Serialize)]
pub struct Pair {
    /// Names of the two models.
    pub models: [String; 2],
    /// Comparison of velocities and accelerations at equal physical states.
    pub accelerations: Row,
    /// Comparison of final states of flights from equal physical states.
    pub flights: Row,
}

impl Pair {
    fn holds(&self) -> bool {
        self.accelerations.verdict == Verdict::Holds && self.flights.verdict != Verdict::Refuted
    }
}

/// Pairwise comparison of models that should describe the same motion.
#[derive(Clone, Debug, Serialize)]
pub struct SameMotion {
    /// One result per pair of models.
    pub pairs: Vec<Pair>,
}

impl SameMotion {
    /// Whether all accelerations agree and no flights were refuted.
    pub fn holds(&self) -> bool {
        self.pairs.iter().all(Pair::holds)
    }

    /// Formats the results of all pairs of models as a text table.
    pub fn table(&self) -> String {
        let mut table = plain_table(&["models", "accelerations", "flights", "verdict", "where"]);
        for pair in &self.pairs {
            table.add_row(vec![
                pair.models.join(" and "),
                format!(
                    "{:.1e} of {}",
                    pair.accelerations.worst, pair.accelerations.cases
                ),
                format!("{:.1e} of {}", pair.flights.worst, pair.flights.cases),
                String::from(if pair.holds() {
                    "same motion"
                } else {
                    "DIFFERENT"
                }),
                format!("{} {}", pair.accelerations.detail, pair.flights.detail)
                    .trim()
                    .to_owned(),
            ]);
        }
        format!("{table}\n")
    }
}

/// Compares each pair of models of the same body, whose corresponding constants have equal names.
pub fn compare(subjects: &[Subject<'_>], options: &Options) -> SameMotion {
    let mut pairs = Vec::new();
    for (k, a) in subjects.iter().enumerate() {
        for b in &subjects[k + 1..] {
            pairs.push(Pair {
                models: [a.model.name.clone(), b.model.name.clone()],
                accelerations: accelerations(a, b, options),
                flights: crate::flights::same_flights(a, b, options),
            });
        }
    }
    SameMotion { pairs }
}

fn accelerations(a: &Subject<'_>, b: &Subject<'_>, options: &Options) -> Row {
    const NAME: &str = "accelerations";
    let (Some(chart_a), Some(chart_b)) = (&a.chart, &b.chart) else {
        return Row::skipped(NAME, "the meaning of the states is unknown");
    };
    let mut random = Random::new(options.seed, NAME);
    let mut worst = Worst::default();
    for _ in 0..options.cases {
        let here = sample::point(a.model, &mut random);
        let Some(there) = a.corresponding_point(b, &here) else {
            return Row::skipped(NAME, "the states of one cannot be found from the other's");
        };
        let one = chart_a.physical_rate(&here.states, &a.equations.rates(&here));
        let other = chart_b.physical_rate(&there.states, &b.equations.rates(&there));
        for (what, error) in rate_differences(&one, &other) {
            worst.update(error, || what.to_owned());
        }
    }
    Row::judged(NAME, options.cases, &worst, 1e3 * TOLERANCE)
}
