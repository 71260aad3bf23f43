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

/// A model with arrays, loads, a quaternion, a marker and a case.
const SEED: &str = "model seed;
frame N;
frame B = N by quaternion (e0, e1, e2, e3);
param m = 0.12 g;
param c[i] for i in 1..3 = (8, 33.75, 17.5) mm;
let half[i] for i in 1..3 = c[i]/2;
body S { mass m; inertia diag(1e-9 [kg*m^2], 1e-9 [kg*m^2], 1e-9 [kg*m^2]) in B; fixed in B; position (x, y, z) in N;
  velocity (u, v, w) in N; angular velocity (p, q, r) in B; }
force weight = -m*(9.81 [m/s^2])*N.3;
moment damping = -(1e-6 [N*m*s])*in_B(angular_velocity);
let energy = m*(9.81 [m/s^2])*z;
let noisy = 3*(0.1 [m]);
marker tip in B;
observe tip = position + in_N(tip);
check \"falls\" { expect der(w) = -9.81 m/s^2 within 1e-9; }
";

/// Position of the first `text` in a text, `ahead` characters on.
fn place(of: &str, text: &str, ahead: usize) -> Value {
    let at = of.find(text).unwrap_or_else(|| panic!("{text}")) + ahead;
    let line = of[..at].matches('\n').count();
    let start = of[..at].rfind('\n').map_or(0, |end| end + 1);
    json!({ "line": line, "character": of[start..at].chars().count() })
}

#[test]
fn what_stands_under_the_pointer_is_told() {
    let uri = "file:///seed.hyz";
    let mut server = Server::with_text(uri, SEED);
    let mut hover = |text: &str, ahead: usize| -> String {
        let parameters =
            json!({ "textDocument": { "uri": uri }, "position": place(SEED, text, ahead) });
        let answer = server.asked("textDocument/hover", &parameters);
        let shown = answer["result"]["contents"]["value"].as_str();
        shown.unwrap_or_default().to_owned()
    };
    let told = [
        ("param c", 6, "(0.008, 0.03375, 0.0175) m"),
        ("let half", 4, "(0.004, 0.016875, 0.00875) m"),
        ("let noisy", 4, ": 0.3 m\n"),
        ("param m", 0, "param NAME[i] for i in 1..3"),
        ("force weight", 0, "force NAME[i] for i in 1..3"),
        ("force weight", 6, "\n\nforce weight = "),
        ("moment damping", 7, "vector N*m in B"),
        ("let energy", 4, "N*m"),
        ("frame B", 0, "by quaternion (q0, q1, q2, q3)"),
        (" by quat", 1, "by quaternion"),
        (" by quat", 4, "unit quaternion"),
        ("for i in", 0, "array"),
        ("for i in", 6, "bounds"),
        ("within", 0, "difference"),
        ("in_B(", 0, "in_FRAME(VECTOR)"),
        ("in_B(", 3, "frame"),
        ("marker tip", 0, "comes with each recording"),
        ("expect der", 0, "expect der(STATE)"),
        ("m/s^2])*N", 0, "unit of a length"),
        ("12 g;", 3, "unit of a mass: 1 g = 0.001 kg"),
    ];
    for (text, ahead, part) in told {
        let shown = hover(text, ahead);
        assert!(shown.contains(part), "{text} {ahead}: {shown}");
    }
    let told = hover("m/s^2])*N", 0);
    assert!(!told.contains('='), "{told}");
}

#[test]
fn only_what_fits_is_completed() {
    let uri = "file:///seed.hyz";
    let labels = |statement: &str| -> Vec<String> {
        let text = SEED.replace("check ", &format!("{statement}|"));
        let text = text.split_once('|').expect("a mark").0;
        let mut server = Server::with_text(uri, SEED);
        let change = json!({
            "textDocument": { "uri": uri, "version": 2 }, "contentChanges": [{ "text": text }],
        });
        server.send(&json!({ "method": "textDocument/didChange", "params": change }));
        server.answer(PATIENCE).expect("errors");
        let end = text.lines().last().map_or(0, |line| line.chars().count());
        let place = json!({ "line": text.lines().count() - 1, "character": end });
        let parameters = json!({ "textDocument": { "uri": uri }, "position": place });
        let answer = server.asked("textDocument/completion", &parameters);
        let items = answer["result"].as_array().cloned().unwrap_or_default();
        let labels = items.iter().filter_map(|item| item["label"].as_str());
        labels.map(str::to_owned).collect()
    };
    assert_eq!(labels("frame C = N "), ["turned", "by"]);
    assert_eq!(labels("frame C = N by "), ["quaternion"]);
    assert_eq!(labels("let a = velocity."), ["1", "2", "3"]);
    assert_eq!(labels("let a = c[1]."), ["1", "2", "3"]);
    assert!(labels("let a = 1.").is_empty());
    let given = labels("check \"a\" { set ");
    let has = |found: &[String], word: &str| found.iter().any(|own| own == word);
    assert!(
        has(&given, "m") && has(&given, "w") && has(&given, "tip"),
        "{given:?}"
    );
    let others = ["energy", "sin", "weight", "time", "N"];
    assert!(others.iter().all(|own| !has(&given, own)), "{given:?}");
    let computed = labels("check \"a\" { set m = 1 g; expect ");
    assert!(
        has(&computed, "energy") && has(&computed, "der"),
        "{computed:?}"
    );
    assert!(
        !has(&computed, "m") && !has(&computed, "sin"),
        "{computed:?}"
    );
    let sum = labels("let a = ");
    assert!(
        has(&sum, "in_B") && has(&sum, "in_N") && has(&sum, "energy"),
        "{sum:?}"
    );
    assert!(!has(&sum, "weight") && !has(&sum, "damping"), "{sum:?}");
    let unfinished = labels("marker \nobserve \ncheck \"a\" { ");
    assert_eq!(unfinished, ["let", "set", "expect"]);
}
