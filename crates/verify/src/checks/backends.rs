//! Every backend against every other: the tape and the generated code, one flight at a time and on every
//! kind of lanes that this machine has. All that fuse must give the same bits, and all that do not; the two may differ by
//! roundings.

use crate::report::{Measure, Row, Verdict, Worst};
use codegen::compile::Compiled;
use codegen::program::Function;
use codegen::rust::source_hash;
use codegen::tape::{Inputs, Tape};
use lanes::{Isa, Kernel, Lanes, Real, dispatch_with};
use model_spec::model::Model;
use oracle::point::Point;

/// Name of the check.
pub const BACKENDS: &str = "backends";

/// Name of the check of those that fuse against those that do not.
pub const FUSED: &str = "fused and not";

/// How far these may be apart, of the greatest result of a function: 1e4 roundings, for what cancels.
const FUSED_TOLERANCE: f64 = 1e-12;

/// What one backend gives at a list of points: for each the results of every function, end to end.
#[derive(Clone, Debug)]
pub struct Run {
    /// The backend.
    pub backend: String,
    /// Whether it fuses a product and a sum.
    pub fuses: bool,
    /// Results at each point.
    pub results: Vec<Vec<f64>>,
}

/// Functions in the order of the results, each with its length.
pub fn functions(compiled: &Compiled) -> Vec<(&'static str, usize)> {
    compiled
        .functions()
        .map(|f| (f.name, f.program.outputs.len()))
        .into()
}

/// Runs every backend. Generated code takes part where it was made from this very text.
pub fn runs(model: &Model, compiled: &Compiled, points: &[Point<f64>]) -> Vec<Run> {
    let tapes = Tapes::new(compiled);
    let mut runs = vec![Run {
        backend: "tape".into(),
        fuses: false,
        results: points
            .iter()
            .map(|p| tapes.results(&Numbers::of(p, |v| v)))
            .collect(),
    }];
    runs.extend(on_lanes("tape", &tapes, points));
    if let Some(made) =
        generated::model(&model.name).filter(|made| made.source_hash == source_hash(model))
    {
        let results = points
            .iter()
            .map(|p| plain(made, &Numbers::of(p, |v| v)))
            .collect();
        runs.push(Run {
            backend: "generated".into(),
            fuses: Isa::best().fuses(),
            results,
        });
        runs.extend(generated::visit(&model.name, OnLanes(points)).unwrap_or_default());
    }
    runs
}

/// The first run that fuses, or the first that does not.
fn first(runs: &[Run], fuses: bool) -> Option<&Run> {
    runs.iter().find(|run| run.fuses == fuses)
}

/// Every run against the first of its kind, bit for bit.
pub fn check(compiled: &Compiled, runs: &[Run]) -> Row {
    let mut worst = Worst::default();
    for run in runs {
        let Some(first) = first(runs, run.fuses) else {
            continue;
        };
        for (expected, got) in first.results.iter().zip(&run.results) {
            for (index, (a, b)) in expected.iter().zip(got).enumerate() {
                worst.see(ulps(*a, *b), || {
                    format!("{} in {}", function_at(compiled, index), run.backend)
                });
            }
            if expected.len() != got.len() {
                worst.see(f64::INFINITY, || {
                    format!("another number of results in {}", run.backend)
                });
            }
        }
    }
    let names: Vec<&str> = runs.iter().map(|run| run.backend.as_str()).collect();
    let holds = worst.error == 0.0;
    Row {
        check: BACKENDS,
        cases: runs.iter().map(|run| run.results.len()).sum(),
        worst: worst.error,
        measure: Measure::Ulp,
        tolerance: 0.0,
        verdict: if holds {
            Verdict::Holds
        } else {
            Verdict::Refuted
        },
        detail: if holds { names.join(", ") } else { worst.place },
    }
}

/// A run that fuses against one that does not, each result by the greatest of its function.
pub fn check_fused(compiled: &Compiled, runs: &[Run]) -> Row {
    let (Some(plain), Some(fused)) = (first(runs, false), first(runs, true)) else {
        return Row::skipped(FUSED, "nothing fuses here");
    };
    let mut worst = Worst::default();
    for (plain, fused) in plain.results.iter().zip(&fused.results) {
        let mut start = 0;
        for (function, len) in functions(compiled) {
            let range = start..start + len;
            start += len;
            let size = plain[range.clone()]
                .iter()
                .fold(f64::MIN_POSITIVE, |most, v| most.max(v.abs()));
            for (a, b) in plain[range.clone()].iter().zip(&fused[range]) {
                worst.see((a - b).abs() / size, || function.to_string());
            }
        }
    }
    Row::judged(FUSED, plain.results.len(), &worst, FUSED_TOLERANCE)
}

