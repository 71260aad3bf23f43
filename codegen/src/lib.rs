//! The compiler: a checked Model becomes a shared graph, exact derivatives, and code in several forms.
