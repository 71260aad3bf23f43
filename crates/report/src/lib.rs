//! Figures and tables of flights, and the pages of a fit and of a diagnosis.

#![forbid(unsafe_code)]

pub mod diagnosis;
pub mod figures;
pub mod fit;
pub mod literature;
