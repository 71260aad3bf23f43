//! Renders docs/sensors.md.

use serde::Serialize;

use super::flights::SensorNoise;
use super::study::{DISPLACEMENT, SensorSet};
use crate::error::StudyError;
use crate::page::{Page, render};

#[derive(Serialize)]
struct Results<'r> {
    seeds: u64,
    noise: Noise,
    displacement_mm: f64,
    sets: &'r [SensorSet],
}

#[derive(Serialize)]
struct Noise {
    position_mm: f64,
    attitude: f64,
    rate: f64,
    force: f64,
    speed: f64,
}

/// Renders docs/sensors.md from the results of all sensor sets.
///
/// # Errors
/// [`StudyError`] if the template cannot be rendered with the results.
pub fn sensors_page(sets: &[SensorSet], seeds: u64) -> Result<Page, StudyError> {
    let noise = SensorNoise::default();
    let results = Results {
        seeds,
        noise: Noise {
            position_mm: 1e3 * noise.position,
            attitude: noise.attitude,
            rate: noise.rate,
            force: noise.force,
            speed: noise.speed,
        },
        displacement_mm: 1e3 * DISPLACEMENT[0],
        sets,
    };
    Ok(Page {
        text: render(include_str!("page.md"), results)?,
        figures: Vec::new(),
    })
}
