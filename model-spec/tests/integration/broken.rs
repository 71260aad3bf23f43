//! A corpus of broken files, each with a snapshot of what is said about it.

use std::path::Path;

use model_spec::load;

/// Text of the errors that loading a model file reports. If the name of the file begins with `effect_`, its effect
/// `more_drag` is applied first.
fn said(path: &str) -> String {
    let effect = Path::new(path)
        .file_name()
        .unwrap()
        .to_string_lossy()
        .starts_with("effect_");
    let with: &[&str] = if effect { &["more_drag"] } else { &[] };
    match load::inspect(path, with) {
        Ok(loaded) => {
            assert!(!loaded.diagnostics.is_empty(), "{path} is not broken");
            for fault in &loaded.diagnostics {
                assert!(fault.message.len() < 600, "{path}: {}", fault.message);
            }
            model_spec::render(&loaded.diagnostics, &loaded.sources, false)
        }
        Err(error) => format!("{error}\n"),
    }
}

#[test]
fn every_broken_file_is_explained() {
    let mut files: Vec<String> = std::fs::read_dir("tests/integration/broken")
        .unwrap()
        .map(|entry| {
            format!(
                "tests/integration/broken/{}",
                entry.unwrap().file_name().to_string_lossy()
            )
        })
        .filter(|path| path.ends_with(".hyz"))
        .collect();
    files.sort();
    assert!(files.len() >= 60, "{} files", files.len());
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("broken/snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        for path in files {
            let name = Path::new(&path)
                .file_stem()
                .unwrap()
                .to_string_lossy()
                .into_owned();
            insta::assert_snapshot!(name, said(&path));
        }
    });
}

/// The edit that carries out a hint mends the error.
#[test]
fn edits_of_hints_mend_their_errors() {
    let faults = |text: &str| match load::inspect_text("broken.hyz", text, &[]) {
        Ok(loaded) => loaded.diagnostics,
        Err(error) => error.diagnostics().to_vec(),
    };
    let mut mended = 0;
    for entry in std::fs::read_dir("tests/integration/broken").unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|kind| kind != "hyz") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap_or_default();
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

#[test]
fn a_file_of_ten_megabytes_gets_one_clear_message() {
    let path = std::env::temp_dir().join(format!("hyzer-long-{}.hyz", std::process::id()));
    std::fs::write(&path, "let a = 1;\n".repeat(1_000_000)).unwrap();
    let start = std::time::Instant::now();
    let loaded = load::inspect(path.to_str().unwrap(), &[]);
    std::fs::remove_file(&path).unwrap();
    let error = loaded.unwrap_err().to_string();
    assert!(
        error.contains("has 11000000 bytes; a model file has at most 1000000"),
        "{error}"
    );
    assert!(start.elapsed().as_secs() < 2);
}

#[test]
fn a_file_just_short_enough_does_not_take_long() {
    // One statement per line, all of them faulty in their own way.
    for line in [
        "let a = b;\n",
        "param k;\n",
        "((((((((\n",
        "let a = 1 + ;\n",
        "{",
        "\0",
        "/// doc\n",
        "-",
    ] {
        let text = line.repeat(model_spec::syntax::MAX_SOURCE_BYTES / line.len());
        let start = std::time::Instant::now();
        let loaded = load::inspect_text("long.hyz", &text, &[]).unwrap();
        let shown = model_spec::render(&loaded.diagnostics, &loaded.sources, false);
        assert!(shown.len() < 200_000, "{line:?}: {} bytes", shown.len());
        assert!(
            start.elapsed().as_secs() < 20,
            "{line:?}: {:?}",
            start.elapsed()
        );
    }
}
