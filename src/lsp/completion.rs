//! Names, words and units that may stand at a place.

use model_spec::symbols::{BodyQuantity, Declaration, SymbolKind};
use model_spec::syntax::words::{BLOCKS, statements_of};
use model_spec::unit::symbol;
use serde_json::{Value, json};

use super::document::Document;
use super::facts;
use super::hover::facts_of;
use super::includes;
use super::project::Project;
use super::words::{Word, built_in, find, inner, statements};

/// Units that are offered besides all symbols without a prefix.
const COMPOUND: [&str; 18] = [
    "kg", "mm", "cm", "km", "ms", "m/s", "m/s^2", "rad/s", "kg*m^2", "kg/m^3", "N*m", "N*m*s",
    "m^2", "km/h", "/s", "/rad", "/rad^2", "mN",
];

/// What may stand at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    Nothing,
    Statement,
    Unit,
    /// Behind a colon: a unit, or `vector`.
    Type,
    Frame,
    /// Behind the frame that another is turned from.
    Turn,
    /// Behind `by`, of a frame.
    Quaternion,
    /// What a case sets.
    Given,
    /// What a case expects.
    Computed,
    /// Number of a component or an axis.
    Part,
    /// Name of a load.
    Load,
    Expression,
}

/// Result of `textDocument/completion`.
pub fn complete(document: &Document, project: &Project<'_>, position: &Value) -> Value {
    let offset = document.lines.offset(&document.text, position);
    if let Some(files) = includes::files(document, offset) {
        return files;
    }
    let at = project.offset(position);
    let before = &document.text[..offset];
    let is_of_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\u{307}' | '\u{308}');
    let before = before.trim_end_matches(is_of_word);
    let of_kinds = |kinds: &[SymbolKind]| names(project, at, |kind| kinds.contains(&kind));
    let of_expression = || {
        let names = names(project, at, |kind| !is_heading(kind));
        [names, of_bodies(project), words(&built_in(), 3)].concat()
    };
    let items = match place(before) {
        Place::Nothing => Vec::new(),
        Place::Statement => {
            let block = block(before);
            let inside = statements_of(block);
            let mut own = statements();
            own.retain(|(word, ..)| inside.contains(word));
            let mut items = words(&own, 14);
            if block == "solve" {
                // An equation begins with any name.
                items.extend(of_expression());
            }
            items
        }
        Place::Unit => units(),
        Place::Type => {
            let vector = words(&[("vector", "vector UNIT in FRAME", "a vector")], 14);
            [vector, units()].concat()
        }
        Place::Frame => of_kinds(&[SymbolKind::Frame]),
        Place::Turn => keywords(&["turned", "by"]),
        Place::Quaternion => keywords(&["quaternion"]),
        Place::Given => of_kinds(&GIVEN),
        Place::Computed => {
            let names = of_kinds(&[SymbolKind::Quantity, SymbolKind::Unknown]);
            [names, keywords(&["der"])].concat()
        }
        Place::Part => {
            let part = |part| json!({ "label": part, "kind": 5 });
            ["1", "2", "3"].map(part).into()
        }
        Place::Load => of_kinds(&[SymbolKind::Force, SymbolKind::Moment]),
        Place::Expression => {
            let frames = changes_of_frame(project, at);
            let mut items = [of_expression(), frames, words(&inner(), 14)].concat();
            items.retain(|own| own["label"] != "in_");
            items
        }
    };
    Value::Array(items)
}

/// What a case sets.
const GIVEN: [SymbolKind; 5] = [
    SymbolKind::Parameter,
    SymbolKind::Coefficient,
    SymbolKind::Input,
    SymbolKind::State,
    SymbolKind::Marker,
];

fn words(words: &[Word], kind: u8) -> Vec<Value> {
    let item = |(word, form, doc): &Word| json!({ "label": word, "kind": kind, "detail": form, "documentation": doc });
    words.iter().map(item).collect()
}

fn keywords(wanted: &[&str]) -> Vec<Value> {
    let found: Vec<Word> = { wanted.iter() }
        .filter_map(|word| find(word, true))
        .collect();
    words(&found, 14)
}

/// `in_B` for each frame `B`.
fn changes_of_frame(project: &Project<'_>, at: usize) -> Vec<Value> {
    let Some((prefix, _, meaning)) = find("in_", true) else {
        return Vec::new();
    };
    let mut frames = names(project, at, |kind| kind == SymbolKind::Frame);
    for own in &mut frames {
        let name = format!("{prefix}{}", own["label"].as_str().unwrap_or_default());
        *own = json!({ "label": name, "kind": 3, "detail": format!("{name}(VECTOR)"), "documentation": meaning });
    }
    frames
}

