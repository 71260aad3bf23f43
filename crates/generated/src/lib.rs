//! Flight models as plain Rust functions, written by hyzer generate and never edited.
