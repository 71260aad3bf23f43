//! Formatting of a wind as the table `[wind]` of a release file.

use std::fmt::Write;

use super::{GustStrength, Profile, ReferenceWind, WindField};

impl WindField {
    /// The wind as the tables `[wind]` and `[wind.gusts]`; `constant`, m/s, only without a mean wind by height.
    pub fn to_toml(&self, constant: [f64; 3]) -> String {
        let mut text = "[wind]\n".to_owned();
        let reference = |text: &mut String, law: &str, at: &ReferenceWind| {
            let _ = writeln!(
                text,
                "profile = {law:?}\nspeed = {:?}\ndirection = {:?}\nreference_height = {:?}",
                at.speed, at.direction, at.height
            );
        };
        match &self.profile {
            None => {
                let _ = writeln!(text, "constant = {constant:?}");
            }
            Some(Profile::Log { at, roughness }) => {
                reference(&mut text, "log", at);
                let _ = writeln!(text, "roughness = {roughness:?}");
            }
            Some(Profile::Power { at, exponent }) => {
                reference(&mut text, "power", at);
                let _ = writeln!(text, "exponent = {exponent:?}");
            }
            Some(Profile::Table { rows }) => {
                let _ = writeln!(text, "table = {rows:?}");
            }
        }
        if let Some(gusts) = &self.gusts {
            let _ = writeln!(
                text,
                "\n[wind.gusts]\nmodel = \"dryden\"\nseed = {}\nflight = {}\nheading = {:?}\nintensity = {:?}\nheight = {:?}",
                gusts.seed, gusts.flight, gusts.heading, gusts.intensity, gusts.height
            );
            if let GustStrength::Stated { sd, length } = &gusts.strength {
                let _ = writeln!(text, "sd = {sd:?}\nlength = {length:?}");
            }
        }
        text
    }
}
