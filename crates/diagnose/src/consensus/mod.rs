//! Effects with the same sign in all flights, although each deviates from every common law in its own way.

mod hypotheses;
mod sign_flip_test;

pub(crate) use hypotheses::consensus;
