//! Server of the language server protocol, which tells an editor what it needs to know of models and effects.
//!
//! It answers one message after another. Errors of a text are published when no further message waits, so that typing is
//! never behind.

mod completion;
mod computed;
mod document;
mod facts;
mod faults;
mod hover;
mod includes;
mod layout;
mod names;
mod positions;
mod project;
mod transport;
mod uri;
mod words;

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, BufReader, Read, Write};
use std::path::Path;

use document::Document;
use project::{Project, is_same_file};
use serde_json::{Value, json};
use transport::Incoming;

/// Greatest number of open texts.
const MAX_DOCUMENTS: usize = 1000;

const PARSE_ERROR: i32 = -32700;
const INVALID_REQUEST: i32 = -32600;
const METHOD_NOT_FOUND: i32 = -32601;
const NOT_INITIALIZED: i32 = -32002;
const REQUEST_FAILED: i32 = -32803;

/// Serves one client until it says `exit` or its messages end; returns whether it said `shutdown` before.
///
/// # Errors
/// If a message cannot be read or written.
pub fn serve(input: impl Read, output: &mut impl Write) -> io::Result<bool> {
    let mut input = BufReader::new(input);
    let mut server = Server::default();
    while let Some(incoming) = transport::read(&mut input)? {
        let answers = match incoming {
            Incoming::Message(message) => server.receive(&message),
            Incoming::Faulty(reason) => vec![failure(&Value::Null, PARSE_ERROR, &reason)],
        };
        for answer in answers {
            transport::write(output, &answer)?;
        }
        if server.state == State::Ended {
            return Ok(server.said_shutdown);
        }
        if input.buffer().is_empty() {
            for notice in server.notices() {
                transport::write(output, &notice)?;
            }
        }
    }
    Ok(server.said_shutdown)
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum State {
    #[default]
    New,
    Running,
    ShutDown,
    Ended,
}

#[derive(Default)]
struct Server {
    state: State,
    said_shutdown: bool,
    documents: BTreeMap<String, Document>,
    /// URIs of the texts that have changed, whose errors are to be published.
    changed: BTreeSet<String>,
    /// URIs of the texts whose errors may have changed with them.
    touched: BTreeSet<String>,
    /// Errors that were published last, by URI.
    published: BTreeMap<String, Value>,
}

impl Server {
    /// Handles a message; returns what is answered.
    fn receive(&mut self, message: &Value) -> Vec<Value> {
        let Some(method) = message["method"].as_str() else {
            // An answer to a request of the server, of which there are none.
            let is_answer = message.get("result").or(message.get("error")).is_some();
            let is_request = !message["id"].is_null() && !is_answer;
            let reason = "the message has no method";
            let fault = || failure(&message["id"], INVALID_REQUEST, reason);
            return is_request.then(fault).into_iter().collect();
        };
        let (id, parameters) = (&message["id"], &message["params"]);
        if id.is_null() {
            return self.notified(method, parameters);
        }
        let result = match (method, self.state) {
            ("initialize", State::New) => {
                self.state = State::Running;
                Ok(capabilities())
            }
            (_, State::New) => Err((NOT_INITIALIZED, "`initialize` comes first".to_owned())),
            ("shutdown", State::Running) => {
                (self.state, self.said_shutdown) = (State::ShutDown, true);
                Ok(Value::Null)
            }
            (_, State::Running) if method != "initialize" => self.asked(method, parameters),
            _ => Err((INVALID_REQUEST, format!("`{method}` cannot be asked now"))),
        };
        vec![match result {
            Ok(result) => json!({ "jsonrpc": "2.0", "id": id, "result": result }),
            Err((code, reason)) => failure(id, code, &reason),
        }]
    }

    fn notified(&mut self, method: &str, parameters: &Value) -> Vec<Value> {
        if method == "exit" {
            self.state = State::Ended;
            return Vec::new();
        }
        if self.state != State::Running {
            return Vec::new();
        }
        let own = &parameters["textDocument"];
        let Some(uri) = own["uri"].as_str() else {
            return Vec::new();
        };
        match method {
            "textDocument/didOpen" if self.documents.len() < MAX_DOCUMENTS => {
                let text = own["text"].as_str().unwrap_or_default();
                let document = Document::new(uri, own["version"].clone(), text);
                self.documents.insert(uri.to_owned(), document);
                self.publish_later(uri);
            }
            "textDocument/didChange" => {
                let Some(document) = self.documents.get_mut(uri) else {
                    return Vec::new();
                };
                document.version = own["version"].clone();
                let changes = parameters["contentChanges"].as_array();
                for change in changes.into_iter().flatten() {
                    document.change(change);
                }
                self.publish_later(uri);
            }
            // A file that others include may have changed.
            "textDocument/didSave" => {
                self.documents.values_mut().for_each(Document::forget);
                self.changed.extend(self.documents.keys().cloned());
            }
            "textDocument/didClose" => {
                self.publish_later(uri);
                self.documents.remove(uri);
                self.published.remove(uri);
                return vec![published(json!({ "uri": uri, "diagnostics": [] }))];
            }
            _ => {}
        }
        Vec::new()
    }

    /// States that a text has changed, and with it those that are read together with it.
    fn publish_later(&mut self, uri: &str) {
        self.changed.insert(uri.to_owned());
        let together = project::together(&self.documents, uri);
        for other in &together {
            if let Some(document) = self.documents.get_mut(other) {
                document.forget();
            }
        }
        self.touched.extend(together);
    }

    /// Finds out what is not known yet about some texts.
    fn analyse(&mut self, uris: &BTreeSet<String>) {
        for uri in uris {
            let all = &self.documents;
            let open = |path: &Path| {
                let path = path.to_string_lossy();
                let mut open = all.values().filter(|own| is_same_file(&own.path, &path));
                open.next().map(|own| own.text.clone())
            };
            let found = all.get(uri).filter(|own| own.is_stale());
            let found = found.map(|own| own.check(&open));
            if let (Some(found), Some(document)) = (found, self.documents.get_mut(uri)) {
                document.learn(found);
            }
        }
    }

    /// Errors of the texts that have changed, and of others if they differ from those published before.
    fn notices(&mut self) -> Vec<Value> {
        let changed = std::mem::take(&mut self.changed);
        let mut touched = std::mem::take(&mut self.touched);
        touched.extend(changed.iter().cloned());
        self.analyse(&touched);
        // What is included now is read with the text that includes it.
        let now = changed.iter();
        let now = now.flat_map(|uri| project::together(&self.documents, uri));
        touched.extend(now);
        touched.retain(|uri| self.documents.contains_key(uri));
        self.analyse(&touched);
        let mut notices = Vec::new();
        for uri in touched {
            let own = faults::published(&self.documents, &uri);
            let before = self
                .published
                .insert(uri.clone(), own["diagnostics"].clone());
            if changed.contains(&uri) || before.as_ref() != Some(&own["diagnostics"]) {
                notices.push(published(own));
            }
        }
        notices
    }

    fn asked(&mut self, method: &str, parameters: &Value) -> Result<Value, (i32, String)> {
        let uri = parameters["textDocument"]["uri"]
            .as_str()
            .unwrap_or_default();
        let is_of_text = method.starts_with("textDocument/");
        if !is_of_text || !self.documents.contains_key(uri) {
            return Err(if is_of_text {
                (REQUEST_FAILED, format!("`{uri}` is not open"))
            } else {
                (METHOD_NOT_FOUND, format!("there is no method `{method}`"))
            });
        }
        self.analyse(&project::together(&self.documents, uri));
        let position = &parameters["position"];
        let (all, document) = (&self.documents, &self.documents[uri]);
        let project = || Project::of(all, uri);
        Ok(match method {
            "textDocument/hover" => hover::hover(document, position),
            "textDocument/definition" => names::definition(document, &project(), position),
            "textDocument/references" => {
                let declaration = &parameters["context"]["includeDeclaration"];
                names::references(all, uri, position, declaration.as_bool().unwrap_or(true))
            }
            "textDocument/documentHighlight" => names::highlights(all, uri, position),
            "textDocument/prepareRename" => names::renamed_range(&project(), position),
            "textDocument/rename" => {
                let name = parameters["newName"].as_str().unwrap_or_default();
                return names::rename(all, uri, position, name)
                    .map_err(|reason| (REQUEST_FAILED, reason));
            }
            "textDocument/documentSymbol" => names::outline(document),
            "textDocument/completion" => completion::complete(document, &project(), position),
            "textDocument/codeAction" => faults::actions(all, uri, &parameters["range"]),
            "textDocument/formatting" => layout::formatting(document),
            "textDocument/inlayHint" => layout::hints(document, &parameters["range"]),
            "textDocument/semanticTokens/full" => layout::colours(document),
            _ => return Err((METHOD_NOT_FOUND, format!("there is no method `{method}`"))),
        })
    }
}

fn published(parameters: Value) -> Value {
    json!({ "jsonrpc": "2.0", "method": "textDocument/publishDiagnostics", "params": parameters })
}

fn failure(id: &Value, code: i32, reason: &str) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "error": { "code": code, "message": reason } })
}

fn capabilities() -> Value {
    json!({
        "capabilities": {
            "positionEncoding": "utf-16",
            "textDocumentSync": { "openClose": true, "change": 2, "save": true },
            "hoverProvider": true,
            "definitionProvider": true,
            "referencesProvider": true,
            "documentHighlightProvider": true,
            "renameProvider": { "prepareProvider": true },
            "documentSymbolProvider": true,
            "completionProvider": { "triggerCharacters": [" ", ":", "["] },
            "codeActionProvider": { "codeActionKinds": ["quickfix"] },
            "documentFormattingProvider": true,
            "inlayHintProvider": true,
            "semanticTokensProvider": {
                "legend": { "tokenTypes": layout::TOKEN_TYPES, "tokenModifiers": [] },
                "full": true,
            },
        },
        "serverInfo": { "name": "hyzer", "version": env!("CARGO_PKG_VERSION") },
    })
}
