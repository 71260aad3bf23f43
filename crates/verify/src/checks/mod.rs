//! The checks, one file each.

pub mod backends;
pub mod by_hand;
pub mod cases;
pub mod derivatives;
pub mod effects;
pub mod exact;
pub mod identities;
pub mod reference;
pub mod singular;
pub mod symmetries;
pub mod units;
