//! The language server as an editor runs it: `hyzer lsp` with messages through its pipes.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use model_spec::model::Function;
use model_spec::symbols::INNER;
use model_spec::syntax::words::statements_of;
use serde_json::{Value, json};

use crate::support::hyzer;

/// Time within which an answer must come.
pub const PATIENCE: Duration = Duration::from_secs(30);

/// Time without an answer after which none is expected, where transcripts are written.
const SILENCE: Duration = Duration::from_millis(300);

/// A running server.
pub struct Server {
    child: Child,
    input: Option<ChildStdin>,
    answers: Receiver<Value>,
}

impl Server {
    /// A server that knows nothing of its client.
    fn new() -> Self {
        let mut command = hyzer();
        command.args(["lsp", "--stdio"]);
        let pipes = command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = pipes.stderr(Stdio::piped()).spawn().expect("it runs");
        let mut output = BufReader::new(child.stdout.take().expect("a pipe"));
        let (sender, answers) = channel();
        std::thread::spawn(move || {
            while let Some(answer) = next_message(&mut output) {
                if sender.send(answer).is_err() {
                    return;
                }
            }
        });
        Self {
            input: child.stdin.take(),
            child,
            answers,
        }
    }

    /// A server with an open text.
    pub fn with_text(uri: &str, text: &str) -> Self {
        let mut server = Self::new();
        server.asked("initialize", &json!({}));
        let own = json!({ "uri": uri, "version": 1, "text": text });
        server
            .send(&json!({ "method": "textDocument/didOpen", "params": { "textDocument": own } }));
        server.answer(PATIENCE).expect("the errors of the text");
        server
    }

    fn write(&mut self, text: &str) {
        let pipe = self.input.as_mut().expect("a pipe");
        // A server that has ended reads nothing more.
        let _ = pipe.write_all(text.as_bytes());
    }

    pub fn send(&mut self, message: &Value) {
        self.write(&framed(&message.to_string()));
    }

    pub fn answer(&self, patience: Duration) -> Option<Value> {
        self.answers.recv_timeout(patience).ok()
    }

    /// Answer to a request.
    pub fn asked(&mut self, method: &str, parameters: &Value) -> Value {
        self.send(&json!({ "id": method, "method": method, "params": parameters }));
        let answer = self.answer(PATIENCE).expect("an answer");
        assert_eq!(answer["id"], method);
        answer
    }

    /// A line of what the system says of the process, by the file and the word that the line begins with; `None` where
    /// there is no such file.
    pub fn process(&self, file: &str, word: &str) -> Option<String> {
        let path = format!("/proc/{}/{file}", self.child.id());
        let text = fs::read_to_string(path).ok()?;
        let line = text.lines().find_map(|line| line.strip_prefix(word))?;
        Some(line.trim().to_owned())
    }

    /// Ends the input; returns the exit status and the answers that were not read.
    pub fn end(mut self) -> (Option<i32>, Vec<Value>) {
        self.input = None;
        let rest: Vec<Value> = self.answers.iter().collect();
        let mut errors = String::new();
        let mut pipe = self.child.stderr.take().expect("a pipe");
        pipe.read_to_string(&mut errors).expect("text");
        assert!(errors.is_empty(), "{errors}");
        (self.child.wait().expect("it ends").code(), rest)
    }
}

fn framed(text: &str) -> String {
    format!("Content-Length: {}\r\n\r\n{text}", text.len())
}

fn next_message(output: &mut impl BufRead) -> Option<Value> {
    let (mut header, mut blank) = (String::new(), String::new());
    output.read_line(&mut header).ok()?;
    output.read_line(&mut blank).ok()?;
    let length = header.trim().strip_prefix("Content-Length: ")?;
    let mut bytes = vec![0; length.parse().ok()?];
    output.read_exact(&mut bytes).ok()?;
    serde_json::from_slice(&bytes).ok()
}

