//! Section of docs/studies/real-data.md on the poses of golf discs.

use serde::Serialize;

use super::fit::{BODY, DiscPose, PRIORS, Ratio, Throw, ratio};
use super::read::FOLLOWED;
use crate::error::StudyError;
use crate::page::render;

#[derive(Serialize)]
struct Section<'d> {
    followed: (f64, f64),
    throws: &'d [Throw],
    poses: usize,
    used: usize,
    body: String,
    up: [f64; 3],
    scatter_deg: f64,
    joint: Ratio,
    without_air: Ratio,
    tilted: Ratio,
    jackknife: f64,
    pooled: [f64; 3],
    /// Estimated rotations of the measured axes, whose z axis is the normal of the tag on the ground, against true
    /// upright axes: first about x, then about the rotated y axis. Each is a pair (estimate, standard error), degrees;
    /// NaN if not estimated.
    tilts: Vec<[f64; 2]>,
    coefficients: Vec<CoefficientRow>,
    /// RMS residuals of the fit of all throws: of the measured attitudes, degrees, and of the measured positions, mm.
    left: [f64; 2],
}

#[derive(Serialize)]
struct CoefficientRow {
    name: &'static str,
    prior: [f64; 2],
    value: f64,
    std_error: f64,
    clustered: f64,
    /// Prior standard deviation / the larger of the two standard errors (plain and cluster-robust): how much the data
    /// narrow the prior.
    gain: f64,
}

/// Renders the section of docs/studies/real-data.md on the measured poses of golf discs, as Markdown.
pub(in super::super) fn disc_pose_section(data: &DiscPose) -> Result<String, StudyError> {
    let coefficient = |name: &'static str| {
        let missing = || StudyError::Name {
            of: "fit of the poses",
            name: name.to_owned(),
        };
        data.joint.coefficients.get(name).ok_or_else(missing)
    };
    let rows = PRIORS.map(|(name, mean, sigma)| {
        let own = coefficient(name)?;
        let clustered = own.std_error_cluster_robust.unwrap_or(own.std_error);
        Ok(CoefficientRow {
            name,
            prior: [mean, sigma],
            value: own.value,
            std_error: own.std_error,
            clustered,
            gain: sigma / clustered.max(own.std_error),
        })
    });
    let tilts = ["tilt_x", "tilt_y"].map(|name| {
        let own = data.tilted.coefficients.get(name);
        own.map_or([f64::NAN; 2], |own| {
            [own.value.to_degrees(), own.std_error.to_degrees()]
        })
    });
    let rms = |quantity: &str, unit: f64| {
        let mut channels = data.joint.sensors.iter();
        let own = channels.find(|own| own.measures == quantity);
        own.map_or(f64::NAN, |own| own.rms * unit)
    };
    let body = BODY.iter().filter(|(name, _)| *name != "I_a");
    let body: Vec<String> = body
        .map(|(name, value)| format!("`{name}` {value}"))
        .collect();
    let section = Section {
        followed: FOLLOWED,
        throws: &data.throws,
        poses: data.throws.iter().map(|throw| throw.samples).sum(),
        used: data.throws.iter().map(|throw| throw.used).sum(),
        body: body.join(", "),
        up: data.up,
        scatter_deg: data.scatter.to_degrees(),
        joint: data.ratio(),
        without_air: ratio(&data.without_air),
        tilted: ratio(&data.tilted),
        jackknife: data.jackknife,
        pooled: data.pooled,
        tilts: tilts.to_vec(),
        coefficients: rows.into_iter().collect::<Result<_, StudyError>>()?,
        left: [
            rms("attitude", 180.0 / std::f64::consts::PI),
            rms("position", 1e3),
        ],
    };
    render(include_str!("page.md"), section)
}
