//! Names and sentences of the page of a diagnosis.

use diagnose::Report;
use identify::MARKER;
use identify::numbers::{percent, plain, quantity};

/// Name of an effect as words separated by spaces.
pub(super) fn readable(name: &str) -> String {
    name.replace(['-', '_'], " ")
}

pub(super) fn noise(report: &Report) -> String {
    let noise = report.leading_noise();
    if !report.noise.contains_key(MARKER) && report.noise.len() > 1 {
        let each = report.noise.iter();
        let each = each.map(|(kind, own)| format!("{kind} {}", quantity(own.sigma, &own.unit)));
        let each: Vec<String> = each.collect();
        return format!("Standard deviation of the noise: {}.", each.join(", "));
    }
    format!(
        "The noise per coordinate is {} (standard deviation), with a lag-1 autocorrelation of {}; {} of the points were \
         classified as outliers.",
        quantity(noise.sigma, &noise.unit),
        plain(noise.lag1_autocorrelation, 2),
        percent(noise.outlier_fraction)
    )
}

/// Readable name of a site.
pub(super) fn site(site: &str) -> &str {
    match site {
        "side" => "side force",
        "roll" => "rolling moment",
        "pitch" => "pitching moment",
        "spin" => "moment about the axis",
        "vertical" => "the measured vertical",
        "scale" => "the measured lengths",
        "clock" => "the clock",
        "marker" => "the markers’ places",
        other => other,
    }
}
