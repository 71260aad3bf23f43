//! The scalar tape, the tape over lanes and the committed Rust code perform the same operations in the same order:
//! their results are bit-identical.

use crate::support::{self, Random, model, point};
use codegen::backend::SourceFile;
use codegen::tape::{Inputs, Tape};
use codegen::tape_model::{At, Scratch};
use codegen::{Compiled, TapeModel, compile};
use lanes::{Kernel, Lanes, ScalarKernel, ScalarLane, dispatch, dispatch_scalar};

#[allow(non_snake_case, clippy::all)]
#[rustfmt::skip]
#[path = "zoo/f_jac_par.rs"]
mod zoo_f_jac_par;
#[allow(non_snake_case, clippy::all)]
#[rustfmt::skip]
#[path = "zoo/prepare.rs"]
mod zoo_prepare;
#[rustfmt::skip]
#[path = "zoo/tables.rs"]
mod tables;

const MARK: [f64; 3] = [0.1, -0.02, 0.01];

fn bits(values: &[f64]) -> Vec<u64> {
    // maps -0 to 0
    values.iter().map(|v| (v + 0.0).to_bits()).collect()
}

#[test]
fn committed_code_agrees_with_the_tape() {
    let mut random = Random(11);
    for table in generated::MODELS {
        let compiled = compile(&model(table.name));
        let tape = TapeModel::new(&compiled);
        assert_eq!(
            table.j_pattern,
            tape.f_jac_par.pattern("j"),
            "{} is stale",
            table.name
        );
        let mut scratch = Scratch::default();
        for _ in 0..30 {
            let (x, p) = point(&compiled, &mut random);
            let mut k = vec![0.0; table.prepared.len()];
            (table.prepare)(&p, &mut k);
            let prepared = tape.prepare(&p);
            assert_eq!(bits(&k), bits(&prepared), "{} prepare", table.name);
            let at = At {
                t: 0.2,
                x: &x,
                p: &p,
                prepared: &prepared,
            };

            let n = table.states.len();
            let (mut dx, mut j) = (vec![0.0; n], vec![0.0; table.j_pattern.len()]);
            let mut jp = vec![0.0; table.jp_pattern.len()];
            let (mut dx2, mut j2, mut jp2) = (dx.clone(), j.clone(), jp.clone());
            (table.f)(0.2, &x, &p, &k, &mut dx);
            tape.f.eval(at, &[], &mut scratch, &mut [&mut dx2]);
            assert_eq!(bits(&dx), bits(&dx2), "{} f", table.name);
            (table.f_jac_par)(0.2, &x, &p, &k, &mut dx, &mut j, &mut jp);
            tape.f_jac_par
                .eval(at, &[], &mut scratch, &mut [&mut dx2, &mut j2, &mut jp2]);
            let expected = (bits(&dx2), bits(&j2));
            assert_eq!((bits(&dx), bits(&j)), expected, "{}", table.name);
            assert_eq!(bits(&jp), bits(&jp2), "{} f_jac_par", table.name);

            let (mut y, mut y2) = ([0.0; 3], [0.0; 3]);
            (table.observe)(0.2, &x, &p, &k, &MARK, &mut y);
            tape.observe.eval(at, &MARK, &mut scratch, &mut [&mut y2]);
            assert_eq!(bits(&y), bits(&y2), "{} observe", table.name);
            let mut q = vec![0.0; table.quantity_names.len()];
            let mut q2 = q.clone();
            (table.quantities)(0.2, &x, &p, &k, &mut q);
            tape.quantities.eval(at, &[], &mut scratch, &mut [&mut q2]);
            assert_eq!(bits(&q), bits(&q2), "{} quantities", table.name);
        }
    }
}

