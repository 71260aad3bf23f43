//! The oracle agrees with itself by two ways, and shares nothing with the compiler.

mod agreement;
mod independence;
