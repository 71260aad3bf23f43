//! Common-subexpression elimination: shares pairs of factors and pairs of terms that several definitions contain.

mod candidates;
mod products;
mod sums;

pub(super) use products::share as share_products;
pub(super) use sums::share as share_sums;
