//! Where names are declared and used, and other names for them.

use std::collections::{BTreeMap, BTreeSet};

use model_spec::diagnostic::Source;
use model_spec::symbols::{SymbolKind, Symbols, WordKind};
use serde_json::{Value, json};

use super::document::Document;
use super::includes;
use super::positions::Lines;
use super::project::{self, Project};
use super::uri;

/// Result of `textDocument/definition`.
pub fn definition(document: &Document, project: &Project<'_>, position: &Value) -> Value {
    let offset = project.offset(position);
    let symbols = &project.symbols;
    if let Some(own) = symbols.declaration_at(offset) {
        return project.location(symbols.declarations[own].range.clone());
    }
    let in_text = document.lines.offset(&document.text, position);
    if let Some(file) = includes::definition(document, in_text) {
        return file;
    }
    let word = symbols
        .word_at(offset)
        .filter(|word| word.kind == WordKind::Unknown);
    let name = word.and_then(|word| project.text(word.range.clone()));
    name.map_or(Value::Null, |name| elsewhere(document, name))
}

/// Declaration of a name in the model that an effect is for.
fn elsewhere(document: &Document, name: &str) -> Value {
    let sources = document.model().map_or(&[][..], |model| &model.sources);
    let is_file = |source: &&Source| std::path::Path::new(&source.name).is_file();
    for source in sources.iter().filter(is_file) {
        let symbols = Symbols::of(&source.text);
        if let Some(found) = symbols.declarations.iter().find(|own| own.name == name) {
            let range = Lines::of(&source.text).range(&source.text, found.range.clone());
            return json!({ "uri": uri::of(&source.name), "range": range });
        }
    }
    Value::Null
}

/// A place where a name stands, and whether that is its declaration.
type Found = (Value, bool);

/// Where the name at a position of a file stands, in all models that have one of these places.
fn everywhere(
    documents: &BTreeMap<String, Document>,
    uri: &str,
    position: &Value,
    mut check: impl FnMut(&Symbols, usize) -> Result<(), String>,
) -> Result<Vec<Found>, String> {
    let mut found: Vec<Found> = Vec::new();
    let (mut roots, mut files) = (BTreeSet::new(), BTreeSet::from([uri.to_owned()]));
    let mut open = vec![(uri.to_owned(), position.clone())];
    while let Some((uri, position)) = open.pop() {
        for root in project::roots(documents, &uri) {
            if !roots.insert(&root.uri) {
                continue;
            }
            let project = Project::within(root, documents, &uri);
            let symbols = &project.symbols;
            let Some(own) = symbols.declaration_at(project.offset(&position)) else {
                continue;
            };
            check(symbols, own)?;
            for range in symbols.occurrences(own) {
                let is_declaration = range == symbols.declarations[own].range;
                let location = project.location(range);
                let uri = location["uri"].as_str().unwrap_or_default().to_owned();
                if files.insert(uri.clone()) {
                    open.push((uri, location["range"]["start"].clone()));
                }
                if !found.iter().any(|(known, _)| *known == location) {
                    found.push((location, is_declaration));
                }
            }
        }
    }
    Ok(found)
}

/// Result of `textDocument/references`, in all files of the models.
pub fn references(
    documents: &BTreeMap<String, Document>,
    uri: &str,
    position: &Value,
    with_declaration: bool,
) -> Value {
    let found = everywhere(documents, uri, position, |_, _| Ok(())).unwrap_or_default();
    if found.is_empty() {
        return Value::Null;
    }
    let shown = found.into_iter().filter(|own| with_declaration || !own.1);
    shown.map(|(location, _)| location).collect()
}

/// Result of `textDocument/documentHighlight`.
pub fn highlights(documents: &BTreeMap<String, Document>, uri: &str, position: &Value) -> Value {
    let found = references(documents, uri, position, true);
    let own = found.as_array().into_iter().flatten();
    let own = own.filter(|location| location["uri"] == uri);
    own.map(|location| json!({ "range": location["range"] }))
        .collect()
}

/// Result of `textDocument/prepareRename`: the range of the name, `null` where nothing can be renamed.
pub fn renamed_range(project: &Project<'_>, position: &Value) -> Value {
    let (offset, symbols) = (project.offset(position), &project.symbols);
    match (symbols.declaration_at(offset), symbols.word_at(offset)) {
        (Some(_), Some(word)) => project.location(word.range.clone())["range"].take(),
        _ => Value::Null,
    }
}

/// Result of `textDocument/rename`, in all files of the models.
///
/// # Errors
/// Why the name cannot be changed so.
pub fn rename(
    documents: &BTreeMap<String, Document>,
    uri: &str,
    position: &Value,
    name: &str,
) -> Result<Value, String> {
    let refusal = |symbols: &Symbols, own| symbols.refusal(own, name).map_or(Ok(()), Err);
    let found = everywhere(documents, uri, position, refusal)?;
    if found.is_empty() {
        return Err("neither this file nor one of its model declares such a name".to_owned());
    }
    let mut changes: BTreeMap<String, Vec<Value>> = BTreeMap::new();
    for (location, _) in found {
        let uri = location["uri"].as_str().unwrap_or_default().to_owned();
        let edit = json!({ "range": location["range"], "newText": name });
        changes.entry(uri).or_default().push(edit);
    }
    Ok(json!({ "changes": changes }))
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
        SymbolKind::Solve => 19,
        _ => 13,
    }
}
