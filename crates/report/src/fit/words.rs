//! Sentences on a fit: data, goodness of fit, precision of the coefficients, and warnings.
use dataset::Role;
use identify::numbers::{percent, plain, quantity, significant};
use identify::wording::{count, counted, names, short};
use identify::{Coefficient, FitReport, FlightReport};

use super::FitPage;

/// Largest relative standard error of a well determined coefficient.
const GOOD: f64 = 0.1;
/// Smallest ratio of the prediction error of a flight to the noise at which it is badly predicted.
const FAR: f64 = 3.0;

/// Sentence of a page without warnings.
pub(super) const NO_WARNINGS: &str = "No warnings: the fit converged, no coefficient is at a bound, every flight was used to its end, at most 1 % of the points \
     are outliers, and the residuals are compatible with the noise model.";
pub(super) const PROFILES: &str = "One coefficient is fixed at each value and all others are fitted again; the deviance is twice the logarithm of the \
     ratio of the greatest likelihood to this one. Where the profile is not a parabola, the standard error is not a valid \
     measure of uncertainty.";
pub(super) const STATES: &str = "States of the fitted model, with the angle of attack and the airspeed where the model defines them.";
pub(crate) const PREDICTIONS: &str = "Flights that were not fitted, and their predictions";
pub(crate) const RESIDUALS: &str = "Residuals of all flights in sequence";

pub(super) fn summary(page: &FitPage<'_>) -> Vec<String> {
    let report = page.report;
    let number = |role: Role| report.used(role).count();
    let (fitted, held_out) = (number(Role::Fit), number(Role::HeldOut));
    let left_out = report.excluded().count();
    let noise = report.leading_noise();
    let mut text = format!("The model ‘{}’", report.model);
    if !report.effects.is_empty() {
        text += &format!(" with {}", names(&report.effects));
    }
    text += &format!(
        " was fitted to {} of ‘{}’, {}",
        count(fitted, "flight"),
        page.dataset,
        match super::summaries::only(report) {
            true => count(super::summaries::values(report), "measured value"),
            false => count(noise.points, "measured point"),
        }
    );
    if held_out > 0 {
        text += &format!("; {} held out for validation", count(held_out, "flight"));
    }
    text.push('.');
    if left_out > 0 {
        text += &format!(" {} excluded.", counted(left_out, "flight"));
    }
    if super::summaries::only(report) {
        let residuals = super::summaries::residuals(report);
        return [text]
            .into_iter()
            .chain(residuals)
            .chain(report.notes.clone())
            .collect();
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
    all.extend(super::summaries::residuals(report));
    all.extend(report.notes.clone());
    all
}

/// Sentence on the prediction errors of the held-out flights, if there are any.
fn held_out_words(report: &FitReport) -> Option<String> {
    let held_out = report.used(Role::HeldOut).map(FlightReport::rms);
    let mut rms: Vec<f64> = held_out.filter(|v| v.is_finite()).collect();
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

/// Which coefficients the flights determine well, roughly, or not at all, and which were fixed.
pub(super) fn opening(page: &FitPage<'_>) -> Vec<String> {
    let [good, loose, unknown, fixed] = by_precision(page);
    let sentence = |names: &str, before: &str, after: &str| {
        (!names.is_empty()).then(|| format!("{before} {names}{after}"))
    };
    let better = format!(" to {} or better.", percent(GOOD));
    let roughly = ", but the size only roughly.";
    let sentences = [
        sentence(&good, "These flights determine", &better),
        sentence(&loose, "They determine the sign of", roughly),
        sentence(&unknown, "They cannot distinguish", " from zero."),
        sentence(&fixed, "Fixed, not estimated:", "."),
    ];
    sentences.into_iter().flatten().collect()
}

/// Names of the coefficients that are well determined, determined only in sign, not distinguishable from 0, and fixed.
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
    let is_scattered = |c: &Coefficient, error: f64| !c.fixed && error > 2.0 * c.std_error;
    let scattered = chosen(&|c| {
        c.std_error_cluster_robust
            .is_some_and(|error| is_scattered(c, error))
    });
    add(
        !scattered.is_empty(),
        format!(
            "The cluster-robust standard errors (by flight) are more than twice those by the noise, so the latter are \
             too small: {scattered}."
        ),
    );
    let noise = report.leading_noise();
    let outliers = percent(noise.outlier_fraction);
    add(
        noise.outlier_fraction > 0.01,
        format!("{outliers} of the points were classified as outliers and not used."),
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
    let flights = counted(cut, "flight");
    add(
        cut > 0,
        format!("{flights} cut before the end of the table."),
    );
    let notes = report.flights.iter().filter(|f| !f.notes.is_empty());
    let note = |f: &FlightReport| format!("{}: {}", f.file, short(&f.notes.join("; ")));
    let noted: Vec<String> = notes.clone().take(3).map(note).collect();
    let rest = match notes.count() - noted.len() {
        0 => String::new(),
        more => format!(" {more} more are in the table of flights."),
    };
    add(
        !noted.is_empty(),
        format!("Notes on flights. {}.{rest}", noted.join(". ")),
    );
    for (axis, left) in &report.residuals {
        let first = left.whitened_autocorrelation.get(1).copied().unwrap_or(0.0);
        // The unknowns of short flights correlate many lags, of right models too; the lack-of-fit test counts them.
        add(
            first.abs() > 2.0 * left.band,
            format!(
                "The whitened residuals along {axis} are autocorrelated ({} at a lag of one sample, 95 % band ±{}): the \
                 model lacks an effect, or the noise is not a first-order process.",
                significant(first, 2),
                significant(left.band, 2)
            ),
        );
    }
    alarms
}

pub(super) fn noise(report: &FitReport) -> String {
    if super::summaries::only(report) {
        return super::summaries::noise(report);
    }
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

pub(super) fn sensors(report: &FitReport) -> Vec<String> {
    let sensors = report.sensors.iter();
    let seen = |name: &str| {
        let mut values = report.flights.iter().flat_map(|flight| &flight.seen);
        values.any(|own| own.name == name)
    };
    // Columns of summaries have a sentence of their own.
    let sensors = sensors.filter(|sensor| !seen(&sensor.name)).map(|sensor| {
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
