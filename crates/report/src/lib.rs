//! Figures and tables of flights, the pages of a fit and of a diagnosis, and that of the effects.

#![forbid(unsafe_code)]

mod atomic_file;
pub mod diagnosis;
pub mod effects;
pub mod figures;
pub mod fit;
pub mod literature;

pub use atomic_file::write_atomic;
