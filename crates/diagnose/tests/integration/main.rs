//! Diagnoses of models that are not built in, and of measured shots.

mod golf;
mod own_models;
mod unmeasured;
