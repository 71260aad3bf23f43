//! The language server in a project: files that several models include, and what may stand where.

use std::fs;

use serde_json::{Value, json};

use crate::language_server::{PATIENCE, Server};

/// Two models that include one file, all open: errors and names of the file are those of the models.
#[test]
fn an_included_file_is_read_with_the_open_models_that_include_it() {
    let folder = std::env::temp_dir().join(format!("hyzer-lsp-two-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let part = "param rho = 1.2 kg/m^3;\nlet q = rho/2*V^2;\n";
    let model = |name: &str, own: &str| {
        format!(
            "model {name};\nparam m = 1 kg;\ninclude \"part.hyz\";\nframe N;\n\
             point p {{ mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }}\n\
             let V = norm(velocity);\nlet own = {own};\nforce weight = -m*(9.81 [m/s^2])*N.3;\n"
        )
    };
    let texts = [part.to_owned(), model("one", "q"), model("two", "rho*V")];
    let uris = ["part", "one", "two"].map(|name| {
        let path = folder.join(format!("{name}.hyz"));
        format!("file://{}", path.display())
    });
    for (uri, text) in uris.iter().zip(&texts) {
        fs::write(uri.trim_start_matches("file://"), text).expect("written");
    }
    // Alone, the part lacks what the models have.
    let mut server = Server::with_text(&uris[0], part);
    let open = |server: &mut Server, k: usize| {
        let own = json!({ "uri": uris[k], "version": 1, "text": texts[k] });
        server
            .send(&json!({ "method": "textDocument/didOpen", "params": { "textDocument": own } }));
    };
    // Number of errors by file, as published; the notices come in the order of the names.
    let errors = |server: &Server, names: &[&str]| {
        for expected in names {
            let (name, count) = expected.split_once(' ').expect("a name and a count");
            let notice = server.answer(PATIENCE).expect("errors");
            let own = &notice["params"];
            assert!(
                own["uri"].as_str().is_some_and(|uri| uri.contains(name)),
                "{notice}"
            );
            let found = own["diagnostics"].as_array().map_or(0, Vec::len);
            assert_eq!(found.to_string(), count, "{notice}");
        }
    };
    open(&mut server, 1);
    errors(&server, &["one.hyz 0", "part.hyz 0"]);
    open(&mut server, 2);
    errors(&server, &["two.hyz 0"]);
    // A name is changed in both models, from whichever file, with one edit for each place.
    for (k, line, character) in [(0, 0, 7), (0, 1, 9), (2, 6, 11)] {
        let parameters = json!({
            "textDocument": { "uri": uris[k] }, "newName": "density",
            "position": { "line": line, "character": character },
        });
        let answer = server.asked("textDocument/rename", &parameters);
        let changes = &answer["result"]["changes"];
        let counts = uris
            .each_ref()
            .map(|uri| changes[uri].as_array().map_or(0, Vec::len));
        assert_eq!(counts, [2, 0, 1], "{answer}");
    }
    let parameters = json!({
        "textDocument": { "uri": uris[1] }, "newName": "speed",
        "position": { "line": 5, "character": 4 },
    });
    let answer = server.asked("textDocument/rename", &parameters);
    let changes = &answer["result"]["changes"];
    let counts = uris
        .each_ref()
        .map(|uri| changes[uri].as_array().map_or(0, Vec::len));
    assert_eq!(counts, [1, 1, 2], "{answer}");
    // A break in the part, not saved, is an error of each model, and of the part where it is.
    let change = json!({
        "textDocument": { "uri": uris[0], "version": 2 },
        "contentChanges": [{ "text": part.replace("param rho", "param rhoo") }],
    });
    server.send(&json!({ "method": "textDocument/didChange", "params": change }));
    errors(&server, &["one.hyz 1", "part.hyz 1", "two.hyz 2"]);
    // Without the models it is alone again.
    for uri in &uris[1..] {
        let own = json!({ "textDocument": { "uri": uri } });
        server.send(&json!({ "method": "textDocument/didClose", "params": own }));
    }
    errors(&server, &["one.hyz 0"]);
    let mut last = Value::Null;
    while let Some(notice) = server.answer(std::time::Duration::from_secs(2)) {
        last = notice["params"].clone();
    }
    assert!(
        last["uri"]
            .as_str()
            .is_some_and(|uri| uri.contains("part.hyz")),
        "{last}"
    );
    let alone = last["diagnostics"].as_array().map_or(0, Vec::len);
    assert!(alone > 1, "{last}");
    let _ = fs::remove_dir_all(&folder);
}

#[test]
fn words_are_completed_where_they_can_stand() {
    let text = "model two;\nframe N;\nframe A = N turned φ about 1;\nstate φ = 0;\n\
        point a { mass 1 kg; \n }\ncheck \"it\" { \n }\n\nlet s = 2*;\n";
    let uri = "file:///words.hyz";
    let mut server = Server::with_text(uri, text);
    let mut labels = |line: usize, character: usize| -> Vec<String> {
        let parameters = json!({
            "textDocument": { "uri": uri }, "position": { "line": line, "character": character },
        });
        let answer = server.asked("textDocument/completion", &parameters);
        let items = answer["result"].as_array().cloned().unwrap_or_default();
        let labels = items.iter().filter_map(|item| item["label"].as_str());
        labels.map(str::to_owned).collect()
    };
    let has = |found: &[String], word: &str| found.iter().filter(|own| *own == word).count();
    let (body, case, outside, sum) = (labels(5, 0), labels(7, 0), labels(8, 0), labels(9, 10));
    assert_eq!(
        (
            has(&body, "inertia"),
            has(&body, "set"),
            has(&body, "force")
        ),
        (1, 0, 0)
    );
    assert_eq!((has(&case, "expect"), has(&case, "mass")), (1, 0));
    assert_eq!(
        (
            has(&outside, "force"),
            has(&outside, "mass"),
            has(&outside, "set")
        ),
        (1, 0, 0)
    );
    assert_eq!(has(&sum, "φ"), 1, "{sum:?}");
}
