//! A certificate says what was verified, and no longer stands once any of it has changed.

use model_spec::load::inspect;
use model_spec::model::Model;
use std::fs;
use std::path::{Path, PathBuf};
use verify::Options;
use verify::certificate::{
    Certificate, CertificateError, CertifiedModel, Change, Hash, Origin, folder_of,
};
use verify::report::{Outcome, Verdict};

const QUICK: Options = Options {
    seed: 3,
    cases: 10,
    mutants: false,
    effects: true,
};

const KITE: &str = "model kite; param g0 = 9.81 m/s^2; param k = 0.3 1/s; frame N;
state z = 1 m; state v = 0 m/s; der(z) = v; der(v) = -g0 - k*v;";

/// Temporary folder of one test, deleted when dropped.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("hyzer-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.join(name);
        fs::write(&path, text).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn certified(models: &[(&str, &[&str])], folder: &Path) -> Certificate {
    let each = models.iter().map(|(name, with)| {
        let loaded = inspect(name, with).unwrap();
        let report = verify::run(&loaded, &QUICK);
        CertifiedModel::new(folder, name, with, &loaded, &report).unwrap()
    });
    Certificate::new(&QUICK, each.collect(), None)
}

fn lines(changes: &[Change]) -> Vec<String> {
    changes.iter().map(ToString::to_string).collect()
}

fn never(_: &Model) -> bool {
    false
}

#[test]
fn a_certificate_holds_every_check_and_is_read_back_as_it_is() {
    let folder = Folder::new("whole");
    let certificate = certified(&[("disc", &[])], &folder.0);
    let text = certificate.text();
    assert_eq!(Certificate::parse(&text).unwrap(), certificate);
    assert_eq!(certified(&[("disc", &[])], &folder.0).text(), text);
    let report = verify::run(&inspect("disc", &[]).unwrap(), &QUICK);
    let model = &certificate.models[0];
    assert_eq!(model.checks.len(), report.rows.len());
    for (check, row) in model.checks.iter().zip(&report.rows) {
        assert_eq!(
            (check.check.as_str(), check.verdict),
            (row.check, row.verdict)
        );
    }
    assert_eq!(model.from, Origin::Name("disc".into()));
    assert_eq!(certificate.outcome, Outcome::Verified);
    assert!(certificate.changes(&folder.0).is_empty());
    // No time of day, no folder of the machine.
    assert!(!text.contains(folder.0.to_str().unwrap()), "{text}");
}

#[test]
fn hashes_of_sources_are_those_of_sha256sum() {
    let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    assert_eq!(Hash::of_text("abc").to_string(), abc);
}

#[test]
fn a_changed_source_is_named_and_the_code_with_it() {
    let folder = Folder::new("source");
    let kite = folder.file("kite.hyz", KITE);
    let certificate = certified(&[(kite.to_str().unwrap(), &[])], &folder.0);
    assert_eq!(certificate.models[0].from, Origin::File("kite.hyz".into()));
    assert_eq!(certificate.models[0].covers.sources[0].name, "kite.hyz");
    assert_eq!(certificate.outcome, Outcome::NotVerified);
    assert!(certificate.changes(&folder.0).is_empty());
    // Code says of which text it is.
    folder.file("kite.hyz", &(KITE.to_owned() + "\n// a remark\n"));
    assert_eq!(
        lines(&certificate.changes(&folder.0)),
        [
            "kite: source kite.hyz changed",
            "kite: generated Rust code changed"
        ]
    );
    folder.file("kite.hyz", &KITE.replace("- k*v", "+ k*v"));
    assert_eq!(
        lines(&certificate.changes(&folder.0)),
        [
            "kite: source kite.hyz changed",
            "kite: schedule changed",
            "kite: generated Rust code changed",
            "kite: results of the tape changed"
        ]
    );
    folder.file("kite.hyz", "model kite; der(v) = ");
    assert_eq!(
        lines(&certificate.changes(&folder.0)),
        ["kite: its text is refused by the checker"]
    );
    fs::remove_file(kite).unwrap();
    assert_eq!(
        lines(&certificate.changes(&folder.0)),
        ["kite: kite.hyz is not there"]
    );
}

#[test]
fn the_folder_may_be_moved_with_the_model() {
    let (here, there) = (Folder::new("here"), Folder::new("there"));
    let kite = here.file("kite.hyz", KITE);
    fs::create_dir_all(here.0.join("certificates")).unwrap();
    let inner = here.0.join("certificates");
    let certificate = certified(&[(kite.to_str().unwrap(), &[])], &inner);
    assert_eq!(
        certificate.models[0].from,
        Origin::File("../kite.hyz".into())
    );
    there.file("kite.hyz", KITE);
    fs::create_dir_all(there.0.join("certificates")).unwrap();
    assert!(
        certificate
            .changes(&there.0.join("certificates"))
            .is_empty()
    );
}

#[test]
fn a_changed_effect_is_named() {
    let folder = Folder::new("effect");
    let kite = folder.file("kite.hyz", KITE);
    let law =
        "effect pull { site drag; coefficient c_p = 0 m/s^2 in -1 .. 1; negligible c_p 0.01 m/s^2;
        replace der(v) = -g0 - k*v + c_p; }";
    let pull = folder.file("pull.hyz", law);
    let with = [pull.to_str().unwrap()];
    let certificate = certified(&[(kite.to_str().unwrap(), &with)], &folder.0);
    let covered = &certificate.models[0].covers.sources;
    assert_eq!(covered.len(), 2, "{covered:?}");
    assert!(certificate.changes(&folder.0).is_empty());
    folder.file("pull.hyz", &law.replace("-1 .. 1", "-2 .. 1"));
    let changes = lines(&certificate.changes(&folder.0));
    assert_eq!(changes[0], "kite: source pull.hyz changed");
    let alone = inspect(kite.to_str().unwrap(), &[]).unwrap().model.unwrap();
    let status = certificate.status(&folder.0.join("c.json"), &alone);
    assert_eq!(status.outcome, None);
    assert!(!status.changes.is_empty());
}

