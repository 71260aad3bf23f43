//! Measured flights: datasets, and the coefficients that fit them.
