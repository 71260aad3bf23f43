//! Checks of the effects declared in a model's file.

use std::collections::HashSet;

use crate::check;
use crate::diagnostic::{self, Diagnostic, Kind, Source};
use crate::effect;
use crate::syntax::ast::File;

/// Maximum number of checked effects of a file, as each checks the whole model.
const MAX_CHECKED_OFFERS: usize = 50;

/// Errors of the effects of a file, each applied alone to a copy of the model.
pub(super) fn faults(file: &File, sources: &[Source]) -> Vec<Diagnostic> {
    let model = file.model().map_or("", |name| &name.text);
    let mut diagnostics = Vec::new();
    let mut names: HashSet<&str> = HashSet::new();
    for offered in file.effects() {
        let name = &offered.name;
        if !names.insert(&name.text) {
            let message = format!("there are two effects `{}`", name.text);
            let fault = Diagnostic::new(Kind::Duplicate, name.span, message);
            diagnostics.push(fault.help("rename one of them"));
            continue;
        }
        let is_applied = file.applied.iter().any(|a| a.name.text == name.text);
        if is_applied || offered.excludes(model) || names.len() > MAX_CHECKED_OFFERS {
            continue;
        }
        match effect::apply(file, offered) {
            Ok(changed) => diagnostics.extend(check::check(&changed, sources).diagnostics),
            Err(faults) => diagnostics.extend(faults),
        }
    }
    diagnostic::sort(&mut diagnostics);
    diagnostics
}