#[test]
fn another_version_effects_or_code_of_the_program_are_named() {
    let folder = Folder::new("program");
    let text = certified(&[("ball", &[])], &folder.0).text();
    let with = |from: &str, to: &str| {
        assert!(text.contains(from), "{from} in {text}");
        let certificate = Certificate::parse(&text.replacen(from, to, 1)).unwrap();
        lines(&certificate.changes(&folder.0))
    };
    let version = format!("\"version\": \"{}\"", env!("CARGO_PKG_VERSION"));
    let now = env!("CARGO_PKG_VERSION");
    assert_eq!(
        with(&version, "\"version\": \"0.0.1\""),
        [format!("program version: 0.0.1, now {now}")]
    );
    for (field, what) in [
        ("effects", "built-in effects of the program changed"),
        ("schedule", "ball: schedule changed"),
        ("rust", "ball: generated Rust code changed"),
        ("results", "ball: results of the tape changed"),
        ("sha256", "ball: source ball.hyz changed"),
    ] {
        let at = text.find(&format!("\"{field}\": \"")).unwrap() + field.len() + 5;
        let hash = &text[at..at + 64];
        assert_eq!(with(hash, &"0".repeat(64)), [what]);
    }
}

#[test]
fn checks_made_again_are_compared_by_their_verdicts() {
    let folder = Folder::new("again");
    let mut certificate = certified(&[("ball", &[])], &folder.0);
    assert!(certificate.changes_again(&folder.0, never).is_empty());
    let checks = &mut certificate.models[0].checks;
    checks[3].verdict = Verdict::Skipped;
    checks.pop();
    let name = checks[3].check.clone();
    assert!(certificate.changes(&folder.0).is_empty());
    let changes = lines(&certificate.changes_again(&folder.0, never));
    assert_eq!(
        changes,
        [
            format!("ball: check `{name}`: skipped, now holds"),
            String::from("ball: check `effects: reference` is new")
        ]
    );
}

#[test]
fn a_model_in_use_is_found_by_its_texts() {
    let folder = Folder::new("use");
    let certificate = certified(&[("ball", &[]), ("disc", &[])], &folder.0);
    let path = folder.0.join("both.json");
    let model = |name: &str, with: &[&str]| inspect(name, with).unwrap().model.unwrap();
    let status = certificate.status(&path, &model("disc", &[]));
    assert_eq!(
        (status.outcome, status.changes.len()),
        (Some(Outcome::Verified), 0)
    );
    let other = certificate.status(&path, &model("discus", &[]));
    assert_eq!(
        lines(&other.changes),
        ["discus: it does not cover this model"]
    );
    let with = certificate.status(&path, &model("disc", &["zero_lift_drag_angle"]));
    assert_eq!(
        lines(&with.changes),
        ["disc: it covers other effects or another text"]
    );
    assert_eq!(folder_of(&path), folder.0);
}

#[test]
fn what_is_no_certificate_is_refused_with_the_place() {
    let folder = Folder::new("hostile");
    let text = certified(&[("ball", &[])], &folder.0).text();
    let refused = |text: &str| Certificate::parse(text).unwrap_err().to_string();
    for (from, to, place) in [
        ("\"schema\"", "\"scheme\"", "line 2 column 10"),
        (
            "hyzer.certificate/1",
            "hyzer.certificate/9",
            "schema: found",
        ),
        ("\"seed\": 3", "\"seed\": -3", "column"),
        ("\"cases\": 10", "\"cases\": 0", "options.cases: found 0"),
        (
            "\"cases\": 10",
            "\"cases\": 99999999",
            "options.cases: found 99999999",
        ),
        (
            "\"holds\"",
            "\"refuted\"",
            "models[0].outcome: found verified, expected refuted",
        ),
        (
            "\"outcome\": \"verified\"",
            "\"outcome\": \"refuted\"",
            "outcome: found refuted",
        ),
        ("\"sha256\": \"", "\"sha256\": \"x", "64 hexadecimal digits"),
        ("\"models\": [", "\"models\": [[", "column"),
        (
            "\"models\"",
            "\"more\": 1, \"models\"",
            "unknown field `more`",
        ),
    ] {
        assert!(text.contains(from), "{from}");
        let said = refused(&text.replacen(from, to, 1));
        assert!(said.contains(place), "{said}");
    }
    for cut in (0..text.len()).step_by(97) {
        refused(&text[..cut]);
    }
    refused(&"[".repeat(100_000));
    refused("");
    assert!(matches!(
        Certificate::parse(&" ".repeat(4_000_001)),
        Err(CertificateError::TooLong)
    ));
    let bytes = folder.0.join("bytes.json");
    fs::write(&bytes, [b'{', 0xff]).unwrap();
    let said = Certificate::read(&bytes).unwrap_err().to_string();
    assert_eq!(said, "byte 1 begins no character of UTF-8");
    assert!(Certificate::read(&folder.0.join("absent")).is_err());
    assert!(Certificate::read(&folder.0).is_err());
}
