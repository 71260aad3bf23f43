//! Reports: figures and tables of flights, HTML pages of fits and diagnoses, the catalogue page of effects, and the
//! folders to which results are written.

#![forbid(unsafe_code)]

mod angle;
mod bands;
pub mod design;
pub mod diagnosis;
pub mod effects;
mod equation;
mod faults;
mod figure;
mod figure_file;
pub mod figures;
pub mod fit;
mod formula;
mod html;
pub mod import;
pub mod kml;
mod literature;
mod page;
pub mod stability;
pub mod sweep;
mod table;
mod text;
mod text_table;
mod thin;
mod units;
pub mod viewer;

pub use bands::{PredictionBand, prediction_band};
pub use figure::Figure;
pub use figure_file::{FigureError, FigureKind};
pub use figures::csv::CsvTable;
pub use formula::plain as plain_formula;
pub use html::Html;
pub use page::Page;
pub use table::{Cell, Rows, Table};
pub use text::{set_width, wrapped};
pub use units::Units;

/// Rounds a value to hundredths for a sentence or a table; a negative zero becomes 0.
pub fn hundredths(value: f64) -> f64 {
    (100.0 * value).round() / 100.0 + 0.0
}

#[cfg(test)]
mod tests {
    use super::hundredths;

    #[test]
    fn small_negative_values_are_rounded_to_zero_without_a_sign() {
        assert_eq!([1.236, -1.234].map(hundredths), [1.24, -1.23]);
        assert!(hundredths(-0.001).is_sign_positive());
    }
}