/// What may stand behind a text that ends before a word.
fn place(before: &str) -> Place {
    let line = before.rsplit('\n').next().unwrap_or_default();
    if line.contains("//") || line.matches('"').count() % 2 == 1 {
        return Place::Nothing;
    }
    let is_spaced = before.ends_with(char::is_whitespace);
    let code = last_code(before);
    let Some(last) = code.chars().next_back() else {
        return Place::Statement;
    };
    let statement = code.rsplit([';', '{', '}']).next().unwrap_or_default();
    let word = |text: &str| -> String {
        let word = text
            .rsplit(|c: char| !c.is_alphanumeric() && c != '_')
            .next();
        word.unwrap_or_default().to_owned()
    };
    let last_word = word(code);
    let is_number = last_word.starts_with(|c: char| c.is_ascii_digit());
    let open = statement
        .rfind('[')
        .filter(|at| !statement[*at..].contains(']'));
    if let Some(open) = open {
        let before = word(statement[..open].trim_end());
        let of_number = before.starts_with(|c: char| c.is_ascii_digit()) || before.is_empty();
        return if of_number {
            Place::Unit
        } else {
            Place::Expression
        };
    }
    if let Some(place) = place_in(statement, before) {
        return place;
    }
    match last {
        '.' => {
            let of = word(code.trim_end_matches('.'));
            let is_number = of.starts_with(|c: char| c.is_ascii_digit());
            if is_number || code.ends_with("..") {
                Place::Nothing
            } else {
                Place::Part
            }
        }
        ';' | '}' => Place::Statement,
        '{' if !code.trim_end_matches('{').trim_end().ends_with('=') => Place::Statement,
        ':' => Place::Type,
        _ if last_word == "in" && !is_number => {
            let is_bound = word(code.trim_end_matches("in").trim_end());
            let is_bound = is_bound.starts_with(|c: char| c.is_ascii_digit());
            if is_bound {
                Place::Nothing
            } else {
                Place::Frame
            }
        }
        '=' if line.trim_start().starts_with("frame ") => Place::Frame,
        _ if is_number && is_spaced => Place::Unit,
        _ => Place::Expression,
    }
}

/// What may stand behind the words of a statement; `None` if they do not tell it.
fn place_in(statement: &str, before: &str) -> Option<Place> {
    // Statements above may lack their end.
    let line = statement.rsplit('\n').next().unwrap_or_default();
    let words: Vec<&str> = line.split_whitespace().collect();
    let is_spaced = before.ends_with(char::is_whitespace);
    match words[..] {
        ["frame", _, "=", _] if is_spaced => Some(Place::Turn),
        ["frame", _, "=", _, "by"] => Some(Place::Quaternion),
        ["replace", "force" | "moment"] => Some(Place::Load),
        ["set"] if block(before) == "check" => Some(Place::Given),
        ["expect"] if block(before) == "check" => Some(Place::Computed),
        _ => None,
    }
}

/// The text without white space and comments at its end.
fn last_code(before: &str) -> &str {
    let mut code = before.trim_end();
    loop {
        let start = code.rfind('\n').map_or(0, |end| end + 1);
        match code[start..].find("//") {
            Some(comment) => code = code[..start + comment].trim_end(),
            None => return code,
        }
        if code.is_empty() {
            return code;
        }
    }
}

fn units() -> Vec<Value> {
    let listed = symbol::listed();
    let symbols = listed
        .split([',', ' '])
        .filter(|word| symbol::find(word).is_some());
    let all = COMPOUND.into_iter().chain(symbols);
    all.map(|unit| json!({ "label": unit, "kind": 11 }))
        .collect()
}

/// Whether a declaration names no value and no frame, so that expressions cannot name it.
fn is_heading(kind: SymbolKind) -> bool {
    let headings = [
        SymbolKind::Force,
        SymbolKind::Moment,
        SymbolKind::Model,
        SymbolKind::Body,
        SymbolKind::Effect,
        SymbolKind::Observation,
        SymbolKind::Solve,
    ];
    headings.contains(&kind)
}

/// Word that begins the innermost block in which a text ends; empty outside of blocks.
fn block(before: &str) -> &str {
    let mut open = 0_usize;
    for (at, sign) in before.rmatch_indices(['{', '}']) {
        match (sign, open) {
            ("}", _) => open += 1,
            (_, 0) => {
                let head = before[..at].rsplit([';', '{', '}']).next();
                let lines = head.unwrap_or_default().lines();
                // Statements above may lack their end.
                let mut first = lines
                    .rev()
                    .filter_map(|line| line.split_whitespace().next());
                let is_block = |word: &&str| BLOCKS.iter().any(|own| own.word == *word);
                return first.find(is_block).unwrap_or_default();
            }
            _ => open -= 1,
        }
    }
    ""
}

fn names(project: &Project<'_>, at: usize, is_wanted: impl Fn(SymbolKind) -> bool) -> Vec<Value> {
    let known = project.symbols.known_at(at);
    let known = known.filter(|own| is_wanted(own.kind));
    let mut shown: Vec<Value> = Vec::new();
    for own in known.map(|own| item(project, own)) {
        // Frames may be turned by a state that is declared elsewhere.
        let is_same =
            |other: &Value| other["label"] == own["label"] && other["kind"] == own["kind"];
        if !shown.iter().any(is_same) {
            shown.push(own);
        }
    }
    shown
}

/// Quantities of each body that its model has by the name of the body.
fn of_bodies(project: &Project<'_>) -> Vec<Value> {
    let Some(model) = project.model else {
        return Vec::new();
    };
    let declarations = project.symbols.declarations.iter();
    let bodies = declarations.filter(|own| own.kind == SymbolKind::Body);
    let all = bodies.flat_map(|body| {
        BodyQuantity::ALL.iter().filter_map(|quantity| {
            let (name, doc) = (quantity.of(&body.name), quantity.meaning());
            let facts = facts::of_value(model, &name)?;
            Some(json!({ "label": name, "kind": 6, "detail": facts.of, "documentation": doc }))
        })
    });
    all.collect()
}

fn item(project: &Project<'_>, own: &Declaration) -> Value {
    let facts = project.model.and_then(|model| facts_of(model, own));
    let facts = facts.unwrap_or_default();
    let parts = [own.kind.noun(), &facts.of, &facts.value];
    let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    let kind = match own.kind {
        SymbolKind::Table | SymbolKind::Function => 3,
        SymbolKind::Parameter | SymbolKind::Coefficient => 21,
        SymbolKind::Frame => 22,
        _ => 6,
    };
    let label = project.text(own.range.clone());
    json!({ "label": label, "kind": kind, "detail": parts.join(", "), "documentation": own.doc })
}
