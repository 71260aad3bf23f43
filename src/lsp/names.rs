//! Where names are declared and used, and other names for them.

use std::ops::Range;

use model_spec::symbols::{SymbolKind, Symbols, WordKind};
use serde_json::{Value, json};

use super::document::Document;
use super::positions::Lines;
use super::uri;

fn location(document: &Document, range: Range<usize>) -> Value {
    json!({ "uri": document.uri, "range": document.lines.range(&document.text, range) })
}

/// Result of `textDocument/definition`.
pub fn definition(document: &Document, position: &Value) -> Value {
    let offset = document.lines.offset(&document.text, position);
    let symbols = &document.known().symbols;
    if let Some(own) = symbols.declaration_at(offset) {
        return location(document, symbols.declarations[own].range.clone());
    }
    let word = symbols
        .word_at(offset)
        .filter(|word| word.kind == WordKind::Unknown);
    let name = word.and_then(|word| document.text.get(word.range.clone()));
    name.map_or(Value::Null, |name| elsewhere(document, name))
}

/// Declaration of a name in a file that this one includes, or in the model that an effect is for.
fn elsewhere(document: &Document, name: &str) -> Value {
    let of_model = document.model().map_or(&[][..], |model| &model.sources);
    let sources = document.known().sources.iter().skip(1).chain(of_model);
    for source in sources.filter(|source| std::path::Path::new(&source.name).is_file()) {
        let symbols = Symbols::of(&source.text);
        if let Some(found) = symbols.declarations.iter().find(|own| own.name == name) {
            let range = Lines::of(&source.text).range(&source.text, found.range.clone());
            return json!({ "uri": uri::of(&source.name), "range": range });
        }
    }
    Value::Null
}

/// Result of `textDocument/references`.
pub fn references(document: &Document, position: &Value, with_declaration: bool) -> Value {
    let offset = document.lines.offset(&document.text, position);
    let symbols = &document.known().symbols;
    let Some(own) = symbols.declaration_at(offset) else {
        return Value::Null;
    };
    let declared = &symbols.declarations[own].range;
    let ranges = symbols
        .occurrences(own)
        .filter(|range| with_declaration || range != declared);
    ranges.map(|range| location(document, range)).collect()
}

/// Result of `textDocument/documentHighlight`.
pub fn highlights(document: &Document, position: &Value) -> Value {
    let found = references(document, position, true);
    let ranges = found.as_array().into_iter().flatten();
    ranges
        .map(|location| json!({ "range": location["range"] }))
        .collect()
}

/// Result of `textDocument/prepareRename`: the range of the name, `null` where nothing can be renamed.
pub fn renamed_range(document: &Document, position: &Value) -> Value {
    let offset = document.lines.offset(&document.text, position);
    let symbols = &document.known().symbols;
    match (symbols.declaration_at(offset), symbols.word_at(offset)) {
        (Some(_), Some(word)) => document.lines.range(&document.text, word.range.clone()),
        _ => Value::Null,
    }
}

/// Result of `textDocument/rename`.
///
/// # Errors
/// Why the name cannot be changed so.
pub fn rename(document: &Document, position: &Value, name: &str) -> Result<Value, String> {
    let offset = document.lines.offset(&document.text, position);
    let symbols = &document.known().symbols;
    let own = symbols.declaration_at(offset);
    let own = own.ok_or_else(|| "this file declares no such name".to_owned())?;
    if let Some(reason) = symbols.refusal(own, name) {
        return Err(reason);
    }
    let edit =
        |range| json!({ "range": document.lines.range(&document.text, range), "newText": name });
    let edits: Vec<Value> = symbols.occurrences(own).map(edit).collect();
    Ok(json!({ "changes": { document.uri.as_str(): edits } }))
}

/// Result of `textDocument/documentSymbol`.
pub fn outline(document: &Document) -> Value {
    let declarations = &document.known().symbols.declarations;
    let listed = declarations.iter().filter(|own| {
        let is_inner = matches!(
            own.kind,
            SymbolKind::Index | SymbolKind::Argument | SymbolKind::Need
        );
        !is_inner && own.scope.start == 0
    });
    let symbols = listed.map(|own| {
        json!({
            "name": document.text.get(own.range.clone()),
            "detail": own.kind.noun(),
            "kind": protocol_kind(own.kind),
            "range": document.lines.range(&document.text, own.statement.clone()),
            "selectionRange": document.lines.range(&document.text, own.range.clone()),
        })
    });
    symbols.collect()
}

/// `SymbolKind` of the protocol.
fn protocol_kind(kind: SymbolKind) -> u8 {
    match kind {
        SymbolKind::Model => 2,
        SymbolKind::Body => 5,
        SymbolKind::Frame => 3,
        SymbolKind::Table | SymbolKind::Function => 12,
        SymbolKind::Parameter | SymbolKind::Coefficient => 14,
        SymbolKind::Force | SymbolKind::Moment => 24,
        SymbolKind::Effect => 11,
        _ => 13,
    }
}
