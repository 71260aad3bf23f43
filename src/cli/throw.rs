//! Options that describe a throw, for `hyzer simulate` and `hyzer stability`.

use std::path::PathBuf;

use clap::Args;

/// A throw given by its quantities, or by a launch monitor. Options take precedence over the release and the launch
/// monitor.
#[derive(Args)]
#[command(next_help_heading = "Throw")]
pub struct ThrowOptions {
    /// Speed over the ground, m/s
    #[arg(long, value_name = "M/S", allow_hyphen_values = true)]
    pub speed: Option<String>,
    /// Direction of the velocity over the ground, measured from +x, positive to the left, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub heading: Option<String>,
    /// Angle of the velocity above the horizontal, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub launch: Option<String>,
    /// Angle of attack, positive nose-up, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub nose: Option<String>,
    /// Tilt about the velocity, positive when the left edge is the lower one, seen from behind, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub hyzer: Option<String>,
    /// Spin, positive clockwise seen from above, rpm
    #[arg(long, value_name = "RPM", allow_hyphen_values = true)]
    pub spin: Option<String>,
    /// Height at release, m; by default 1
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub height: Option<String>,
    /// Wobble: half the opening angle of the cone that the axis describes, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub wobble: Option<String>,
    /// Throws of a launch monitor: a CSV file of TechDisc
    #[arg(long, value_name = "FILE", conflicts_with = "release")]
    pub techdisc: Option<PathBuf>,
    /// Fly only this throw of the launch monitor: its id, or its number from 1
    #[arg(long, value_name = "ID|N", requires = "techdisc")]
    pub row: Option<String>,
}

impl ThrowOptions {
    /// Names and texts of the throw options that were given on the command line.
    pub fn given(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let all = [
            ("speed", &self.speed),
            ("heading", &self.heading),
            ("launch", &self.launch),
            ("nose", &self.nose),
            ("hyzer", &self.hyzer),
            ("spin", &self.spin),
            ("height", &self.height),
            ("wobble", &self.wobble),
        ];
        all.into_iter()
            .filter_map(|(name, text)| Some((name, text.as_deref()?)))
    }
}
