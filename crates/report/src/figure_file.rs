//! Figures as PDF or PNG files, rendered from SVG.
//!
//! The font is a subset of DejaVu Sans (`fonts/`), so that a figure looks the same on every machine. Without the feature
//! `pictures`, figures are SVG alone.

#[cfg(feature = "pictures")]
mod render;

use thiserror::Error;

/// Format of a figure file, in addition to SVG.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FigureKind {
    /// PDF: vector graphics, on a page of the size of the figure.
    Pdf,
    /// PNG: raster image on a white background, two pixels for each SVG unit.
    Png,
}

/// Reason why a figure cannot be drawn.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FigureError {
    /// The program was built without the feature `pictures`.
    #[error(
        "this program was built without PDF and PNG; figures are SVG, or build it with `--features pictures`"
    )]
    NotBuilt,
    /// The SVG text cannot be parsed.
    #[cfg(feature = "pictures")]
    #[error("the SVG of a figure is not understood")]
    Svg(#[from] svg2pdf::usvg::Error),
    /// The SVG cannot be converted to PDF.
    #[error("a figure cannot be written as PDF: {0}")]
    Pdf(String),
    /// The image is empty or too large; width and height in SVG units.
    #[error("a figure of {0} × {1} units cannot be drawn as PNG")]
    Size(f32, f32),
    /// The image cannot be encoded as PNG.
    #[error("a figure cannot be written as PNG: {0}")]
    Png(String),
}

impl FigureKind {
    /// Both formats of figure files besides SVG: PDF and PNG.
    pub const ALL: [FigureKind; 2] = [FigureKind::Pdf, FigureKind::Png];

    /// Extension of the file name, such as `pdf`; the same text selects the format on the command line.
    pub fn name(self) -> &'static str {
        match self {
            FigureKind::Pdf => "pdf",
            FigureKind::Png => "png",
        }
    }

    /// The format with this name, if the program can write it.
    ///
    /// # Errors
    /// [`FigureError::NotBuilt`] without the feature `pictures`.
    pub fn available(self) -> Result<Self, FigureError> {
        match cfg!(feature = "pictures") {
            true => Ok(self),
            false => Err(FigureError::NotBuilt),
        }
    }

    /// Renders a figure, given as SVG text, and returns the contents of the file.
    ///
    /// # Errors
    /// [`FigureError`] if the SVG cannot be parsed or converted, or without the feature `pictures`.
    #[cfg(feature = "pictures")]
    pub fn draw(self, svg: &str) -> Result<Vec<u8>, FigureError> {
        render::draw(self, svg)
    }

    /// Renders a figure, given as SVG text, and returns the contents of the file.
    ///
    /// # Errors
    /// [`FigureError::NotBuilt`], because the program was built without the feature `pictures`.
    #[cfg(not(feature = "pictures"))]
    pub fn draw(self, _svg: &str) -> Result<Vec<u8>, FigureError> {
        Err(FigureError::NotBuilt)
    }
}
