//! Evaluates all functions of a model at many points: by tapes, and by generated code.

use crate::evaluation::Inputs;
use codegen::program::Program;
use codegen::tape::Tape;
use generated::{Equations, Visitor};
use lanes::{Isa, Kernel, Lanes, Real, dispatch_with};
use oracle::Point;
use std::marker::PhantomData;

/// Implementation of all functions of a model for any scalar type.
pub trait Functions {
    /// Concatenated results of all functions, in the order of [`codegen::Compiled::functions`].
    fn results<T: Real>(&self, inputs: Inputs<T>) -> Vec<T>;

    /// Results at each point, computed with one SIMD instruction set; `None` if this machine lacks it.
    fn on_lanes(&self, isa: Isa, points: &[Point<f64>]) -> Option<Vec<Vec<f64>>>
    where
        Self: Sized,
    {
        let functions = self;
        dispatch_with(isa, Batch { functions, points })
    }
}

/// Tapes of all functions of a model, in the order of [`codegen::Compiled::functions`]. The first tape computes values
/// that depend on parameters only; the other tapes read them.
pub struct Tapes(Vec<Tape>);

impl Tapes {
    /// Creates the tapes of the programs of all functions.
    pub fn new<'a>(programs: impl IntoIterator<Item = &'a Program>) -> Self {
        Self(programs.into_iter().map(Tape::new).collect())
    }
}

impl Functions for Tapes {
    #[inline(always)]
    fn results<T: Real>(&self, mut inputs: Inputs<T>) -> Vec<T> {
        let (mut all, mut scratch) = (Vec::new(), Vec::new());
        for (k, tape) in self.0.iter().enumerate() {
            let mut out = vec![T::splat(0.0); tape.outputs()];
            tape.eval(inputs.of_tape(), &mut scratch, &mut out);
            if k == 0 {
                inputs.prepared.clone_from(&out);
            }
            all.extend(out);
        }
        all
    }
}

struct Generated<E>(PhantomData<E>);

impl<E: Equations> Functions for Generated<E> {
    #[inline(always)]
    fn results<T: Real>(&self, at: Inputs<T>) -> Vec<T> {
        let (t, x, p, marker) = (at.time, &*at.states, &*at.parameters, &*at.marker);
        let m = E::MODEL;
        let zeros = |len: usize| vec![T::splat(0.0); len];
        let k = &mut zeros(m.prepared.len());
        E::prepare(p, k);
        let (dx, j) = (&mut zeros(m.states.len()), &mut zeros(m.j_pattern.len()));
        let jp = &mut zeros(m.jp_pattern.len());
        let mut all = vec![k.clone()];
        E::f(t, x, p, k, dx);
        all.push(dx.clone());
        E::f_jac(t, x, p, k, dx, j);
        all.extend([dx.clone(), j.clone()]);
        E::f_jac_par(t, x, p, k, dx, j, jp);
        all.extend([dx.clone(), j.clone(), jp.clone()]);
        if m.observed {
            let y = &mut zeros(3);
            let patterns = [m.dy_dx_pattern, m.dy_dp_pattern, m.dy_dmarker_pattern];
            let [mut by_x, mut by_p, mut by_marker] = patterns.map(|pattern| zeros(pattern.len()));
            E::observe(t, x, p, k, marker, y);
            all.push(y.clone());
            let [a, b, c] = [&mut by_x, &mut by_p, &mut by_marker];
            E::observe_jac(t, x, p, k, marker, y, a, b, c);
            all.extend([y.clone(), by_x, by_p, by_marker]);
        }
        let q = &mut zeros(m.quantity_names.len());
        let l = &mut zeros(m.limit_bounds.len());
        E::quantities(t, x, p, k, q);
        E::limits(t, x, p, k, l);
        all.extend([q.clone(), l.clone()]);
        all.concat()
    }
}

struct Batch<'a, F> {
    functions: &'a F,
    points: &'a [Point<f64>],
}

