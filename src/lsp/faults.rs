//! Errors of a text, and the edits that carry out their hints.

use std::collections::BTreeMap;

use model_spec::diagnostic::{Diagnostic, Source, Span};
use serde_json::{Value, json};

use super::document::Document;
use super::positions::Lines;
use super::project::{self, is_same_file};
use super::uri;

/// Greatest number of errors that are published.
const MAX_FAULTS: usize = 200;

/// Parameters of `textDocument/publishDiagnostics`.
pub fn published(documents: &BTreeMap<String, Document>, uri: &str) -> Value {
    let mut faults: Vec<Value> = Vec::new();
    for shown in Shown::all(documents, uri) {
        for fault in shown.faults().take(MAX_FAULTS) {
            let fault = shown.fault(fault);
            // Models that include the file may have the same error.
            let is_same = |own: &Value| {
                ["range", "message"]
                    .iter()
                    .all(|key| own[key] == fault[key])
            };
            if !faults.iter().any(is_same) {
                faults.push(fault);
            }
        }
    }
    faults.truncate(MAX_FAULTS);
    json!({ "uri": uri, "version": documents[uri].version, "diagnostics": faults })
}

/// Result of `textDocument/codeAction`: the edits for errors in a range.
pub fn actions(documents: &BTreeMap<String, Document>, uri: &str, range: &Value) -> Value {
    let all = Shown::all(documents, uri);
    let mut actions: Vec<Value> = Vec::new();
    for action in all.iter().flat_map(|shown| shown.actions(range)) {
        if !actions.contains(&action) {
            actions.push(action);
        }
    }
    Value::Array(actions)
}

/// Errors of a model that are shown in one of its files.
struct Shown<'a> {
    document: &'a Document,
    /// The open text that includes the file, or the text itself.
    root: &'a Document,
    /// [`Span::source`] of the file.
    own: u16,
}

impl<'a> Shown<'a> {
    /// The text in each of the open models that it belongs to.
    fn all(documents: &'a BTreeMap<String, Document>, uri: &str) -> Vec<Shown<'a>> {
        let document = &documents[uri];
        let roots = project::roots(documents, uri).into_iter();
        let within = |root: &'a Document| {
            let mut sources = root.known().sources.iter();
            let is_own = |source: &Source| is_same_file(&source.name, &document.path);
            let own = sources.position(is_own).unwrap_or(0);
            Shown {
                document,
                root,
                own: u16::try_from(own).unwrap_or(u16::MAX),
            }
        };
        roots.map(within).collect()
    }

    /// The errors: of a file that is included those that lie in it.
    fn faults(&self) -> impl Iterator<Item = &'a Diagnostic> {
        let own = self.own;
        let all = self.root.known().faults.iter();
        all.filter(move |fault| own == 0 || fault.span.source == own)
    }

    fn actions(&self, range: &Value) -> Vec<Value> {
        let asked = self.document.lines.offsets(&self.document.text, range);
        let mut actions = Vec::new();
        for fault in self.faults() {
            let own = fault.span.range();
            let is_near = own.start <= asked.end && asked.start <= own.end;
            let fix = fault
                .fix
                .as_ref()
                .filter(|fix| is_near && fix.span.source == self.own);
            let Some(fix) = fix else { continue };
            let edit = json!({ "range": self.range(fix.span), "newText": fix.text });
            let title = match (fix.span.range().is_empty(), fix.text.trim()) {
                (true, text) => format!("insert `{text}`"),
                (false, text) => format!("write `{text}`"),
            };
            actions.push(json!({
                "title": title,
                "kind": "quickfix",
                "isPreferred": true,
                "diagnostics": [self.fault(fault)],
                "edit": { "changes": { self.document.uri.as_str(): [edit] } },
            }));
        }
        actions
    }

    fn range(&self, span: Span) -> Value {
        self.document.lines.range(&self.document.text, span.range())
    }

    fn fault(&self, fault: &Diagnostic) -> Value {
        let mut message = fault.message.clone();
        for note in &fault.notes {
            message += &format!("\nnote: {note}");
        }
        if let Some(help) = &fault.help {
            message += &format!("\nhelp: {help}");
        }
        let labels = fault.labels.iter().filter(|label| label.span != fault.span);
        let mut related: Vec<Value> = labels
            .filter_map(|label| self.related(label.span, &label.text))
            .collect();
        let is_own = fault.span.source == self.own;
        if !is_own {
            related.extend(self.related(fault.span, &fault.message));
        }
        json!({
            "range": self.range(if is_own { fault.span } else { Span::default() }),
            "severity": 1,
            "source": "hyzer",
            "code": fault.kind.slug(),
            "message": message,
            "relatedInformation": related,
        })
    }

    fn related(&self, span: Span, text: &str) -> Option<Value> {
        let location = if span.source == self.own {
            json!({ "uri": self.document.uri, "range": self.range(span) })
        } else {
            let source = self.root.known().sources.get(usize::from(span.source))?;
            let range = Lines::of(&source.text).range(&source.text, span.range());
            json!({ "uri": uri::of(&source.name), "range": range })
        };
        Some(json!({ "location": location, "message": text }))
    }
}
