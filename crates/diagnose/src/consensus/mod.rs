//! Effects on which the flights agree although no hypothesis is adequate: each flight deviates from every common law
//! in a different way, but the effect has the same sign in all of them.

mod discordant;
mod hypotheses;
mod sign_flip_test;

pub(crate) use hypotheses::consensus;
