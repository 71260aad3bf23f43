//! Command `hyzer lsp`: serves an editor.

use crate::cli::Lsp;
use crate::{Answer, lsp};

/// Runs `hyzer lsp` until the editor ends it. `Answer::No` if it ends without saying so.
pub(super) fn run(_options: &Lsp) -> anyhow::Result<Answer> {
    let ended = lsp::serve(std::io::stdin().lock(), &mut std::io::stdout().lock())?;
    Ok(Answer::of(ended))
}
