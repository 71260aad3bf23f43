//! Exact derivatives against dual numbers that run through the tape of the value alone.

use crate::support::{self, Dual, Random, model, point};
use codegen::program::{Function, Program};
use codegen::tape::{Inputs, Tape};
use codegen::{Compiled, compile};
use lanes::Real;

struct Point<'a> {
    t: f64,
    x: &'a [f64],
    p: &'a [f64],
    marker: &'a [f64],
}

fn run<T: Real>(
    program: &Program,
    prepare: &Program,
    t: T,
    x: &[T],
    p: &[T],
    marker: &[T],
) -> Vec<T> {
    let mut scratch = Vec::new();
    let mut prepared = vec![T::splat(0.0); prepare.outputs.len()];
    let inputs = Inputs {
        t,
        x: &[],
        p,
        prepared: &[],
        marker: &[],
    };
    Tape::new(prepare).eval(inputs, &mut scratch, &mut prepared);
    let mut out = vec![T::splat(0.0); program.outputs.len()];
    Tape::new(program).eval(
        Inputs {
            t,
            x,
            p,
            prepared: &prepared,
            marker,
        },
        &mut scratch,
        &mut out,
    );
    out
}

/// Derivatives of the outputs of a function, by dual numbers, with respect to element `k` of the input `kind`: `x`
/// (states), `p` (parameters) or `marker`.
fn by_dual(
    compiled: &Compiled,
    function: &Function,
    at: &Point<'_>,
    kind: &str,
    k: usize,
) -> Vec<f64> {
    let seed = |values: &[f64], mine: &str| -> Vec<Dual> {
        values
            .iter()
            .enumerate()
            .map(|(i, &v)| Dual::new(v, f64::from(u8::from(mine == kind && i == k))))
            .collect()
    };
    let (x, p, marker) = (seed(at.x, "x"), seed(at.p, "p"), seed(at.marker, "marker"));
    run(
        &function.program,
        &compiled.prepare.program,
        Dual::new(at.t, 0.0),
        &x,
        &p,
        &marker,
    )
    .iter()
    .map(|dual| dual.0.eps)
    .collect()
}

fn compare(
    compiled: &Compiled,
    value: &Function,
    full: &Function,
    at: &Point<'_>,
    groups: &[(&str, &str, usize)],
) {
    let got = run(
        &full.program,
        &compiled.prepare.program,
        at.t,
        at.x,
        at.p,
        at.marker,
    );
    let plain = run(
        &value.program,
        &compiled.prepare.program,
        at.t,
        at.x,
        at.p,
        at.marker,
    );
    for (k, (a, b)) in plain.iter().zip(&got).enumerate() {
        assert!(
            (a - b).abs() <= 1e-11 * (1.0 + a.abs()),
            "{} value {k}: {a} {b}",
            full.name
        );
    }
    for &(section, kind, columns) in groups {
        let range = full.range(section);
        let pattern = full.pattern(section);
        for column in 0..columns {
            let exact = by_dual(compiled, value, at, kind, column);
            let mut mine = vec![0.0; exact.len()];
            for (place, &(row, c)) in range.clone().zip(pattern) {
                if c as usize == column {
                    mine[row as usize] = got[place];
                }
            }
            let scale = exact.iter().fold(1.0_f64, |m, v| m.max(v.abs()));
            for (row, (a, b)) in mine.iter().zip(&exact).enumerate() {
                assert!(
                    a.is_finite(),
                    "{} {section} ({row}, {column}) is {a}",
                    full.name
                );
                assert!(
                    (a - b).abs() <= 1e-9 * scale,
                    "{} {section} ({row}, {column}): {a} but dual numbers give {b}",
                    full.name
                );
            }
        }
    }
}

