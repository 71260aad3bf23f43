//! Simulates both flights under every reading and ranks the readings by the agreement of the outcomes with the paper's
//! claims.

use super::claims::{self, Claim, Outcome};
use super::coefficients::coefficients;
use super::columns::{Columns, orders};
use super::conventions::Conventions;
use super::fly::Flyer;
use super::reading::Reading;
use super::table::Table1;
use crate::error::StudyError;

/// Maximum deviation of a simulated from a stated outcome that enters the misfit, in units of the outcome's tolerance.
/// Larger deviations are clipped to this value.
const MAX_DEPARTURE: f64 = 10.0;

/// Increase of the score of an interpretation of Table 1 of Hubbard & Hummel (2000) for each hypothesis that it makes:
/// Akaike's penalty for one more parameter. The remainder of the score is a sum of squared deviations, each deviation
/// divided by its tolerance.
pub(super) const PENALTY: f64 = 2.0;

/// A reading (interpretation of Table 1 of Hubbard & Hummel, 2000), with the agreement between the flights simulated
/// under it and the outcomes that the publication states.
#[derive(Clone, Debug)]
pub struct Scored {
    /// Interpretation of Table 1 of Hubbard & Hummel (2000) under which both flights were simulated.
    pub reading: Reading,
    /// Sum, over the outcomes that Hubbard & Hummel (2000) state, of the squared deviations of the simulation, each
    /// deviation divided by the outcome's tolerance; each square is clipped to 100.
    pub misfit: f64,
    /// Number of outcomes stated by Hubbard & Hummel (2000) from which the simulation deviates by at most the
    /// tolerance.
    pub held: usize,
}

impl Scored {
    /// Sum of the misfit and a penalty of 2 for each hypothesis that the interpretation makes; the lowest score is the
    /// best.
    pub fn score(&self) -> f64 {
        self.misfit + PENALTY * self.reading.hypotheses() as f64
    }
}

/// Simulated outcomes of the two flights of Hubbard & Hummel (2000) under all interpretations of their Table 1, and the
/// ranking of these interpretations.
pub struct Study {
    /// Numerical values that Hubbard & Hummel (2000) state about their two flights.
    pub claims: Vec<Claim>,
    /// All interpretations of Table 1 of Hubbard & Hummel (2000) with their misfit, sorted by score, best first.
    pub ranking: Vec<Scored>,
    orders: Vec<Columns>,
    conventions: Vec<Conventions>,
    /// Simulated outcomes of the flight fssh3, indexed `[convention][order]` like the lists `conventions` (assumed
    /// signs and units) and `orders` (assumed orders of the table's columns). `None` if the integration fails.
    fssh3: Vec<Vec<Option<Outcome>>>,
    bffl8: Vec<Vec<Option<Outcome>>>,
}

impl Study {
    /// Simulates both flights of Hubbard & Hummel (2000) under every interpretation of their Table 1, and ranks the
    /// interpretations.
    ///
    /// # Errors
    /// [`StudyError`] if the built-in model or a release does not load.
    pub fn run() -> Result<Self, StudyError> {
        let claims = claims::all();
        let table = Table1::printed();
        let (orders, conventions) = (orders(), Conventions::all());
        let flown = |name: &str, row: &[f64; 8]| -> Result<Vec<Vec<Option<Outcome>>>, StudyError> {
            let flyer = Flyer::new(name, duration(&claims, name))?;
            let (d, g) = flyer.scales();
            Ok(flight::parallel::each(conventions.len(), |index| {
                let conventions = &conventions[index];
                let fly = |&order: &Columns| {
                    flyer.fly(&coefficients(row, order, conventions, d, g), conventions)
                };
                orders.iter().map(fly).collect()
            }))
        };
        let (fssh3, bffl8) = (flown("fssh3", &table.fssh3)?, flown("bffl8", &table.bffl8)?);
        let mut study = Self {
            claims,
            ranking: Vec::new(),
            orders,
            conventions,
            fssh3,
            bffl8,
        };
        study.rank();
        Ok(study)
    }

