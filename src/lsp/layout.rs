//! What is drawn into a text: its format, units behind names, and colours by meaning.

use model_spec::model::Model;
use model_spec::symbols::{Declaration, SymbolKind, WordKind};
use serde_json::{Value, json};

use super::document::Document;
use super::hover::facts_of;

/// Result of `textDocument/formatting`; `null` while the text has errors of grammar.
pub fn formatting(document: &Document) -> Value {
    let Ok(formatted) = model_spec::format(&document.path, &document.text) else {
        return Value::Null;
    };
    if formatted == document.text {
        return json!([]);
    }
    let whole = document.lines.range(&document.text, 0..document.text.len());
    json!([{ "range": whole, "newText": formatted }])
}

/// Result of `textDocument/inlayHint`: units and frames of named quantities that state none, and behind each statement
/// how many operations it costs.
pub fn hints(document: &Document, range: &Value) -> Value {
    let shown = document.lines.offsets(&document.text, range);
    let Some(model) = document.model() else {
        return json!([]);
    };
    let declarations = document.known().symbols.declarations.iter();
    let is_near = |own: &&Declaration| {
        own.range.end >= shown.start && own.range.start <= shown.end && own.scope.start == 0
    };
    let near: Vec<&Declaration> = declarations.filter(is_near).collect();
    let costs = near.iter().filter_map(|own| cost(document, model, own));
    let units = near.iter().filter_map(|own| {
        if own.kind != SymbolKind::Quantity {
            return None;
        }
        let rest = document.text.get(own.range.end..own.statement.end)?;
        let (head, _) = rest.split_once('=')?;
        let of = facts_of(model, own)?.of;
        if head.contains(':') || of == "1" || of.is_empty() {
            return None;
        }
        let end = own.range.end + head.trim_end().len();
        let (line, character) = document.lines.place(&document.text, end);
        let position = json!({ "line": line, "character": character });
        Some(json!({ "position": position, "label": format!(": {of}"), "kind": 1 }))
    });
    units.chain(costs).collect()
}

/// Number of operations of a quantity or unknown, behind its statement.
fn cost(document: &Document, model: &Model, own: &Declaration) -> Option<Value> {
    if own.is_array || !matches!(own.kind, SymbolKind::Quantity | SymbolKind::Unknown) {
        return None;
    }
    let index = model
        .aux_variables
        .iter()
        .rposition(|it| it.name == own.name)?;
    let count = *document.operations().get(index)?;
    let (line, character) = document.lines.place(&document.text, own.statement.end);
    let tooltip = "operations in compiled code, with those of the quantities that it uses";
    Some(json!({
        "position": { "line": line, "character": character },
        "label": if count == 1 { "1 operation".to_owned() } else { format!("{count} operations") },
        "paddingLeft": true,
        "tooltip": tooltip,
    }))
}

/// Types of semantic tokens, by index.
pub const TOKEN_TYPES: [&str; 7] = [
    "keyword",
    "function",
    "type",
    "variable",
    "parameter",
    "property",
    "namespace",
];

/// Result of `textDocument/semanticTokens/full`.
pub fn colours(document: &Document) -> Value {
    let symbols = &document.known().symbols;
    let mut data: Vec<usize> = Vec::with_capacity(5 * symbols.words.len());
    let (mut last_line, mut last_start) = (0, 0);
    for word in &symbols.words {
        let kind = match word.kind {
            WordKind::Keyword => 0,
            WordKind::BuiltIn => 1,
            WordKind::Unit => 2,
            WordKind::Unknown => continue,
            WordKind::Declaration(own) | WordKind::Reference(own) => {
                match symbols.declarations[own].kind {
                    SymbolKind::Table | SymbolKind::Function => 1,
                    SymbolKind::Coefficient => 4,
                    SymbolKind::State | SymbolKind::Input => 5,
                    SymbolKind::Frame => 6,
                    _ => 3,
                }
            }
        };
        let (line, start) = document.lines.place(&document.text, word.range.start);
        let (_, end) = document.lines.place(&document.text, word.range.end);
        let from = if line == last_line { last_start } else { 0 };
        data.extend([line - last_line, start - from, end - start, kind, 0]);
        (last_line, last_start) = (line, start);
    }
    json!({ "data": data })
}