/// The function that a result belongs to.
pub fn function_at(compiled: &Compiled, index: usize) -> &'static str {
    let mut end = 0;
    let found = functions(compiled).into_iter().find(|(_, len)| {
        end += len;
        index < end
    });
    found.map_or("nothing", |(name, _)| name)
}

/// Steps between two numbers; 0 for two that are none.
fn ulps(a: f64, b: f64) -> f64 {
    if a == b || (a.is_nan() && b.is_nan()) {
        return 0.0;
    }
    // Bits in the order of the numbers, on both sides of 0.
    let place = |v: f64| {
        let bits = v.to_bits() as i64;
        if bits < 0 {
            i64::MIN.wrapping_sub(bits)
        } else {
            bits
        }
    };
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        place(a).abs_diff(place(b)) as f64
    }
}

/// A point in the order of the compiler.
struct Numbers<T> {
    t: T,
    x: Vec<T>,
    p: Vec<T>,
    marker: Vec<T>,
}

impl<T> Numbers<T> {
    fn of(point: &Point<f64>, lift: impl Fn(f64) -> T) -> Self {
        Self {
            t: lift(point.time),
            x: point.states.iter().map(|&v| lift(v)).collect(),
            p: crate::engine::parameters(point)
                .into_iter()
                .map(&lift)
                .collect(),
            marker: point.marker.iter().map(|&v| lift(v)).collect(),
        }
    }
}

/// All functions of a model, for any lanes, results end to end.
trait Bundle {
    fn results<T: Real>(&self, at: &Numbers<T>) -> Vec<T>;
}

struct Tapes {
    prepare: Tape,
    others: Vec<Tape>,
}

impl Tapes {
    fn new(compiled: &Compiled) -> Self {
        let [prepare, others @ ..] = compiled
            .functions()
            .map(|f: &Function| Tape::new(&f.program));
        Self {
            prepare,
            others: others.into(),
        }
    }
}

impl Bundle for Tapes {
    #[inline(always)]
    fn results<T: Real>(&self, at: &Numbers<T>) -> Vec<T> {
        let mut scratch = Vec::new();
        let mut all = vec![T::splat(0.0); self.prepare.outputs()];
        let inputs = Inputs {
            t: at.t,
            x: &at.x,
            p: &at.p,
            prepared: &[],
            marker: &at.marker,
        };
        self.prepare.eval(inputs, &mut scratch, &mut all);
        let prepared = all.clone();
        for tape in &self.others {
            let mut out = vec![T::splat(0.0); tape.outputs()];
            tape.eval(
                Inputs {
                    prepared: &prepared,
                    ..inputs
                },
                &mut scratch,
                &mut out,
            );
            all.extend(out);
        }
        all
    }
}

struct Generated<E>(std::marker::PhantomData<E>);

impl<E: generated::Equations> Bundle for Generated<E> {
    #[inline(always)]
    fn results<T: Real>(&self, at: &Numbers<T>) -> Vec<T> {
        let m = E::MODEL;
        let zeros = |n: usize| vec![T::splat(0.0); n];
        let (n, Numbers { t, x, p, marker }) = (m.states.len(), at);
        let mut k = zeros(m.prepared.len());
        E::prepare(p, &mut k);
        let mut all = k.clone();
        let mut push = |parts: Vec<Vec<T>>| all.extend(parts.into_iter().flatten());
        let (mut dx, mut j, mut jp) = (
            zeros(n),
            zeros(m.j_pattern.len()),
            zeros(m.jp_pattern.len()),
        );
        E::f(*t, x, p, &k, &mut dx);
        push(vec![dx.clone()]);
        E::f_jac(*t, x, p, &k, &mut dx, &mut j);
        push(vec![dx.clone(), j.clone()]);
        E::f_jac_par(*t, x, p, &k, &mut dx, &mut j, &mut jp);
        push(vec![dx, j, jp]);
        if m.observed {
            let (mut y, mut by_x) = (zeros(3), zeros(m.dy_dx_pattern.len()));
            let (mut by_p, mut by_marker) = (
                zeros(m.dy_dp_pattern.len()),
                zeros(m.dy_dmarker_pattern.len()),
            );
            E::observe(*t, x, p, &k, marker, &mut y);
            push(vec![y.clone()]);
            E::observe_jac(
                *t,
                x,
                p,
                &k,
                marker,
                &mut y,
                &mut by_x,
                &mut by_p,
                &mut by_marker,
            );
            push(vec![y, by_x, by_p, by_marker]);
        }
        let (mut q, mut l) = (zeros(m.quantity_names.len()), zeros(m.limit_bounds.len()));
        E::quantities(*t, x, p, &k, &mut q);
        E::limits(*t, x, p, &k, &mut l);
        push(vec![q, l]);
        all
    }
}