/// Each message `> …` of a transcript is answered as the lines `< …` say that follow. With the environment variable
/// `UPDATE_TRANSCRIPTS` these lines are written.
#[test]
fn messages_are_answered_as_in_the_transcripts() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/integration/transcripts");
    let is_written = std::env::var_os("UPDATE_TRANSCRIPTS").is_some();
    let mut count = 0;
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("a file").path();
        let text = fs::read_to_string(&path).expect("text");
        let mut server = Server::new();
        let mut written = String::new();
        let mut lines = text.lines().peekable();
        while let Some(line) = lines.next() {
            written += &format!("{line}\n");
            let mut expected = 0;
            while lines.next_if(|line| line.starts_with('<')).is_some() {
                expected += 1;
            }
            let Some(message) = line.strip_prefix("> ") else {
                continue;
            };
            server.write(&framed(message));
            if is_written {
                while let Some(answer) = server.answer(SILENCE) {
                    written += &format!("< {answer}\n");
                }
            } else {
                for _ in 0..expected {
                    let answer = server.answer(PATIENCE).unwrap_or_default();
                    written += &format!("< {answer}\n");
                }
            }
        }
        if is_written {
            fs::write(&path, &written).expect("written");
            continue;
        }
        let changed = written.lines().zip(text.lines()).find(|(a, b)| a != b);
        assert!(written == text, "{}: {changed:#?}", path.display());
        assert_eq!(server.end().1, Vec::<Value>::new(), "{}", path.display());
        count += 1;
    }
    assert!(is_written || count >= 9, "{count}");
}

