//! Design of throws: landings, their derivatives and their spread, and the throws that are found.

mod bounds;
mod gradients;
mod spread;
mod support;
mod tasks;
mod wind;
