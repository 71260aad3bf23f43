//! Study of fits and diagnoses with sensors of every kind: poses, gyroscope and accelerometer, and combinations of
//! them. Writes docs/studies/sensors.md.

mod flights;
mod page;
mod study;

pub(crate) use flights::read;
pub use flights::{Observed, SensorNoise, sensor_flights};
pub use page::sensors_page;
pub use study::{DISPLACEMENT, SensorSet, sensors};
