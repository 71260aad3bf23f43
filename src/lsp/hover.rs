//! What is shown about the word under the pointer.

use model_spec::model::Model;
use model_spec::symbols::{Declaration, SymbolKind, WordKind};
use model_spec::unit::symbol;
use serde_json::{Value, json};

use super::document::Document;
use super::facts::{self, Facts};
use super::words;

/// Longest statement that is shown, lines.
const MAX_LINES: usize = 6;

/// Result of `textDocument/hover`.
pub fn hover(document: &Document, position: &Value) -> Value {
    let offset = document.lines.offset(&document.text, position);
    let symbols = &document.known().symbols;
    let Some(word) = symbols.word_at(offset) else {
        return Value::Null;
    };
    let text = document.text.get(word.range.clone()).unwrap_or_default();
    let shown = match word.kind {
        WordKind::Declaration(own) | WordKind::Reference(own) => {
            let declaration = &symbols.declarations[own];
            let behind = document.text.get(word.range.end..).unwrap_or_default();
            let element = element(declaration, behind);
            Some(of_declaration(document, declaration, element.as_deref()))
        }
        WordKind::Keyword => of_word(text, true),
        WordKind::BuiltIn => of_word(text, false),
        WordKind::Unit => of_unit(text),
        WordKind::Unknown => document.model().and_then(|model| of_other(model, text)),
    };
    match shown {
        Some(text) => json!({
            "contents": { "kind": "markdown", "value": text },
            "range": document.lines.range(&document.text, word.range.clone()),
        }),
        None => Value::Null,
    }
}

/// What the model of a document says about a name that it declares.
pub fn facts_of(model: &Model, declaration: &Declaration) -> Option<Facts> {
    let name = declaration.name.as_str();
    if declaration.scope.start > 0 {
        return None;
    }
    match declaration.kind {
        SymbolKind::Frame => facts::of_frame(model, name),
        SymbolKind::Table => facts::of_table(model, name),
        SymbolKind::Force => facts::of_load(model, name, false),
        SymbolKind::Moment => facts::of_load(model, name, true),
        SymbolKind::Index | SymbolKind::Argument | SymbolKind::Function => None,
        _ if declaration.is_array => facts::of_array(model, name),
        _ => facts::of_value(model, name),
    }
}

/// Name of the element of an array that is written with these characters behind the name: `v_1_2` of `[1, 2]`.
fn element(declaration: &Declaration, behind: &str) -> Option<String> {
    let (indices, _) = behind.trim_start().strip_prefix('[')?.split_once(']')?;
    let mut name = declaration.name.clone();
    for index in indices.split(',') {
        name += &format!("_{}", index.trim().parse::<u32>().ok()?);
    }
    declaration.is_array.then_some(name)
}

fn complete_facts(model: &Model, declaration: &Declaration) -> Option<Facts> {
    let mut facts = facts_of(model, declaration)?;
    let is_value = matches!(
        declaration.kind,
        SymbolKind::Quantity
            | SymbolKind::Parameter
            | SymbolKind::Coefficient
            | SymbolKind::State
            | SymbolKind::Observation
    );
    if is_value && declaration.is_array {
        facts::complete_array(model, &declaration.name, &mut facts);
    } else if is_value {
        facts::complete(model, &declaration.name, &mut facts);
    }
    Some(facts)
}

fn facts_of_element(model: &Model, name: &str) -> Option<Facts> {
    let mut facts = facts::of_value(model, name)?;
    facts::complete(model, name, &mut facts);
    Some(facts)
}

fn of_declaration(document: &Document, declaration: &Declaration, element: Option<&str>) -> String {
    let statement = document
        .text
        .get(declaration.statement.clone())
        .unwrap_or_default();
    let mut lines: Vec<&str> = statement.lines().take(MAX_LINES).collect();
    if statement.lines().count() > MAX_LINES {
        lines.push("…");
    }
    let mut shown = format!("```hyz\n{}\n```\n", lines.join("\n"));
    let mut line = declaration.kind.noun().to_owned();
    let facts = document.model().and_then(|model| {
        let of_element = element.and_then(|name| facts_of_element(model, name));
        of_element.or_else(|| complete_facts(model, declaration))
    });
    let facts = facts.unwrap_or_default();
    match facts.of.as_str() {
        "" => {}
        "1" => line += ", a pure number",
        of => line += &format!(", {of}"),
    }
    if !facts.value.is_empty() {
        line += &format!(": {}", facts.value);
    }
    shown += &line;
    for part in [&declaration.doc, &facts.formula] {
        if !part.is_empty() {
            shown += &format!("\n\n{part}");
        }
    }
    shown
}

fn of_word(word: &str, is_keyword: bool) -> Option<String> {
    let (_, form, meaning) = words::find(word, is_keyword)?;
    Some(format!("```hyz\n{form}\n```\n{meaning}"))
}

fn of_unit(text: &str) -> Option<String> {
    let found = symbol::find(text)?;
    let unit = found.unit.tidy().to_string();
    let of = found.unit.quantity().map_or("", |(one, _)| one);
    let mut shown = "unit".to_owned();
    if !of.is_empty() {
        shown += &format!(" of {of}");
    }
    if unit != text {
        shown += &format!(": 1 {text} = {}", facts::with_unit(found.factor, &unit));
    }
    Some(shown)
}

/// A name that the text does not declare, of the model that an effect is for.
fn of_other(model: &Model, name: &str) -> Option<String> {
    let mut facts = facts::of_value(model, name).or_else(|| facts::of_frame(model, name))?;
    facts::complete(model, name, &mut facts);
    let parts = [facts.of, facts.value, facts.formula];
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    Some(format!(
        "of the model `{}`\n\n{}",
        model.name,
        parts.join("\n\n")
    ))
}
