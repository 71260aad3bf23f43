//! Reports: figures and tables of flights, HTML pages of fits and diagnoses, and the page of the effects.

#![forbid(unsafe_code)]

mod atomic_file;
pub mod diagnosis;
pub mod effects;
pub mod figures;
pub mod fit;
pub mod literature;

pub use atomic_file::write_atomic;
