//! Command `hyzer generate`: writes models as source code, to a folder of the user or to `crates/generated`.

use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use codegen::backend::{Backend, SourceFile};
use codegen::generate::{self, Difference};
use identify::wording::count;
use model_spec::load;
use model_spec::model::Model;

use crate::cli::Generate;
use crate::{Answer, output, progress};

const SOURCES: &str = "crates/generated/src";
const MODELS: &str = "model-spec/models";
/// Models whose code is committed in `crates/generated`; the others run by tape.
const GENERATED: [&str; 2] = ["ball", "disc"];

/// Runs `hyzer generate`. `Answer::No` if `--check` finds differences.
pub(super) fn run(options: &Generate) -> anyhow::Result<Answer> {
    match &options.out {
        Some(out) => generate_modules(options, out),
        None => generate_crate(options),
    }
}

/// Generates a module per model in the folder `out`.
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
    let backend = if options.lanes {
        &codegen::rust::LanesRust as &dyn Backend
    } else {
        codegen::backend(&options.backend)
            .with_context(|| format!("no backend is called {}", options.backend))?
    };
    let effects = super::names(&options.with);
    let mut files: Vec<SourceFile> = Vec::new();
    for name in &options.models {
        let model = load::load(name, &effects)?;
        for file in generate::generate_with(backend, &[model]) {
            let path = &file.path;
            ensure!(
                !files.iter().any(|other| other.path == *path),
                "two models would be written to {path}: rename one of them"
            );
            files.push(file);
        }
    }
    Ok(files)
}

/// Generates the sources of the crate `generated` of this repository.
fn generate_crate(options: &Generate) -> anyhow::Result<Answer> {
    let root = match &options.root {
        Some(root) => root.clone(),
        None => repository()?,
    };
    let models = models(&root.join(MODELS))?;
    let sources = root.join(SOURCES);
    if options.check {
        let differences = generate::check(&sources, &models);
        let differences =
            differences.with_context(|| format!("cannot read {}", sources.display()))?;
        return report(&differences, SOURCES, models.len());
    }
    let changed = generate::write(&sources, &models);
    let changed = changed.with_context(|| format!("cannot write {}", sources.display()))?;
    list(&changed, SOURCES, models.len())
}

fn report(differences: &[Difference], folder: &str, models: usize) -> anyhow::Result<Answer> {
    for difference in differences {
        output::print(difference.to_string())?;
    }
    if differences.is_empty() {
        eprintln!("{}; {folder} is up to date", count(models, "model"));
        return Ok(Answer::Yes);
    }
    let files = count(differences.len(), "file");
    let are = if differences.len() == 1 { "is" } else { "are" };
    eprintln!("{files} of {folder} {are} stale; run `hyzer generate` without --check");
    Ok(Answer::No)
}

fn list(changed: &[String], folder: &str, models: usize) -> anyhow::Result<Answer> {
    for path in changed {
        output::print(format!("{folder}/{path}\n"))?;
    }
    let (models, files) = (count(models, "model"), count(changed.len(), "file"));
    eprintln!("{models}, {files} changed");
    Ok(Answer::Yes)
}

/// Root of the repository around the current folder.
fn repository() -> anyhow::Result<PathBuf> {
    let here = std::env::current_dir()?;
    let is_root = |folder: &&Path| folder.join(SOURCES).is_dir() && folder.join(MODELS).is_dir();
    let root = here.ancestors().find(is_root).with_context(|| {
        format!(
            "found no {MODELS} and {SOURCES} in {} or above it; give models and --out DIR, or --root DIR",
            here.display()
        )
    })?;
    Ok(root.to_path_buf())
}

/// Loads the models of `crates/generated` from the repository, where they may differ from the built-in ones.
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
