// Written by `hyzer generate`; changes belong in the models, or in the compiler.
//! Flight models as plain Rust functions, written by `hyzer generate` and never edited.
//!
//! Each model is a module: functions over plain arrays and any [`lanes::Real`], with the names of states
//! and parameters and the patterns of the sparse Jacobians as constants. A model can be picked by name
//! at run time from [`MODELS`], or as a type through [`visit`].

#![allow(non_snake_case, non_upper_case_globals, unused_parens)]
#![allow(clippy::too_many_arguments, clippy::excessive_precision, clippy::all)]

pub mod ball;
pub mod disc;
pub mod disc_appendix;
pub mod disc_quaternion;
pub mod discus;
mod plain;
mod table;

pub use table::{Equations, Model, Visitor, model};
use table::{array, array_mut};

/// Every model, in order of its name.
#[rustfmt::skip]
pub static MODELS: &[&Model] = &[
    &ball::MODEL,
    &disc::MODEL,
    &disc_appendix::MODEL,
    &disc_quaternion::MODEL,
    &discus::MODEL,
];

/// Hands the equations of a model to a visitor, as a type, so that it can be used with any lanes.
pub fn visit<V: Visitor>(name: &str, visitor: V) -> Option<V::Output> {
    match name {
        "ball" => Some(visitor.visit::<ball::Ball>()),
        "disc" => Some(visitor.visit::<disc::Disc>()),
        "disc_appendix" => Some(visitor.visit::<disc_appendix::DiscAppendix>()),
        "disc_quaternion" => Some(visitor.visit::<disc_quaternion::DiscQuaternion>()),
        "discus" => Some(visitor.visit::<discus::Discus>()),
        _ => None,
    }
}
