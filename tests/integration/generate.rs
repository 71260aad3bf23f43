//! `hyzer generate MODEL… --out DIR`: code for any crate.

use assert_cmd::Command;
use std::path::Path;

fn hyzer(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let done = Command::cargo_bin("hyzer")
        .unwrap()
        .current_dir(folder)
        .args(arguments)
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let code = done.status.code().unwrap();
    (code, text(&done.stdout), text(&done.stderr))
}

#[test]
fn modules_are_written_checked_and_shown_where_stale() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    std::fs::write(
        here.join("spring.hyz"),
        "model spring;\nframe N;\nparam k = 2 1/s^2;\nstate a = 1;\nstate b = 0 1/s;\nlet pull = k*a;\nder(a) = b;\nder(b) = -pull;\n",
    )
    .unwrap();
    let (code, written, _) = hyzer(
        here,
        &["generate", "spring.hyz", "ball", "--out", "src/models"],
    );
    assert_eq!(code, 0);
    assert_eq!(written, "src/models/spring.rs\nsrc/models/ball.rs\n");
    let module = here.join("src/models/spring.rs");
    let text = std::fs::read_to_string(&module).unwrap();
    assert!(
        text.contains("pub fn f(") && text.contains("&[f64; 2]"),
        "{text}"
    );
    assert!(text.contains("// spring.hyz:6  let pull = k*a;"), "{text}");

    let check = [
        "generate",
        "spring.hyz",
        "ball",
        "--out",
        "src/models",
        "--check",
    ];
    assert_eq!(hyzer(here, &check).0, 0);
    std::fs::write(&module, text.replace("dx[0] = b;", "dx[0] = a;")).unwrap();
    let (code, difference, _) = hyzer(here, &check);
    assert_eq!(code, 1);
    assert!(difference.contains("+    dx[0] = b;"), "{difference}");
    let (code, _, _) = hyzer(
        here,
        &["generate", "spring.hyz", "--lanes", "--out", "lanes"],
    );
    assert_eq!(code, 0);
    let text = std::fs::read_to_string(here.join("lanes/spring.rs")).unwrap();
    assert!(
        text.contains("#[inline(always)]\npub fn f<T: Real>("),
        "{text}"
    );
}

#[test]
fn an_effect_changes_the_code_and_mistakes_are_bad_input() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    assert_eq!(hyzer(here, &["generate", "disc", "--out", "a"]).0, 0);
    let with = [
        "generate",
        "disc",
        "--with",
        "zero_lift_drag_angle",
        "--out",
        "b",
    ];
    assert_eq!(hyzer(here, &with).0, 0);
    let text = |folder: &str| std::fs::read_to_string(here.join(folder).join("disc.rs")).unwrap();
    assert!(!text("a").contains("alpha_0") && text("b").contains("alpha_0"));

    for bad in [
        &["generate", "ball"][..],
        &["generate", "--out", "c"],
        &["generate", "ball", "ball", "--out", "c"],
        &["generate", "no_such_model", "--out", "c"],
        &["generate", "ball", "--out", "c", "--backend", "cobol"],
    ] {
        let (code, out, error) = hyzer(here, bad);
        assert_eq!((code, out.as_str()), (2, ""), "{bad:?}");
        assert!(!error.is_empty(), "{bad:?}");
        assert!(!here.join("c").exists(), "{bad:?}");
    }
}
