//! Throws from command-line options, which modify a release or a throw of a launch monitor, or stand alone.

use anyhow::{Context, ensure};
use flight::release::Release;
use flight::throw::{FIELDS, Throw, ThrownModel};
use model_spec::model::Model;
use model_spec::syntax::spelling::joined;
use report::Units;

use crate::cli::ThrowOptions;

/// Release of the model called `name` without wind, with default values, to the ground; without the motion of a throw.
pub fn at_defaults(name: &str, model: &Model) -> Release {
    Release {
        model: name.to_owned(),
        ..Release::of(model)
    }
}

/// Refuses values of `--set` for states that a throw determines, all but the place above the ground and what effects add.
pub fn check_sets(sets: &[String], model: &Model) -> anyhow::Result<()> {
    let (added, [x, y, _]) = (model.added_states(), model.place());
    let names = sets.iter().filter_map(|set| set.split_once('='));
    for name in names.map(|(name, _)| joined(name.trim())) {
        let state = model.states.iter().position(|own| own.name == name);
        let is_kept = state.is_none_or(|own| added.contains(&own) || [x, y].contains(&state));
        ensure!(
            is_kept,
            "--set: the throw determines {name}; expected an option of the throw, such as --height, or a release with [initial]"
        );
    }
    Ok(())
}

/// Sets the motion of `throw`, or else the release's, with the quantities that options, in `units`, replace.
pub fn apply(
    options: &ThrowOptions,
    units: Units,
    throw: Option<Throw>,
    model: &Model,
    release: &mut Release,
) -> anyhow::Result<()> {
    if throw.is_none() && options.given().next().is_none() {
        return Ok(());
    }
    let thrown = ThrownModel::new(model)?;
    let parameters = thrown.release_parameters(release);
    let before = release.state();
    let mut throw = throw.unwrap_or_else(|| thrown.throw(&before, &parameters));
    for (name, text) in options.given() {
        let value = text.trim().parse::<f64>().ok().filter(|v| v.is_finite());
        let unit = FIELDS.iter().find(|(field, ..)| *field == name);
        let unit = unit.map_or("", |(_, unit, ..)| unit);
        let (unit, size) = units.instead_of(unit);
        let expected = || format!("--{name}: found {text:?}, expected a number in {unit}");
        throw.set(name, value.with_context(expected)? * size);
    }
    let ground = thrown.ground(&before, &parameters);
    let state = thrown.state(&throw, ground, &parameters);
    let option = |field: Option<&str>| match field {
        Some(name) if options.given().any(|(given, _)| given == name) => format!("--{name}"),
        _ => "the throw".into(),
    };
    let state = state.map_err(|e| {
        let option = option(e.field());
        anyhow::Error::new(e).context(option)
    })?;
    let added = model.added_states();
    for (index, ((_, value), found)) in release.initial.iter_mut().zip(state).enumerate() {
        if !added.contains(&index) {
            *value = found;
        }
    }
    Ok(())
}
