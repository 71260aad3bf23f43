//! True values of a synthetic dataset, for readers and tests; fits do not use them.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::{Corruption, Spread};
use crate::quoted;

/// True values and settings with which a synthetic dataset was generated.
#[derive(Clone, Debug, PartialEq)]
pub struct Truth {
    /// Name of the model.
    pub model: String,
    /// Names of the effects that the model includes.
    pub effects: Vec<String>,
    /// True value of each coefficient by name, SI.
    pub coefficients: BTreeMap<String, f64>,
    /// Settings of the measurement noise that was applied.
    pub noise: Corruption,
    /// Settings of the random variation of the initial states.
    pub spread: Spread,
    /// Seed of the random number generators.
    pub seed: u64,
    /// File name and true initial state (SI, keyed by the names of the states) of each flight.
    pub initial: Vec<(String, BTreeMap<String, f64>)>,
}

impl Truth {
    /// Formats the true values and settings as TOML text.
    pub fn text(&self) -> String {
        let mut text = "# What was put into this dataset, which was made and not measured. `hyzer fit` does not read this file.\n".to_owned();
        let _ = writeln!(text, "model = {}", quoted(&self.model));
        let effects: Vec<String> = self.effects.iter().map(|name| quoted(name)).collect();
        let _ = writeln!(text, "effects = [{}]", effects.join(", "));
        let _ = writeln!(text, "seed = {}", self.seed);
        text.push_str("\n[coefficients]\n");
        for (name, value) in &self.coefficients {
            let _ = writeln!(text, "{name} = {value:?}");
        }
        let Corruption {
            sigma,
            ar1,
            outliers,
            outlier_size,
            dropouts,
        } = self.noise;
        let _ = write!(
            text,
            "\n[noise]\nsigma = {sigma:?}        # m, one axis\nar1 = {ar1:?}\noutliers = {outliers:?}\n\
             outlier_size = {outlier_size:?}  # m, one axis\ndropouts = {dropouts:?}\n"
        );
        let Spread {
            fraction,
            speed,
            angle,
            rate,
        } = self.spread;
        let _ = write!(
            text,
            "\n[spread]\nfraction = {fraction:?}\nspeed = {speed:?}  # m/s\nangle = {angle:?}  # rad\nrate = {rate:?}  # rad/s\n"
        );
        for (file, state) in &self.initial {
            let _ = writeln!(text, "\n[[flights]]\nfile = {}", quoted(file));
            let each: Vec<String> = state
                .iter()
                .map(|(name, value)| format!("{name} = {value:?}"))
                .collect();
            let _ = writeln!(text, "initial = {{ {} }}", each.join(", "));
        }
        text
    }
}
