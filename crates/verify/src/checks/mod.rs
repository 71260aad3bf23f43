//! The checks of a model, one module per check.

pub mod backends;
pub mod balances;
pub mod cases;
pub mod claim;
pub mod derivatives;
pub mod determined;
mod disputed;
pub mod effects;
pub mod exact;
pub mod exact_functions;
mod function_rows;
pub mod identities;
mod long_functions;
pub mod metamorphic;
mod observed;
mod precision;
pub mod reference;
pub mod singular;
pub mod units;
