//! Reports: figures and tables of flights, HTML pages of fits and diagnoses, the catalogue page of effects, and the
//! folders to which results are written.

#![forbid(unsafe_code)]

mod angle;
mod bands;
mod data_faults;
pub mod diagnosis;
pub mod effects;
mod equation;
mod figure_file;
pub mod figures;
pub mod fit;
pub mod import;
pub mod literature;
mod numbers;
mod sheet;
mod thin;
pub mod viewer;

pub use bands::{PredictionBand, prediction_band};
pub use figure_file::{FigureError, FigureKind};
pub use sheet::{Section, Sheet, SheetFigure, Table};
