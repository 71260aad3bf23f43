//! Builds datasets in memory and reads them from files.

use std::path::Path;

use dataset::synthesize::{self, Plan};
use dataset::{Dataset, Flight, KnownValue, Marker, Reading, Role, Sensor, SensorKind};
use flight::release::Release;
use flight::{InputInterpolation, InputSeries};

use crate::{Error, Model};

/// Builder of a dataset in memory.
///
/// ```
/// use hyzer::{DatasetBuilder, Role};
///
/// let times = [0.0, 0.01, 0.02];
/// let positions = times.iter().map(|t| vec![Some([12.0 * t, 0.0, 1.5])]).collect();
/// let dataset = DatasetBuilder::new("disc")
///     .parameter("m", 0.175)
///     .marker("m1", [0.1, 0.0, 0.01])
///     .flight("throw1", Role::Fit, &times, positions)
///     .build()?;
/// assert_eq!(dataset.flights[0].positions.len(), 3);
/// # Ok::<(), hyzer::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct DatasetBuilder {
    dataset: Dataset,
}

impl DatasetBuilder {
    /// Creates a dataset without flights for the named model.
    pub fn new(model: &str) -> DatasetBuilder {
        DatasetBuilder {
            dataset: Dataset {
                model: model.to_owned(),
                ..Dataset::default()
            },
        }
    }

    /// Sets a known parameter of the body or its environment, SI; it replaces the model's default.
    pub fn parameter(mut self, name: &str, value: f64) -> Self {
        self.dataset.parameters.insert(name.to_owned(), value);
        self
    }

    /// Adds a marker: name, and position in the body frame, m.
    pub fn marker(mut self, name: &str, position: [f64; 3]) -> Self {
        let name = name.to_owned();
        self.dataset.markers.push(Marker { name, position });
        self
    }

    /// Adds markers `m1`, `m2`, … by their positions in the body frame, m.
    pub fn markers(mut self, positions: &[[f64; 3]]) -> Self {
        for (i, position) in positions.iter().enumerate() {
            self = self.marker(&format!("m{}", i + 1), *position);
        }
        self
    }

    /// Sets the standard deviation of the noise of each coordinate, m; by default a fit estimates it.
    pub fn sigma(mut self, sigma: f64) -> Self {
        self.dataset.sigma = Some(sigma);
        self
    }

    /// Adds a sensor at a position on the body, m, before the flights that have its
    /// [`readings`](DatasetBuilder::readings) or [`poses`](DatasetBuilder::poses).
    pub fn sensor(mut self, name: &str, kind: SensorKind, position: [f64; 3]) -> Self {
        self.dataset.sensors.push(Sensor::new(name, kind, position));
        self
    }

    /// Sets the readings of a sensor in the flight added last, one for each sample: a vector in body axes (rad/s, m/s²), or
    /// a speed (m/s) as the first component. No effect for an unknown sensor, a pose sensor or without a flight.
    pub fn readings(self, sensor: &str, readings: &[Option<[f64; 3]>]) -> Self {
        let channel = readings.iter().map(|r| r.map(|[x, y, z]| [x, y, z, 0.0]));
        self.channels(sensor, &[channel.collect()])
    }

    /// Sets the poses of a pose sensor in the flight added last, one for each sample: position in the inertial frame, m,
    /// and unit quaternion from body to inertial components, scalar part first.
    pub fn poses(self, sensor: &str, poses: &[Option<([f64; 3], [f64; 4])>]) -> Self {
        let position =
            |pose: &Option<([f64; 3], [f64; 4])>| pose.map(|([x, y, z], _)| [x, y, z, 0.0]);
        let positions = poses.iter().map(position).collect();
        let attitudes = poses.iter().map(|pose| pose.map(|(_, attitude)| attitude));
        self.channels(sensor, &[positions, attitudes.collect()])
    }

