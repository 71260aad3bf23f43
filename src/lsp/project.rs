//! The files of one model: an open text with what it includes, or the open text that includes it.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use model_spec::model::Model;
use model_spec::symbols::Symbols;
use model_spec::syntax::MAX_SOURCE_BYTES;
use serde_json::{Value, json};

use super::document::Document;
use super::positions::Lines;
use super::uri;

/// Greatest length of all files of a model, bytes, whose names are found.
const MAX_BYTES: usize = 4 * MAX_SOURCE_BYTES;

/// A file of a model.
struct Part {
    uri: String,
    text: String,
    lines: Lines,
    /// Where it begins in the text of the whole model.
    start: usize,
}

/// Files of one model and the names of all of them, found as if they were one text.
pub struct Project<'a> {
    parts: Vec<Part>,
    /// Index of the file that is asked about.
    own: usize,
    /// Names of the text of all files, one after another.
    pub symbols: Symbols,
    /// Model of the file that includes the others, if its last text had one.
    pub model: Option<&'a Model>,
}

impl<'a> Project<'a> {
    /// The model to which an open text belongs.
    pub fn of(documents: &'a BTreeMap<String, Document>, uri: &str) -> Project<'a> {
        let asked = &documents[uri];
        let includes =
            |other: &&Document| included(other).any(|path| is_same_file(path, &asked.path));
        let root = documents.values().find(includes).unwrap_or(asked);
        let mut texts = vec![(root.uri.clone(), root.text.clone())];
        for source in root.known().sources.iter().skip(1) {
            if !Path::new(&source.name).is_file() {
                continue;
            }
            // What is open counts, saved or not.
            let mut open = documents.values();
            let open = open.find(|own| is_same_file(&source.name, &own.path));
            texts.push(match open {
                Some(own) => (own.uri.clone(), own.text.clone()),
                None => (uri::of(&source.name), source.text.clone()),
            });
        }
        let (mut parts, mut whole) = (Vec::new(), String::new());
        for (uri, text) in texts {
            let start = whole.len();
            whole += &text;
            whole.push('\n');
            parts.push(Part {
                lines: Lines::of(&text),
                uri,
                text,
                start,
            });
        }
        Project {
            own: parts.iter().position(|part| part.uri == uri).unwrap_or(0),
            symbols: match whole.len() {
                0..=MAX_BYTES => Symbols::of(&whole),
                _ => Symbols::default(),
            },
            model: root.model(),
            parts,
        }
    }

    /// Offset in the whole of a position in the file that is asked about.
    pub fn offset(&self, position: &Value) -> usize {
        let own = &self.parts[self.own];
        own.start + own.lines.offset(&own.text, position)
    }

    /// The text at a range of the whole.
    pub fn text(&self, range: Range<usize>) -> Option<&str> {
        let part = self.part(&range);
        part.text
            .get(range.start - part.start..range.end - part.start)
    }

    /// File and range of a range of the whole.
    pub fn location(&self, range: Range<usize>) -> Value {
        let part = self.part(&range);
        let within = range.start - part.start..range.end - part.start;
        json!({ "uri": part.uri, "range": part.lines.range(&part.text, within) })
    }

    fn part(&self, range: &Range<usize>) -> &Part {
        let behind = self.parts.partition_point(|part| part.start <= range.start);
        &self.parts[behind.saturating_sub(1)]
    }
}

/// Paths of the files that a text includes.
fn included(document: &Document) -> impl Iterator<Item = &str> {
    let sources = document.known().sources.iter().skip(1);
    sources.map(|source| source.name.as_str())
}

fn is_same_file(a: &str, b: &str) -> bool {
    if a == b {
        return true;
    }
    let [a, b] = [a, b].map(|path| Path::new(path).canonicalize().ok());
    a.is_some() && a == b
}
