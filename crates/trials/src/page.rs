//! Pages that the trials write, in Markdown with figures beside them.

mod discovery;
mod identification;
pub mod peers;
mod real_data;
mod write;

pub use discovery::{details, discovery};
pub use identification::identification;
pub use real_data::{RealData, real_data};

/// A page and its figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// Markdown.
    pub text: String,
    /// File names, as the text has them beside it, and SVG.
    pub figures: Vec<(String, String)>,
}