    fn channels(mut self, sensor: &str, channels: &[Vec<Option<Reading>>]) -> Self {
        let sensors = &self.dataset.sensors;
        let count = |sensors: &[Sensor]| -> usize {
            let channels = sensors.iter().map(|sensor| sensor.kind.channels().len());
            channels.sum()
        };
        let all = count(sensors);
        let Some(index) = sensors.iter().position(|own| own.name == sensor) else {
            return self;
        };
        let first = count(&sensors[..index]);
        let is_kind = sensors[index].kind.channels().len() == channels.len();
        if let Some(flight) = self.dataset.flights.last_mut().filter(|_| is_kind) {
            flight.readings.resize(flight.times.len(), Vec::new());
            for (sample, row) in flight.readings.iter_mut().enumerate() {
                row.resize(all, None);
                for (offset, channel) in channels.iter().enumerate() {
                    row[first + offset] = channel.get(sample).copied().flatten();
                }
            }
        }
        self
    }

    /// Adds a flight: its name, its role, the increasing times of its samples (s), and the positions `[sample][marker]` in
    /// the inertial frame (m, z up), `None` for a marker that was not measured.
    pub fn flight(
        mut self,
        name: &str,
        role: Role,
        times: &[f64],
        positions: Vec<Vec<Option<[f64; 3]>>>,
    ) -> Self {
        self.dataset.flights.push(Flight {
            file: name.to_owned(),
            role,
            times: times.to_vec(),
            positions,
            ..Flight::default()
        });
        self
    }

    /// Sets a value of the flight added last that is known from other measurements, such as the wind.
    pub fn known(mut self, name: &str, value: KnownValue) -> Self {
        if let Some(flight) = self.dataset.flights.last_mut() {
            flight.known.insert(name.to_owned(), value);
        }
        self
    }

    /// Sets a scalar input of the flight added last by its values over time: times in s, as those of the samples, and
    /// values, SI.
    pub fn input(
        mut self,
        name: &str,
        samples: &[(f64, f64)],
        interpolation: InputInterpolation,
    ) -> Self {
        self.dataset.input_interpolation = interpolation;
        if let Some(flight) = self
            .dataset
            .flights
            .last_mut()
            .filter(|_| !samples.is_empty())
        {
            let series = InputSeries::new(samples, interpolation);
            flight.inputs.push((name.to_owned(), series));
        }
        self
    }

    /// Estimates an input, a coefficient or a constant for each flight that does not know it.
    pub fn unknown(mut self, name: &str) -> Self {
        self.dataset.unknown.push(name.to_owned());
        self
    }

    /// Checks the dataset as one read from files, and returns it.
    ///
    /// # Errors
    /// [`Error::Dataset`] for the first fault found.
    pub fn build(self) -> Result<Dataset, Error> {
        self.dataset.validate()?;
        Ok(self.dataset)
    }
}

/// Reads a dataset: a folder with `dataset.toml` and a table or C3D file per flight.
///
/// # Errors
/// [`Error::Dataset`] for the first fault of the files.
pub fn read_dataset(folder: impl AsRef<Path>) -> Result<Dataset, Error> {
    Ok(dataset::load(folder.as_ref())?)
}

/// Simulates a dataset: flies the releases in turn, with random variation, and measures markers with noise, all from
/// the seed of the plan.
///
/// # Errors
/// [`Error::Synthesis`] if the plan is invalid or a flight cannot be simulated.
///
/// ```
/// # fn main() -> Result<(), hyzer::Error> {
/// let disc = hyzer::Model::load("disc")?;
/// let plan = hyzer::Plan { flights: 3, ..hyzer::Plan::default() };
/// let data = hyzer::synthesize(&disc, &[disc.release("backhand")?], &plan)?;
/// assert_eq!(data.flights.len(), 3);
/// # Ok(())
/// # }
/// ```
pub fn synthesize(model: &Model, releases: &[Release], plan: &Plan) -> Result<Dataset, Error> {
    Ok(synthesize::flights(model.checked(), releases, plan)?.dataset)
}