    fn rank(&mut self) {
        let mut ranking = Vec::new();
        for (c, conventions) in self.conventions.iter().enumerate() {
            let score = |flight: &str, outcomes: &[Option<Outcome>]| -> Vec<(f64, usize)> {
                outcomes
                    .iter()
                    .map(|outcome| self.judge(flight, outcome.as_ref()))
                    .collect()
            };
            let (first, second) = (
                score("fssh3", &self.fssh3[c]),
                score("bffl8", &self.bffl8[c]),
            );
            for (i, &fssh3) in self.orders.iter().enumerate() {
                for (j, &bffl8) in self.orders.iter().enumerate() {
                    ranking.push(Scored {
                        reading: Reading {
                            conventions: *conventions,
                            fssh3,
                            bffl8,
                        },
                        misfit: first[i].0 + second[j].0,
                        held: first[i].1 + second[j].1,
                    });
                }
            }
        }
        ranking.sort_by(|a, b| {
            a.score()
                .total_cmp(&b.score())
                .then(a.reading.cmp(&b.reading))
        });
        self.ranking = ranking;
    }

    /// Misfit of one simulated flight, and the number of outcomes stated for this flight that it meets within the
    /// tolerance. `outcome` is `None` if the integration failed; every deviation then counts as [`MAX_DEPARTURE`]
    /// tolerances.
    fn judge(&self, flight: &str, outcome: Option<&Outcome>) -> (f64, usize) {
        let claims = self.claims.iter().filter(|claim| claim.flight == flight);
        claims.fold((0.0, 0), |(misfit, held), claim| {
            let departure = outcome.map_or(f64::INFINITY, |outcome| outcome.departure(claim).abs());
            let departure = if departure.is_finite() {
                departure
            } else {
                MAX_DEPARTURE
            };
            (
                misfit + departure.min(MAX_DEPARTURE).powi(2),
                held + usize::from(departure <= 1.0),
            )
        })
    }

    /// Outcome of a flight simulated under an interpretation of Table 1 of Hubbard & Hummel (2000); `None` if the
    /// integration fails.
    pub(super) fn outcome(&self, reading: &Reading, flight: &str) -> Option<Outcome> {
        let convention = self
            .conventions
            .iter()
            .position(|conventions| *conventions == reading.conventions)?;
        let (outcomes, order) = match flight {
            "fssh3" => (&self.fssh3, reading.fssh3),
            _ => (&self.bffl8, reading.bffl8),
        };
        outcomes[convention][self.orders.iter().position(|&known| known == order)?]
    }

    /// Looks up an interpretation of Table 1 of Hubbard & Hummel (2000) in the ranking, with its misfit and score;
    /// `None` if the interpretation is not part of the study.
    pub(super) fn score_of(&self, reading: &Reading) -> Option<&Scored> {
        self.ranking
            .iter()
            .find(|scored| scored.reading == *reading)
    }

    /// Returns the interpretations of Table 1 of Hubbard & Hummel (2000) that the outcomes stated in that publication
    /// cannot distinguish from the best one, which is first. These interpretations have the same number of outcomes
    /// within tolerance and a misfit less than 1 above the minimum.
    pub(super) fn indistinguishable(&self) -> Vec<&Scored> {
        let best = &self.ranking[0];
        let near = |scored: &&Scored| scored.held == best.held && scored.misfit < best.misfit + 1.0;
        self.ranking.iter().filter(near).collect()
    }
}

/// Latest time in a flight for which Hubbard & Hummel (2000) state an outcome, s; 0 if they state none.
fn duration(claims: &[Claim], flight: &str) -> f64 {
    claims
        .iter()
        .filter(|claim| claim.flight == flight)
        .filter_map(|claim| claim.at)
        .fold(0.0, f64::max)
}
