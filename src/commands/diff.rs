//! Command `hyzer diff`: prints the effect of a change of a model.

use std::io::Read;
use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context, anyhow, bail};
use model_spec::LoadError;
use model_spec::load::{Loaded, inspect, inspect_text};
use model_spec::model::Model;
use verify::difference::{DifferenceOptions, compare};

use crate::cli::Diff;
use crate::{Answer, output};

/// Maximum size of a model file, bytes; equal to the limit of the model language.
const MAX_BYTES: u64 = 1_000_000;
/// Maximum value of the option `--seconds`, the duration of the flights with which two models are compared, s; a larger
/// value is an error.
const MAX_SECONDS: f64 = 60.0;

/// Runs `hyzer diff`: compares two models. Returns `Answer::No` if they differ in a time derivative of a state, a
/// component of the measurement equation or a limit of validity.
pub fn run(options: &Diff) -> anyhow::Result<Answer> {
    if !(options.seconds > 0.0 && options.seconds <= MAX_SECONDS) {
        bail!(
            "--seconds: found {}, expected above 0, at most {MAX_SECONDS}",
            options.seconds
        );
    }
    let with = super::names(&options.with);
    let ((old, old_faults), (new, new_faults)) =
        (model(&options.old, &with)?, model(&options.new, &with)?);
    let settings = DifferenceOptions {
        seconds: options.seconds,
        time: options.time,
        ..DifferenceOptions::default()
    };
    let difference = compare(&old, &new, &settings).with_unit_faults(&old_faults, &new_faults);
    output::print(if options.json {
        serde_json::to_string_pretty(&difference)? + "\n"
    } else if options.markdown {
        difference.markdown()
    } else {
        difference.text()
    })?;
    Ok(match difference.is_changed() {
        true => Answer::No,
        false => Answer::Yes,
    })
}

/// Loads a model by name, by path, or by `REVISION:PATH` of a file in git; an existing file takes precedence. Also
/// returns the messages on inconsistent units.
fn model(wanted: &str, with: &[&str]) -> anyhow::Result<(Model, Vec<String>)> {
    let loaded = loaded(wanted, with)?;
    let faults = loaded.diagnostics.iter().map(|d| d.message.clone());
    let faults = faults.collect();
    match loaded.model {
        Some(model) => Ok((model, faults)),
        None => Err(LoadError::Faults {
            diagnostics: loaded.diagnostics,
            sources: loaded.sources,
        }
        .into()),
    }
}

fn loaded(wanted: &str, with: &[&str]) -> anyhow::Result<Loaded> {
    match wanted.split_once(':') {
        Some((revision, path)) if !Path::new(wanted).exists() && !revision.is_empty() => {
            Ok(inspect_text(wanted, &of_git(revision, path)?, with)?)
        }
        _ => Ok(inspect(wanted, with)?),
    }
}

/// Text of the file `path` at the git revision `revision`, from `git show`.
fn of_git(revision: &str, path: &str) -> anyhow::Result<String> {
    let object = format!("{revision}:{path}");
    if revision.starts_with('-') {
        bail!("{object}: found a revision that begins with `-`, expected a commit, branch or tag");
    }
    let mut child = Command::new("git")
        .args(["show", "--end-of-options", &object])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .context("cannot run `git`")?;
    let mut text = Vec::new();
    let piped = child.stdout.take();
    let mut limited = piped
        .ok_or_else(|| anyhow!("`git` has no output"))?
        .take(MAX_BYTES + 1);
    limited.read_to_end(&mut text)?;
    drop(limited);
    let finished = child.wait_with_output()?;
    if text.len() as u64 > MAX_BYTES {
        bail!("{object}: found more than {MAX_BYTES} bytes, expected a model file");
    }
    if !finished.status.success() {
        let why = String::from_utf8_lossy(&finished.stderr);
        bail!(
            "{object}: git has no such file: {}",
            why.lines().next().unwrap_or_default()
        );
    }
    String::from_utf8(text).map_err(|_| anyhow!("{object}: found bytes that are not UTF-8"))
}
