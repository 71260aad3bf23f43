//! Models with a line changed, and their checks.

use codegen::Compiled;
use codegen::program::Function;
use codegen::tape::{Inputs, Tape};
use model_spec::load::{Loaded, inspect, inspect_text};
use oracle::Point;
use verify::Options;
use verify::checks::effects::{EFFECT_REFERENCE, EFFECTS};
use verify::report::{Report, Row, Verdict};

/// Options for fast verifications: few random points, since most faults show at almost every point, and no mutation
/// testing.
pub const QUICK: Options = Options {
    seed: 1,
    cases: 24,
    mutants: false,
    effects: true,
};

/// Options for fast verifications without checks of effects: few random points and no mutation testing.
#[allow(dead_code)]
pub const WITHOUT_EFFECTS: Options = Options {
    effects: false,
    ..QUICK
};

/// Names of checks that refute a built-in model although the model is correct; their failures are ignored.
pub const KNOWN: [&str; 0] = [];

/// Names of the refuted checks of a report, except those in [`KNOWN`].
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

/// Loads a built-in model without effects.
#[allow(dead_code)]
pub fn built_in(name: &str) -> Loaded {
    inspect(name, &[]).unwrap()
}

/// Loads a built-in model after the first occurrence of `from` in its text has been replaced by `to`.
#[allow(dead_code)]
pub fn edited(name: &str, from: &str, to: &str) -> Loaded {
    let text = built_in(name).sources[0].text.clone();
    assert!(text.contains(from), "{name} has no `{from}`");
    inspect_text(name, &text.replacen(from, to, 1), &[]).unwrap()
}

/// Loads a built-in model with `lines` appended to its text.
#[allow(dead_code)]
pub fn with_lines(name: &str, lines: &str) -> Loaded {
    let text = built_in(name).sources[0].text.clone() + lines;
    inspect_text(name, &text, &[]).unwrap()
}

/// Result of the check named `check` in a report; panics if the report has none.
#[allow(dead_code)]
pub fn row<'a>(report: &'a Report, check: &str) -> &'a Row {
    let found = report.rows.iter().find(|row| row.check == check);
    found.unwrap_or_else(|| panic!("no check is called `{check}`"))
}

/// Verifies a model and returns the verdict of one check. The checks of effects, which compile the model once per
/// effect, run only if one of them is requested.
#[allow(dead_code)]
pub fn verdict(loaded: &Loaded, check: &str) -> Verdict {
    assert!(loaded.model.is_some(), "{:#?}", loaded.diagnostics);
    let options = Options {
        effects: [EFFECTS, EFFECT_REFERENCE].contains(&check),
        ..QUICK
    };
    row(&verify::run(loaded, &options), check).verdict
}

/// Text of a test model of a body of revolution about its first axis, whose attitude is given by rotations about axes
/// 3, 2 and 1; the air is still.
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

/// Concatenated results of a compiled function at all points.
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
