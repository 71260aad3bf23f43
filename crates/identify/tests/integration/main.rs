//! Datasets, read, written and made, and the fits of them.

mod added_states;
mod alone;
mod arrival;
mod bootstrap;
mod known_and_markers;
