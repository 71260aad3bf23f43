//! Section of docs/real-data.md on the paper's two flights with the wind tunnel's coefficients.

use model_spec::model::Model;
use serde::Serialize;

use super::table::{Measured, interpolated};
use crate::error::StudyError;
use crate::identification::scenario;
use crate::oracle_flights::{paper_flight, release_angle_of_attack};
use crate::page::render;
use crate::paper::printed_coefficient;

/// Number of noise seeds.
const SEEDS: u64 = 40;

/// Difference of two estimates, in standard deviations, above which they count as different.
const DIFFERENT: f64 = 3.0;

const FLIGHTS: [&str; 2] = ["fssh3", "bffl8"];

#[derive(Serialize)]
struct Section {
    /// Angle of attack at release, degrees.
    released: [f64; 2],
    seeds: u64,
    coefficients: Vec<CoefficientRow>,
    different: Vec<(String, f64)>,
}

#[derive(Serialize)]
struct CoefficientRow {
    name: String,
    /// Mean and standard deviation over the seeds, from each flight.
    estimates: [(f64, f64); 2],
    printed: Option<[f64; 2]>,
}

impl CoefficientRow {
    /// Difference of the two means / its standard deviation.
    fn difference(&self) -> f64 {
        let [a, b] = self.estimates;
        (a.0 - b.0).abs() / a.1.hypot(b.1)
    }
}

/// Makes and fits the flights. The section, in Markdown.
pub(in super::super) fn paper_flights_section(
    disc: &Model,
    table: &[Measured],
) -> Result<String, StudyError> {
    let curves = |alpha: f64| interpolated(table, alpha);
    let fits = FLIGHTS.map(|name| {
        let flight = paper_flight(disc, name, Some(&curves));
        scenario(disc, name, &flight, 0.0, SEEDS)
    });
    let rows = disc.coefficients.iter().enumerate();
    let rows = rows.map(|(k, coefficient)| CoefficientRow {
        name: coefficient.name.clone(),
        estimates: fits.each_ref().map(|fits| fits.mean_and_deviation(k)),
        printed: printed_coefficient(&coefficient.name),
    });
    let rows: Vec<CoefficientRow> = rows.collect();
    let different = rows.iter().map(|row| (row.name.clone(), row.difference()));
    let section = Section {
        released: FLIGHTS.map(|name| release_angle_of_attack(disc, name).to_degrees()),
        seeds: SEEDS,
        different: different.filter(|(_, z)| *z > DIFFERENT).collect(),
        coefficients: rows,
    };
    render(include_str!("paper_flights.md"), section)
}
