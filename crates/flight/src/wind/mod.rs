//! Winds that change with height, and gusts: their description in a release, and their composition with a model.
//!
//! The laws are effects of `model-spec/winds`; a table in height and the sinusoids of gusts are added to them as nodes
//! of the syntax tree, so that a model in a wind is compiled, differentiated and flown like any other.

mod compose;
mod dryden;
mod read;
mod text;

pub use dryden::{GUST_TERMS, gust_phases, gust_spectrum};
pub use read::{StatedWind, read_wind_file};

/// Wind of a release file in addition to a constant one: a mean wind by height, gusts, or both.
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
    /// Velocities at given heights, by monotone cubics with a continuous derivative; constant beyond the ends.
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

/// Gusts with Dryden spectra, frozen in the air of the mean wind: u along the flight, v across to the left, w upwards.
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
    /// Height at which the mean wind carries the gusts, m, and for [`GustStrength::LowAltitude`] that of its model.
    pub height: f64,
    /// Source of the standard deviations and length scales of the gusts.
    pub strength: GustStrength,
}

/// Source of the standard deviations and length scales of gusts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GustStrength {
    /// Deviations and length scales by the low-altitude model of MIL-F-8785C, from the wind at 20 ft and the height.
    LowAltitude,
    /// Standard deviations and length scales of u, v and w as in the file of the wind.
    Stated {
        /// Standard deviations of u, v and w, m/s.
        sd: [f64; 3],
        /// Length scales of u, v and w, m.
        length: [f64; 3],
    },
}

impl WindField {
    /// Names and values of the parameters that the wind adds to a model, in SI, with directions in degrees.
    #[doc(hidden)]
    pub fn parameters(&self) -> Vec<(String, f64)> {
        let mut own = self.clone();
        let values = own.places().into_iter();
        let values = values.map(|(name, value)| (name.to_owned(), *value));
        let phases = self.gusts.iter();
        let phases = phases.flat_map(|gusts| gust_phases(gusts.seed, gusts.flight));
        values.chain(phases).collect()
    }

    /// Sets a parameter, in the unit of [`parameters`](Self::parameters); false if the wind has no such one.
    #[doc(hidden)]
    pub fn set(&mut self, name: &str, value: f64) -> bool {
        let mut places = self.places().into_iter();
        let place = places.find(|(own, _)| *own == name);
        place.map(|(_, place)| *place = value).is_some()
    }

    /// Names and places of the parameters other than the phases of gusts.
    fn places(&mut self) -> Vec<(&'static str, &mut f64)> {
        let (at, own) = match &mut self.profile {
            Some(Profile::Log { at, roughness }) => (Some(at), Some(("wind_roughness", roughness))),
            Some(Profile::Power { at, exponent }) => (Some(at), Some(("wind_exponent", exponent))),
            Some(Profile::Table { .. }) | None => (None, None),
        };
        let mut places = Vec::new();
        if let Some(at) = at {
            places.extend([
                ("wind_speed", &mut at.speed),
                ("wind_direction", &mut at.direction),
                ("wind_reference_height", &mut at.height),
            ]);
        }
        places.extend(own);
        let Some(gusts) = &mut self.gusts else {
            return places;
        };
        places.extend([
            ("gust_intensity", &mut gusts.intensity),
            ("gust_heading", &mut gusts.heading),
            ("gust_height", &mut gusts.height),
        ]);
        if let GustStrength::Stated { sd, length } = &mut gusts.strength {
            let names = [
                "gust_sd_u",
                "gust_sd_v",
                "gust_sd_w",
                "gust_length_u",
                "gust_length_v",
                "gust_length_w",
            ];
            places.extend(names.into_iter().zip(sd.iter_mut().chain(length)));
        }
        places
    }
}
