use std::fs;
use std::io::Cursor;
use std::path::Path;

use model_spec::load::{EFFECTS, MODELS};
use model_spec::model::Function;
use serde_json::{Value, json};

use super::{Server, State, serve, words};

/// Server with open texts, after `initialize`.
fn running(texts: &[(&str, &str)]) -> Server {
    let mut server = Server {
        state: State::Running,
        ..Server::default()
    };
    for (uri, text) in texts {
        let own = json!({ "uri": uri, "version": 1, "text": text });
        server.receive(
            &json!({ "method": "textDocument/didOpen", "params": { "textDocument": own } }),
        );
    }
    server
}

/// Each message `> …` of a transcript is answered as the lines `< …` say that follow. With the environment variable
/// `UPDATE_TRANSCRIPTS` these lines are written.
#[test]
fn messages_are_answered_as_in_the_transcripts() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lsp/transcripts");
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let mut server = Server::default();
        let mut written = String::new();
        for line in text.lines().filter(|line| !line.starts_with('<')) {
            written += &format!("{line}\n");
            let Some(message) = line.strip_prefix("> ") else {
                continue;
            };
            let message: Value = serde_json::from_str(message).unwrap();
            let mut answers = server.receive(&message);
            answers.extend(server.notices());
            written.extend(answers.iter().map(|answer| format!("< {answer}\n")));
        }
        if std::env::var_os("UPDATE_TRANSCRIPTS").is_some() {
            fs::write(&path, &written).unwrap();
            continue;
        }
        let changed = written.lines().zip(text.lines()).find(|(a, b)| a != b);
        assert!(written == text, "{}: {changed:#?}", path.display());
    }
}

#[test]
fn what_is_no_message_is_answered_and_passed_over() {
    let framed = |text: &str| format!("Content-Length: {}\r\n\r\n{text}", text.len());
    let initialize = framed(r#"{"id": 1, "method": "initialize"}"#);
    let end = framed(r#"{"id": 2, "method": "shutdown"}"#) + &framed(r#"{"method": "exit"}"#);
    let cases = [
        ("no JSON", framed("{"), 1),
        ("too deep", framed(&"[".repeat(100_000)), 1),
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
        let input = format!("{initialize}{text}{end}");
        let mut output = Vec::new();
        assert!(serve(Cursor::new(input), &mut output).unwrap(), "{what}");
        let output = String::from_utf8(output).unwrap();
        assert_eq!(
            output.matches("\"error\"").count(),
            errors,
            "{what}: {output}"
        );
        assert_eq!(output.matches("\"result\"").count(), 2, "{what}");
    }
    let unended = serve(Cursor::new("Content-Length: 99\r\n\r\n{"), &mut Vec::new());
    assert!(!unended.unwrap());
}

#[test]
fn every_function_is_described() {
    for (name, _) in Function::NAMES {
        assert!(words::find(name, false).is_some(), "{name}");
    }
}

/// The edit that carries out a hint mends the error.
#[test]
fn edits_of_hints_mend_their_errors() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("model-spec/tests/integration/broken");
    let mut mended = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap_or_default();
        if path.extension().is_none_or(|kind| kind != "hyz") {
            continue;
        }
        let faults = |text: &str| {
            let loaded = model_spec::load::inspect_text("broken.hyz", text, &[]);
            loaded.map_or_else(
                |error| error.diagnostics().to_vec(),
                |loaded| loaded.diagnostics,
            )
        };
        for fault in faults(&text) {
            let Some(fix) = &fault.fix else { continue };
            let mut changed = text.clone();
            changed.replace_range(fix.span.range(), &fix.text);
            let is_left = faults(&changed)
                .iter()
                .any(|other| other.message == fault.message && other.span == fault.span);
            assert!(!is_left, "{}: {fault:#?}", path.display());
            mended += 1;
        }
    }
    assert!(mended > 15, "{mended}");
}

/// Random edits, and everything that can be asked, on texts of the repository; `EDITS` says how many.
#[test]
fn random_edits_do_no_harm() {
    let count = std::env::var("EDITS").map_or(300, |count| count.parse().unwrap());
    let mut seed = 20_261_127_u64;
    let mut random = move |below: usize| {
        // SplitMix64.
        seed = seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = (seed ^ (seed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % below as u64) as usize
    };
    let texts: Vec<&str> = MODELS
        .iter()
        .chain(EFFECTS)
        .map(|(_, text)| *text)
        .collect();
    let uri = "file:///random.hyz";
    let mut server = running(&[(uri, texts[0])]);
    let methods = [
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
    for edit in 0..count {
        let position = |random: &mut dyn FnMut(usize) -> usize| json!({ "line": random(130), "character": random(60) });
        let (start, end) = (position(&mut random), position(&mut random));
        let near = json!({ "line": start["line"], "character": random(60) });
        let end = if random(20) == 0 { end } else { near };
        let own = texts[random(texts.len())];
        let from = own.floor_char_boundary(random(own.len()));
        let to = own.floor_char_boundary(from + random(12));
        let change = match random(150) {
            0 => json!({ "text": own }),
            _ => json!({ "range": { "start": start, "end": end }, "text": &own[from..to] }),
        };
        let document = json!({ "uri": uri, "version": edit });
        let parameters = json!({ "textDocument": document, "contentChanges": [change] });
        server.receive(&json!({ "method": "textDocument/didChange", "params": parameters }));
        let method = format!("textDocument/{}", methods[random(methods.len())]);
        let parameters = json!({
            "textDocument": document, "position": position(&mut random), "newName": "other",
            "range": { "start": start, "end": end },
        });
        let answers =
            server.receive(&json!({ "id": edit, "method": method, "params": parameters }));
        assert_eq!(answers.len(), 1, "{method}");
        assert_eq!(server.notices().len(), 1);
    }
}
