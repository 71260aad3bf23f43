//! The pages of a fit, a diagnosis and an import.

mod browser;
mod diagnosis;
mod diagnosis_sizes;
mod finding;
mod found;
mod import;
mod made;
mod page;
mod stability;
