//! How long the disc's functions and one flight take: `cargo bench --bench speed`.

use codegen::tape::{Inputs, Tape};
use criterion::{Criterion, criterion_group, criterion_main};
use generated::disc;
use lanes::{Isa, Kernel, Lanes, dispatch};
use ode::{Event, IntegrationOptions, integrate_to_end, rhs_from_fn};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// A full backhand: position, velocity, angles, their rates.
const THROW: [f64; 12] = [
    -0.903, 0.633, 0.913, 13.109, 0.41, -2.779, -0.0711, -0.211, -5.03, -14.9, 1.48, -54.3,
];
const J: usize = disc::J_PATTERN.len();
const JP: usize = disc::JP_PATTERN.len();

fn prepared() -> [f64; disc::PREPARED.len()] {
    let mut k = [0.0; disc::PREPARED.len()];
    (disc::MODEL.prepare)(&disc::DEFAULTS, &mut k);
    k
}

fn scalar(c: &mut Criterion) {
    let (model, p, k) = (disc::MODEL, disc::DEFAULTS, prepared());
    let (mut dx, mut j, mut jp) = ([0.0; 12], [0.0; J], [0.0; JP]);
    let mut group = c.benchmark_group("f64");
    group.bench_function("f", |b| {
        b.iter(|| (model.f)(0.0, black_box(&THROW), &p, &k, black_box(&mut dx)));
    });
    group.bench_function("f+J", |b| {
        let (dx, j) = (&mut dx, &mut j);
        b.iter(|| (model.f_jac)(0.0, black_box(&THROW), &p, &k, black_box(dx), black_box(j)));
    });
    group.bench_function("f+J+Jp", |b| {
        let (dx, j, jp) = (&mut dx, &mut j, &mut jp);
        let x = black_box(&THROW);
        b.iter(|| (model.f_jac_par)(0.0, x, &p, &k, black_box(dx), black_box(j), black_box(jp)));
    });
    group.finish();
}

/// What is evaluated in lanes.
#[derive(Clone, Copy)]
enum Form<'a> {
    Generated(usize),
    Tape(&'a Tape),
}

/// So many evaluations in lanes, in total over the lanes.
struct Many<'a>(Form<'a>, u64);

impl Kernel for Many<'_> {
    type Output = Duration;

    #[inline(always)]
    fn run<T: Lanes>(self) -> Duration {
        let zero = T::splat(0.0);
        let (mut x, mut p) = ([zero; 12], [zero; disc::DEFAULTS.len()]);
        let mut k = [zero; disc::PREPARED.len()];
        for (to, from) in x.iter_mut().zip(THROW) {
            *to = T::splat(from);
        }
        for (to, from) in p.iter_mut().zip(disc::DEFAULTS) {
            *to = T::splat(from);
        }
        disc::prepare(&p, &mut k);
        let (mut dx, mut j, mut jp) = ([zero; 12], [zero; J], [zero; JP]);
        let (mut scratch, mut out) = (Vec::new(), vec![zero; 12 + J + JP]);
        let start = Instant::now();
        for _ in 0..self.1.div_ceil(T::WIDTH as u64) {
            let x = black_box(&x);
            match self.0 {
                Form::Generated(0) => disc::f(zero, x, &p, &k, &mut dx),
                Form::Generated(1) => disc::f_jac(zero, x, &p, &k, &mut dx, &mut j),
                Form::Generated(_) => disc::f_jac_par(zero, x, &p, &k, &mut dx, &mut j, &mut jp),
                Form::Tape(tape) => {
                    let inputs = Inputs {
                        t: zero,
                        x,
                        p: &p,
                        prepared: &k,
                        marker: &[],
                    };
                    tape.eval(inputs, &mut scratch, &mut out);
                }
            }
            black_box((&mut dx, &mut j, &mut jp, &mut out));
        }
        start.elapsed()
    }
}

fn in_lanes(c: &mut Criterion) {
    let model = model_spec::load::load("disc", &[]).expect("the model");
    let compiled = codegen::compile(&model);
    let functions = [
        ("f", &compiled.f),
        ("f+J", &compiled.f_jac),
        ("f+J+Jp", &compiled.f_jac_par),
    ];
    let isa = Isa::best().name();
    for (i, (name, function)) in functions.into_iter().enumerate() {
        let tape = Tape::new(&function.program);
        for (title, form) in [
            ("generated", Form::Generated(i)),
            ("tape", Form::Tape(&tape)),
        ] {
            // A time of criterion's is that of one lane.
            c.bench_function(&format!("one lane of {isa}/{title}/{name}"), |b| {
                b.iter_custom(|evaluations| dispatch(Many(form, evaluations)));
            });
        }
    }
}

fn flight(c: &mut Criterion) {
    let (p, k) = (disc::DEFAULTS, prepared());
    let mut thrown = rhs_from_fn(&disc::STATES, |t, x: &[f64; 12], dx: &mut [f64; 12]| {
        disc::f(t, x, &p, &k, dx);
    });
    let options = IntegrationOptions::with_tolerance(1e-6);
    c.bench_function("backhand to the ground at 1e-6", |b| {
        b.iter(|| {
            let ground = Event::falls_to("ground", 2, 0.0).terminal();
            let start = (0.0, black_box(&THROW));
            integrate_to_end(&mut thrown, start, 60.0, &options, &mut [ground]).map(|end| end.time)
        });
    });
}

criterion_group!(benches, scalar, in_lanes, flight);
criterion_main!(benches);
