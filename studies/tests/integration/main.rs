//! The studies: a small fixed part of each, the program `hyzer-studies`, and that the pages say what the studies compute.

mod bodies;
mod cli;
mod derivatives;
mod discovery;
mod effect_laws;
mod fits;
mod measured;
mod others;
mod own_models;
mod recovery;
mod seeded;
mod sensors;
mod spoiled;
mod takes;
mod throws;
mod wild;

use shared_features as _;
