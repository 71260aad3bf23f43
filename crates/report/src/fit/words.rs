//! Summary of a fit in sentences: data, goodness of fit, precision of the coefficients, and warnings.

use dataset::Role;
use identify::wording::count;
use identify::{Coefficient, FitReport, FlightReport};

use super::FitPage;
use identify::numbers::{percent, plain, quantity, significant};
use identify::wording::{counted, names, short};

/// Maximum relative standard error at which the report calls a coefficient well determined.
const GOOD: f64 = 0.1;
/// Minimum ratio of a held-out flight's RMS prediction error to the RMS noise at which the report calls the flight
/// badly predicted.
const FAR: f64 = 3.0;

/// Sentence of a page without warnings.
pub(super) const NO_WARNINGS: &str = "No warnings: the fit converged, no coefficient is at a bound, every flight was used to its end, at most 1 % of the points \
     are outliers, and the residuals are compatible with the noise model.";
/// How to read profile likelihoods.
pub(super) const PROFILES: &str = "One coefficient is fixed at each value and all others are fitted again; the deviance is twice the logarithm of the \
     ratio of the greatest likelihood to this one. Where the profile is not a parabola, the standard error is not a valid \
     measure of uncertainty.";
/// How to read figures of states.
pub(super) const STATES: &str = "States of the fitted model, with the angle of attack and the airspeed where the model defines them.";
/// Heading of the figures of predictions.
pub(crate) const PREDICTIONS: &str = "Flights that were not fitted, and their predictions";
/// Heading of the figures of residuals.
pub(crate) const RESIDUALS: &str = "Residuals of all flights in sequence";

/// Sentences on the fitted data, the noise and the goodness of fit.
pub(super) fn summary(page: &FitPage<'_>) -> Vec<String> {
    let report = page.report;
    let number = |role: Role| report.used(role).count();
    let (fitted, held_out) = (number(Role::Fit), number(Role::HeldOut));
    let left_out = report.excluded().count();
    let noise = report.leading_noise();
    let mut text = format!("The model ‘{}’", report.model);
    if !report.effects.is_empty() {
        let effects = names(&report.effects);
        text += &format!(" with {effects}");
    }
    text += &format!(
        " was fitted to {} of ‘{}’, {}",
        count(fitted, "flight"),
        page.dataset,
        count(noise.points, "measured point")
    );
    if held_out > 0 {
        let flights = count(held_out, "flight");
        text += &format!("; {flights} held out for validation");
    }
    text.push('.');
    if left_out > 0 {
        text += &format!(" {} excluded.", counted(left_out, "flight"));
    }
    let rms = report.rms_text();
    let sigma = quantity(noise.sigma, &noise.unit);
    let ratio = report.rms() / noise.sigma;
    let fits = if noise.estimated {
        format!(
            "The RMS residual per coordinate is {rms}. The noise was estimated from the same residuals, as {sigma}, so \
             these two numbers do not test the model; the residual diagnostics do."
        )
    } else if ratio > 1.2 {
        format!(
            "The RMS residual per coordinate is {rms}, {} times the noise of {sigma} that the dataset states: either \
             the model lacks an effect or the noise is larger than stated.",
            plain(ratio, 1)
        )
    } else {
        format!("The RMS residual per coordinate is {rms}; the dataset states a noise of {sigma}.")
    };
    let mut all = vec![text, fits];
    all.extend(held_out_words(report));
    all
}

/// Sentence on the RMS prediction errors of the held-out flights; `None` if there are no held-out flights.
fn held_out_words(report: &FitReport) -> Option<String> {
    let held_out = report.used(Role::HeldOut);
    let mut rms: Vec<f64> = held_out
        .map(identify::FlightReport::rms)
        .filter(|v| v.is_finite())
        .collect();
    rms.sort_by(f64::total_cmp);
    let (least, most) = (rms.first()?, rms.last()?);
    let times = |rms: f64| match rms / report.leading_noise().sigma {
        ratio if ratio.is_finite() => format!(", {} times the noise", plain(ratio, 1)),
        _ => String::new(),
    };
    let unit = &report.leading_noise().unit;
    let far = quantity(*most, unit) + &times(*most);
    Some(if rms.len() == 1 {
        format!("The RMS prediction error of the held-out flight is {far}.")
    } else {
        let near = quantity(*least, unit);
        format!("The RMS prediction errors of the held-out flights range from {near} to {far}.")
    })
}

/// First sentences of the report: which coefficients the measured flights determine well, roughly, or not at all, and
/// which were not estimated.
pub(super) fn opening(page: &FitPage<'_>) -> Vec<String> {
    let [good, loose, unknown, fixed] = by_precision(page);
    let sentences = [
        (
            &good,
            format!(
                "These flights determine {good} to {} or better.",
                percent(GOOD)
            ),
        ),
        (
            &loose,
            format!("They determine the sign of {loose}, but the size only roughly."),
        ),
        (
            &unknown,
            format!("They cannot distinguish {unknown} from zero."),
        ),
        (&fixed, format!("Fixed, not estimated: {fixed}.")),
    ];
    let sentences = sentences.into_iter().filter(|(names, _)| !names.is_empty());
    sentences.map(|(_, text)| text).collect()
}

