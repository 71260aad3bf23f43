//! Bodies after the first one: their equations, effects on them, and the text of models that have them.

use flight::CompiledModel;
use flight::release::{Release, Stop};
use flight::simulate;
use model_spec::load::from_text;
use model_spec::model::Model;
use model_spec::syntax;
use ode::IntegrationOptions;
use std::collections::BTreeMap;

const HEAD: &str = "model probe;
param m = 0.3 kg;
param J = 1 kg*m^2;
frame N;
";

/// Frames, the plate's angular velocity, and states at the start, of an attitude.
type Attitude = (&'static str, &'static str, &'static [(&'static str, f64)]);

const ANGLES: &[(&str, f64)] = &[
    ("phi", 0.3),
    ("theta", 0.7),
    ("psi", -0.2),
    ("phidot", 2.0),
    ("thetadot", -0.3),
    ("psidot", 4.0),
];

const ATTITUDES: [Attitude; 4] = [
    (
        "frame P = N by quaternion (e0, e1, e2, e3);",
        "angular velocity (p, q, r) in P = (1, 20, 3) rad/s;",
        &[],
    ),
    (
        "frame A = N turned phi about 1; frame B = A turned theta about 2; frame P = B turned psi about 3;",
        "",
        ANGLES,
    ),
    (
        "frame A = N turned phi about 3; frame B = A turned theta about 1; frame P = B turned psi about 3;",
        "",
        ANGLES,
    ),
    (
        "frame A = N turned phi about 1; frame B = A turned theta about 3; frame P = B turned psi about 2;",
        "",
        ANGLES,
    ),
];

/// A plate, alone: its velocity is in `{V}`, its moments of inertia are `{I}`.
const PLATE: &str = "body plate {
  mass m;
  inertia {I} in P;
  fixed in P;
  position (x, y, z) in N = (0, 0, 2) m;
  velocity (u, v, w) in {V} = (5, 1, 2) m/s;
  {W}
}
";

const STONE: &str = "point stone {
  mass 1 kg;
  position (a, b, c) in N;
  velocity (da, db, dc) in N = (1, 0, 0) m/s;
}
force weight = -9.81 [N]*N.3;
";

/// Loads on the plate, which they name by `{on}`, by its velocity `{v}` and its angular velocity `{w}`.
const LOADS: &str = "force weight{on} = -m*9.81 [m/s^2]*N.3;
force drag{on} = -0.02 [kg/m]*norm({v})*{v};
moment damping{on} = -1e-3 [N*m*s]*{w} + in_P(2e-3 [N*m]*N.1);
";

fn loads(on: &str, of: &str) -> String {
    let text = LOADS.replace("{on}", on);
    let text = text.replace("{v}", &format!("velocity{of}"));
    text.replace("{w}", &format!("angular_velocity{of}"))
}

