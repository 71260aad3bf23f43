//! The bodies of the program that are not discs of the paper: their coefficients, their flights, and the filmed throws of a driver.

mod curves;
mod filmed;
mod flights;
mod page;

pub use curves::{Curve, curves};
pub use filmed::{Filmed, filmed};
pub use flights::{TurnAndFade, turns_and_fades};
pub use page::bodies_page;

/// Discs that fly in the page's tables and figures.
pub const DISCS: [&str; 4] = [
    "golf_putter",
    "golf_midrange",
    "golf_driver",
    "ultimate_disc",
];
