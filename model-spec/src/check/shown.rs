//! Names in messages as they stand in the text: `r[3]` for the element `r_3`, `v` for a variable of a call.

use std::collections::HashMap;

use crate::diagnostic::Diagnostic;
use crate::syntax::ast::{File, Item, ItemKind};

/// Replaces in messages the names that expansion has made.
pub(super) fn show_written_names(file: &File, faults: &mut [Diagnostic]) {
    if faults.is_empty() {
        return;
    }
    let names: HashMap<&str, String> = file.items.iter().filter_map(written).collect();
    if names.is_empty() {
        return;
    }
    let show = |text: &mut String| *text = shown(text, &names);
    for fault in faults {
        show(&mut fault.message);
        fault.labels.iter_mut().for_each(|own| show(&mut own.text));
        fault.notes.iter_mut().for_each(show);
        fault.help.iter_mut().for_each(show);
    }
}

/// A message as it is for any element of an array: without subscripts.
pub(super) fn of_any_element(message: &str, names: &HashMap<&str, String>) -> String {
    let message = shown(message, names);
    let mut parts = message.split('[');
    let mut general = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let inner = part.find(']').filter(|end| is_subscript(&part[..*end]));
        general.push('[');
        general.push_str(&part[inner.unwrap_or(0)..]);
    }
    general
}

fn is_subscript(text: &str) -> bool {
    text.chars()
        .all(|c| c.is_ascii_digit() || matches!(c, ',' | ' '))
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
    let ItemKind::Array(array) = &origin.from.written.kind else {
        return None;
    };
    let own = &array.statement.array_name()?.text;
    let subscripts = name.strip_prefix(own.as_str())?.strip_prefix('_')?;
    Some((name, format!("{own}[{}]", subscripts.replace('_', ", "))))
}

/// A text with names as they are written.
fn shown(text: &str, names: &HashMap<&str, String>) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut rest = text;
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
    shown
}