fn read(text: &str) -> Model {
    from_text("probe.hyz", text, &[]).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// Values of states after a second, by name; `start` has those at the release that are not the defaults.
fn flown(model: &Model, start: &[(&str, f64)]) -> BTreeMap<String, f64> {
    let body = CompiledModel::new(model);
    let release = start.iter().fold(Release::of(model), |release, own| {
        release.with_initial(own.0, own.1)
    });
    let release = Release {
        stop: Stop::Duration(1.0),
        ..release
    };
    let options = IntegrationOptions::with_tolerance(1e-12);
    let flight = simulate(&body, &release, &options).unwrap_or_else(|error| panic!("{error}"));
    let names = body.layout().states.iter().cloned();
    names.zip(flight.end_state).collect()
}

#[test]
fn a_second_body_flies_as_it_does_alone() {
    let full = "((2e-3*J, 3e-4*J, -1e-4*J), (3e-4*J, 4e-3*J, 2e-4*J), (-1e-4*J, 2e-4*J, 5e-3*J))";
    let inertias = ["diag(2e-3*J, 4e-3*J, 5e-3*J)", full];
    for (frames, angular, start) in ATTITUDES {
        let head = format!("{HEAD}{frames}\n");
        for (inertia, frame) in inertias
            .into_iter()
            .flat_map(|own| [(own, "N"), (own, "P")])
        {
            let plate = PLATE.replace("{I}", inertia).replace("{V}", frame);
            let plate = plate.replace("{W}", angular);
            let alone = read(&format!("{head}{plate}{}", loads("", "")));
            let second = read(&format!(
                "{head}{STONE}{plate}{}",
                loads(" on plate", "_of_plate")
            ));
            assert_eq!(second.states.len(), alone.states.len() + 6);
            let found = flown(&second, start);
            for (name, expected) in flown(&alone, start) {
                let difference = (found[&name] - expected).abs();
                assert!(
                    difference < 1e-9,
                    "{frames} {inertia} {frame}: {name} {difference}"
                );
            }
        }
    }
}

/// More loads than a sum in a row may have operations.
#[test]
fn a_second_body_has_many_loads() {
    let text = "model many; frame N;
        point one { mass 1 kg; position (x, y, z) in N; velocity (u, v, w) in N; }
        point other { mass 2 kg; position (a, b, c) in N; velocity (da, db, dc) in N; }
        force pull[i] on other for i in 1..400 = i*1 [N]*N.1;";
    let model = read(text);
    let body = CompiledModel::new(&model);
    let release = Release {
        stop: Stop::Duration(1.0),
        ..Release::of(&model)
    };
    let flight = simulate(&body, &release, &IntegrationOptions::with_tolerance(1e-10));
    let flight = flight.unwrap_or_else(|error| panic!("{error}"));
    let speed = flight.end_state[body.layout().state("da").expect("da").index()];
    assert!((speed - 200.0 * 401.0 / 2.0).abs() < 1e-6, "{speed}");
}

const TWO: &str = "model two;
param L = 1 m;
frame N;
point one { mass 2 kg; position (x, y, z) in N; velocity (u, v, w) in N; }
point other {
  mass 3 kg;
  position (a, b, c) in N = (0, 0, -1) m;
  velocity (da, db, dc) in N;
}
force weight = -2 [kg]*9.81 [m/s^2]*N.3;
/// its weight
force weight on other = -3 [kg]*9.81 [m/s^2]*N.3;
function drag(k: kg/s, v: vector m/s in N): vector N in N { return -k*v; }
force drag on other = drag(0.2 [kg/s], velocity_of_other);
let line = position_of_other - position;
solve { unknown T: N; constraint norm(line) = L within 1 mm; }
force line = T*unit(line);
force line on other = -T*unit(line);
effect push on two {
  site side;
  variables none;
  coefficient F = 0 N in -10 .. 10;
  force push on other = F*N.2;
}
effect more_drag on two {
  site drag;
  variables speed;
  coefficient more = 0 in -1 .. 5;
  replace force drag on other = previous*(1 + more);
}
";

#[test]
fn effects_add_loads_to_a_second_body_and_replace_them() {
    let with = ["push", "more_drag"];
    let model = from_text("two.hyz", TWO, &with).unwrap_or_else(|error| panic!("{error}"));
    let body = CompiledModel::new(&model);
    let mut release = Release {
        stop: Stop::Duration(0.5),
        ..Release::of(&model)
    };
    let options = IntegrationOptions::with_tolerance(1e-10);
    let end = |release: &Release| {
        let flight = simulate(&body, release, &options).unwrap_or_else(|error| panic!("{error}"));
        let value = |name| flight.end_state[body.layout().state(name).expect(name).index()];
        ["v", "db", "dc", "w"].map(value)
    };
    let free = end(&release);
    release.parameters.push(("F".into(), 5.0));
    let pushed = end(&release);
    // Two bodies on a line, pushed together: momentum grows by the push.
    let momentum = 2.0 * pushed[0] + 3.0 * pushed[1];
    assert!(free[0].abs() + free[1].abs() < 1e-12, "{free:?}");
    // Of 5 N in half a second, less what the drag takes.
    assert!(momentum > 2.4 && momentum < 2.5, "{momentum}");
    release.parameters.push(("more".into(), 4.0));
    assert!(end(&release)[2] > pushed[2] + 0.1);
    // Its text is the model again, with the loads where they were.
    let mut tree = syntax::ast::File::clone(&model.tree);
    let is_effect =
        |item: &syntax::ast::Item| matches!(item.kind, syntax::ast::ItemKind::Effect(_));
    tree.items.retain(|item| !is_effect(item));
    let text = tree.to_string();
    assert!(
        text.contains("point other {") && text.contains("force push on other"),
        "{text}"
    );
    let again = syntax::parse("again.hyz", &text);
    assert!(
        again.diagnostics.is_empty(),
        "{text}\n{:?}",
        again.diagnostics
    );
    assert_eq!(again.file.to_string(), text);
    let again = read(&text);
    assert_eq!(again.states.len(), model.states.len());
    assert_eq!(again.aux_variables.len(), model.aux_variables.len());
}
