//! What is printed reads the same.

use crate::check;
use crate::load::{BODIES, EFFECTS, MODELS, REFUTED};
use crate::syntax::ast::{BinaryOp, ExprKind, File};
use crate::syntax::parse;

#[test]
fn what_is_written_reads_the_same() {
    for (name, text) in MODELS.iter().chain(BODIES).chain(REFUTED).chain(EFFECTS) {
        let once = parse(name, text).file.to_string();
        let read = parse(name, &once);
        assert!(
            read.diagnostics.is_empty(),
            "{name}: {:?}",
            read.diagnostics
        );
        assert_eq!(read.file.to_string(), once, "{name}");
        assert_eq!(read.file.doc, parse(name, text).file.doc);
    }
}

#[test]
fn every_form_of_statement_is_written() {
    let text = "\
//! doc
model probe;
/// a unit with a half power
param k = -3e-5 kg*m^(1/2)/s^2 in -1 .. 0;
input wind in N = (0, -1, 2) m/s;
frame N;
frame C = N by quaternion (q0, q1, q2, q3);

body probe {
  mass 2*k;
  inertia ((k, 0, 0), (0, k, 0), (0, 0, k)) in C;
  fixed in C;
  position (x, y, z) in N;
  velocity (u, v, w) in N;
  angular velocity (p, q, r) in C;
  angular velocity in N;
}

claim body top {
  mass 2*k;
  inertia ((k, 0, 0), (0, k, 0), (0, 0, k)) in C;
  fixed in C;
  axis C.3;
  position (x, y, z) in N;
  velocity velocity - wind;
  angular velocity (p, q, r) in C;
  force weight*N.3;
  moment cross(position, N.3);
}

claim point p {
  mass k;
}

let a: N*m = -x^2*(y + z)^(1/2)/(k*3) - (x - (y - z)) + 2 [m/s^2]*time;
let b = ((x*y)^2)^3 + x^y^2 + (-x)^2 + -(x*y);
let c = (x, y, z) in N + unit(wind, N.3) × C.1 · wind;

clock 1 + 2*k;

check \"a\" {
  set wind = (1, 2, 3) m/s;
  expect der(x) = 3 m/s within 1e-9;
}

/// doc
effect e on probe, disc {
  source \"somewhere\";
  site drag;
  variables alpha, spin;
  input marker_is in N = (0, 0, 0);
  coefficient c_0 = 0;
  negligible c_0 0.1;
  replace a = previous*c_0;
  replace observe mark = previous;
  replace clock = previous*(1 + c_0);
  state W_x = 0 m/s;
  der(W_x) = 0;
  replace inertia diag(k, k, k) in C;
}

effect general {
  needs V: m/s, vector air_velocity: m/s or 2*velocity, alpha;
  generalises e, other;
  site drag;
  replace observe = previous + mass*inertial.3;
  replace der(x) = previous;
}
";
    let parsed = parse("probe", text);
    assert!(parsed.diagnostics.is_empty(), "{:?}", parsed.diagnostics);
    let once = parsed.file.to_string();
    let again = parse("probe", &once);
    assert!(
        again.diagnostics.is_empty(),
        "{once}\n{:?}",
        again.diagnostics
    );
    assert_eq!(again.file.to_string(), once);
    for part in [
        "k = -3e-5 kg*m^(1/2)/s^2 in",
        "2 [m/s^2]*time",
        "-(x*y)",
        "x - (y - z)",
        "velocity velocity - wind;",
        "claim point p {\n  mass k;\n}",
    ] {
        assert!(once.contains(part), "{part} in\n{once}");
    }
}

#[test]
fn what_a_body_stands_for_is_written_where_it_was_changed() {
    let text = "\
model two;
frame N;
frame C = N by quaternion (e0, e1, e2, e3);
point a { mass 1 kg; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
body b {
  mass 2 kg;
  inertia diag(1 [kg*m^2], 2 [kg*m^2], 3 [kg*m^2]) in C;
  fixed in C;
  position (x_b, y_b, z_b) in N = (1, 2, 3) m;
  velocity (u, v, w) in C;
  angular velocity (p, q, r) in C;
}
force pull = -1 [N/m]*(position - position_of_b);
force pull on b = 1 [N/m]*(position - position_of_b);
moment turn on b = 1 [N*m]*C.1;
";
    let states = |file: &File| {
        let model = check(file, &[]).model.expect("a model");
        let states = model.states.into_iter();
        states.map(|own| (own.name, own.value)).collect::<Vec<_>>()
    };
    let parsed = parse("two", text);
    assert!(parsed.diagnostics.is_empty(), "{:?}", parsed.diagnostics);
    let file = parsed.file;
    let changeable = |at: &usize| {
        let item = &file.items[*at];
        item.is_of_body() && item.kind.value().is_some()
    };
    let places: Vec<usize> = (0..file.items.len()).filter(changeable).collect();
    assert!(places.len() > 20);
    for at in places {
        let mut changed = file.clone();
        let value = changed.items[at].kind.roots_mut().swap_remove(0);
        let (own, span) = (Box::new(value.clone()), value.span);
        value.kind = ExprKind::Binary(BinaryOp::Add, own.clone(), own);
        value.span = span;
        let once = changed.to_string();
        let read = parse("two", &once);
        assert!(read.diagnostics.is_empty(), "{once}{:?}", read.diagnostics);
        assert_eq!(read.file.to_string(), once);
        assert_eq!(states(&read.file), states(&changed), "{once}");
    }
}
