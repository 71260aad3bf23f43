//! Releases, throws, winds and tables of flights.

mod constraints;
mod inputs;
mod lane_observer;
mod lanes;
mod near_throws;
mod release;
mod several_bodies;
mod singular_points;
mod solved;
mod switches;
mod table;
mod throw;
mod throw_signs;
mod winds;
