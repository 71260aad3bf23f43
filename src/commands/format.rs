//! Command `hyzer format`: lays out the text of models and effects.

use std::fmt::Write;
use std::io::Read;
use std::path::Path;

use anyhow::Context;
use similar::TextDiff;

use crate::cli::Format;
use crate::{Answer, output};

/// Runs `hyzer format`. `Answer::No` if `--check` finds a file that is not formatted.
pub(super) fn run(options: &Format) -> anyhow::Result<Answer> {
    let mut changed = Vec::new();
    let mut faults = String::new();
    for path in &options.files {
        let is_input = path.as_os_str() == "-";
        let name = if is_input {
            "standard input".into()
        } else {
            path.display().to_string()
        };
        let text = if is_input {
            standard_input()?
        } else {
            model_spec::load::read(&name)?
        };
        match model_spec::format(&name, &text) {
            Err(error) => faults += &format!("{error}\n"),
            Ok(formatted) if is_input && !options.check => output::print(formatted)?,
            Ok(formatted) if formatted != text => changed.push((path, name, text, formatted)),
            Ok(_) => {}
        }
    }
    // A faulty file leaves all as they are.
    if !faults.is_empty() {
        anyhow::bail!("{}", faults.trim_end());
    }
    if options.check {
        let mut shown = String::new();
        for (_, name, text, formatted) in &changed {
            write!(shown, "{}", difference(name, text, formatted))?;
        }
        output::print(shown)?;
        return Ok(Answer::of(changed.is_empty()));
    }
    for (path, name, _, formatted) in &changed {
        write_through(path, formatted)?;
        eprintln!("formatted {name}");
    }
    Ok(Answer::Yes)
}

/// Writes the file that a path leads to, through symbolic links.
fn write_through(path: &Path, text: &str) -> anyhow::Result<()> {
    let target = path.canonicalize();
    let target = target.with_context(|| format!("cannot write {}", path.display()))?;
    output::write(&target, text)
}

fn standard_input() -> anyhow::Result<String> {
    let mut bytes = Vec::new();
    // One more than a file may have, so that a longer one is reported as such.
    let most = model_spec::syntax::MAX_SOURCE_BYTES as u64 + 1;
    let read = std::io::stdin().lock().take(most).read_to_end(&mut bytes);
    read.context("standard input")?;
    Ok(model_spec::load::decode("standard input", bytes)?)
}

fn difference(name: &str, text: &str, formatted: &str) -> String {
    let difference = TextDiff::from_lines(text, formatted);
    let mut difference = difference.unified_diff();
    let header = format!("{name} as it is");
    let shown = difference.context_radius(2);
    shown
        .header(&header, &format!("{name} formatted"))
        .to_string()
}
