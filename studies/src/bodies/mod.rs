//! Study of the built-in bodies that are not discs of the paper: their coefficients, their flights, and the filmed
//! throws of a driver. Writes docs/studies/bodies.md.

mod curves;
mod filmed;
mod flights;
mod page;

pub use curves::{Curve, curves};
pub use filmed::{Filmed, filmed};
pub use flights::{TurnAndFade, turns_and_fades};
pub use page::bodies_page;

use model_spec::layout::{Layout, StateId};

/// Names of the built-in models of the discs that the study simulates and whose aerodynamic coefficients it plots.
pub const DISCS: [&str; 4] = [
    "golf_putter",
    "golf_midrange",
    "golf_driver",
    "ultimate_disc",
];

/// Indices of the states `x` and `y` in the state vector of a body's model; 0 for a state that the model lacks.
fn horizontal_position(layout: &Layout) -> (usize, usize) {
    let index = |name: &str| layout.state(name).map_or(0, StateId::index);
    (index("x"), index("y"))
}
