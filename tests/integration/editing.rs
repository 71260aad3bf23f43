//! The language server while somebody types: random edits do no harm, and answers come at once.

use std::path::{Path, PathBuf};

use model_spec::load::{EFFECTS, MODELS};
use serde_json::{Value, json};

use crate::language_server::{PATIENCE, Server};

/// Memory of the server, KiB, that no number of edits exceeds.
const MAX_MEMORY: u64 = 300_000;

/// What can be asked at a position of a text.
const METHODS: [&str; 12] = [
    "hover",
    "definition",
    "references",
    "documentHighlight",
    "prepareRename",
    "rename",
    "documentSymbol",
    "completion",
    "codeAction",
    "formatting",
    "inlayHint",
    "semanticTokens/full",
];

/// Pseudorandom numbers by SplitMix64.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % bound as u64) as usize
    }

    /// A part of a text, of at most `length` bytes.
    fn part<'t>(&mut self, text: &'t str, length: usize) -> &'t str {
        let from = text.floor_char_boundary(self.below(text.len()));
        let to = text.floor_char_boundary(from + self.below(length));
        &text[from..to]
    }
}

fn gallery() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/gallery");
    let files = std::fs::read_dir(folder).expect("the gallery");
    let paths = files.map(|file| file.expect("a file").path());
    let mut models: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|end| end == "hyz"))
        .collect();
    models.sort();
    models
}

/// Models and effects of the repository.
fn texts() -> Vec<String> {
    let built_in = MODELS.iter().chain(EFFECTS);
    let built_in = built_in.map(|(_, text)| (*text).to_owned());
    let shown = gallery().into_iter();
    let shown = shown.map(|path| std::fs::read_to_string(path).expect("text"));
    built_in.chain(shown).collect()
}

/// Words of a line, with the characters between them, and where each begins, in UTF-16 units.
fn tokens(line: &str) -> Vec<(usize, &str)> {
    let mut tokens = Vec::new();
    let mut from = 0;
    for token in line.split_inclusive(|c: char| !c.is_alphanumeric() && c != '_') {
        tokens.push((from, token));
        from += token.encode_utf16().count();
    }
    tokens
}

/// A change of a text of about 70 lines, as an editor states it: of characters, a token, lines, or all of it.
fn change(random: &mut Random, own: &str) -> Value {
    let line = random.below(90);
    let range = |start: (usize, usize), end: (usize, usize)| json!({ "start": { "line": start.0, "character": start.1 }, "end": { "line": end.0, "character": end.1 } });
    match random.below(100) {
        0 => json!({ "text": own }),
        // Characters inserted, deleted or replaced.
        1..50 => {
            let (a, b) = (random.below(60), random.below(60));
            let end = (line + random.below(20) / 19, if a % 3 == 0 { a } else { b });
            json!({ "range": range((line, a), end), "text": random.part(own, 12) })
        }
        // A token put where another is, or before it.
        50..80 => {
            let lines: Vec<&str> = own.lines().collect();
            let tokens = tokens(lines[random.below(lines.len())]);
            let Some(&(from, token)) = tokens.get(random.below(tokens.len().max(1))) else {
                return json!({ "range": range((line, 0), (line, 0)), "text": ";" });
            };
            let end = from + random.below(2) * token.encode_utf16().count();
            json!({ "range": range((line, from), (line, end)), "text": token })
        }
        // Lines inserted, deleted or replaced.
        _ => {
            let lines: Vec<&str> = own.lines().collect();
            let from = random.below(lines.len());
            let count = random.below(4).min(lines.len() - from);
            let mut text = lines[from..from + count].join("\n");
            if count > 0 {
                text.push('\n');
            }
            let end = line + random.below(4);
            json!({ "range": range((line, 0), (end, 0)), "text": text })
        }
    }
}

