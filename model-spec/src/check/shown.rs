//! Names in messages as they stand in the text: `r[3]` for the element `r_3`, `v` for a variable of a call.

use std::collections::HashMap;

use crate::diagnostic::Diagnostic;
use crate::syntax::ast::{File, Item};

/// Replaces in messages the names that expansion has made.
pub(super) fn show_written_names(file: &File, faults: &mut [Diagnostic]) {
    if faults.is_empty() {
        return;
    }
    let names: HashMap<&str, String> = file.items.iter().filter_map(written).collect();
    if names.is_empty() {
        return;
    }
    for fault in faults {
        show(&mut fault.message, &names);
        fault
            .labels
            .iter_mut()
            .for_each(|own| show(&mut own.text, &names));
        fault.notes.iter_mut().for_each(|own| show(own, &names));
        fault.help.iter_mut().for_each(|own| show(own, &names));
    }
}

/// Name of an expanded statement, and how it is written in the text.
pub(super) fn written(item: &Item) -> Option<(&str, String)> {
    let origin = item.expanded.as_ref()?;
    let name = &item.kind.array_name()?.text;
    if origin.call.is_some() {
        let (_, local) = name.split_once("__")?;
        let (_, local) = local.split_once('_')?;
        return Some((name, local.to_owned()));
    }
    let own = &origin.written_array()?.array_name()?.text;
    let subscripts = name.strip_prefix(own.as_str())?.strip_prefix('_')?;
    Some((name, format!("{own}[{}]", subscripts.replace('_', ", "))))
}

fn show(text: &mut String, names: &HashMap<&str, String>) {
    let mut shown = String::with_capacity(text.len());
    let mut rest = text.as_str();
    let is_of_name = |c: char| c.is_alphanumeric() || c == '_';
    while let Some(start) = rest.find(is_of_name) {
        shown.push_str(&rest[..start]);
        rest = &rest[start..];
        let end = rest.find(|c| !is_of_name(c)).unwrap_or(rest.len());
        let word = &rest[..end];
        shown.push_str(names.get(word).map_or(word, String::as_str));
        rest = &rest[end..];
    }
    shown.push_str(rest);
    *text = shown;
}
