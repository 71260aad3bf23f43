//! Both flights under every reading, ranked.

use crate::paper::claims::{self, Claim, Outcome};
use crate::paper::fly::Flyer;
use crate::paper::reading::{Columns, Common, Reading, Table1, coefficients, orders};

/// A departure of more tolerances than this counts as this: wrong is wrong.
const WORST: f64 = 10.0;

/// What each hypothesis must gain to be worth it, in squared tolerances: Akaike's price of one more parameter.
pub const PRICE: f64 = 2.0;

/// How well a reading does.
#[derive(Clone, Debug)]
pub struct Scored {
    /// The reading.
    pub reading: Reading,
    /// Squared departures from the claims in tolerances, summed, each at most 100.
    pub misfit: f64,
    /// How many claims come out within their tolerance.
    pub held: usize,
}

impl Scored {
    /// Misfit with the price of the hypotheses used.
    pub fn score(&self) -> f64 {
        self.misfit + PRICE * self.reading.hypotheses() as f64
    }
}

/// All readings, flown.
pub struct Study {
    /// The claims.
    pub claims: Vec<Claim>,
    /// Every reading, best first.
    pub ranking: Vec<Scored>,
    orders: Vec<Columns>,
    commons: Vec<Common>,
    /// `[common][order]` for each flight.
    fssh3: Vec<Vec<Option<Outcome>>>,
    bffl8: Vec<Vec<Option<Outcome>>>,
}

impl Study {
    /// Flies both flights under every reading.
    ///
    /// # Errors
    /// In words, where the built-in model or releases cannot be used.
    pub fn run() -> Result<Self, String> {
        let claims = claims::all();
        let table = Table1::printed();
        let (orders, commons) = (orders(), Common::all());
        let flown = |name: &str, row: &[f64; 8]| -> Result<Vec<Vec<Option<Outcome>>>, String> {
            let flyer = Flyer::new(name, duration(&claims, name))?;
            let (d, g) = flyer.scales();
            Ok(flight::batch::each(commons.len(), |index| {
                let common = &commons[index];
                let fly =
                    |&order: &Columns| flyer.fly(&coefficients(row, order, common, d, g), common);
                orders.iter().map(fly).collect()
            }))
        };
        let (fssh3, bffl8) = (flown("fssh3", &table.fssh3)?, flown("bffl8", &table.bffl8)?);
        let mut study = Self {
            claims,
            ranking: Vec::new(),
            orders,
            commons,
            fssh3,
            bffl8,
        };
        study.rank();
        Ok(study)
    }

    fn rank(&mut self) {
        let mut ranking = Vec::new();
        for (c, common) in self.commons.iter().enumerate() {
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
                            common: *common,
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

    /// Misfit and number of claims held by one flight.
    fn judge(&self, flight: &str, outcome: Option<&Outcome>) -> (f64, usize) {
        let claims = self.claims.iter().filter(|claim| claim.flight == flight);
        claims.fold((0.0, 0), |(misfit, held), claim| {
            let departure = outcome.map_or(f64::INFINITY, |outcome| outcome.departure(claim).abs());
            let departure = if departure.is_finite() {
                departure
            } else {
                WORST
            };
            (
                misfit + departure.min(WORST).powi(2),
                held + usize::from(departure <= 1.0),
            )
        })
    }

    /// What came out of a flight under a reading; `None` where it could not be flown to its end.
    pub fn outcome(&self, reading: &Reading, flight: &str) -> Option<Outcome> {
        let common = self
            .commons
            .iter()
            .position(|common| *common == reading.common)?;
        let (outcomes, order) = match flight {
            "fssh3" => (&self.fssh3, reading.fssh3),
            _ => (&self.bffl8, reading.bffl8),
        };
        outcomes[common][self.orders.iter().position(|&known| known == order)?]
    }

    /// The scored entry of a reading.
    pub fn of(&self, reading: &Reading) -> Option<&Scored> {
        self.ranking
            .iter()
            .find(|scored| scored.reading == *reading)
    }

    /// The best reading and all that hold as many claims with a misfit less than one squared tolerance worse:
    /// the claims cannot tell them apart.
    pub fn indistinguishable(&self) -> Vec<&Scored> {
        let best = &self.ranking[0];
        let near = |scored: &&Scored| scored.held == best.held && scored.misfit < best.misfit + 1.0;
        self.ranking.iter().filter(near).collect()
    }
}

/// When the last claim about a flight is made, s.
fn duration(claims: &[Claim], flight: &str) -> f64 {
    claims
        .iter()
        .filter(|claim| claim.flight == flight)
        .filter_map(|claim| claim.at)
        .fold(0.0, f64::max)
}
