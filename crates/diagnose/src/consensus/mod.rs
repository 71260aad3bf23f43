//! What the flights agree on, where no hypothesis is adequate: each flight departs from every common law in its own way.

mod discordant;
mod hypotheses;
mod sign_flip_test;

pub(crate) use hypotheses::consensus;
