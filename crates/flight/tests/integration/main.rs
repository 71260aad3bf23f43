//! Releases, throws, winds and tables of flights.

mod near_throws;
mod release;
mod table;
mod throw;
mod throw_signs;
mod winds;
