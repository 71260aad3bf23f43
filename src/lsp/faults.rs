//! Errors of a text, and the edits that carry out their hints.

use model_spec::diagnostic::{Diagnostic, Span};
use serde_json::{Value, json};

use super::document::{Analysis, Document};
use super::positions::Lines;
use super::uri;

/// Greatest number of errors that are published.
const MAX_FAULTS: usize = 200;

/// Parameters of `textDocument/publishDiagnostics`.
pub fn published(document: &Document) -> Value {
    let shown = Shown::of(document);
    let faults = shown.analysis.faults.iter().take(MAX_FAULTS);
    let faults: Vec<Value> = faults.map(|fault| shown.fault(fault)).collect();
    json!({ "uri": shown.document.uri, "version": shown.document.version, "diagnostics": faults })
}

/// Result of `textDocument/codeAction`: the edits for errors in a range.
pub fn actions(document: &Document, range: &Value) -> Value {
    let asked = document.lines.offsets(&document.text, range);
    let shown = Shown::of(document);
    let mut actions = Vec::new();
    for fault in &shown.analysis.faults {
        let own = fault.span.range();
        let is_near = own.start <= asked.end && asked.start <= own.end;
        let fix = fault
            .fix
            .as_ref()
            .filter(|fix| is_near && fix.span.source == 0);
        let Some(fix) = fix else { continue };
        let edit = json!({ "range": shown.range(fix.span), "newText": fix.text });
        let title = match (fix.span.range().is_empty(), fix.text.trim()) {
            (true, text) => format!("insert `{text}`"),
            (false, text) => format!("write `{text}`"),
        };
        actions.push(json!({
            "title": title,
            "kind": "quickfix",
            "isPreferred": true,
            "diagnostics": [shown.fault(fault)],
            "edit": { "changes": { shown.document.uri.as_str(): [edit] } },
        }));
    }
    Value::Array(actions)
}

struct Shown<'a> {
    document: &'a Document,
    analysis: &'a Analysis,
}

impl<'a> Shown<'a> {
    fn of(document: &'a Document) -> Shown<'a> {
        Shown {
            document,
            analysis: document.known(),
        }
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
        let is_own = fault.span.source == 0;
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
        let document = self.document;
        let location = match span.source {
            0 => json!({ "uri": document.uri, "range": self.range(span) }),
            other => {
                let source = self.analysis.sources.get(usize::from(other))?;
                let range = Lines::of(&source.text).range(&source.text, span.range());
                json!({ "uri": uri::of(&source.name), "range": range })
            }
        };
        Some(json!({ "location": location, "message": text }))
    }
}
