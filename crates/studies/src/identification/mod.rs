//! Study of the fit: coverage of its intervals, and fits of the paper's flights one by one. Writes docs/identification.md.

pub mod coverage;
pub mod page;
pub mod paper_fits;
