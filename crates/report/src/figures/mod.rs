//! Figures as SVG, drawn by ourselves: a few hundred lines that give the same text everywhere, need no font
//! files, and never cut a label off.
//!
//! A figure is one column of panels on a light ground, so that it is read as well on a phone as beside a text;
//! colours (Okabe & Ito's) are told apart by the colour-blind, and each line bears its name at its end.

pub(crate) mod axis;
mod figure;
mod flight;
mod layout;
mod names;
mod panel;
mod states;
pub(crate) mod svg;

pub use figure::{figure, figure_of};
pub use flight::flight;
pub use layout::Layout;
pub use panel::{Bar, Dots, Line, Look, Mark, Panel};
pub use states::StateLabel;
pub(crate) use states::{groups, symbol, what};
