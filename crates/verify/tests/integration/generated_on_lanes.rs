//! Generated code compiled for every instruction set gives the bits of its recorded operations, which
//! `verify::checks::backends` replays in its place.

use generated::{Equations, Visitor};
use lanes::{Isa, Kernel, Lanes, Real, dispatch_with};
use oracle::Point;
use verify::checks::backends::runs;
use verify::random::Random;
use verify::sample;

/// Number of points in each test, not a multiple of any SIMD width, so that incomplete vectors are tested.
const POINTS: usize = 19;

/// Kernel that computes the concatenated results of the generated functions of a model `E` at each point, with one
/// instruction set.
struct Native<'a, E> {
    points: &'a [Point<f64>],
    equations: std::marker::PhantomData<E>,
}

impl<E: Equations> Kernel for Native<'_, E> {
    type Output = Vec<Vec<f64>>;

    #[inline(always)]
    fn run<T: Lanes>(self) -> Vec<Vec<f64>> {
        let mut results = Vec::new();
        for chunk in self.points.chunks(T::WIDTH) {
            let pick = |value: &dyn Fn(&Point<f64>) -> Vec<f64>| -> Vec<T> {
                let each: Vec<Vec<f64>> = chunk.iter().map(value).collect();
                (0..each[0].len())
                    .map(|k| T::from_fn(|lane| each[lane.min(each.len() - 1)][k]))
                    .collect()
            };
            let out = evaluate::<E, T>(
                pick(&|point| vec![point.time])[0],
                &pick(&|point| point.states.clone()),
                &pick(&Point::parameters),
                &pick(&|point| point.marker.iter().copied().collect()),
            );
            results.extend((0..chunk.len()).map(|lane| out.iter().map(|v| v.lane(lane)).collect()));
        }
        results
    }
}

#[inline(always)]
fn evaluate<E: Equations, T: Real>(t: T, x: &[T], p: &[T], marker: &[T]) -> Vec<T> {
    let m = E::MODEL;
    let zeros = |n: usize| vec![T::splat(0.0); n];
    let mut k = zeros(m.prepared.len());
    E::prepare(p, &mut k);
    let mut all = k.clone();
    let mut push = |parts: &[&Vec<T>]| parts.iter().for_each(|part| all.extend(part.iter()));
    let (mut dx, mut j) = (zeros(m.states.len()), zeros(m.j_pattern.len()));
    let mut jp = zeros(m.jp_pattern.len());
    E::f(t, x, p, &k, &mut dx);
    push(&[&dx]);
    E::f_jac(t, x, p, &k, &mut dx, &mut j);
    push(&[&dx, &j]);
    E::f_jac_par(t, x, p, &k, &mut dx, &mut j, &mut jp);
    push(&[&dx, &j, &jp]);
    if m.observed {
        let (mut y, mut by_x) = (zeros(3), zeros(m.dy_dx_pattern.len()));
        let mut by_p = zeros(m.dy_dp_pattern.len());
        let mut by_marker = zeros(m.dy_dmarker_pattern.len());
        E::observe(t, x, p, &k, marker, &mut y);
        push(&[&y]);
        #[rustfmt::skip]
        E::observe_jac(t, x, p, &k, marker, &mut y, &mut by_x, &mut by_p, &mut by_marker);
        push(&[&y, &by_x, &by_p, &by_marker]);
    }
    let mut quantities = zeros(m.quantity_names.len());
    let mut limits = zeros(m.limit_bounds.len());
    E::quantities(t, x, p, &k, &mut quantities);
    E::limits(t, x, p, &k, &mut limits);
    push(&[&quantities, &limits]);
    all
}

/// Computes a model's results at the points with every SIMD instruction set that this machine supports. Returns them
/// with the name of the backend.
struct EveryIsa<'a>(&'a [Point<f64>]);

impl Visitor for EveryIsa<'_> {
    type Output = Vec<(String, Vec<Vec<f64>>)>;

    fn visit<E: Equations>(self) -> Self::Output {
        let native = |isa: Isa| {
            let kernel = Native::<E> {
                points: self.0,
                equations: std::marker::PhantomData,
            };
            Some((
                format!("generated on {}", isa.name()),
                dispatch_with(isa, kernel)?,
            ))
        };
        Isa::ALL.into_iter().filter_map(native).collect()
    }
}

#[test]
fn native_instantiations_agree_with_the_recorded_operations() {
    for code in generated::MODELS {
        let model = model_spec::load::load(code.name, &[]).unwrap();
        let compiled = codegen::compile(&model);
        let mut random = Random::new(0, "generated on lanes");
        let points: Vec<_> = (0..POINTS)
            .map(|_| sample::point(&model, &mut random))
            .collect();
        let runs = runs(&model, &compiled, &points);
        let native = generated::visit(code.name, EveryIsa(&points)).unwrap();
        assert!(native.len() >= 2, "portable and scalar run everywhere");
        for (backend, expected) in native {
            let recorded = runs.iter().find(|run| run.backend == backend);
            let recorded = recorded.unwrap_or_else(|| panic!("{}: no {backend}", code.name));
            for (expected, got) in expected.iter().zip(&recorded.results) {
                assert_eq!(expected.len(), got.len(), "{} {backend}", code.name);
                for (a, b) in expected.iter().zip(got) {
                    // 0 and -0 are one number.
                    let same = (a + 0.0).to_bits() == (b + 0.0).to_bits();
                    assert!(same, "{} {backend}: {a:e} {b:e}", code.name);
                }
            }
        }
    }
}
