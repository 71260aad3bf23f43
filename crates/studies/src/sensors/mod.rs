//! Study of fits to sensors of every kind: poses, gyroscope and accelerometer, and sensors of several kinds together.

mod flights;

pub use flights::{Observed, SensorNoise, sensor_flights};
