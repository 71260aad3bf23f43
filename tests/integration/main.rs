//! The program as its users run it: every command, its faults, its results, and how it ends when it is told to.

mod bodies;
mod bootstrap;
mod cli;
mod dask;
mod design;
mod diagnose;
mod editor;
mod export;
mod fit;
mod generate;
mod help;
mod import;
mod inputs;
mod landings;
mod recovery;
mod reliability;
mod results;
mod review;
mod signals;
mod support;
mod sweep;
mod synthesize;
mod throws;
mod verification;
mod wind;