/// Checks that generated Rust code and bytecode of the test model `zoo` agree, and that the committed code is current.
/// The environment variable `UPDATE_ZOO=1` rewrites the committed code.
#[test]
fn every_function_agrees_as_rust_and_on_the_tape() {
    let zoo = support::zoo();
    let compiled = compile(&zoo);
    for SourceFile { path, text } in codegen::rust::emit(&compiled, &zoo) {
        let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/integration")
            .join(&path);
        if !["zoo/f_jac_par.rs", "zoo/prepare.rs", "zoo/tables.rs"].contains(&path.as_str()) {
            continue;
        }
        if std::env::var_os("UPDATE_ZOO").is_some() {
            std::fs::write(&file, &text).expect("writable");
        }
        let there = std::fs::read_to_string(&file).unwrap_or_default();
        assert_eq!(there, text, "{path} is stale");
    }
    let tape = TapeModel::new(&compiled);
    let mut random = Random(3);
    let mut scratch = Scratch::default();
    for _ in 0..100 {
        let (x, p) = point(&compiled, &mut random);
        let (mut dx, mut j, mut jp) = ([0.0; 3], [0.0; zoo_sizes::J], [0.0; zoo_sizes::JP]);
        let (mut dx2, mut j2, mut jp2) = (dx, j, jp);
        dispatch_scalar(Zoo {
            x: &x,
            p: &p,
            to: [&mut dx, &mut j, &mut jp],
        });
        let prepared = tape.prepare(&p);
        let at = At {
            t: 0.2,
            x: &x,
            p: &p,
            prepared: &prepared,
        };
        tape.f_jac_par
            .eval(at, &[], &mut scratch, &mut [&mut dx2, &mut j2, &mut jp2]);
        assert_eq!(
            (bits(&dx), bits(&j), bits(&jp)),
            (bits(&dx2), bits(&j2), bits(&jp2))
        );
    }
}

struct Zoo<'a> {
    x: &'a [f64],
    p: &'a [f64],
    to: [&'a mut [f64]; 3],
}

impl ScalarKernel for Zoo<'_> {
    #[inline(always)]
    fn run<T: ScalarLane>(self) {
        let (state, parameters) = (T::slice(self.x), T::slice(self.p));
        let (state, parameters) = (state.try_into().unwrap(), parameters.try_into().unwrap());
        let mut k = [T::splat(0.0); zoo_sizes::PREPARED];
        zoo_prepare::prepare(parameters, &mut k);
        let [dx, j, jp] = self.to.map(T::slice_mut);
        let (dx, j) = (dx.try_into().unwrap(), j.try_into().unwrap());
        let time = T::splat(0.2);
        zoo_f_jac_par::f_jac_par(time, state, parameters, &k, dx, j, jp.try_into().unwrap());
    }
}

mod zoo_sizes {
    pub const PREPARED: usize = 14;
    pub const J: usize = 8;
    pub const JP: usize = 7;
}

pub(crate) struct EveryLane<'a> {
    pub(crate) compiled: &'a Compiled,
    pub(crate) points: &'a [(Vec<f64>, Vec<f64>)],
}

impl Kernel for EveryLane<'_> {
    type Output = ();
    #[inline(always)]
    fn run<T: Lanes>(self) {
        let EveryLane { compiled, points } = self;
        let pick = |of: &dyn Fn(usize) -> f64| T::from_fn(|lane| of(lane % points.len()));
        let x: Vec<T> = (0..points[0].0.len())
            .map(|k| pick(&|lane| points[lane].0[k]))
            .collect();
        let p: Vec<T> = (0..points[0].1.len())
            .map(|k| pick(&|lane| points[lane].1[k]))
            .collect();
        let mut scratch = Vec::new();
        let mut prepared = vec![T::splat(0.0); compiled.prepared.len()];
        let none = Inputs {
            t: T::splat(0.2),
            x: &x,
            p: &p,
            prepared: &[],
            marker: &[],
        };
        Tape::new(&compiled.prepare.program).eval(none, &mut scratch, &mut prepared);
        let tape = Tape::new(&compiled.f_jac_par.program);
        let mut out = vec![T::splat(0.0); tape.outputs()];
        tape.eval(
            Inputs {
                prepared: &prepared,
                ..none
            },
            &mut scratch,
            &mut out,
        );

        let single = TapeModel::new(compiled);
        let lens = single.f_jac_par.lens();
        let mut one = Scratch::default();
        for lane in 0..T::WIDTH {
            let (x, p) = &points[lane % points.len()];
            let prepared = single.prepare(p);
            let at = At {
                t: 0.2,
                x,
                p,
                prepared: &prepared,
            };
            let mut parts: Vec<Vec<f64>> = lens.iter().map(|&len| vec![0.0; len]).collect();
            let [dx, j, jp] = parts.as_mut_slice() else {
                panic!("three sections")
            };
            single.f_jac_par.eval(at, &[], &mut one, &mut [dx, j, jp]);
            let wide: Vec<f64> = out.iter().map(|value| value.lane(lane)).collect();
            assert_eq!(
                bits(&parts.concat()),
                bits(&wide),
                "{} lane {lane}",
                compiled.name
            );
        }
    }
}

#[test]
fn every_lane_agrees_with_one_flight() {
    let mut random = Random(5);
    for model in support::with_zoo() {
        let compiled = compile(&model);
        let points: Vec<_> = (0..8).map(|_| point(&compiled, &mut random)).collect();
        dispatch(EveryLane {
            compiled: &compiled,
            points: &points,
        });
    }
}
