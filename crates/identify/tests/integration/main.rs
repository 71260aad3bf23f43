//! Fits of synthetic datasets.

mod added_states;
mod alone;
mod arrival;
mod bootstrap;
mod cancelled;
mod constrained;
mod known_and_markers;
mod marker_noise;
mod near_copies;
mod planar;
mod poses;
mod predicted_changes;
mod rounded_readings;
mod screening;
mod single_flights;
mod stated_constants;
mod summaries;
mod support;
mod units_of_readings;
