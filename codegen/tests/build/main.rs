//! Build scripts: what is generated compiles and agrees with the tape, and mistakes are told.

mod errors;
mod modules;
