//! Renders docs/studies/sensors.md.

use serde::Serialize;

use super::flights::SensorNoise;
use super::study::{DISPLACEMENT, SensorSet};
use crate::error::StudyError;
use crate::page::Page;

#[derive(Serialize)]
struct Results<'r> {
    seeds: u64,
    noise: SensorNoise,
    displacement_mm: f64,
    sets: &'r [SensorSet],
}

/// Renders docs/studies/sensors.md from the results of all sensor sets.
///
/// # Errors
/// [`StudyError`] if the template cannot be rendered with the results.
pub fn sensors_page(sets: &[SensorSet], seeds: u64) -> Result<Page, StudyError> {
    let results = Results {
        seeds,
        noise: SensorNoise::default(),
        displacement_mm: 1e3 * DISPLACEMENT[0],
        sets,
    };
    Page::without_figures(include_str!("page.md"), results)
}
