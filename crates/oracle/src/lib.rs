//! Flight models evaluated directly with vectors in inertial components: by hand, after the paper, and
//! from the tree of a checked [`Model`](model_spec::model::Model). The compiler is checked against both.
//!
//! Nothing here may use the compiler's graph: an oracle that shares a mistake with what it checks is
//! none. A test reads this crate's manifest to keep it so.
//!
//! Everything is generic over the [`scalar`], so that one text gives values, the magnitude of the terms
//! that were summed, exact derivatives in two ways, and rational functions in a prime field.

pub mod attitude;
pub mod chart;
pub mod dynamics;
pub mod effect;
pub mod frames;
pub mod physical;
pub mod point;
pub mod rational;
pub mod reference;
pub mod rigid;
pub mod scalar;
pub mod tree;
