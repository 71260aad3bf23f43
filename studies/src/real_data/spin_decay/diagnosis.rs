//! Fits and diagnoses the record of a gyroscope and an accelerometer with the standard tools and a model of the whole
//! disc.

use std::path::Path;

use dataset::{Dataset, Flight, Reading, Sensor, SensorKind};
use diagnose::{DiagnosisOptions, ExplanationEffect, diagnose};
use identify::{FitOptions, Prior};
use model_spec::compose::Instrument;
use serde::Serialize;

use super::record::FLIGHT;
use crate::error::StudyError;
use crate::real_data::files::{absent, bad_line, rows, text_of};

/// Standard gravity, m/s², the unit of the recorded specific forces.
const STANDARD_GRAVITY: f64 = 9.80665;

/// Length of the parts at the beginning and at the end of the flight that are excluded from the analysis, s.
pub(super) const MARGIN: f64 = 0.06;

/// Names of the disc model and of the effects that represent mounting errors of the sensors on the disc.
const MODEL: (&str, [&str; 2]) = (
    "disc_quaternion",
    ["accelerometer_misplaced", "gyroscope_misaligned"],
);

/// Priors of coefficients that one flight of unknown airspeed does not determine: name, mean, standard deviation, SI.
pub(super) const PRIORS: [(&str, f64, f64); 4] = [
    ("C_L0", 0.2, 0.1),
    ("C_La", 2.4, 0.5),
    ("C_D0", 0.1, 0.05),
    ("C_Da", 1.5, 0.5),
];

/// Results of fitting and diagnosing the measured flight of a disc with gyroscope and accelerometer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Diagnosed {
    pub(super) verdict: String,
    pub(super) causes: Vec<CauseRow>,
    /// Estimated offsets of the accelerometer from the disc's centre along the two axes in the disc's plane, each with
    /// its standard error, mm.
    pub(super) off_mm: [[f64; 2]; 2],
    /// Spin-damping coefficient `C_Nr` from the fit of the model without an added effect, and its standard error,
    /// N·m·s.
    pub(super) c_nr: [f64; 2],
    /// Number of sensor samples of the flight that were fitted and diagnosed.
    pub(super) samples: usize,
}

/// Table row on one hypothesis of the diagnosis: a set of effects (optional model extensions) that explains the misfit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct CauseRow {
    pub(super) effects: String,
    pub(super) site: String,
    pub(super) explained: f64,
}

/// Diagnoses the flight in a table with the columns `t,gx,gy,gz,acc_x,acc_y,acc_z` in s, rad/s and multiples of
/// standard gravity.
pub(super) fn diagnosed(file: &Path) -> Result<Diagnosed, StudyError> {
    let dataset = dataset(file)?;
    let (name, effects) = MODEL;
    let model = model_spec::load::load(name, &effects)?;
    let priors = PRIORS.map(|(name, value, sigma)| Prior {
        name: name.to_owned(),
        value,
        sigma,
    });
    let options = DiagnosisOptions {
        fit: FitOptions {
            priors: &priors,
            trust_data: true,
            ..FitOptions::default()
        },
        ..DiagnosisOptions::default()
    };
    let base = identify::fit(&model, &dataset, &options.fit)?;
    let found = diagnose(&model, &dataset, &options)?;
    let estimate = |name: &str, unit: f64| {
        let own = base.report.coefficients.get(name);
        own.map_or([f64::NAN; 2], |own| {
            [own.value * unit, own.std_error * unit]
        })
    };
    let causes = found.report.explanations.iter().map(|cause| {
        let of = |text: fn(&ExplanationEffect) -> String| -> String {
            let each: Vec<String> = cause.effects.iter().map(text).collect();
            each.join(" with ")
        };
        CauseRow {
            effects: of(|effect| effect.name.clone()),
            site: of(|effect| effect.site.clone()),
            explained: cause.explained_fraction,
        }
    });
    Ok(Diagnosed {
        verdict: format!("{:?}", found.report.verdict).to_lowercase(),
        causes: causes.collect(),
        off_mm: ["accelerometer_by_1", "accelerometer_by_2"].map(|name| estimate(name, 1e3)),
        c_nr: estimate("C_Nr", 1.0),
        samples: dataset.flights[0].times.len(),
    })
}

/// Reads the flight from a table of gyroscope and accelerometer readings, as a dataset with these two sensors.
fn dataset(file: &Path) -> Result<Dataset, StudyError> {
    let text = text_of(file)?;
    let within = FLIGHT.0 + MARGIN - 1e-9..=FLIGHT.1 - MARGIN + 1e-9;
    let (mut times, mut readings) = (Vec::new(), Vec::new());
    for row in rows(&text, 1) {
        let cells: Vec<Option<f64>> = row
            .1
            .split(',')
            .map(|cell| cell.trim().parse().ok())
            .collect();
        let &[
            Some(time),
            Some(gx),
            Some(gy),
            Some(gz),
            Some(ax),
            Some(ay),
            Some(az),
        ] = &cells[..]
        else {
            return Err(bad_line(file, row, "t,gx,gy,gz,acc_x,acc_y,acc_z"));
        };
        if within.contains(&time) {
            let force = [ax, ay, az].map(|g| STANDARD_GRAVITY * g);
            let reading = |[x, y, z]: [f64; 3]| -> Option<Reading> { Some([x, y, z, 0.0]) };
            times.push(time - FLIGHT.0);
            readings.push(vec![reading([gx, gy, gz]), reading(force)]);
        }
    }
    if times.is_empty() {
        return Err(absent(file, "flight"));
    }
    let sensor =
        |name: &str, instrument| Sensor::new(name, SensorKind::Instrument(instrument), [0.0; 3]);
    Ok(Dataset {
        model: MODEL.0.to_owned(),
        sensors: vec![
            sensor("gyroscope", Instrument::Gyroscope),
            sensor("accelerometer", Instrument::Accelerometer),
        ],
        flights: vec![Flight {
            file: "flight.csv".to_owned(),
            positions: vec![Vec::new(); times.len()],
            times,
            readings,
            ..Flight::default()
        }],
        ..Dataset::default()
    })
}
