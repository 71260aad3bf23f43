//! Winds that change with height, and gusts: their description in a release, and their composition with a model.
//!
//! The laws are effects of `model-spec/winds`; a table in height and the sinusoids of gusts are added to them as nodes
//! of the syntax tree, so that a model in a wind is compiled, differentiated and flown like any other.

mod compose;
mod dryden;
mod nodes;
mod read;
mod table;
mod text;

pub use dryden::{GUST_TERMS, gust_phases, gust_spectrum};
pub use read::{StatedWind, read_wind_file};

/// Wind that may be specified in a release file in addition to a constant wind: a mean wind as a function of the
/// height, gusts, or both.
#[derive(Clone, Debug, PartialEq)]
pub struct WindField {
    /// Mean wind as a function of the height; `None` if there is only a constant mean wind.
    pub profile: Option<Profile>,
    /// Gusts added to the mean wind; `None` for a wind without gusts.
    pub gusts: Option<Gusts>,
}

/// Mean wind as a function of the height above the ground; below the ground the wind at the ground applies.
#[derive(Clone, Debug, PartialEq)]
pub enum Profile {
    /// Logarithmic law for the speed at height z: U ln(1 + (z/z₀)²)/ln(1 + (h/z₀)²), where U is the speed at the
    /// reference height h. It is U ln(z/z₀)/ln(h/z₀) well above z₀ and 0 at the ground.
    Log {
        /// Speed and direction of the mean wind at the reference height.
        at: ReferenceWind,
        /// Roughness length z₀ of the logarithmic law, m.
        roughness: f64,
    },
    /// Power law for the speed at height z: U ((z² + ε²)/(h² + ε²))^(n/2), where U is the speed at the reference height
    /// h and ε = 5 cm. It is U (z/h)ⁿ well above ε.
    Power {
        /// Speed and direction of the mean wind at the reference height.
        at: ReferenceWind,
        /// Exponent n of the power law, dimensionless.
        exponent: f64,
    },
    /// Velocities at given heights, interpolated by monotone cubics with a continuous derivative; constant below the
    /// first height and above the last one.
    Table {
        /// Rows of height above the ground (m, increasing) and the three components of the wind velocity, m/s.
        rows: Vec<[f64; 4]>,
    },
}

/// Mean wind at a reference height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceWind {
    /// Speed U of the mean wind at the reference height, m/s.
    pub speed: f64,
    /// Direction towards which the wind blows, from +x to the left (towards +y), deg.
    pub direction: f64,
    /// Reference height h above the ground, m.
    pub height: f64,
}

/// Gusts with Dryden spectra, frozen in the air that the mean wind carries along. Components: u along the direction of
/// flight, v across it to the left, w upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Gusts {
    /// Seed of the random phases of the sinusoids that represent the gusts.
    pub seed: u64,
    /// Index of the flight with these gusts; each index yields different random phases.
    pub flight: u64,
    /// Horizontal direction of flight along which the gusts vary, from +x to the left, deg.
    pub heading: f64,
    /// Factor by which all gusts are multiplied.
    pub intensity: f64,
    /// Height above the ground at which the mean wind carries the gusts, m; [`GustStrength::LowAltitude`] also derives
    /// intensities and length scales from it.
    pub height: f64,
    /// Source of the standard deviations and length scales of the gusts.
    pub strength: GustStrength,
}

/// Source of the standard deviations and length scales of gusts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GustStrength {
    /// Standard deviations and length scales follow from the mean wind at 20 ft and the height of the gusts, by the
    /// low-altitude model of MIL-F-8785C.
    LowAltitude,
    /// Standard deviations and length scales of the gust components u, v and w are specified in the file from which the
    /// wind was read.
    Stated {
        /// Standard deviations of u, v and w, m/s.
        sd: [f64; 3],
        /// Length scales of u, v and w, m.
        length: [f64; 3],
    },
}

impl WindField {
    /// Names and values of the parameters that the wind adds to a model, in the units of these parameters: SI, with
    /// directions in degrees.
    pub fn parameters(&self) -> Vec<(String, f64)> {
        let mut values: Vec<(&str, f64)> = Vec::new();
        let mut reference = |at: &ReferenceWind| {
            values.extend([
                ("wind_speed", at.speed),
                ("wind_direction", at.direction),
                ("wind_reference_height", at.height),
            ]);
        };
        match &self.profile {
            Some(Profile::Log { at, roughness }) => {
                reference(at);
                values.push(("wind_roughness", *roughness));
            }
            Some(Profile::Power { at, exponent }) => {
                reference(at);
                values.push(("wind_exponent", *exponent));
            }
            Some(Profile::Table { .. }) | None => {}
        }
        let Some(gusts) = &self.gusts else {
            return owned(values);
        };
        values.extend([
            ("gust_intensity", gusts.intensity),
            ("gust_heading", gusts.heading),
            ("gust_height", gusts.height),
        ]);
        if let GustStrength::Stated { sd, length } = &gusts.strength {
            values.extend([
                ("gust_sd_u", sd[0]),
                ("gust_sd_v", sd[1]),
                ("gust_sd_w", sd[2]),
                ("gust_length_u", length[0]),
                ("gust_length_v", length[1]),
                ("gust_length_w", length[2]),
            ]);
        }
        let mut values = owned(values);
        values.extend(gust_phases(gusts.seed, gusts.flight));
        values
    }

    /// Sets the parameter of this name to a value in the unit that [`parameters`](Self::parameters) uses; returns false
    /// if the wind has no such parameter.
    pub fn set(&mut self, name: &str, value: f64) -> bool {
        let at = match &mut self.profile {
            Some(Profile::Log { at, roughness }) => {
                if name == "wind_roughness" {
                    *roughness = value;
                    return true;
                }
                Some(at)
            }
            Some(Profile::Power { at, exponent }) => {
                if name == "wind_exponent" {
                    *exponent = value;
                    return true;
                }
                Some(at)
            }
            Some(Profile::Table { .. }) | None => None,
        };
        let of_profile = at.and_then(|at| match name {
            "wind_speed" => Some(&mut at.speed),
            "wind_direction" => Some(&mut at.direction),
            "wind_reference_height" => Some(&mut at.height),
            _ => None,
        });
        let place = of_profile.or_else(|| self.gusts.as_mut()?.number(name));
        match place {
            Some(place) => {
                *place = value;
                true
            }
            None => false,
        }
    }
}

impl Gusts {
    /// Mutable reference to the value of the gust parameter of this name, in SI units or degrees; `None` if the gusts
    /// have no such parameter.
    fn number(&mut self, name: &str) -> Option<&mut f64> {
        match name {
            "gust_intensity" => return Some(&mut self.intensity),
            "gust_heading" => return Some(&mut self.heading),
            "gust_height" => return Some(&mut self.height),
            _ => {}
        }
        let GustStrength::Stated { sd, length } = &mut self.strength else {
            return None;
        };
        let of = |prefix: &str| {
            let axis = name.strip_prefix(prefix)?;
            ["u", "v", "w"].iter().position(|own| *own == axis)
        };
        match (of("gust_sd_"), of("gust_length_")) {
            (Some(k), _) => Some(&mut sd[k]),
            (_, Some(k)) => Some(&mut length[k]),
            _ => None,
        }
    }
}

fn owned(values: Vec<(&str, f64)>) -> Vec<(String, f64)> {
    let values = values.into_iter();
    values
        .map(|(name, value)| (name.to_owned(), value))
        .collect()
}
