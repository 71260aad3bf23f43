//! The files of one model: an open text with what it includes, or the open text that includes it.

use std::collections::{BTreeMap, BTreeSet};
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
    /// The first of the models to which a file belongs.
    pub fn of(documents: &'a BTreeMap<String, Document>, uri: &str) -> Project<'a> {
        let root = roots(documents, uri).into_iter().next();
        Project::within(root.unwrap_or(&documents[uri]), documents, uri)
    }

    /// The model of an open text, asked about a file of it.
    pub fn within(
        root: &'a Document,
        documents: &'a BTreeMap<String, Document>,
        uri: &str,
    ) -> Project<'a> {
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

/// Open texts whose models a file belongs to: those that include it and that none includes, else its own.
pub fn roots<'a>(documents: &'a BTreeMap<String, Document>, uri: &str) -> Vec<&'a Document> {
    let path = uri::path(uri);
    let includes = |path: &str| {
        let all = documents
            .values()
            .filter(|own| !is_same_file(&own.path, path));
        all.filter(|own| included(own).any(|other| is_same_file(other, path)))
            .collect()
    };
    let mut roots: Vec<&Document> = includes(&path);
    roots.retain(|root| includes(&root.path).is_empty());
    if roots.is_empty() {
        roots.extend(documents.get(uri));
    }
    roots
}

/// Open texts that are read together with a file: its roots, and what these include.
pub fn together(documents: &BTreeMap<String, Document>, uri: &str) -> BTreeSet<String> {
    let mut all = BTreeSet::from([uri.to_owned()]);
    for root in roots(documents, uri) {
        let is_part = |own: &&Document| included(root).any(|path| is_same_file(path, &own.path));
        all.extend(
            documents
                .values()
                .filter(is_part)
                .map(|own| own.uri.clone()),
        );
        all.insert(root.uri.clone());
    }
    all
}

/// Paths of the files that a text includes.
fn included(document: &Document) -> impl Iterator<Item = &str> {
    let sources = document.known().sources.iter().skip(1);
    sources.map(|source| source.name.as_str())
}

/// Whether two paths lead to one file.
pub fn is_same_file(a: &str, b: &str) -> bool {
    if a == b {
        return true;
    }
    let [a, b] = [a, b].map(|path| Path::new(path).canonicalize().ok());
    a.is_some() && a == b
}
