//! The option `--wind`: a constant wind, or the wind described in a file.

use std::path::Path;

use anyhow::{Context, bail};
use flight::release::Release;
use flight::wind::read_wind_file;
use model_spec::model::Model;
use report::Units;

use super::vector;

/// Sets the wind of a release by `--wind`, with components in `units`; returns the model with which to fly it.
pub fn apply(
    text: &str,
    units: Units,
    model: Model,
    release: &mut Release,
) -> anyhow::Result<Model> {
    let (unit, size) = units.instead_of("m/s");
    if release.wind_field.is_some() {
        bail!("--wind: the release states a wind by height or gusts, expected only one wind");
    }
    if text.split(',').count() == 3 && !Path::new(text).exists() {
        release.wind = vector("--wind", text, unit)?.map(|own| own * size);
        return with_input(model, release.wind);
    }
    if !Path::new(text).exists() {
        bail!(
            "--wind: found {text:?}, which is no file; expected X,Y,Z in {unit} or a TOML file with [wind]"
        );
    }
    let (constant, field) = read_wind_file(Path::new(text)).context("--wind")?;
    release.wind = constant;
    release.wind_field = field;
    match &release.wind_field {
        Some(field) => field.compose(&model).context("--wind"),
        None => with_input(model, release.wind),
    }
}

/// Refuses a constant wind for a model without an input `wind`.
fn with_input(model: Model, wind: [f64; 3]) -> anyhow::Result<Model> {
    if wind != [0.0; 3] && !model.inputs.iter().any(|input| input.name == "wind") {
        bail!(
            "--wind: found a constant wind, but {} has no input `wind`",
            model.name
        );
    }
    Ok(model)
}
