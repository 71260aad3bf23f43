//! Checks of the effects declared in a model's file.

use std::collections::HashSet;

use crate::check;
use crate::diagnostic::{self, Diagnostic, Kind, Source};
use crate::effect;
use crate::syntax::ast::File;

/// Maximum number of effects in a model file that are checked, since each requires a check of the whole model; further
/// effects are not checked.
const MAX_CHECKED_OFFERS: usize = 50;

/// Returns the errors of the effects that a model file declares. To find them, each effect alone is applied to a copy
/// of the model, and this copy is checked.
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
