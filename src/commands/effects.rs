//! Command `hyzer effects`: lists the available effects.

use report::effects::{listed, not_offered, page};

use crate::cli::Effects;
use crate::{Answer, output};

/// Runs `hyzer effects`: writes the effects of a model, or all built-in effects, as Markdown.
pub(super) fn run(options: &Effects) -> anyhow::Result<Answer> {
    let model = options.model.as_deref();
    let effects = listed(model)?;
    let refused = model.map_or_else(|| Ok(Vec::new()), not_offered)?;
    let page = page(&effects, model, &refused);
    match &options.out {
        Some(file) => {
            output::write(file, page)?;
            eprintln!("{} effects; the page is {}", effects.len(), file.display());
        }
        None => output::print(page)?,
    }
    Ok(Answer::Yes)
}
