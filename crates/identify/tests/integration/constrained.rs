//! Fits of models with constraints: initial states lie where the constraints hold, and coefficients are recovered.

use dataset::synthesize::{Corruption, Plan, Spread, flights};
use flight::release::{Release, Stop};
use identify::{FitOptions, fit};

/// A bob on a rod in the air, as a declared point.
const DECLARED: &str = "model bob;
param m = 0.5 kg;
param L = 1.2 m;
coefficient k = 0.05 kg/m in 0 .. 1;
frame N;
point bob { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
force weight = -m*9.81 [m/s^2]*N.3;
force drag = -k*norm(velocity)*velocity;
force rod = -T*unit(position);
solve rod {
  unknown T: N;
  constraint norm(position) = L within 1 mm;
}
marker mark in N;
observe mark = position + mark;
";

/// The same by equations as they are.
const STATED: &str = "model bob;
param m = 0.5 kg;
param L = 1.2 m;
coefficient k = 0.05 kg/m in 0 .. 1;
frame N;
state x = 0.72 m;
state y = 0 m;
state z = -0.96 m;
state vx = 0 m/s;
state vy = 1 m/s;
state vz = 0 m/s;
let r = (x, y, z) in N;
let v = (vx, vy, vz) in N;
der(x) = vx;
der(y) = vy;
der(z) = vz;
solve rod {
  unknown T: N;
  m*der(v) = -T*r/L - m*9.81 [m/s^2]*N.3 - k*norm(v)*v;
  constraint norm(r) = L within 1 mm;
}
marker mark in N;
observe mark = r + mark;
";

#[test]
fn the_drag_of_a_bob_on_a_rod_is_recovered() {
    for text in [DECLARED, STATED] {
        let model = model_spec::load::from_text("bob.hyz", text, &[]).expect("a model");
        let states = [("x", 0.72), ("z", -0.96), ("vy", 1.2)];
        let mut release = states.iter().fold(Release::of(&model), |release, own| {
            release.with_initial(own.0, own.1)
        });
        release.stop = Stop::Duration(3.0);
        let plan = Plan {
            flights: 4,
            rate: 50.0,
            spread: Spread {
                angle: 1e-4,
                ..Spread::default()
            },
            noise: Corruption {
                sigma: 1e-3,
                ..Corruption::default()
            },
            ..Plan::default()
        };
        let made = flights(&model, &[release], &plan).expect("made");
        let fitted = fit(&model, &made.dataset, &FitOptions::default()).expect("a fit");
        let k = &fitted.report.coefficients["k"];
        println!("k = {} ± {}", k.value, k.std_error);
        assert!((k.value - 0.05).abs() < 4.0 * k.std_error, "{k:?}");
        assert!(k.std_error < 2e-3, "{k:?}");
        let used = fitted
            .report
            .flights
            .iter()
            .filter(|flight| flight.is_used());
        assert_eq!(used.count(), 4);
        for (flight, (_, truth)) in fitted.report.flights.iter().zip(&made.truth.initial) {
            let value = |name: &str| flight.initial[name].value;
            let length = value("x").hypot(value("y")).hypot(value("z"));
            assert!((length - 1.2).abs() < 1e-9, "{length}");
            let along: f64 = ["x", "y", "z"]
                .iter()
                .map(|name| value(name) * value(&format!("v{name}")))
                .sum();
            assert!(along.abs() < 1e-9, "{along}");
            for (name, found) in &flight.initial {
                let distance = (found.value - truth[name]).abs();
                assert!(distance < 5.0 * found.std_error, "{name}: {found:?}");
            }
        }
    }
}

/// A load on a line below a canopy, whose flights begin far from where the model does.
#[test]
fn the_drag_of_a_canopy_with_its_load_is_recovered() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../examples/gallery/parachute_payload.hyz"
    );
    let text = std::fs::read_to_string(path).expect("a model");
    let text = format!("{text}\nmarker mark in N;\nobserve mark = position + mark;\n");
    let model = model_spec::load::from_text("drop.hyz", &text, &[]).expect("a model");
    let releases = (0..4).map(|number| {
        let far = 40.0 * f64::from(number) - 70.0;
        let states = [("x", far), ("x_p", far + 3.6), ("y", -far), ("y_p", -far)];
        let at = Release {
            stop: Stop::Duration(2.5),
            parameters: vec![("CDS_c".into(), 6.3)],
            ..Release::of(&model)
        };
        states
            .iter()
            .fold(at, |at, own| at.with_initial(own.0, own.1))
    });
    let plan = Plan {
        flights: 4,
        rate: 60.0,
        noise: Corruption {
            sigma: 2e-3,
            ..Corruption::default()
        },
        ..Plan::default()
    };
    let made = flights(&model, &releases.collect::<Vec<_>>(), &plan).expect("made");
    let fitted = fit(&model, &made.dataset, &FitOptions::default()).expect("a fit");
    let own = &fitted.report.coefficients["CDS_c"];
    assert!(
        (own.value - 6.3).abs() < 4.0 * own.std_error && own.std_error < 0.5,
        "{own:?}"
    );
    let rms = fitted.report.rms();
    assert!((rms / 2e-3 - 1.0).abs() < 0.15, "{rms}");
}

#[test]
fn a_coefficient_in_a_constraint_is_refused() {
    let text = DECLARED.replace("param L = 1.2 m;", "coefficient L = 1.2 m in 0.1 .. 9;");
    let model = model_spec::load::from_text("bob.hyz", &text, &[]).expect("a model");
    let mut release = Release::of(&model).with_initial("z", -1.2);
    release.stop = Stop::Duration(0.5);
    let plan = Plan {
        flights: 2,
        ..Plan::default()
    };
    let made = flights(&model, &[release], &plan).expect("made");
    let error = fit(&model, &made.dataset, &FitOptions::default());
    let message = error.err().expect("refused").to_string();
    assert!(message.contains("found the coefficient L"), "{message}");
}
