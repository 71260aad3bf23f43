//! Independent reference evaluation of flight models, with vectors in inertial components: reference implementations of
//! the laws of motion, after their publications, and the vector tree of any checked
//! [`Model`](model_spec::model::Model). The compiler is checked against both.
//!
//! This crate shares no code with the compiler, so that it cannot share the compiler's mistakes; a test of the manifest
//! and of the source enforces this.
//!
//! - **Reference implementations**: [`Reference`] binds a [`Law`] to the names of a model.
//! - **Vector tree**: [`Tree`] evaluates the expressions of a model, [`derivatives`] its equations of motion. The tree is
//!   the reference of every effect: it evaluates the text of the effect without the compiler. No effect of the catalogue
//!   has a formula of its own here; the hand-written ones, with which the texts are compared, simulate the flights of the
//!   studies.
//! - **Claims**: a model that writes its equations of motion explicitly may claim that they describe a certain body.
//!   [`ClaimedBody`] contains the quantities of this body and the laws of motion for them; [`claimed_rates`] solves
//!   these laws for the rates of the states.
//! - **Coordinates**: a [`Chart`] maps the states of a model to a [`Physical`] state and back.
//!
//! Everything is generic over the [`scalar`] type, so that one source text yields values, running error bounds,
//! derivatives in several ways, and values in a prime field.

mod attitude;
mod chart;
mod claimed;
mod claimed_rates;
mod dynamics;
mod error;
mod frames;
mod newton_euler;
mod physical;
mod point;
mod reference;
pub mod scalar;
mod system;
mod tree;

pub use attitude::Quaternion;
pub use chart::{Chart, PhysicalRate};
pub use claimed::{Balance, BalanceLaw, ClaimedBody, Turning, moving};
pub use claimed_rates::{ClaimedRates, claimed_rates};
pub use dynamics::{derivatives, derivatives_of};
pub use error::{BindError, Unsupported};
pub use frames::PlacedFrame;
pub use physical::{Load, MassProperties, Motion, Physical, inertia_in_n, solve};
pub use point::Point;
pub use reference::{Law, Reference, Stream};
pub use scalar::{Interpolant, Surface};
pub use tree::{Tree, Value};