/// Edits of texts of the repository, each followed by a question; prints the greatest memory.
fn edit(count: usize, seed: u64) {
    let (mut random, texts) = (Random(seed), texts());
    let uri = "file:///random.hyz";
    let mut server = Server::with_text(uri, &texts[0]);
    for edit in 0..count {
        let own = &texts[random.below(texts.len())];
        let change = match edit % 400 {
            0 => json!({ "text": own }),
            _ => change(&mut random, own),
        };
        let document = json!({ "uri": uri, "version": edit });
        let parameters = json!({ "textDocument": document, "contentChanges": [change] });
        server.send(&json!({ "method": "textDocument/didChange", "params": parameters }));
        let notice = server.answer(PATIENCE).expect("the errors of the text");
        assert_eq!(notice["method"], "textDocument/publishDiagnostics");
        let method = METHODS[random.below(METHODS.len())];
        let place = json!({ "line": random.below(90), "character": random.below(60) });
        let range = json!({ "start": place, "end": { "line": 90, "character": 0 } });
        let parameters = json!({ "textDocument": document, "position": place, "newName": "other", "range": range });
        server.asked(&format!("textDocument/{method}"), &parameters);
    }
    if let Some(peak) = server.process("status", "VmHWM:") {
        println!("{count} edits: at most {peak}");
        let kib = peak.split(' ').next().expect("a number");
        assert!(kib.parse::<u64>().expect("a number") < MAX_MEMORY, "{peak}");
    }
    assert_eq!(server.end().1, Vec::<Value>::new());
}

#[test]
fn random_edits_do_no_harm() {
    edit(500, 20_261_127);
}

#[test]
#[ignore = "takes many minutes"]
fn a_hundred_thousand_random_edits_do_no_harm() {
    edit(100_000, 20_261_128);
}

/// A model of `count` lines.
fn long_model(count: usize) -> String {
    let mut text = "model long;\nparam m = 1 kg;\nframe N;\npoint ball { mass m; position (x, y, z) in N; velocity (u, v, w) in N; }\n\
        let V = norm(velocity);\nlet s_0 = V;\n".to_owned();
    let mut line = text.lines().count();
    let mut k = 0;
    while line < count - 1 {
        k += 1;
        text += &format!(
            "/// factor {k}\ncoefficient C_{k} = 0.{k} in 0 .. 3;\nlet s_{k} = max(s_{}, C_{k}*V/(1 + {k}));\n",
            k - 1
        );
        line += 3;
    }
    text + &format!("force drag = -s_{k}*(1 [kg/s])*unit(velocity);\n")
}

/// Processor time of the server, s; `None` where the system does not say.
fn processor_time(server: &Server) -> Option<f64> {
    let of_main = server.process("schedstat", "")?;
    let nanoseconds: f64 = of_main.split(' ').next()?.parse().ok()?;
    Some(1e-9 * nanoseconds)
}

/// Errors after a change and a hover, in a model of 1,000 lines, take at most 50 ms of a processor in an optimised program;
/// that of the tests is slower.
#[test]
fn a_thousand_lines_are_checked_at_once() {
    let text = long_model(1000);
    let uri = "file:///long.hyz";
    let mut server = Server::with_text(uri, &text);
    let mut spent = Vec::new();
    for round in 0..10 {
        let Some(start) = processor_time(&server) else {
            return;
        };
        let place = json!({ "line": 1, "character": 10 });
        let range = json!({ "start": place, "end": { "line": 1, "character": 11 } });
        let document = json!({ "uri": uri, "version": round });
        let change = json!({ "range": range, "text": (round % 7 + 1).to_string() });
        let parameters = json!({ "textDocument": document, "contentChanges": [change] });
        server.send(&json!({ "method": "textDocument/didChange", "params": parameters }));
        let notice = server.answer(PATIENCE).expect("the errors of the text");
        assert_eq!(notice["params"]["diagnostics"], json!([]));
        let checked = processor_time(&server).expect("as before");
        let place = json!({ "line": 500, "character": 5 });
        let parameters = json!({ "textDocument": document, "position": place });
        let hover = server.asked("textDocument/hover", &parameters);
        assert!(hover["result"].is_object(), "{hover}");
        let hovered = processor_time(&server).expect("as before");
        spent.push([checked - start, hovered - checked]);
    }
    let least = |k: usize| spent.iter().map(|own| own[k]).fold(f64::INFINITY, f64::min);
    println!("errors in {:.4} s, hover in {:.4} s", least(0), least(1));
    assert!(least(0) < 0.1 && least(1) < 0.1, "{spent:?}");
}