pub(crate) fn check(compiled: &Compiled, x: &[f64], p: &[f64]) {
    let marker = [0.1, -0.03, 0.02];
    let at = Point {
        t: 0.3,
        x,
        p,
        marker: &marker,
    };
    let (n, m) = (x.len(), p.len());
    compare(
        compiled,
        &compiled.f,
        &compiled.f_jac,
        &at,
        &[("j", "x", n)],
    );
    compare(
        compiled,
        &compiled.f,
        &compiled.f_jac_par,
        &at,
        &[("j", "x", n), ("jp", "p", m)],
    );
    let observed = [
        ("dy_dx", "x", n),
        ("dy_dp", "p", m),
        ("dy_dmarker", "marker", 3),
    ];
    compare(
        compiled,
        &compiled.observe,
        &compiled.observe_jac,
        &at,
        &observed,
    );
}

#[test]
fn at_random_states() {
    let mut random = Random(7);
    for model in support::with_zoo() {
        let compiled = compile(&model);
        for _ in 0..50 {
            let (x, p) = point(&compiled, &mut random);
            check(&compiled, &x, &p);
        }
    }
}

/// Coefficients that turn frames have columns of ∂f/∂p, through what is computed from them too.
#[test]
fn of_frames_that_are_turned_by_expressions_of_coefficients() {
    let text = "model winged; param m = 0.2 kg; param I = 2.4e-3 kg*m^2; param g = 9.81 m/s^2;
        coefficient i_w = 2 deg in -10 .. 10; coefficient d = 1 deg in -10 .. 10; param tilt = 2*i_w;
        frame N; frame C = N by quaternion (q0, q1, q2, q3);
        frame W = C turned tilt about 2; frame L = W turned i_w + d about 3;
        body winged { mass m; inertia diag(I, I, I) in C; fixed in C; position (x, y, z) in N;
          velocity (u, v, w) in C; angular velocity (p, q, r) in C; }
        force weight = -m*g*N.3; force lift = -0.04 [kg/m]*norm(velocity)*in_L(velocity).1*L.3;
        marker mark in C; observe mark = position + in_N(mark);";
    let model = model_spec::load::from_text("winged.hyz", text, &[]);
    let compiled = compile(&model.unwrap_or_else(|error| panic!("{error}")));
    let mut random = Random(7);
    for _ in 0..20 {
        let (x, p) = point(&compiled, &mut random);
        check(&compiled, &x, &p);
    }
    let column = |name: &str| {
        let names = &compiled.layout.parameters;
        names.iter().position(|own| own == name).expect("a name") as u32
    };
    let pattern = compiled.f_jac_par.pattern("jp");
    for name in ["i_w", "d"] {
        assert!(
            pattern.iter().any(|&(_, own)| own == column(name)),
            "{name}"
        );
    }
}

#[test]
fn at_singular_states() {
    for name in support::models() {
        let compiled = compile(&model(name));
        let mut p = compiled.layout.default_parameters();
        let at_rest = compiled.layout.default_states();
        let mut straight_down = at_rest.clone();
        for (state, name) in straight_down.iter_mut().zip(&compiled.layout.states) {
            match name.as_str() {
                "w" | "vz" => *state = -4.0,
                "phidot" | "p" => *state = 0.3,
                "thetadot" | "q" => *state = 0.2,
                "gammadot" | "r" => *state = -40.0,
                _ => {}
            }
        }
        let mut vertical = straight_down.clone();
        for (state, name) in vertical.iter_mut().zip(&compiled.layout.states) {
            match name.as_str() {
                "theta" => *state = std::f64::consts::FRAC_PI_2,
                "u" => *state = 6.0,
                _ => {}
            }
        }
        for x in [&at_rest, &straight_down] {
            check(&compiled, x, &p);
        }
        // no air: what is divided out must not be divided by
        for (value, name) in p.iter_mut().zip(&compiled.layout.parameters) {
            if ["rho", "g", "C_D0", "C_Da", "C_L0"].contains(&name.as_str()) {
                *value = 0.0;
            }
        }
        for x in [&at_rest, &straight_down] {
            check(&compiled, x, &p);
        }
        let full = &compiled.f_jac_par;
        let got = run(
            &full.program,
            &compiled.prepare.program,
            0.0,
            &vertical,
            &p,
            &[],
        );
        assert!(
            got.iter().all(|v| v.is_finite()),
            "{name} stands vertical: {got:?}"
        );
    }
}
