//! Figures and tables of flights.

#![forbid(unsafe_code)]

pub mod figures;
