//! Constants that a dataset states in another unit than the model's, as a mass in grams.

use super::{Coefficient, FitReport};
use crate::numbers::{quantity, significant};
use crate::problem::FitProblem;
use dataset::Dataset;

/// Ratio of a stated constant to the model's value above which its unit is doubted: grams and millimetres are 1000 times
/// larger, degrees 57 times, and bodies that one model describes are mostly nearer.
const FAR: f64 = 50.0;

/// Gravity in feet and in inches per s², over that in m/s², with the relative difference up to which a ratio is one of them:
/// gravity hardly differs from place to place.
const GRAVITY_UNITS: ([f64; 2], f64) = ([3.2808, 39.37], 0.01);

/// Ratio of two numbers up to which they are of one size.
const ALIKE: f64 = 5.0;

/// A stated constant far from the model's value.
#[derive(Clone, Debug, PartialEq)]
pub struct FarConstant {
    /// Stated value over the model's.
    ratio: f64,
    /// Whether the ratio is that of two units.
    is_in_other_unit: bool,
    /// What is stated, and the model's value, as a sentence.
    pub(super) sentence: String,
}

/// The constants of a dataset that are far from the model's values.
pub fn far_constants(problem: &FitProblem, dataset: &Dataset) -> Vec<FarConstant> {
    let parameters = problem.model.params.iter();
    let far = parameters.filter_map(|own| {
        let stated = *dataset.parameters.get(&own.name)?;
        let ratio = (stated / own.value).abs();
        let is_unit = |unit: f64| (ratio / unit - 1.0).abs() < GRAVITY_UNITS.1;
        let is_in_other_unit = own.name == "g" && GRAVITY_UNITS.0.into_iter().any(is_unit);
        (is_in_other_unit || differ(ratio, FAR)).then(|| FarConstant {
            ratio,
            is_in_other_unit,
            sentence: format!(
                "{} is stated as {}, {} times the {} of the model: state it in the unit of the model, or make a model whose value is near",
                own.name,
                quantity(stated, &own.unit_text),
                significant(ratio, 3),
                quantity(own.value, &own.unit_text),
            ),
        })
    });
    far.collect()
}

/// Cautions of constants far from the model's values, where the estimates bear out a wrong unit: one is as far from the
/// model's value, or at a bound, or the fit `is_doubtful` for another reason.
pub fn cautions(report: &FitReport, is_doubtful: bool) -> impl Iterator<Item = String> {
    let far = report.far_constants.iter().filter(move |constant| {
        let is_as_far = |own: &Coefficient| {
            let ratio = (own.value / own.model_value).abs();
            let both = [ratio * constant.ratio, ratio / constant.ratio];
            own.at_bound || both.iter().any(|of| !differ(*of, ALIKE))
        };
        let mut estimated = report.coefficients.values().filter(|own| !own.fixed);
        constant.is_in_other_unit || is_doubtful || estimated.any(is_as_far)
    });
    far.map(|constant| constant.sentence.clone())
}

/// Whether two numbers with this ratio differ by more than a factor.
fn differ(ratio: f64, factor: f64) -> bool {
    ratio.is_finite() && ratio > 0.0 && !(1.0 / factor..=factor).contains(&ratio)
}
