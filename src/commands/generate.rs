//! Command `hyzer generate`: writes models as source code, to a folder of the user or to `crates/generated`.

use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use codegen::backend::{Backend, SourceFile};
use codegen::generate::{self, Difference};
use model_spec::load;
use model_spec::model::Model;

use crate::cli::Generate;
use crate::{Answer, output, progress};

/// Folder of the generated Rust sources, relative to the root of the repository.
const SOURCES: &str = "crates/generated/src";
/// Folder of the model files, relative to the root of the repository.
const MODELS: &str = "model-spec/models";
/// Models whose code is committed in `crates/generated`; the others run by tape.
const GENERATED: [&str; 2] = ["ball", "disc"];

/// Runs `hyzer generate`: writes the generated files that changed. With `--check` prints the differences instead, and
/// returns `Answer::No` if there are any.
pub fn run(options: &Generate) -> anyhow::Result<Answer> {
    match &options.out {
        Some(out) => generate_modules(options, out),
        None => generate_crate(options),
    }
}

/// Generates one Rust module per model in the folder `out` (option `--out`) and lists the files that changed. With
/// `--check`, writes nothing and returns `Answer::No` if a file in the folder differs from the generated one.
fn generate_modules(options: &Generate, out: &Path) -> anyhow::Result<Answer> {
    let files = modules(options)?;
    let folder = out.display().to_string();
    if options.check {
        let differences =
            generate::check_files(out, &files).with_context(|| format!("cannot read {folder}"))?;
        return report(&differences, &folder, options.models.len());
    }
    let changed = progress::writing(|| generate::write_files(out, &files))
        .with_context(|| format!("cannot write {folder}"))?;
    list(&changed, &folder, options.models.len())
}

fn modules(options: &Generate) -> anyhow::Result<Vec<SourceFile>> {
    let backend = match options.lanes {
        true => &codegen::rust::LanesRust as &dyn Backend,
        false => codegen::backend(&options.backend)
            .with_context(|| format!("no backend is called {}", options.backend))?,
    };
    let effects = super::names(&options.with);
    let mut files: Vec<SourceFile> = Vec::new();
    for name in &options.models {
        let model = load::load(name, &effects)?;
        for file in generate::generate_with(backend, &[model]) {
            if files.iter().any(|other| other.path == file.path) {
                bail!(
                    "two models would be written to {}: rename one of them",
                    file.path
                );
            }
            files.push(file);
        }
    }
    Ok(files)
}

/// Generates the sources of the crate `generated` of this repository and lists the files that changed. With `--check`,
/// writes nothing and returns `Answer::No` if a file of the crate differs from the generated one.
fn generate_crate(options: &Generate) -> anyhow::Result<Answer> {
    let root = match &options.root {
        Some(root) => root.clone(),
        None => repository()?,
    };
    let models = models(&root.join(MODELS))?;
    let sources = root.join(SOURCES);
    if options.check {
        let differences = generate::check(&sources, &models)
            .with_context(|| format!("cannot read {}", sources.display()))?;
        return report(&differences, SOURCES, models.len());
    }
    let changed = generate::write(&sources, &models)
        .with_context(|| format!("cannot write {}", sources.display()))?;
    list(&changed, SOURCES, models.len())
}

fn report(differences: &[Difference], folder: &str, models: usize) -> anyhow::Result<Answer> {
    for difference in differences {
        output::print(difference.to_string())?;
    }
    if differences.is_empty() {
        eprintln!("{models} models; {folder} is up to date");
        return Ok(Answer::Yes);
    }
    let count = differences.len();
    eprintln!("{count} files of {folder} are stale; run `hyzer generate` without --check");
    Ok(Answer::No)
}

fn list(changed: &[String], folder: &str, models: usize) -> anyhow::Result<Answer> {
    for path in changed {
        output::print(format!("{folder}/{path}\n"))?;
    }
    eprintln!("{models} models, {} files changed", changed.len());
    Ok(Answer::Yes)
}

/// Root folder of the `hyzer` repository that contains the current folder; an error if the current folder is outside of
/// the repository.
fn repository() -> anyhow::Result<PathBuf> {
    let here = std::env::current_dir()?;
    match here
        .ancestors()
        .find(|folder| folder.join(SOURCES).is_dir() && folder.join(MODELS).is_dir())
    {
        Some(root) => Ok(root.to_path_buf()),
        None => bail!(
            "found no {MODELS} and {SOURCES} in {} or above it; give models and --out DIR, or --root DIR",
            here.display()
        ),
    }
}

/// Loads the models of `crates/generated` from their files in the repository, which may differ from the models built
/// into `hyzer`.
fn models(folder: &Path) -> anyhow::Result<Vec<Model>> {
    let load = |name: &&str| {
        // Only the file name: the location of the repository must not appear in the generated text.
        let name = format!("{name}.hyz");
        let path = folder.join(&name);
        let text =
            std::fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        let text = load::decode(&name, text)?;
        Ok(load::from_text(&name, &text, &[])?)
    };
    GENERATED.iter().map(load).collect()
}