#[test]
fn what_is_no_message_is_answered_and_passed_over() {
    let cases = [
        ("no JSON", framed("{"), 1),
        ("too deep", framed(&"[".repeat(100_000)), 1),
        (
            "too long",
            format!("Content-Length: 17000000\r\n\r\n{}", " ".repeat(17_000_000)),
            1,
        ),
        (
            "no UTF-8",
            "Content-Length: 2\r\n\r\n\u{00E9}".to_owned(),
            1,
        ),
        ("no length", "Content-Length: x\r\n\r\n".to_owned(), 1),
        ("blank lines", "\r\n\r\n\n".to_owned(), 0),
        (
            "other headers",
            format!("Content-Type: a\r\n{}", framed(r#"{"id": 3}"#)),
            1,
        ),
    ];
    for (what, text, errors) in cases {
        let mut server = Server::new();
        server.asked("initialize", &json!({}));
        server.write(&text);
        for _ in 0..errors {
            let answer = server.answer(PATIENCE).unwrap_or_default();
            assert!(answer["error"].is_object(), "{what}: {answer}");
        }
        assert!(server.asked("shutdown", &json!({}))["result"].is_null());
        server.send(&json!({ "method": "exit" }));
        assert_eq!(server.end(), (Some(0), Vec::new()), "{what}");
    }
}

/// The status is 0 only if `shutdown` came before the end.
#[test]
fn a_server_ends_as_it_is_told() {
    let exit = framed(r#"{"method": "exit"}"#);
    for text in ["", &exit, "Content-Length: 99\r\n\r\n{"] {
        let mut server = Server::new();
        server.asked("initialize", &json!({}));
        server.write(text);
        assert_eq!(server.end().0, Some(1), "{text}");
    }
}

#[test]
fn every_word_inside_statements_is_described() {
    let text = "model a;\nlet b = ";
    let mut server = Server::with_text("file:///a.hyz", text);
    let parameters = json!({ "textDocument": { "uri": "file:///a.hyz" }, "position": { "line": 1, "character": 8 } });
    let answer = server.asked("textDocument/completion", &parameters);
    let found = |word: &str| {
        let items = answer["result"].as_array().into_iter().flatten();
        let item = items.into_iter().find(|item| item["label"] == word);
        item.is_some_and(|item| {
            item["documentation"]
                .as_str()
                .is_some_and(|doc| !doc.is_empty())
        })
    };
    for word in INNER {
        let is_statement = statements_of("body").contains(&word);
        assert!(is_statement || found(word), "{word}: {answer}");
    }
}

#[test]
fn every_function_is_described() {
    let text = "model a;\nlet b = ";
    let mut server = Server::with_text("file:///a.hyz", text);
    let parameters = json!({ "textDocument": { "uri": "file:///a.hyz" }, "position": { "line": 1, "character": 8 } });
    let answer = server.asked("textDocument/completion", &parameters);
    for (name, _) in Function::NAMES {
        let items = answer["result"].as_array().into_iter().flatten();
        let item = items.into_iter().find(|item| item["label"] == name);
        let doc = item.and_then(|item| item["documentation"].as_str());
        assert!(doc.is_some_and(|doc| !doc.is_empty()), "{name}: {answer}");
    }
}

/// A model that includes a file, both open; names are those of the model, in whichever file they stand.
#[test]
fn names_of_included_files_are_those_of_the_model() {
    let folder = std::env::temp_dir().join(format!("hyzer-lsp-{}", std::process::id()));
    fs::create_dir_all(folder.join("parts")).expect("a folder");
    let part = "/// of the air\nparam rho = 1.2 kg/m^3;\nlet q = rho*V^2/2;\n";
    let model = "model bob;\nparam m = 1 kg;\nframe N;\npoint bob { mass m; position (x, y, z) in N; velocity (u, v, w) in N; }\n\
        include \"parts/air.hyz\";\nlet V = norm(velocity);\nforce drag = -q*(1 m^2)*unit(velocity) - T*N.1/rho*(1 kg/m^3);\n\
        solve rail {\n  unknown T: N;\n  constraint x = 0 within 1 mm;\n}\nlet load = T/m;\n";
    let model = model
        .replace("(1 m^2)", "(1 [m^2])")
        .replace("(1 kg/m^3)", "(1 [kg/m^3])");
    let paths = [folder.join("bob.hyz"), folder.join("parts/air.hyz")];
    fs::write(&paths[0], &model).expect("written");
    fs::write(&paths[1], part).expect("written");
    let [main, air] = paths
        .each_ref()
        .map(|path| format!("file://{}", path.display()));
    let mut server = Server::with_text(&main, &model);
    let own = json!({ "uri": air, "version": 1, "text": part });
    server.send(&json!({ "method": "textDocument/didOpen", "params": { "textDocument": own } }));
    server.answer(PATIENCE).expect("the errors of the part");
    let ask = |server: &mut Server, method: &str, uri: &str, line: usize, character: usize| {
        let parameters = json!({
            "textDocument": { "uri": uri }, "position": { "line": line, "character": character },
            "newName": "density", "context": { "includeDeclaration": true },
            "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } },
        });
        server.asked(&format!("textDocument/{method}"), &parameters)["result"].take()
    };
    let line_of = |text: &str| {
        model
            .lines()
            .position(|line| line.contains(text))
            .expect(text)
    };
    let drag = line_of("force drag");
    let column = |text: &str| model.lines().nth(drag).unwrap().find(text).unwrap();
    // Definition, of a name and of the file.
    let found = ask(&mut server, "definition", &main, drag, column("rho"));
    assert_eq!(found["uri"], air.as_str());
    assert_eq!(
        found["range"]["start"],
        json!({ "line": 1, "character": 6 })
    );
    let found = ask(&mut server, "definition", &main, line_of("include"), 12);
    assert_eq!(found["uri"], air.as_str());
    // References and rename, from either file.
    for (uri, line, character) in [(&main, drag, column("rho")), (&air, 2, 8)] {
        let found = ask(&mut server, "references", uri, line, character);
        let uris = found.as_array().expect("references").iter();
        let uris: Vec<&str> = uris.filter_map(|own| own["uri"].as_str()).collect();
        assert_eq!(uris, [main.as_str(), &air, &air], "{found}");
        let edits = ask(&mut server, "rename", uri, line, character)["changes"].take();
        assert_eq!(edits[&main].as_array().map(Vec::len), Some(1), "{edits}");
        assert_eq!(edits[&air].as_array().map(Vec::len), Some(2), "{edits}");
        assert_eq!(
            edits[&main][0]["range"]["start"],
            json!({ "line": drag, "character": column("rho") })
        );
    }
    // The unknown of a block, its uses, and its costs.
    let found = ask(&mut server, "definition", &main, drag, column("T*N.1"));
    let unknown = line_of("unknown T");
    assert_eq!(
        found["range"]["start"],
        json!({ "line": unknown, "character": 10 })
    );
    let found = ask(&mut server, "references", &main, unknown, 10);
    assert_eq!(found.as_array().map(Vec::len), Some(3), "{found}");
    let hints = ask(&mut server, "inlayHint", &main, 0, 0);
    let costs = hints.as_array().expect("hints").iter();
    let costs = costs.filter(|hint| {
        hint["label"]
            .as_str()
            .is_some_and(|label| label.contains("operation"))
    });
    let places: Vec<_> = costs
        .map(|hint| hint["position"]["line"].as_u64())
        .collect();
    let expected = [line_of("let V"), unknown, line_of("let load")];
    assert_eq!(places, expected.map(|line| Some(line as u64)), "{hints}");
    // Completion: names of the part, words and names in a block, files.
    let labels = |found: &Value| -> Vec<String> {
        let items = found.as_array().into_iter().flatten();
        items
            .filter_map(|item| Some(item["label"].as_str()?.to_owned()))
            .collect()
    };
    let found = labels(&ask(&mut server, "completion", &main, drag, column("q*")));
    assert!(
        ["rho", "q", "T", "V"]
            .iter()
            .all(|name| found.contains(&(*name).to_owned())),
        "{found:?}"
    );
    let found = labels(&ask(
        &mut server,
        "completion",
        &main,
        line_of("constraint"),
        2,
    ));
    assert!(
        ["constraint", "unknown", "x", "rho"]
            .iter()
            .all(|name| found.contains(&(*name).to_owned())),
        "{found:?}"
    );
    let found = labels(&ask(
        &mut server,
        "completion",
        &main,
        line_of("include"),
        12,
    ));
    assert_eq!(found, ["parts/air.hyz"]);
    let _ = fs::remove_dir_all(&folder);
}

#[test]
fn quantities_of_further_bodies_are_completed() {
    let text = "model two;\nframe N;\npoint a { mass 1 kg; position (x, y, z) in N; velocity (u, v, w) in N; }\n\
        point b { mass 2 kg; position (x_b, y_b, z_b) in N; velocity (u_b, v_b, w_b) in N; }\n\
        force pull = -(1 [N/m])*(position - position_of_b);\nlet d = ";
    let whole = format!("{text}norm(position_of_b);\n");
    let mut server = Server::with_text("file:///two.hyz", &whole);
    let place = json!({ "line": 5, "character": 8 });
    let parameters = json!({ "textDocument": { "uri": "file:///two.hyz" }, "position": place });
    let answer = server.asked("textDocument/completion", &parameters);
    let items = answer["result"].as_array().expect("items").iter();
    let found: Vec<(&str, &str)> = items
        .filter_map(|item| Some((item["label"].as_str()?, item["detail"].as_str()?)))
        .filter(|(label, _)| label.ends_with("_b"))
        .collect();
    for (name, of) in [
        ("position_of_b", "vector m in N"),
        ("velocity_of_b", "vector m/s in N"),
        ("force_on_b", "vector N in N"),
    ] {
        assert!(found.contains(&(name, of)), "{name}: {found:?}");
    }
    let names = |wanted: &str| found.iter().any(|(name, _)| *name == wanted);
    assert!(names("mass_of_b") && !names("moment_on_b"), "{found:?}");
}