/// The functions for `f64` that a model is picked with at run time.
fn plain(m: &generated::Model, at: &Numbers<f64>) -> Vec<f64> {
    let zeros = |n: usize| vec![0.0; n];
    let (n, Numbers { t, x, p, marker }) = (m.states.len(), at);
    let mut k = zeros(m.prepared.len());
    (m.prepare)(p, &mut k);
    let mut all = k.clone();
    let mut push = |parts: Vec<Vec<f64>>| all.extend(parts.into_iter().flatten());
    let (mut dx, mut j, mut jp) = (
        zeros(n),
        zeros(m.j_pattern.len()),
        zeros(m.jp_pattern.len()),
    );
    (m.f)(*t, x, p, &k, &mut dx);
    push(vec![dx.clone()]);
    (m.f_jac)(*t, x, p, &k, &mut dx, &mut j);
    push(vec![dx.clone(), j.clone()]);
    (m.f_jac_par)(*t, x, p, &k, &mut dx, &mut j, &mut jp);
    push(vec![dx, j, jp]);
    if m.observed {
        let (mut y, mut by_x) = (zeros(3), zeros(m.dy_dx_pattern.len()));
        let (mut by_p, mut by_marker) = (
            zeros(m.dy_dp_pattern.len()),
            zeros(m.dy_dmarker_pattern.len()),
        );
        (m.observe)(*t, x, p, &k, marker, &mut y);
        push(vec![y.clone()]);
        (m.observe_jac)(
            *t,
            x,
            p,
            &k,
            marker,
            &mut y,
            &mut by_x,
            &mut by_p,
            &mut by_marker,
        );
        push(vec![y, by_x, by_p, by_marker]);
    }
    let (mut q, mut l) = (zeros(m.quantity_names.len()), zeros(m.limit_bounds.len()));
    (m.quantities)(*t, x, p, &k, &mut q);
    (m.limits)(*t, x, p, &k, &mut l);
    push(vec![q, l]);
    all
}

struct OnLanes<'a>(&'a [Point<f64>]);

impl generated::Visitor for OnLanes<'_> {
    type Output = Vec<Run>;

    fn visit<E: generated::Equations>(self) -> Vec<Run> {
        on_lanes(
            "generated",
            &Generated::<E>(std::marker::PhantomData),
            self.0,
        )
    }
}

fn on_lanes<B: Bundle>(name: &str, bundle: &B, points: &[Point<f64>]) -> Vec<Run> {
    let run = |isa: Isa| {
        let results = dispatch_with(isa, Batch { bundle, points })?;
        Some(Run {
            backend: format!("{name} on {}", isa.name()),
            fuses: isa.fuses(),
            results,
        })
    };
    Isa::ALL.into_iter().filter_map(run).collect()
}

/// Many points at once.
struct Batch<'a, B> {
    bundle: &'a B,
    points: &'a [Point<f64>],
}

impl<B: Bundle> Kernel for Batch<'_, B> {
    type Output = Vec<Vec<f64>>;

    #[inline(always)]
    fn run<T: Lanes>(self) -> Vec<Vec<f64>> {
        let mut results = Vec::with_capacity(self.points.len());
        for chunk in self.points.chunks(T::WIDTH) {
            let each: Vec<Numbers<f64>> = chunk.iter().map(|p| Numbers::of(p, |v| v)).collect();
            // Lanes beyond the end repeat the last point.
            let pick = |value: &dyn Fn(&Numbers<f64>) -> f64| {
                T::from_fn(|lane| value(&each[lane.min(each.len() - 1)]))
            };
            let at = Numbers {
                t: pick(&|n| n.t),
                x: (0..each[0].x.len()).map(|i| pick(&|n| n.x[i])).collect(),
                p: (0..each[0].p.len()).map(|i| pick(&|n| n.p[i])).collect(),
                marker: (0..3).map(|i| pick(&|n| n.marker[i])).collect(),
            };
            let out = self.bundle.results(&at);
            results.extend((0..chunk.len()).map(|lane| out.iter().map(|v| v.lane(lane)).collect()));
        }
        results
    }
}
