//! Mistakes in a build script are reported by what to change.

use codegen::build::{BuildError, Config};

#[test]
fn an_invalid_model_is_reported_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("kite.hyz");
    std::fs::write(&path, "model kite;\nstate a = 0;\nder(a) = b;\n").unwrap();
    let error = Config::new()
        .model(path.to_str().unwrap())
        .out_dir(folder.path())
        .compile()
        .unwrap_err();
    let text = error.to_string();
    assert!(matches!(error, BuildError::Model { .. }), "{text}");
    assert!(text.contains("kite.hyz:3"), "{text}");
    assert!(!folder.path().join("kite.rs").exists());
}

#[test]
fn mistakes_in_the_configuration_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let compile = |config: &mut Config| config.out_dir(folder.path()).compile().unwrap_err();
    let orphan = compile(Config::new().with("wind").model("ball"));
    assert!(matches!(orphan, BuildError::NoModel { effect } if effect == "wind"));
    let twice = compile(Config::new().model("ball").model("ball"));
    assert!(matches!(twice, BuildError::SamePath { path } if path == "ball.rs"));
    let missing = compile(Config::new().model("no-such-model"));
    assert!(missing.to_string().contains("no-such-model"));
    if std::env::var_os("OUT_DIR").is_none() {
        let nowhere = Config::new().model("ball").compile().unwrap_err();
        assert!(matches!(nowhere, BuildError::NoOutDir));
    }
}
