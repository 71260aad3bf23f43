//! Command `hyzer effects`: lists the available effects.

use report::effects::{listed, not_offered, page, text};

use crate::cli::{Effects, ListForm};
use crate::{Answer, output};

/// Runs `hyzer effects`: writes the effects of a model, or all built-in effects, as Markdown or, on a terminal, text.
pub(super) fn run(options: &Effects) -> anyhow::Result<Answer> {
    let model = options.model.as_deref();
    let effects = listed(model)?;
    let refused = model.map_or_else(|| Ok(Vec::new()), not_offered)?;
    let is_text = match options.format {
        Some(form) => form == ListForm::Text,
        None => options.out.is_none() && output::is_terminal(),
    };
    if is_text {
        // Where no terminal states its width.
        report::set_width(output::PRINTED_WIDTH);
    }
    let page = match is_text {
        true => text(&effects, model, &refused),
        false => page(&effects, model, &refused),
    };
    match &options.out {
        Some(file) => {
            output::write(file, page)?;
            eprintln!("{} effects; the page is {}", effects.len(), file.display());
        }
        None => output::print(page)?,
    }
    Ok(Answer::Yes)
}
