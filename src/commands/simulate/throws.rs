//! Throws from command-line options, which modify a release or a throw of a launch monitor, or stand alone.

use anyhow::{Context, bail};
use flight::release::Release;
use flight::throw::{FIELDS, Throw, ThrownModel};
use model_spec::model::Model;

use crate::cli::{Simulate, ThrowOptions};

/// Whether the options alone define a throw, by a speed or by a launch monitor's file, so that no release is needed.
pub fn are_enough(options: &ThrowOptions) -> bool {
    options.speed.is_some() || options.techdisc.is_some()
}

/// Loads the model that the options name, and creates a release with the model's default values and without wind, whose
/// simulation ends at the ground.
pub fn bare(options: &Simulate) -> anyhow::Result<(Model, Release)> {
    let Some(name) = &options.model else {
        bail!(
            "no MODEL: expected one before the options of a throw, as in hyzer simulate disc --speed 20"
        );
    };
    let model = model_spec::load::load(name, &super::super::names(&options.with))?;
    let release = at_defaults(name, &model);
    Ok((model, release))
}

/// Creates a release of the model called `name`, with the model's default values and without wind, whose simulation
/// ends at the ground. The caller sets the motion of a throw in this release.
pub fn at_defaults(name: &str, model: &Model) -> Release {
    Release {
        model: name.to_owned(),
        ..Release::of(model)
    }
}

/// Sets the initial states of the release to the motion of `throw`, in which the command-line options replace single
/// quantities. If `throw` is `None`, the options modify the motion specified in the release.
pub fn apply(
    options: &ThrowOptions,
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
        let value = value
            .with_context(|| format!("--{name}: found {text:?}, expected a number in {unit}"))?;
        throw.set(name, value);
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
