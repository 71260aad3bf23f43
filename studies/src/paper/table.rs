//! Table 1 of the paper (Hubbard & Hummel 2000): printed coefficients of the two flights.

use serde::Deserialize;

/// Table 1 of the paper (Hubbard & Hummel, 2000) as printed: eight coefficients for each flight, in the printed order
/// of columns.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct Table1 {
    pub(super) fssh3: [f64; 8],
    pub(super) bffl8: [f64; 8],
}

impl Table1 {
    /// Parses the built-in copy of Table 1 of Hubbard & Hummel (2000).
    pub(super) fn printed() -> Self {
        toml::from_str(include_str!("data/table1.toml")).expect("the built-in table is valid")
    }
}

/// For each column of Table 1 of Hubbard & Hummel (2000): the name of the coefficient in the model `disc`, and the
/// factor that converts the printed sign to the model's convention. In that convention, negative `C_Mq` and `C_Nr`
/// damp.
const MODEL_COLUMNS: [(&str, f64); 8] = [
    ("C_L0", 1.0),
    ("C_La", 1.0),
    ("C_D0", 1.0),
    ("C_Da", 1.0),
    ("C_Ma", 1.0),
    ("C_Mq", -1.0),
    ("C_Rr", 1.0),
    ("C_Nr", -1.0),
];

/// Values of a coefficient of the model `disc` in Table 1 of Hubbard & Hummel (2000) for the flights fssh3 and bffl8,
/// SI, with the model's sign; `None` if the table has no such coefficient.
pub(crate) fn printed_coefficient(name: &str) -> Option<[f64; 2]> {
    let column = MODEL_COLUMNS.iter().position(|(of, _)| *of == name)?;
    let table = Table1::printed();
    let sign = MODEL_COLUMNS[column].1;
    Some([table.fssh3, table.bffl8].map(|row| sign * row[column]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn damping_has_the_model_s_sign() {
        assert_eq!(printed_coefficient("C_Mq"), Some([-0.029, -0.025]));
        assert_eq!(
            printed_coefficient("C_Nr"),
            Some([-0.000_074, 0.000_000_25])
        );
        assert_eq!(printed_coefficient("C_Rr"), Some([0.012, -0.003]));
        assert_eq!(printed_coefficient("C_X"), None);
    }
}
