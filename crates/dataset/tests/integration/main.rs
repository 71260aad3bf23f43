//! Integration tests of datasets: reading, writing and synthesis.

mod broken;
mod c3d;
mod datasets;
mod inputs;
mod made_noise;
mod recording;
mod sensors;
mod shots;
mod stated;
mod summaries;
mod support;
mod synthesize;
mod takes;
mod written;