/// Names of the coefficients, as text, in four groups: well determined; determined only in sign; not distinguishable
/// from 0; fixed.
fn by_precision(page: &FitPage<'_>) -> [String; 4] {
    let mut kinds: [Vec<&str>; 4] = Default::default();
    for (name, found) in page.coefficients() {
        let [low, high] = found.interval;
        let kind = match () {
            () if found.fixed => 3,
            () if found.std_error <= GOOD * found.value.abs() => 0,
            () if low > 0.0 || high < 0.0 => 1,
            () => 2,
        };
        kinds[kind].push(name);
    }
    kinds.map(|kind| names(&kind))
}

/// Warnings on the reliability of the fit; empty if there are none.
pub(super) fn alarms(page: &FitPage<'_>) -> Vec<String> {
    let report = page.report;
    let mut alarms = Vec::new();
    let mut add = |when: bool, text: String| {
        if when {
            alarms.push(text);
        }
    };
    let coefficients = page.coefficients();
    let chosen = |which: &dyn Fn(&Coefficient) -> bool| {
        let all = coefficients.iter().filter(|(_, c)| which(c));
        names(&all.map(|(name, _)| *name).collect::<Vec<_>>())
    };
    let at_bound = chosen(&|c| c.at_bound);
    add(
        !at_bound.is_empty(),
        format!("At a bound, where standard errors and intervals are not valid: {at_bound}."),
    );
    let broken = chosen(&|c| !c.value.is_finite() || !c.std_error.is_finite());
    add(
        !broken.is_empty(),
        format!("Without a finite value or standard error: {broken}."),
    );
    let scattered = chosen(&|c| {
        !c.fixed
            && c.std_error_cluster_robust
                .is_some_and(|e| e > 2.0 * c.std_error)
    });
    add(
        !scattered.is_empty(),
        format!(
            "The cluster-robust standard errors (by flight) are more than twice those by the noise, so the latter are \
             too small: {scattered}."
        ),
    );
    let noise = report.leading_noise();
    let fraction = noise.outlier_fraction;
    add(
        fraction > 0.01,
        format!(
            "{} of the points were classified as outliers and not used.",
            percent(fraction)
        ),
    );
    let held_out = report.used(Role::HeldOut);
    let bad = |f: &&FlightReport| f.rms() > FAR * noise.sigma;
    let far = held_out.filter(bad).count();
    add(
        far > 0,
        format!(
            "{} predicted with an error above {FAR} times the noise.",
            counted(far, "held-out flight")
        ),
    );
    let cut = report.flights.iter().filter(|f| f.cut.is_some()).count();
    add(
        cut > 0,
        format!(
            "{} cut before the end of the table.",
            counted(cut, "flight")
        ),
    );
    let notes = report.flights.iter().filter(|f| !f.notes.is_empty());
    let noted: Vec<String> = notes
        .clone()
        .take(3)
        .map(|f| format!("{}: {}", f.file, short(&f.notes.join("; "))))
        .collect();
    let more = notes.count() - noted.len();
    let rest = if more == 0 {
        String::new()
    } else {
        format!(" {more} more are in the table of flights.")
    };
    add(
        !noted.is_empty(),
        format!("Notes on flights. {}.{rest}", noted.join(". ")),
    );
    for (axis, left) in &report.residuals {
        let lags = left.whitened_autocorrelation.get(1..).unwrap_or_default();
        let outside = lags.iter().filter(|v| v.abs() > left.band).count();
        let first = lags.first().copied().unwrap_or(0.0);
        // At the 5 % level, one lag in twenty lies outside the band by chance.
        let many = outside as f64
            > 0.05 * lags.len() as f64 + 2.5 * (0.05 * lags.len() as f64).sqrt() + 0.5;
        add(
            many || first.abs() > 2.0 * left.band,
            format!(
                "The whitened residuals along {axis} are autocorrelated ({outside} of {} lags outside the 95 % band): \
                 the model lacks an effect, or the noise is not a first-order process.",
                lags.len()
            ),
        );
    }
    alarms
}

/// Sentences on the noise of the measured positions and its model.
pub(super) fn noise(report: &FitReport) -> String {
    let noise = report.leading_noise();
    let how = if noise.estimated {
        "estimated"
    } else {
        "given by the dataset"
    };
    format!(
        "Of one coordinate; {how}. The noise model is a stationary first-order autoregressive process along each axis; \
         the autocorrelation is that of samples {} ms apart and falls to 1/e in the correlation time. The fitted \
         flights have {} measured points, {} of them ({}) classified as outliers; {} are missing.",
        significant(1e3 * noise.interval_s, 3),
        noise.points,
        noise.outliers,
        percent(noise.outlier_fraction),
        noise.missing
    )
}

/// A sentence on the residuals and the noise of each sensor.
pub(super) fn sensors(report: &FitReport) -> Vec<String> {
    let sensors = report.sensors.iter().map(|sensor| {
        format!(
            "{} ({}): RMS residual {:.3} {unit}, noise {:.3} {unit}, lag-1 autocorrelation {}, {} of {} outliers.",
            sensor.name,
            sensor.measures,
            sensor.rms,
            sensor.sigma,
            plain(sensor.lag1_autocorrelation, 2),
            sensor.outliers,
            sensor.points,
            unit = sensor.unit,
        )
    });
    sensors.collect()
}
