//! A page of `docs/`, as a study returns it.

/// A page and its figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// Markdown.
    pub text: String,
    /// File name, relative to the page, and SVG text of each figure.
    pub figures: Vec<(String, String)>,
}
