//! Datasets, read, written and made, and the fits of them.

mod added_states;
mod alone;
mod arrival;
mod bootstrap;
mod broken;
mod c3d;
mod datasets;
mod known_and_markers;
mod made_noise;
mod recording;
mod sensors;
mod support;
mod synthesize;
mod written;
