//! Published values of coefficients, selected by the `reference` of a model.
//!
//! Values for discs are converted to the frames and signs of this repository's models, in which negative `C_Mq` and
//! `C_Nr` damp. Values with an incompatible definition are omitted.

/// A publication that contains values of coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source {
    /// Short name of the publication, used as the heading of a table column.
    pub short: &'static str,
    /// Full citation, and how the published values were converted to the coordinate frames and sign conventions of the
    /// models.
    pub long: &'static str,
    /// Published values: pairs of coefficient name and value.
    pub values: &'static [(&'static str, Value)],
}

/// Published value of a coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Single number as text, as printed in the publication; only its sign may be changed, to follow the sign
    /// convention of the models.
    One(&'static str),
    /// Range of numbers as text: lower and upper end.
    Range(&'static str, &'static str),
}

use Value::{One, Range};

const DISC: &[Source] = &[
    Source {
        short: "fssh3 (2000)",
        long: "M. Hubbard & S. A. Hummel, ‘Simulation of Frisbee Flight’, 5th Conference on Mathematics and Computers \
               in Sport, Sydney, 2000, Table 1, flight fssh3, as printed; C_Mq is the paper’s −C_Mα̇ and C_Nr its −C_Nr.",
        values: &[
            ("C_L0", One("−0.40")),
            ("C_La", One("1.89")),
            ("C_D0", One("0.83")),
            ("C_Da", One("0.83")),
            ("C_Ma", One("−0.16")),
            ("C_Mq", One("−0.029")),
            ("C_Rr", One("0.012")),
            ("C_Nr", One("−7.4 · 10⁻⁵")),
        ],
    },
    Source {
        short: "bffl8 (2000)",
        long: "The same table, flight bffl8.",
        values: &[
            ("C_L0", One("1.17")),
            ("C_La", One("0.28")),
            ("C_D0", One("5.07")),
            ("C_Da", One("0.077")),
            ("C_Ma", One("0.22")),
            ("C_Mq", One("−0.025")),
            ("C_Rr", One("−0.0030")),
            ("C_Nr", One("2.5 · 10⁻⁷")),
        ],
    },
    Source {
        short: "H & H (2002)",
        long: "S. A. Hummel & M. Hubbard, ‘Identification of Frisbee aerodynamic coefficients using flight data’, 4th \
               International Conference on the Engineering of Sport, Kyoto, 2002, four flights; its axis d3 points down, so C_Ma and C_Rr \
               change sign here. Left out: its C_Nr, which is multiplied by the dynamic pressure; its damping, which is \
               one number for pitch and another for roll (0.0008 and −0.013); its C_M0, which these models lack.",
        values: &[
            ("C_L0", One("0.188")),
            ("C_La", One("2.37")),
            ("C_D0", One("0.15")),
            ("C_Da", One("1.24")),
            ("C_Ma", One("−0.38")),
            ("C_Rr", One("−0.0004")),
        ],
    },
    Source {
        short: "Hummel (2003)",
        long: "S. A. Hummel, ‘Frisbee Flight Simulation and Throw Biomechanics’, M.Sc. thesis, University of \
               California, Davis, 2003, short flights; d3 down, as above. Left out: its drag (0.18, 0.69), which is about a zero-lift angle of \
               −4°; its damping, again one for pitch and another for roll (−0.005 and −0.0055); its rolling moment \
               by spin, which is made dimensionless with √(d/g); its C_Nr.",
        values: &[
            ("C_L0", One("0.33")),
            ("C_La", One("1.91")),
            ("C_Ma", One("−0.43")),
        ],
    },
];

const BALL: &[Source] = &[Source {
    short: "smooth sphere",
    long: "A smooth sphere at Reynolds numbers of 10³ to 2 · 10⁵, below the drag crisis: R. Clift, J. R. Grace & M. E. \
           Weber, ‘Bubbles, Drops, and Particles’, Academic Press, 1978, standard drag curve; E. Achenbach, \
           ‘Experiments on the flow past spheres at very high Reynolds numbers’, J. Fluid Mech. 54 (1972) 565.",
    values: &[("C_D", Range("0.4", "0.5"))],
}];

/// Publications with values for the coefficients of a model; `reference` is the literature reference that the model
/// file declares. Empty if the reference is unknown or `None`.
pub fn sources(reference: Option<&str>) -> &'static [Source] {
    match reference {
        Some("hubbard_hummel_disc") => DISC,
        Some("ball_with_drag") => BALL,
        _ => &[],
    }
}

impl Source {
    /// Published value of the coefficient `name`; `None` if the publication contains none.
    pub fn value(&self, name: &str) -> Option<Value> {
        let found = self.values.iter().find(|(of, _)| *of == name);
        found.map(|(_, value)| *value)
    }
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            One(value) => f.write_str(value),
            Range(low, high) => write!(f, "{low} … {high}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_is_of_a_coefficient_of_the_model() {
        for name in ["disc", "disc_appendix", "disc_quaternion", "ball"] {
            let model = model_spec::load::load(name, &[]).unwrap();
            let known = sources(model.reference.as_deref());
            assert!(!known.is_empty(), "{name}");
            for (coefficient, _) in known.iter().flat_map(|s| s.values) {
                assert!(
                    model.coefficients.iter().any(|c| c.name == *coefficient),
                    "{name}: {coefficient}"
                );
            }
        }
        assert!(sources(None).is_empty() && sources(Some("other")).is_empty());
    }

    #[test]
    fn signs_are_carried_over() {
        let fssh3 = &sources(Some("hubbard_hummel_disc"))[0];
        assert_eq!(fssh3.value("C_Nr"), Some(One("−7.4 · 10⁻⁵")));
        assert_eq!(fssh3.value("C_Mq"), Some(One("−0.029")));
        assert_eq!(fssh3.value("C_X"), None);
    }
}
