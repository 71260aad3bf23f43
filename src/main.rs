//! The `hyzer` program.

fn main() {}
