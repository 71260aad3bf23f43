//! An instrumented disc: how its spin dies away.

use std::path::Path;

use crate::markdown::{Text, three};
use crate::real_data::spin_decay::{FORMS, Fit, Form, Record, fit, read};

/// What was made of the record.
pub struct Spindown {
    record: Record,
    fits: Vec<(Form, Fit)>,
    /// The power, without the first of the throw, when the disc still wobbles most.
    later: Option<Fit>,
    /// Axial moment of inertia that is taken, kg·m², and the model's own coefficient, N·m·s.
    known: [f64; 2],
}

/// The part of the throw that is left out to see whether its wobble matters, s.
const WOBBLE: f64 = 0.5;

/// A form whose criterion lies so much above the least is rejected.
const REJECTED: f64 = 10.0;

impl Spindown {
    /// Fits every form of the decay.
    ///
    /// # Errors
    /// In words, where the record is missing or malformed.
    pub fn of(file: &Path, disc: &model_spec::model::Model) -> Result<Self, String> {
        let record = read(file)?;
        let fits = FORMS
            .iter()
            .filter_map(|form| Some((*form, fit(*form, &record)?)));
        let value = |name: &str| {
            let mut constants = disc.params.iter().chain(&disc.coefficients);
            constants
                .find(|c| c.name == name)
                .map_or(f64::NAN, |c| c.value)
        };
        let late = record.times.partition_point(|time| *time < WOBBLE);
        let later = Record {
            times: record.times[late..].iter().map(|t| t - WOBBLE).collect(),
            rates: record.rates[late..].to_vec(),
        };
        Ok(Self {
            later: fit(Form::Power, &later),
            fits: fits.collect(),
            known: [value("I_a"), value("C_Nr")],
            record,
        })
    }

    /// The fit of a form.
    pub fn fit(&self, form: Form) -> Option<&Fit> {
        self.fits
            .iter()
            .find(|(own, _)| *own == form)
            .map(|(_, fit)| fit)
    }
}

/// The section.
pub fn section(text: &mut Text, data: &Spindown) {
    text.paragraph("## The spin of a disc in flight (misc-protolabs/flatball-ins)");
    let rates = &data.record.rates;
    let (first, last) = (
        rates.first().copied().unwrap_or(0.0),
        rates.last().copied().unwrap_or(0.0),
    );
    text.paragraph(format!(
        "A gyroscope inside a disc at 100 Hz, {} samples of one throw, upside down; the spin falls from {first:.1} to {last:.1} rad/s. \
         The speed through the air is not known. Each form of the torque is fitted to the rate about the axis, under noise that is correlated \
         from one sample to the next by an amount that is fitted too (which forgives a wrong form much). Akaike's criterion is given \
         above the least; {REJECTED:.0} and more we call rejected.",
        rates.len()
    ));
    let least = data
        .fits
        .iter()
        .map(|(_, fit)| fit.aic)
        .fold(f64::INFINITY, f64::min);
    let rows = data.fits.iter().map(|(form, fit)| {
        let third = match (form, fit.numbers.get(2), fit.errors.get(2)) {
            (Form::Power, Some(value), Some(error)) => format!("power {value:.2} ± {error:.2}"),
            (Form::Falling, Some(value), Some(error)) => {
                format!(
                    "falls by {:.1} ± {:.1} % each second",
                    100.0 * value,
                    100.0 * error
                )
            }
            _ => String::new(),
        };
        vec![
            named(*form).into(),
            format!(
                "{:.2} ± {:.2}",
                100.0 * fit.numbers[1],
                100.0 * fit.errors[1]
            ),
            third,
            format!("{:.1}", 1e3 * fit.rms),
            format!("{:.2}", fit.correlation),
            format!("{:.1}", fit.aic - least),
        ]
    });
    text.table(
        &[
            "torque",
            "lost at first, % each second",
            "besides",
            "leaves, mrad/s",
            "correlation",
            "criterion above the least",
        ],
        rows,
    );
    let rejected: Vec<&str> = data
        .fits
        .iter()
        .filter(|(_, fit)| fit.aic > least + REJECTED)
        .map(|(form, _)| named(*form))
        .collect();
    let (Some(linear), Some(falling)) = (data.fit(Form::Linear), data.fit(Form::Falling)) else {
        return;
    };
    let [inertia, own] = data.known;
    let scaled = |fit: &Fit| -fit.numbers[1] * inertia;
    let end = 1.0 - falling.numbers[2] * data.record.times.last().copied().unwrap_or(0.0);
    text.paragraph(format!(
        "Rejected: {}. The torque falls faster than the spin does, and than its square. Of the forms of the catalogue that leaves the one by dynamic \
         pressure (`spin_down_by_pressure`: speed times spin), if the speed falls to {:.2} of what it was; a throw may well \
         do so, but the speed was not measured: the form is not proved, and its coefficient cannot be had. A power of the spin alone would have \
         to be {:.1}, for which we know no reason ({} without the first {WOBBLE} s, when the disc wobbles most).",
        if rejected.is_empty() { "none".to_owned() } else { rejected.join(", ") },
        end,
        data.fit(Form::Power).map_or(f64::NAN, |fit| fit.numbers[2]),
        data.later.as_ref().map_or(String::new(), |fit| format!(
            "{:.1} ± {:.1}",
            fit.numbers[2], fit.errors[2]
        )),
    ));
    text.paragraph(format!(
        "The model's own form, a multiple of the spin, would be `C_Nr` {} ± {} N·m·s over the throw as a whole (95 %: {} .. {}) if the disc had the \
         axial inertia of the model, {} kg·m², which nobody measured of this one; the model has {}. Over the throw it runs from {} to {}.",
        three(scaled(linear)),
        three(linear.errors[1] * inertia),
        three(scaled(linear) - 1.96 * linear.errors[1] * inertia),
        three(scaled(linear) + 1.96 * linear.errors[1] * inertia),
        three(inertia),
        three(own),
        three(scaled(falling)),
        three(scaled(falling) * end),
    ));
}

fn named(form: Form) -> &'static str {
    match form {
        Form::Constant => "constant",
        Form::Linear => "by the spin",
        Form::Quadratic => "by its square",
        Form::Power => "by a power of it",
        Form::Falling => "by the spin, and falling with time",
    }
}