impl<F: Functions> Kernel for Batch<'_, F> {
    type Output = Vec<Vec<f64>>;

    #[inline(always)]
    fn run<T: Lanes>(self) -> Vec<Vec<f64>> {
        let mut results = Vec::with_capacity(self.points.len());
        for chunk in self.points.chunks(T::WIDTH) {
            let each: Vec<Inputs<f64>> = chunk.iter().map(Inputs::of).collect();
            // Lanes beyond the last point repeat the last point.
            let lanes = |values: &dyn Fn(&Inputs<f64>) -> Vec<f64>| -> Vec<T> {
                let each: Vec<Vec<f64>> = each.iter().map(values).collect();
                let of_lane = |k: usize, lane: usize| each[lane.min(each.len() - 1)][k];
                let count = 0..each[0].len();
                count.map(|k| T::from_fn(|lane| of_lane(k, lane))).collect()
            };
            let out = self.functions.results(Inputs {
                time: lanes(&|at| vec![at.time])[0],
                states: lanes(&|at| at.states.clone()),
                parameters: lanes(&|at| at.parameters.clone()),
                marker: lanes(&|at| at.marker.clone()),
                prepared: Vec::new(),
            });
            results.extend((0..chunk.len()).map(|lane| out.iter().map(|v| v.lane(lane)).collect()));
        }
        results
    }
}

pub(super) struct OnLanes<'a>(pub &'a [Point<f64>]);

impl Visitor for OnLanes<'_> {
    type Output = Vec<(Isa, Vec<Vec<f64>>)>;

    fn visit<E: Equations>(self) -> Self::Output {
        on_lanes(&Generated::<E>(PhantomData), self.0)
    }
}

pub(super) fn on_lanes(
    functions: &impl Functions,
    points: &[Point<f64>],
) -> Vec<(Isa, Vec<Vec<f64>>)> {
    let run = |isa: Isa| Some((isa, functions.on_lanes(isa, points)?));
    Isa::ALL.into_iter().filter_map(run).collect()
}

/// Concatenated results of all functions of the generated Rust code, in the order of [`Functions::results`].
pub(super) fn generated_results(m: &generated::Model, at: &Inputs<f64>) -> Vec<f64> {
    let (t, x, p, marker) = (at.time, &at.states, &at.parameters, &at.marker);
    let (n, j, jp) = (m.states.len(), m.j_pattern.len(), m.jp_pattern.len());
    let k = &written([m.prepared.len()], |[k]| (m.prepare)(p, k));
    let mut all = vec![
        k.clone(),
        written([n], |[dx]| (m.f)(t, x, p, k, dx)),
        written([n, j], |[dx, j]| (m.f_jac)(t, x, p, k, dx, j)),
        written([n, j, jp], |[dx, j, jp]| {
            (m.f_jac_par)(t, x, p, k, dx, j, jp);
        }),
    ];
    if m.observed {
        let patterns = [m.dy_dx_pattern, m.dy_dp_pattern, m.dy_dmarker_pattern];
        let [by_x, by_p, by_marker] = patterns.map(<[_]>::len);
        all.push(written([3], |[y]| (m.observe)(t, x, p, k, marker, y)));
        all.push(written([3, by_x, by_p, by_marker], |[y, a, b, c]| {
            (m.observe_jac)(t, x, p, k, marker, y, a, b, c);
        }));
    }
    let (q, l) = (m.quantity_names.len(), m.limit_bounds.len());
    all.push(written([q], |[q]| (m.quantities)(t, x, p, k, q)));
    all.push(written([l], |[l]| (m.limits)(t, x, p, k, l)));
    all.concat()
}

/// Concatenated values that `function` writes into slices of the given lengths.
fn written<const N: usize>(
    lengths: [usize; N],
    function: impl FnOnce([&mut [f64]; N]),
) -> Vec<f64> {
    let mut results = lengths.map(|len| vec![f64::INFINITY; len]);
    function(results.each_mut().map(Vec::as_mut_slice));
    results.concat()
}
