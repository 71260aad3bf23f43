//! Figures as SVG, drawn by ourselves: a few hundred lines that give the same text everywhere, need no font
//! files, and never cut a label off.
//!
//! A figure is one column of panels on a light ground, so that it is read as well on a phone as beside a text;
//! colours (Okabe & Ito's) are told apart by the colour-blind, and each line bears its name at its end.

mod axis;
mod flight;
mod panel;
mod svg;

pub use flight::{StateLabel, flight};
pub use panel::{Line, Mark, Panel, figure};
