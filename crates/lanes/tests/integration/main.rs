//! The elementary functions over lanes: accuracy, and the same bits on every instruction set.

mod accuracy;
mod bits;
mod support;
