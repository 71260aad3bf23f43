//! Datasets whose vertical is not known, such as those in the axes of a camera. The direction of the vertical is
//! estimated with the other parameters, from several initial directions.

use model_spec::compose::{EffectTree, ModelTree};
use model_spec::model::Model;

use crate::error::FitError;
use crate::fit::{Fit, fit};
use crate::options::FitOptions;
use crate::vertical::{ANGLES, EFFECT, angles};
use dataset::{Dataset, Role};

/// Maximum number of flights that are fitted from each of several initial directions of the vertical, to choose among
/// these directions.
const TRIED_FLIGHTS: usize = 6;

/// Trial directions of the vertical: upward vectors, not normalised, along the axes of the measured positions and
/// halfway between two of them.
fn directions() -> Vec<[f64; 3]> {
    let all =
        (0..27).map(|index| [index / 9, index / 3 % 3, index % 3].map(|k| f64::from(k) - 1.0));
    let zeros = |v: &[f64; 3]| v.iter().filter(|x| **x == 0.0).count();
    all.filter(|v| (1..=2).contains(&zeros(v))).collect()
}

/// Adds to the model the effect that rotates the axes of the measured positions by two estimated angles, about x and
/// then y. The arguments are the initial values of these angles, rad.
fn turned(model: &Model, [about_x, about_y]: [f64; 2]) -> Result<Model, FitError> {
    let [x, y] = ANGLES;
    let text = format!(
        "/// The axes that positions are measured in are turned from the vertical by angles that are not known.\n\
         effect {EFFECT} {{\n\
         source \"the dataset: its vertical is unknown\";\n\
         site vertical;\n\
         variables position;\n\
         /// turn of the measured axes about x\n\
         coefficient {x} = {about_x:?} rad in -4 .. 4;\n\
         /// turn about the y that they have then\n\
         coefficient {y} = {about_y:?} rad in -4 .. 4;\n\
         negligible {x} 1e-6 rad;\n\
         negligible {y} 1e-6 rad;\n\
         replace observe = (cos({y})*previous.1 - sin({y})*(cos({x})*previous.3 - sin({x})*previous.2),\n\
           cos({x})*previous.2 + sin({x})*previous.3,\n\
           sin({y})*previous.1 + cos({y})*(cos({x})*previous.3 - sin({x})*previous.2)) in inertial;\n}}\n"
    );
    let refused = |error: model_spec::LoadError| FitError::Sensor {
        model: model.name.clone(),
        reason: error.to_string(),
    };
    let effect = EffectTree::parse("unknown_vertical.hyz", &text).map_err(refused)?;
    let tree = ModelTree::of(model).with(&effect).map_err(refused)?;
    tree.check().map_err(refused)
}

/// Returns the model with the effect that rotates the axes of the measured positions by two angles. The initial angles
/// are those of the best fit to a few flights, over all trial directions of the vertical.
///
/// # Errors
/// The error of the last fit if no fit succeeds; [`FitError::Interrupted`] if the work is cancelled.
pub fn with_vertical(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
) -> Result<Model, FitError> {
    let mut few = dataset.clone();
    few.flights.retain(|flight| flight.role == Role::Fit);
    few.flights.truncate(TRIED_FLIGHTS);
    let of_few = FitOptions {
        profiles: &[],
        progress: None,
        ..*options
    };
    let mut best: Option<(f64, [f64; 2])> = None;
    let mut failure = FitError::NothingToFit;
    for direction in directions() {
        if options.is_cancelled() {
            return Err(FitError::Interrupted);
        }
        let start = angles(direction);
        match fit(&turned(model, start)?, &few, &of_few) {
            Ok(found) => {
                let misfit = misfit(&found);
                if let Some(angles) = estimated(&found).filter(|_| reaches_noise(&found)) {
                    return turned(model, angles);
                }
                if best.is_none_or(|(least, _)| misfit < least)
                    && let Some(angles) = estimated(&found)
                {
                    best = Some((misfit, angles));
                }
            }
            Err(error) => failure = error,
        }
    }
    match best {
        Some((_, angles)) => turned(model, angles),
        None => Err(failure),
    }
}

/// Ratio of the root mean square residual to the noise floor, below which the search for the initial direction of the
/// vertical ends, as no other direction can fit noticeably better.
const NOISE_RATIO: f64 = 1.1;

/// Whether the residuals of a fit are at the level of the measurement noise.
fn reaches_noise(found: &Fit) -> bool {
    let floor = found.report.position_noise().and_then(|noise| noise.floor);
    floor.is_some_and(|floor| misfit(found) < NOISE_RATIO * floor)
}

/// Measure by which fits from different initial directions of the vertical are compared, m: root mean square residual ×
/// (1 + number of excluded flights).
fn misfit(found: &Fit) -> f64 {
    let excluded = found.report.excluded().count() as f64;
    found.report.rms() * (1.0 + excluded)
}

/// Estimated angles, rad, by which the axes of the measured positions are rotated from the vertical, about x and then
/// y; `None` if the fit does not estimate them.
fn estimated(found: &Fit) -> Option<[f64; 2]> {
    let value = |name: &str| Some(found.report.coefficients.get(name)?.value);
    Some([value(ANGLES[0])?, value(ANGLES[1])?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vertical::upward;

    #[test]
    fn angles_and_directions_are_one_another_s_inverse() {
        for direction in directions() {
            let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
            let back = upward(angles(direction));
            for (a, b) in direction.iter().zip(back) {
                assert!((a / length - b).abs() < 1e-12, "{direction:?} {back:?}");
            }
        }
        assert_eq!(directions().len(), 18);
    }
}
