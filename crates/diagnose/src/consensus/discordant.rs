//! Discordant flights: flights in which an effect has the opposite sign, or a much smaller size, than in most
//! flights.

use super::sign_flip_test::SignFlipTest;
use crate::context::ColumnId;

/// Maximum number of iterations of the search for concordant flights. An iteration estimates the common value of an
/// unknown from the concordant flights, then finds the flights that agree with this value.
const MAX_ITERATIONS: usize = 20;

/// A flight can contradict the common estimate of an unknown only if this estimate is expected to change the flight's
/// weighted sum of squares, χ², by at least this amount. Flights with a smaller expected change carry too little
/// information.
const MIN_EXPECTED_CHI2: f64 = 10.0;

/// Minimum ratio of the value of an unknown estimated from one flight alone to the common value estimated from all
/// concordant flights. A flight with enough information and a smaller ratio is discordant.
const MIN_SHARE: f64 = 0.25;

/// Division of the flights into those that agree with a common value of one unknown and those that contradict it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Concordance {
    /// Indices of the flights that contradict the value of the unknown on which all other flights agree.
    pub discordant: Vec<usize>,
    /// Decrease of the weighted sum of squares, χ², of the concordant flights if the unknown has the value on which
    /// these flights agree, instead of its value at the linearization point.
    pub chi2_decrease: f64,
}

impl SignFlipTest {
    /// Finds the value of the unknown of `column` on which most flights agree, and the discordant flights:
    /// informative flights that contradict this value.
    pub fn concordance(&self, column: ColumnId) -> Concordance {
        let flights = 0..self.flights();
        let score = |flight: usize| self.scores[(flight, column.index())];
        let information = |flight: usize| self.information[(flight, column.index())];
        // The sign of the effect in most flights, each flight weighted by its cosine.
        let sum: f64 = flights.clone().map(|f| self.cosine(f, column)).sum();
        let sign = sum.signum();
        let mut concordant: Vec<usize> =
            flights.clone().filter(|&f| sign * score(f) > 0.0).collect();
        let mut value = 0.0;
        for _ in 0..MAX_ITERATIONS {
            let total: f64 = concordant.iter().map(|&f| information(f)).sum();
            if total <= 0.0 {
                break;
            }
            value = concordant.iter().map(|&f| score(f)).sum::<f64>() / total;
            let is_concordant = |flight: &usize| {
                let expected = value * value * information(*flight);
                expected < MIN_EXPECTED_CHI2 || value * score(*flight) > MIN_SHARE * expected
            };
            let next: Vec<usize> = flights.clone().filter(is_concordant).collect();
            if next == concordant {
                break;
            }
            concordant = next;
        }
        let decrease = |&f: &usize| value * (2.0 * score(f) - value * information(f));
        Concordance {
            chi2_decrease: concordant.iter().map(decrease).sum(),
            discordant: flights.filter(|f| !concordant.contains(f)).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::consensus::sign_flip_test::tests::flights;
    use crate::context::ColumnId;

    #[test]
    fn flights_of_opposite_sign_are_discordant() {
        let found = flights(24, 7).concordance(ColumnId::new(0));
        assert_eq!(found.discordant, (17..24).collect::<Vec<_>>());
        // The weighted sum of squares of each of the 17 concordant flights falls by about 1000.
        let relative = found.chi2_decrease / 17_000.0;
        assert!((relative - 1.0).abs() < 0.3, "{relative}");
        let none = flights(24, 0).concordance(ColumnId::new(0));
        assert!(none.discordant.is_empty());
    }
}
