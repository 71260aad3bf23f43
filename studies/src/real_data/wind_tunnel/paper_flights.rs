//! Section of docs/studies/real-data.md on the paper's two flights, simulated with the wind tunnel's coefficients and fitted by
//! the model.

use model_spec::model::Model;
use serde::Serialize;

use super::table::{Measured, interpolated};
use crate::error::StudyError;
use crate::identification::scenario;
use crate::oracle_flights::{paper_flight, release_angle_of_attack};
use crate::page::render;
use crate::paper::printed_coefficient;

/// Number of seeds of the noise, that is of simulated datasets, for each flight.
const SEEDS: u64 = 40;

/// The estimates of a coefficient from the two flights count as different if they differ by more than this number of
/// standard deviations of their difference.
const DIFFERENT: f64 = 3.0;

const FLIGHTS: [&str; 2] = ["fssh3", "bffl8"];

#[derive(Serialize)]
struct Section {
    /// Angles of attack at the releases of flights fssh3 and bffl8, degrees.
    released: [f64; 2],
    seeds: u64,
    coefficients: Vec<CoefficientRow>,
    different: Vec<(String, f64)>,
}

#[derive(Serialize)]
struct CoefficientRow {
    name: String,
    /// Mean and standard deviation, over the seeds of the noise, of the estimates from flight fssh3 and from flight
    /// bffl8.
    estimates: [(f64, f64); 2],
    printed: Option<[f64; 2]>,
}

impl CoefficientRow {
    /// Absolute difference between the mean estimates from flights fssh3 and bffl8 / standard deviation of this
    /// difference.
    fn difference(&self) -> f64 {
        let [a, b] = self.estimates;
        (a.0 - b.0).abs() / a.1.hypot(b.1)
    }
}

/// Simulates the two flights of Hubbard & Hummel (2000) with the coefficients measured in the wind tunnel (`table`),
/// fits the model `disc` to each, and renders the section on the estimates as Markdown.
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
