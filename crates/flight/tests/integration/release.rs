//! Releases: good ones are read, and each fault of a bad one is named with its place.

use flight::release::{self, Name, Release, Stop, Vocabulary};
use model_spec::load::{self, LoadError};
use proptest::prelude::*;

/// Names that release files for a disc model may use, with bounds of the coefficients.
fn disc() -> Vocabulary {
    let free = |name: &&str| Name {
        name: name.to_string(),
        bounds: None,
    };
    let bounded = |name: &&str| Name {
        name: name.to_string(),
        bounds: Some((-10.0, 10.0)),
    };
    Vocabulary {
        parameters: ["m", "I_a", "I_d", "d", "A", "rho", "g"]
            .iter()
            .map(free)
            .collect(),
        coefficients: [
            "C_L0", "C_La", "C_D0", "C_Da", "C_Ma", "C_Mq", "C_Rr", "C_Nr",
        ]
        .iter()
        .map(bounded)
        .collect(),
        states: [
            "x", "y", "z", "u", "v", "w", "phi", "theta", "gamma", "phidot", "thetadot", "gammadot",
        ]
        .map(String::from)
        .to_vec(),
        optional: Vec::new(),
        inputs: vec!["wind".into(), "omega".into()],
        scalar_inputs: Vec::new(),
        quaternions: Vec::new(),
        model: None,
    }
}

fn read(text: &str) -> Result<Release, release::ReleaseError> {
    release::read("r.toml", text, |model| match model {
        "disc" | "discus" => Ok(disc()),
        "ball" => Ok(Vocabulary {
            states: ["x", "y", "z", "vx", "vy", "vz"].map(String::from).to_vec(),
            ..disc()
        }),
        "spin" => Ok(Vocabulary {
            states: ["a", "b", "c", "d"].map(String::from).to_vec(),
            quaternions: vec![[0, 1, 2, 3]],
            ..disc()
        }),
        other => Err(LoadError::UnknownModel {
            wanted: other.to_owned(),
            known: vec!["disc".to_owned()],
        }),
    })
}

const STATES: &str = "[initial]\nx=0\ny=0\nz=1\nu=10\nv=0\nw=0.0\nphi=0\ntheta=0\ngamma=0\nphidot=0\nthetadot=0\ngammadot=-50\n";

#[test]
fn the_paper_s_releases_are_as_printed() {
    let fssh3 = read(release::built_in("fssh3").unwrap()).unwrap();
    assert_eq!(fssh3.stop, Stop::Duration(0.5));
    assert_eq!(
        fssh3.state(),
        [
            -0.71, -0.52, 1.13, 3.03, -0.45, -2.25, -0.066, -0.34, 3.01, -3.03, -0.76, -8.91
        ]
    );
    let values: Vec<f64> = fssh3.coefficients.iter().map(|(_, v)| *v).collect();
    let by_name = |name: &str| {
        fssh3
            .coefficients
            .iter()
            .find(|(n, _)| n == name)
            .unwrap()
            .1
    };
    assert_eq!(values.len(), 8);
    assert_eq!(
        (by_name("C_Mq"), by_name("C_Rr"), by_name("C_Nr")),
        (-0.029, 0.012, -0.000074)
    );
    assert_eq!(
        fssh3.constants([("m", 1.0), ("rho", 1.0), ("other", 7.0)]),
        [0.175, 1.23, 7.0]
    );
    let bffl8 = read(release::built_in("bffl8").unwrap()).unwrap();
    assert_eq!(bffl8.stop, Stop::Duration(1.0));
    assert_eq!(
        bffl8.state(),
        [
            -1.42, -0.40, 0.81, 8.40, -0.15, -1.23, -0.081, -0.25, 4.40, -6.33, 0.37, -37.1
        ]
    );
    assert_eq!(
        bffl8
            .coefficients
            .iter()
            .find(|(n, _)| n == "C_Nr")
            .unwrap()
            .1,
        2.5e-7
    );
}

#[test]
fn every_built_in_release_is_read() {
    for (name, text) in release::BUILT_IN {
        let release = read(text).unwrap_or_else(|e| panic!("{name}: {e}"));
        let states = if release.model == "ball" { 6 } else { 12 };
        assert_eq!(release.initial.len(), states);
    }
}

#[test]
fn all_that_a_release_may_say() {
    let text = format!(
        "\u{feff}# a comment\r\nmodel = \"disc\"\nuntil = \"ground\"\nwind.constant = [1, -2.5, 0]\nknown = {{ omega = [0, 0, 50.0] }}\nparameters.m = 0x1\n{STATES}"
    );
    let release = read(&text).unwrap();
    assert_eq!(release.stop, Stop::Ground);
    assert_eq!(release.wind, [1.0, -2.5, 0.0]);
    assert_eq!(release.known, [("omega".to_string(), [0.0, 0.0, 50.0])]);
    assert_eq!(release.parameters, [("m".to_string(), 1.0)]);
    assert_eq!(release.initial[11], ("gammadot".to_string(), -50.0));
}

