//! Models with a line changed, and their checks.

use codegen::Compiled;
use codegen::program::Function;
use codegen::tape::{Inputs, Tape};
use model_spec::load::{Loaded, inspect, inspect_text};
use oracle::Point;
use verify::Options;
use verify::checks::effect_reference::EFFECT_REFERENCE;
use verify::checks::effects::EFFECTS;
use verify::report::{Report, Row, Verdict};

/// Few points and no mutants: a fault shows at almost every point.
pub const QUICK: Options = Options {
    seed: 1,
    cases: 24,
    mutants: false,
    effects: true,
};

/// [`QUICK`] without the checks of effects.
#[allow(dead_code)]
pub const WITHOUT_EFFECTS: Options = Options {
    effects: false,
    ..QUICK
};

/// Checks that refute a built-in model for a defect that is known and not the model's.
pub const KNOWN: [&str; 0] = [];

/// What is refuted, but for what is known.
#[allow(dead_code)]
pub fn refuted(report: &Report) -> Vec<&'static str> {
    let refuted = report
        .rows
        .iter()
        .filter(|row| row.verdict == Verdict::Refuted);
    refuted
        .map(|row| row.check)
        .filter(|check| !KNOWN.contains(check))
        .collect()
}

/// A built-in model.
#[allow(dead_code)]
pub fn built_in(name: &str) -> Loaded {
    inspect(name, &[]).unwrap()
}

/// A built-in model with a piece of its text exchanged.
#[allow(dead_code)]
pub fn edited(name: &str, from: &str, to: &str) -> Loaded {
    let text = built_in(name).sources[0].text.clone();
    assert!(text.contains(from), "{name} has no `{from}`");
    inspect_text(name, &text.replacen(from, to, 1), &[]).unwrap()
}

/// A built-in model with lines added.
#[allow(dead_code)]
pub fn with_lines(name: &str, lines: &str) -> Loaded {
    let text = built_in(name).sources[0].text.clone() + lines;
    inspect_text(name, &text, &[]).unwrap()
}

/// The row of a check.
#[allow(dead_code)]
pub fn row<'a>(report: &'a Report, check: &str) -> &'a Row {
    let found = report.rows.iter().find(|row| row.check == check);
    found.unwrap_or_else(|| panic!("no check is called `{check}`"))
}

/// What a check says of a model. The checks of effects, which compile the model with each effect, run only where they
/// are asked for.
#[allow(dead_code)]
pub fn verdict(loaded: &Loaded, check: &str) -> Verdict {
    assert!(loaded.model.is_some(), "{:#?}", loaded.diagnostics);
    let options = Options {
        effects: [EFFECTS, EFFECT_REFERENCE].contains(&check),
        ..QUICK
    };
    row(&verify::run(loaded, &options), check).verdict
}

/// A body of revolution about its first axis, by angles about 3, 2 and 1, in still air.
#[allow(dead_code)]
pub const TOP: &str = "model top;
param m = 0.43 kg;
param I_l = 0.0019 kg*m^2;
param I_t = 0.0029 kg*m^2;
param g = 9.81 m/s^2;
coefficient k = 0.01 kg/m in 0 .. 1;
coefficient c = 0.0001 N*m*s in 0 .. 1;
frame N;
frame A = N turned psi about 3;
frame B = A turned theta about 2;
frame C = B turned phi about 1;
body top {
  mass m; inertia diag(I_l, I_t, I_t) in B; fixed in C;
  position (x, y, z) in N; velocity (vx, vy, vz) in N;
}
force weight = -m*g*N.3;
force drag = -k*norm(velocity)*velocity;
moment damping = -c*angular_velocity;
";

/// Results of a function at points.
#[allow(dead_code)]
pub fn results(compiled: &Compiled, function: &Function, points: &[Point<f64>]) -> Vec<f64> {
    let (prepare, tape) = (
        Tape::new(&compiled.prepare.program),
        Tape::new(&function.program),
    );
    let mut all = Vec::new();
    for point in points {
        let p = point.parameters();
        let before = Inputs {
            t: point.time,
            x: &point.states,
            p: &p,
            prepared: &[],
            marker: point.marker.as_slice(),
        };
        let mut prepared = vec![0.0; prepare.outputs()];
        prepare.eval(before, &mut Vec::new(), &mut prepared);
        let mut out = vec![0.0; tape.outputs()];
        let inputs = Inputs {
            prepared: &prepared,
            ..before
        };
        tape.eval(inputs, &mut Vec::new(), &mut out);
        all.extend(out);
    }
    all
}
