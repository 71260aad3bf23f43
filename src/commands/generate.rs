//! `hyzer generate`: the models as Rust, in `crates/generated`.

use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use codegen::generate;
use model_spec::load;
use model_spec::model::Model;

use crate::cli::Generate;
use crate::{Answer, output};

/// Where the generated sources are, below the repository.
const SOURCES: &str = "crates/generated/src";
/// Where the models are, below the repository.
const MODELS: &str = "model-spec/models";

/// Writes what differs; with `--check` shows it instead, and the answer is no where there is any.
pub fn run(options: &Generate) -> anyhow::Result<Answer> {
    let root = match &options.root {
        Some(root) => root.clone(),
        None => repository()?,
    };
    let models = models(&root.join(MODELS))?;
    let sources = root.join(SOURCES);
    if options.check {
        let differences = generate::check(&sources, &models)
            .with_context(|| format!("cannot read {}", sources.display()))?;
        for difference in &differences {
            output::print(difference.to_string())?;
        }
        if differences.is_empty() {
            eprintln!("{} models, and {SOURCES} is what they say", models.len());
            return Ok(Answer::Yes);
        }
        eprintln!(
            "{} files of {SOURCES} are stale; run `hyzer generate`",
            differences.len()
        );
        return Ok(Answer::No);
    }
    let changed = generate::write(&sources, &models)
        .with_context(|| format!("cannot write {}", sources.display()))?;
    for path in &changed {
        output::print(format!("{SOURCES}/{path}\n"))?;
    }
    eprintln!("{} models, {} files changed", models.len(), changed.len());
    Ok(Answer::Yes)
}

/// The repository around the current folder.
fn repository() -> anyhow::Result<PathBuf> {
    let here = std::env::current_dir()?;
    match here
        .ancestors()
        .find(|folder| folder.join(SOURCES).is_dir() && folder.join(MODELS).is_dir())
    {
        Some(root) => Ok(root.to_path_buf()),
        None => bail!(
            "found no {MODELS} and {SOURCES} in {} or above it; generate works inside the repository, or give --root DIR",
            here.display()
        ),
    }
}

/// The models of the repository as they are now, not as they were built into the program.
fn models(folder: &Path) -> anyhow::Result<Vec<Model>> {
    let entries =
        std::fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| Ok(entry?.path()))
        .collect::<std::io::Result<_>>()?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "hyz"));
    paths.sort();
    if paths.is_empty() {
        bail!("found no .hyz file in {}", folder.display());
    }
    let mut models = Vec::with_capacity(paths.len());
    for path in paths {
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let text =
            std::fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        // By its bare name: the place of the repository must not reach the generated text.
        let text = load::decode(&name, text)?;
        models.push(load::from_text(&name, &text, &[])?);
    }
    Ok(models)
}
