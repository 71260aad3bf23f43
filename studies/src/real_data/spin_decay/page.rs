//! Section of docs/studies/real-data.md on the decay of the spin.

use serde::Serialize;

use super::diagnosis::{Diagnosed, MARGIN, PRIORS};
use super::fit::DecayFit;
use super::form::Form;
use super::results::{SpinDecay, WOBBLE};
use crate::error::StudyError;
use crate::page::render;

/// A torque law is rejected if its AIC exceeds the minimum AIC by more than this difference.
const REJECTED_AIC: f64 = 10.0;

#[derive(Serialize)]
struct Section<'d> {
    diagnosed: &'d Diagnosed,
    /// Time that the diagnosis leaves out at the start and at the end of the flight, s.
    margin: f64,
    priors: String,
    samples: usize,
    first_rate: f64,
    last_rate: f64,
    rejected_aic: f64,
    forms: Vec<FormRow>,
    rejected: String,
    /// Airspeed at the end of the flight / airspeed at the release. It is implied by the fit of a torque that is
    /// proportional to the spin and to a factor that falls linearly with time.
    final_factor: f64,
    exponent: f64,
    /// Exponent of the spin in the torque law, fitted without the first part of the flight in which the disc wobbles,
    /// and its standard error; `None` if that fit failed.
    exponent_without_wobble: Option<(f64, f64)>,
    wobble: f64,
    /// Spin-damping coefficient C_Nr, constant over the whole flight, from the fit of a torque proportional to the
    /// spin, and its standard error, N·m·s.
    c_nr: (f64, f64),
    axial_inertia: f64,
    model_c_nr: f64,
    /// Spin-damping coefficients C_Nr at the release and at the end of the flight, N·m·s. They follow from the fit of a
    /// torque proportional to the spin and to a factor that falls linearly with time.
    c_nr_range: (f64, f64),
}

#[derive(Serialize)]
struct FormRow {
    form: &'static str,
    loss: (f64, f64),
    /// Estimate of the torque law's third unknown, with its standard error; `None` for a law with two unknowns.
    third: Option<(f64, f64)>,
    is_power: bool,
    rms: f64,
    ar1: f64,
    delta_aic: f64,
}

/// Renders the section of docs/studies/real-data.md on the decay of a disc's spin, as Markdown.
pub(in super::super) fn spin_decay_section(data: &SpinDecay) -> Result<String, StudyError> {
    let missing = |form: &str| StudyError::Name {
        of: "list of fitted forms",
        name: form.to_owned(),
    };
    let linear = data.fit(Form::Linear).ok_or_else(|| missing("linear"))?;
    let falling = data.fit(Form::Falling).ok_or_else(|| missing("falling"))?;
    let power = data.fit(Form::Power).ok_or_else(|| missing("power"))?;
    let least = data.fits.iter().map(|(_, fit)| fit.aic);
    let least = least.fold(f64::INFINITY, f64::min);
    let rejected = data.fits.iter();
    let rejected = rejected.filter(|(_, fit)| fit.aic > least + REJECTED_AIC);
    let rejected: Vec<&str> = rejected.map(|(form, _)| form.label()).collect();
    let rates = &data.record.rates;
    let duration = data.record.times.last().copied().unwrap_or(0.0);
    let final_factor = 1.0 - falling.unknowns[2] * duration;
    let c_nr = |fit: &DecayFit| -fit.unknowns[1] * data.axial_inertia;
    let priors = PRIORS.map(|(name, mean, sigma)| format!("`{name}` {mean} ± {sigma}"));
    let section = Section {
        diagnosed: &data.diagnosed,
        margin: MARGIN,
        priors: priors.join(", "),
        samples: rates.len(),
        first_rate: rates.first().copied().unwrap_or(0.0),
        last_rate: rates.last().copied().unwrap_or(0.0),
        rejected_aic: REJECTED_AIC,
        forms: data.fits.iter().map(|fit| form_row(fit, least)).collect(),
        rejected: match rejected.is_empty() {
            true => "none".to_owned(),
            false => rejected.join(", "),
        },
        final_factor,
        exponent: power.unknowns[2],
        exponent_without_wobble: data
            .power_without_wobble
            .as_ref()
            .map(|fit| (fit.unknowns[2], fit.std_errors[2])),
        wobble: WOBBLE,
        c_nr: (c_nr(linear), linear.std_errors[1] * data.axial_inertia),
        axial_inertia: data.axial_inertia,
        model_c_nr: data.model_c_nr,
        c_nr_range: (c_nr(falling), c_nr(falling) * final_factor),
    };
    render(include_str!("page.md"), section)
}

fn form_row((form, fit): &(Form, DecayFit), least_aic: f64) -> FormRow {
    let third = fit.unknowns.get(2).zip(fit.std_errors.get(2));
    FormRow {
        form: form.label(),
        loss: (fit.unknowns[1], fit.std_errors[1]),
        third: third.map(|(value, error)| (*value, *error)),
        is_power: *form == Form::Power,
        rms: fit.rms,
        ar1: fit.ar1,
        delta_aic: fit.aic - least_aic,
    }
}
