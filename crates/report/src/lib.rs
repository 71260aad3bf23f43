//! Figures and tables of flights, and the page of a fit.

#![forbid(unsafe_code)]

pub mod figures;
pub mod fit;
pub mod literature;
