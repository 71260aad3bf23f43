//! Files beside a model: included statements and the knots of tables.

use model_spec::ModelTree;
use model_spec::load::{from_text, load};
use model_spec::model::Model;
use std::fs;
use std::path::PathBuf;

const BODY: &str = "frame N;
param m = 0.5 kg;
point probe { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
";

/// A folder of its own for the files of a test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, files: &[(&str, &str)]) -> Folder {
        let folder =
            std::env::temp_dir().join(format!("hyzer-files-{name}-{}", std::process::id()));
        for (path, text) in files {
            let path = folder.join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        Folder(folder)
    }

    fn path(&self, name: &str) -> String {
        self.0.join(name).to_string_lossy().into_owned()
    }

    fn load(&self) -> Model {
        load(&self.path("main.hyz"), &[]).unwrap_or_else(|error| panic!("{error}"))
    }

    fn refused(name: &str, files: &[(&str, &str)]) -> String {
        let folder = Folder::new(name, files);
        let error = load(&folder.path("main.hyz"), &[]).unwrap_err();
        error.to_string().replace(&folder.path(""), "")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_model_is_made_of_files_and_prints_as_one() {
    let main = "model probe;
        include \"parts/air.hyz\";
        include \"body.hyz\";
        table C_D(Ma) = \"parts/drag.csv\" linear;
        table C_L(alpha: deg, Ma) = \"lift.csv\";
        force drag = -rho*S[2]*C_D(V/sound)*C_L(alpha, V/sound)*V*velocity;";
    let air = "//! The air.
        include \"../none.hyz\"; // is told below
        param rho = 1.2 kg/m^3; param sound = 340 m/s; let V = norm(velocity); let alpha = 3 [deg];";
    let air = air.replace(
        "include \"../none.hyz\"; // is told below",
        "include \"wind.hyz\";",
    );
    let folder = Folder::new(
        "whole",
        &[
            ("main.hyz", main),
            ("parts/air.hyz", &air),
            ("parts/wind.hyz", "param S[i] for i in 1..2 = (1, 2) cm^2;"),
            ("body.hyz", BODY),
            ("parts/drag.csv", "Ma,C_D\n0,0.1\n0.8,0.12\n1.2, 0.4\n"),
            (
                "lift.csv",
                "# measured, by hand\nalpha\\Ma;0.2;0.8\n-5;-0.3;-0.4\n0;0;0\n\n10;0.9;1.1\n",
            ),
        ],
    );
    let model = folder.load();
    assert_eq!(
        model.tables[0].points(),
        [(0.0, 0.1), (0.8, 0.12), (1.2, 0.4)]
    );
    let [alpha, mach] = &model.tables[1].arguments[..] else {
        panic!("two arguments")
    };
    assert_eq!(mach.knots, [0.2, 0.8]);
    assert!((alpha.knots[2] - 10_f64.to_radians()).abs() < 1e-15);
    assert_eq!(model.tables[1].values, [-0.3, -0.4, 0.0, 0.0, 0.9, 1.1]);
    let names: Vec<&str> = model
        .sources
        .iter()
        .map(|s| s.name.rsplit('/').next().unwrap())
        .collect();
    assert_eq!(
        names,
        [
            "main.hyz", "air.hyz", "wind.hyz", "body.hyz", "drag.csv", "lift.csv"
        ]
    );

    let text = ModelTree::of(&model).to_text("");
    let again = from_text("alone.hyz", &text, &[]).unwrap_or_else(|e| panic!("{text}\n{e}"));
    assert_eq!(again.tables[1].values, model.tables[1].values);
    assert_eq!(again.params.len(), model.params.len());
    assert!(!text.contains("include"));
}

#[test]
fn messages_point_into_the_file_that_is_wrong() {
    let refused = Folder::refused(
        "wrong",
        &[
            ("main.hyz", "model probe;\ninclude \"part.hyz\";"),
            ("part.hyz", &format!("{BODY}let a = m + z;")),
        ],
    );
    assert!(
        refused.contains("quantities of different units"),
        "{refused}"
    );
    assert!(refused.contains("part.hyz:4:"), "{refused}");
    let refused = Folder::refused(
        "csv",
        &[
            (
                "main.hyz",
                &format!("model probe;\n{BODY}table t(a) = \"t.csv\";"),
            ),
            ("t.csv", "0, 1\n1, two\n"),
        ],
    );
    assert!(
        refused.contains("expected a number, found `two`"),
        "{refused}"
    );
    assert!(refused.contains("t.csv:2:4"), "{refused}");
}

#[test]
fn files_are_beside_the_model_and_bounded() {
    let with = |statement: &str| format!("model probe;\n{BODY}{statement}");
    for (statement, message) in [
        ("include \"/etc/passwd\";", "does not lie beside"),
        ("include \"../other.hyz\";", "does not lie beside"),
        ("include \"none.hyz\";", "cannot be read"),
        ("include \"folder\";", "is no file"),
        ("include \"model.hyz\";", "has no `model`"),
        ("table t(a) = \"t.csv\";", "a line has a knot and its value"),
        (
            "table t(a, b) = \"t.csv\" monotone;",
            "cannot be `monotone`",
        ),
        ("include \"1.hyz\";", "at most 8 deep"),
    ] {
        let mut files = vec![
            ("folder/a.hyz".to_owned(), String::new()),
            ("model.hyz".to_owned(), "model other;".to_owned()),
            ("t.csv".to_owned(), "0, 1, 2\n1, 3, 4\n2, 3, 4".to_owned()),
            ("main.hyz".to_owned(), with(statement)),
        ];
        files.extend((1..20).map(|k| (format!("{k}.hyz"), format!("include \"{}.hyz\";", k + 1))));
        let files: Vec<(&str, &str)> = files
            .iter()
            .map(|(a, b)| (a.as_str(), b.as_str()))
            .collect();
        let refused = Folder::refused("bounds", &files);
        assert!(refused.contains(message), "{statement}: {refused}");
    }
    let error = from_text("<text>", &with("include \"a.hyz\";"), &[]).unwrap_err();
    assert!(
        error.to_string().contains("this text is not in a file"),
        "{error}"
    );
}

#[test]
fn what_two_files_include_is_there_once() {
    let folder = Folder::new(
        "circle",
        &[
            (
                "main.hyz",
                "model probe; include \"a.hyz\"; include \"b.hyz\";",
            ),
            (
                "a.hyz",
                "include \"body.hyz\"; include \"b.hyz\"; let V = norm(velocity);",
            ),
            (
                "b.hyz",
                "include \"body.hyz\"; include \"a.hyz\"; let W = 2*V;",
            ),
            ("body.hyz", BODY),
        ],
    );
    assert_eq!(folder.load().aux_variables.len(), 2);
}

#[test]
fn a_number_in_a_file_is_as_small_as_one_in_a_text() {
    let text = format!("model probe;\n{BODY}table T(a) = \"t.csv\";\nlet b = T(x/(1 m));\n");
    let folder = Folder::new(
        "small",
        &[("probe.hyz", &text), ("t.csv", "0,1\n1,1e-400\n")],
    );
    let error = load(&folder.path("probe.hyz"), &[])
        .unwrap_err()
        .to_string();
    assert!(error.contains("1e-400 is too small"), "{error}");
}

/// What is open in an editor counts, saved or not.
#[test]
fn open_texts_stand_for_their_files() {
    let text = format!("model probe;\n{BODY}include \"part.hyz\";\nlet b = 2*a;\n");
    let folder = Folder::new(
        "open",
        &[("probe.hyz", &text), ("part.hyz", "let a = 3;\n")],
    );
    let part = folder.path("part.hyz");
    let open = |path: &std::path::Path| {
        (path.to_string_lossy() == part).then(|| "let a = 3 [m];\nlet c = missing;\n".to_owned())
    };
    let loaded = model_spec::load::inspect_open(&folder.path("probe.hyz"), &text, &open).unwrap();
    let faults: Vec<&str> = loaded
        .diagnostics
        .iter()
        .map(|own| own.message.as_str())
        .collect();
    assert_eq!(faults, ["there is no `missing`"]);
    assert_eq!(loaded.diagnostics[0].span.source, 1);
}
