//! Recordings: read in every format, and cut into throws; spoiled ones are refused.

mod broken;
mod clean;
mod formats;
mod headers;
mod mutated;
mod real_c3d;
mod support;
mod template;
mod throws;
