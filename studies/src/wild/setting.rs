//! Setting of a simulated recording of a disc: what is measured, how often and how well, and what flies.

use dataset::synthesize::Corruption;
use dataset::{Sensor, SensorKind};
use model_spec::compose::Instrument;
use rand::{Rng, RngExt};

use crate::oracle_flights::{Plan, TRUTH, Throws};
use crate::seeded::SeededEffects;
use crate::sensors::SensorNoise;

/// Numbers of flights of which one is drawn: datasets of exactly two flights are frequent.
const FLIGHTS: [usize; 12] = [1, 2, 2, 2, 3, 4, 5, 6, 8, 12, 16, 20];

/// Sample rates of which one is drawn, Hz.
const RATES: [f64; 6] = [30.0, 60.0, 100.0, 120.0, 200.0, 240.0];

/// Range from which the noise of a measured position is drawn, m.
const SIGMA: (f64, f64) = (5e-4, 4e-3);

/// Range of the ratio of a true coefficient to its value in [`TRUTH`].
const RATIO: (f64, f64) = (0.7, 1.3);

/// What is measured of a flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measured {
    Markers,
    Pose,
    PoseAndGyroscope,
    MarkersAndInertial,
    Inertial,
    Gyroscope,
    Speed,
}

impl Measured {
    pub(super) fn has_markers(self) -> bool {
        matches!(self, Self::Markers | Self::MarkersAndInertial)
    }

    pub(super) fn has_positions(self) -> bool {
        self.has_markers() || matches!(self, Self::Pose | Self::PoseAndGyroscope)
    }

    fn label(self) -> &'static str {
        match self {
            Self::Markers => "markers",
            Self::Pose => "pose",
            Self::PoseAndGyroscope => "pose and gyroscope",
            Self::MarkersAndInertial => "markers, gyroscope, accelerometer",
            Self::Inertial => "gyroscope and accelerometer",
            Self::Gyroscope => "gyroscope",
            Self::Speed => "speed",
        }
    }

    /// Sensors other than markers.
    pub(super) fn sensors(self) -> Vec<Sensor> {
        let instrument = |name, kind, place| Sensor::new(name, SensorKind::Instrument(kind), place);
        let pose = Sensor::new("tag", SensorKind::Pose, [0.0, 0.0, 0.01]);
        let gyroscope = instrument("gyro", Instrument::Gyroscope, [0.0; 3]);
        let accelerometer = instrument("acc", Instrument::Accelerometer, [0.02, -0.01, 0.005]);
        let speed = instrument("radar", Instrument::Speed, [0.0; 3]);
        match self {
            Self::Markers => Vec::new(),
            Self::Pose => vec![pose],
            Self::PoseAndGyroscope => vec![pose, gyroscope],
            Self::MarkersAndInertial | Self::Inertial => vec![gyroscope, accelerometer],
            Self::Gyroscope => vec![gyroscope],
            Self::Speed => vec![speed],
        }
    }
}

/// Setting of a simulated recording of a disc.
#[derive(Clone, Debug)]
pub(super) struct Setting {
    /// Built-in model that is flown and fitted.
    pub(super) model: &'static str,
    pub(super) measured: Measured,
    /// Number of flights.
    pub(super) flights: usize,
    /// Sample rate, Hz.
    pub(super) rate: f64,
    /// Range of the durations of the flights, s.
    pub(super) duration: (f64, f64),
    /// Noise, outliers and gaps of the measured markers.
    pub(super) noise: Corruption,
    /// Noise of the sensors.
    pub(super) sensor_noise: SensorNoise,
    pub(super) throws: Throws,
    /// True coefficients.
    pub(super) truth: Vec<(&'static str, f64)>,
    /// Index and coefficients of a flight of another disc.
    pub(super) other_disc: Option<(usize, Vec<(&'static str, f64)>)>,
    /// Time by which a marker is sampled later per metre of its y coordinate, s/m.
    pub(super) row_time: f64,
    /// Time by which the sensors other than markers and poses are late, s.
    pub(super) latency: f64,
    /// Effects that the fitted model lacks.
    pub(super) hidden: SeededEffects,
}

impl Setting {
    /// Draws a setting without a mistake.
    pub(super) fn draw(measured: Measured, random: &mut impl Rng) -> Self {
        let mut uniform = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
        let sigma = SIGMA.0 * (SIGMA.1 / SIGMA.0).powf(uniform(0.0, 1.0));
        let white = Corruption {
            sigma,
            ar1: 0.0,
            outliers: 0.0,
            outlier_size: 0.05,
            dropouts: 0.0,
        };
        let kind = uniform(0.0, 1.0);
        let noise = match kind {
            k if k < 0.6 => white,
            k if k < 0.75 => Corruption {
                ar1: uniform(0.3, 0.7),
                ..white
            },
            k if k < 0.9 => Corruption {
                dropouts: uniform(0.02, 0.15),
                ..white
            },
            _ => Corruption {
                outliers: 0.01,
                ..white
            },
        };
        let truth = TRUTH.map(|(name, value)| (name, value * uniform(RATIO.0, RATIO.1)));
        let long = uniform(0.8, 1.3);
        let sensor_noise = SensorNoise {
            position: sigma,
            attitude: uniform(0.003, 0.015),
            rate: uniform(0.02, 0.1),
            force: uniform(0.1, 0.5),
            speed: uniform(0.05, 0.15),
        };
        let wobble = uniform(1.0, 4.0);
        Self {
            model: if random.random::<f64>() < 0.7 {
                "disc"
            } else {
                "disc_quaternion"
            },
            measured,
            flights: FLIGHTS[random.random_range(0..FLIGHTS.len())],
            rate: RATES[random.random_range(0..RATES.len())],
            duration: (0.8 * long, long),
            noise,
            sensor_noise,
            throws: Throws {
                wobble,
                ..Throws::SPREAD
            },
            truth: truth.to_vec(),
            other_disc: None,
            row_time: 0.0,
            latency: 0.0,
            hidden: SeededEffects::default(),
        }
    }

    /// Throws of the recording as a plan of the studies.
    pub(super) fn plan(&self) -> Plan<'_> {
        Plan {
            truth: &self.truth,
            throws: self.throws,
            flights: self.flights,
            duration: self.duration,
            rate: self.rate,
        }
    }

    /// The same recording without noise.
    pub(super) fn exact(&self) -> Self {
        let none = SensorNoise {
            position: 0.0,
            attitude: 0.0,
            rate: 0.0,
            force: 0.0,
            speed: 0.0,
        };
        Self {
            noise: Corruption {
                sigma: 0.0,
                outliers: 0.0,
                dropouts: 0.0,
                ..self.noise
            },
            sensor_noise: none,
            ..self.clone()
        }
    }

    pub(super) fn sigma_of_positions(&self) -> Option<f64> {
        self.measured.has_positions().then_some(self.noise.sigma)
    }

    pub(super) fn description(&self) -> String {
        let noise = match self.measured.has_positions() {
            true => format!(", {:.1} mm", 1e3 * self.noise.sigma),
            false => String::new(),
        };
        let correlated = match self.noise.ar1 > 0.0 && self.measured.has_markers() {
            true => format!(" AR({:.1})", self.noise.ar1),
            false => String::new(),
        };
        let Self {
            model,
            flights,
            rate,
            ..
        } = self;
        let measured = self.measured.label();
        format!("{model}: {measured}, {flights} flights, {rate} Hz{noise}{correlated}")
    }
}
