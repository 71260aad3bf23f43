//! Effects on which the flights agree, although no hypothesis is adequate: each flight departs from every common law
//! in its own way.

mod discordant;
mod hypotheses;
mod sign_flip_test;

pub(crate) use hypotheses::consensus;