#[test]
fn a_release_that_states_no_wind_has_that_of_its_model() {
    let disc = load::load("disc", &[]).expect("the disc");
    let tree = disc.with_values([("wind_x", 2.0)]).expect("a wind");
    let model = tree.check().expect("a model");
    let wind = |stated: &str| {
        let text = format!("model = \"disc\"\nuntil = \"ground\"\n{stated}{STATES}");
        let read = release::read("r.toml", &text, |_| Ok(Vocabulary::of(&model)));
        read.expect("a release").wind
    };
    assert_eq!(wind(""), [2.0, 0.0, 0.0]);
    assert_eq!(wind("wind.constant = [0, 0, 0]\n"), [0.0; 3]);
    assert_eq!(Release::of(&model).wind, [2.0, 0.0, 0.0]);
}

#[test]
fn each_fault_has_its_message() {
    let head = "model = \"disc\"\nduration = 1.0\n";
    let cases = [
        String::new(),
        "model = ".into(),
        "model = \"disc\"\nmodel = \"disc\"\n".into(),
        format!("duration = 1.0\n{STATES}"),
        format!("model = 3\nduration = 1.0\n{STATES}"),
        format!("model = \"dics\"\nduration = 1.0\n{STATES}"),
        format!("model = \"disc\"\n{STATES}"),
        format!("{head}until = \"ground\"\n{STATES}"),
        format!("model = \"disc\"\nuntil = \"apex\"\n{STATES}"),
        format!("model = \"disc\"\nduration = -1\n{STATES}"),
        format!("model = \"disc\"\nduration = nan\n{STATES}"),
        format!("model = \"disc\"\nduration = \"1 s\"\n{STATES}"),
        format!("{head}rate = 120\n{STATES}"),
        format!("{head}parameter.m = 1\n{STATES}"),
        head.into(),
        format!("{head}[initial]\nx = 1\n"),
        format!("{head}initial = 3\n"),
        format!("{head}{STATES}thetadott = 1\n"),
        format!("{head}{}", STATES.replace("u=10", "u=\"ten\"")),
        format!("{head}{}", STATES.replace("u=10", "u=-inf")),
        format!("{head}{}", STATES.replace("u=10", "u=[10]")),
        format!("{head}[parameters]\nm = -0.175\nI_a = 0\nrho = -1\n{STATES}"),
        format!("{head}[parameters]\nm = true\nC_L0 = 0.1\nmass = 1\n{STATES}"),
        format!("{head}[coefficients]\nC_La = 11\nm = 1\nC_Lalpha = 2\n{STATES}"),
        format!("{head}[wind]\nconstant = [1, 2]\n{STATES}"),
        format!("{head}[wind]\nconstant = [1, \"2\", nan]\nconst = 1\n{STATES}"),
        format!("{head}[known]\nomga = [1, 2, 3]\nwind = [1, 2, 3]\n{STATES}"),
        "model = \"spin\"\nduration = 1\n[initial]\na = 0\nb = 0\nc = 0\nd = 0\n".into(),
        "model = \"spin\"\nduration = 99999999999999999999\n[initial]\na = 1\nb = 0\nc = 0\nd = 0\n".into(),
        format!("{head}deep = {}{}\n{STATES}", "[".repeat(5000), "]".repeat(5000)),
    ];
    let messages: Vec<String> = cases
        .iter()
        .map(|case| read(case).unwrap_err().to_string())
        .collect();
    insta::assert_snapshot!(messages.join("\n\n"), @r#"
    r.toml: found no end; expected duration = … (s) or until = "ground"
    r.toml: found no model; expected one, as in model = "disc"
    
    r.toml:1:9: this is no TOML: string values must be quoted, expected literal string
    
    r.toml:2:1: this is no TOML: duplicate key
    
    r.toml: found no model; expected one, as in model = "disc"
    
    r.toml:1:9: model is 3; expected a name or a path, as in model = "disc"
    
    r.toml:1:9: there is no model `dics`: no such file, and no such model is built in
    did you mean `disc`?
    built in are disc
    
    r.toml: found no end; expected duration = … (s) or until = "ground"
    
    r.toml:3:9: found both until and duration; expected one of the two
    
    r.toml:2:9: until is the text "apex"; expected "ground"
    
    r.toml:2:12: duration is -1; expected a time above 0 s and up to 600 s
    
    r.toml:2:12: duration is NaN; expected a finite number
    
    r.toml:2:12: duration is the text "1 s"; expected a number
    
    r.toml:3:1: unknown key "rate"; expected one of model, duration, until, parameters, coefficients, initial, throw, wind, known, inputs
    
    r.toml:3:1: unknown key "parameter"; did you mean "parameters"?
    
    r.toml: found no x, y, z, u, v, w, phi, theta, gamma, phidot, thetadot, gammadot in [initial]; expected every state of the model
    
    r.toml:3:1: found no y, z, u, v, w, phi, theta, gamma, phidot, thetadot, gammadot in [initial]; expected every state of the model
    
    r.toml:3:11: initial is 3; expected a table, as in [initial]
    
    r.toml:16:1: the model has no state "thetadott"; did you mean "thetadot"?
    
    r.toml:7:3: u is the text "ten"; expected a number
    
    r.toml:7:3: u is -inf; expected a finite number
    
    r.toml:7:3: u is a list of 1; expected a number
    
    r.toml:4:5: m is -0.175; expected a number above 0
    r.toml:5:7: I_a is 0; expected a number above 0
    r.toml:6:7: rho is -1; expected 0 or a number above
    
    r.toml:4:5: m is true; expected a number
    r.toml:5:1: C_L0 is one of the model's coefficients; expected it in [coefficients]
    r.toml:6:1: the model has no "mass" among its parameters; expected one of m, I_a, I_d, d, A, rho, g
    
    r.toml:4:8: C_La is 11; expected a number from -10 to 10
    r.toml:5:1: m is one of the model's parameters; expected it in [parameters]
    r.toml:6:1: the model has no "C_Lalpha" among its coefficients; expected one of C_L0, C_La, C_D0, C_Da, C_Ma, C_Mq, C_Rr, C_Nr
    
    r.toml:4:12: constant wind is a list of 2; expected three numbers, as in [0.0, 0.0, 0.0]
    
    r.toml:4:16: constant wind is the text "2"; expected a number
    r.toml:4:21: constant wind is NaN; expected a finite number
    r.toml:5:1: unknown key "const" in [wind]; did you mean "constant"?
    
    r.toml:4:1: the model has no input "omga"; did you mean "omega"?
    r.toml:5:1: wind stands here; expected it in [wind], as in constant = [3.0, 0.0, 0.0]
    
    r.toml:3:1: the quaternion a, b, c, d has length 0; expected 1
    
    r.toml:2:12: duration is 100000000000000000000; expected a time above 0 s and up to 600 s
    
    r.toml:3:88: this is no TOML: cannot recurse further; max recursion depth met
    "#);
}

#[test]
fn files_that_cannot_be_read() {
    let folder = std::env::temp_dir().join(format!("hyzer-release-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let read = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        std::fs::write(&path, bytes).unwrap();
        let error = release::read_file(&path, |_| Ok(disc())).unwrap_err();
        error
            .faults
            .into_iter()
            .map(|f| format!("{:?} {}", f.location, f.message))
            .collect::<Vec<_>>()
            .join("\n")
    };
    insta::assert_snapshot!(read("latin1.toml", b"# ok\nmodel = \"\xe9\"\n"), @"Some((2, 10)) found the byte 0xe9; expected UTF-8 text");
    insta::assert_snapshot!(read("huge.toml", &vec![b'#'; (1 << 20) + 1]), @"None has 1048577 bytes; a release has at most 1048576");
    insta::assert_snapshot!(read("zero.toml", b"model = \"a\0b\"\n"), @r#"Some((1, 11)) this is no TOML: invalid basic string, expected non-double-quote visible characters, `\`"#);
    assert!(
        release::read_file(&folder.join("absent.toml"), |_| Ok(disc()))
            .unwrap_err()
            .to_string()
            .contains("found no such file; expected a release")
    );
    std::fs::remove_dir_all(&folder).unwrap();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..Default::default() })]

    #[test]
    fn no_text_is_read_as_a_number_that_is_none(cut in 0..2000_usize, put in "[-=\\[\\]\"a-z0-9 .\n{}#',]{0,12}", which in 0..release::BUILT_IN.len()) {
        let text = release::BUILT_IN[which].1;
        let cut = text.char_indices().map(|(i, _)| i).take_while(|i| *i <= cut).last().unwrap_or(0);
        let text = format!("{}{put}{}", &text[..cut], &text[cut..]);
        match read(&text) {
            Ok(release) => {
                prop_assert!(release.initial.iter().all(|(_, v)| v.is_finite()));
                prop_assert!(release.parameters.iter().chain(&release.coefficients).all(|(_, v)| v.is_finite()));
            }
            Err(error) => prop_assert!(!error.faults.is_empty() && error.to_string().len() < 5000),
        }
    }
}

#[test]
fn the_built_in_releases_speak_of_the_models_there_are() {
    for (name, text) in release::BUILT_IN {
        let read = release::read(name, text, |model| {
            model_spec::load::load(model, &[]).map(|model| Vocabulary::of(&model))
        });
        assert!(read.is_ok(), "{}", read.unwrap_err());
    }
}

#[test]
fn a_state_that_an_effect_adds_may_be_left_out() {
    let text = "\
model stone;
param m = 1 kg;
frame N;
point stone { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
effect gust {
  site wind;
  state W_x = 2 m/s;
  der(W_x) = 0;
  force gust = 1 [kg/s]*W_x*N.1;
}
";
    let model = model_spec::load::from_text("stone.hyz", text, &["gust"]).unwrap();
    let read = |more: &str| {
        let release = format!(
            "model = \"stone\"\nduration = 1\n[initial]\nx=0\ny=0\nz=1\nvx=10\nvy=0\nvz=0\n{more}"
        );
        release::read("r.toml", &release, |_| Ok(Vocabulary::of(&model))).unwrap()
    };
    assert_eq!(read("").initial[6], ("W_x".into(), 2.0));
    assert_eq!(read("W_x = -1").initial[6], ("W_x".into(), -1.0));
}
