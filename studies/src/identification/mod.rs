//! Study of the fit: coverage of its confidence intervals, and fits of the paper's two flights, one by one and
//! together. Writes docs/studies/identification.md.

mod coverage;
mod page;
mod paper_fits;
mod scatter;

pub use coverage::{CoefficientCoverage, Coverage, coverage};
pub use page::identification_page;
pub(crate) use paper_fits::scenario;
pub use paper_fits::{PaperFits, Scenario, paper_fits};
