//! Stability of flying bodies.
mod criteria;
mod linearise;
mod modes;
mod trim;

pub use criteria::{AxisDerivatives, Criteria};
pub use linearise::{Body, BoundBody, Linearised, StabilityError};
pub use modes::{Mode, ModeKind, Modes, modes};
pub use trim::{Trim, trim};
