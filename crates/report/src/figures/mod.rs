//! Figures as SVG, without a plotting library. The SVG text is deterministic, needs no font files, and never clips a
//! label.
//!
//! A figure is a column of panels on a light background, readable on a phone and beside a text. The colours (of Okabe
//! & Ito) are distinguishable for the colour-blind, and each line is labelled at its end.

pub(crate) mod axis;
pub(crate) mod chart;
pub(crate) mod csv;
mod figure;
mod flight;
mod layout;
mod names;
mod panel;
mod states;
pub(crate) mod svg;
#[cfg(test)]
mod tests;
pub(crate) mod triangle;

pub use figure::{figure, figure_of};
pub use flight::flight;
pub use layout::Layout;
pub(crate) use panel::samples_below;
pub use panel::{Bar, Dots, Line, Look, Mark, Panel};
pub use states::StateLabel;
pub(crate) use states::{panels_over_time, symbol};
