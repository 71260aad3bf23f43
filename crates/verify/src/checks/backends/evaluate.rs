//! Evaluates all functions of a model at many points: by tapes, and by generated code for `f64`.

use codegen::program::Program;
use codegen::tape::{Inputs, Tape};
use lanes::{Isa, Kernel, Lanes, Real, dispatch_with};
use oracle::Point;

/// Inputs of the compiled functions at a point, in the order of the compiled model's variables: time, states,
/// parameters, marker position.
pub(super) struct Numbers<T> {
    t: T,
    x: Vec<T>,
    p: Vec<T>,
    marker: Vec<T>,
}

impl Numbers<f64> {
    pub fn of(point: &Point<f64>) -> Self {
        Self {
            t: point.time,
            x: point.states.clone(),
            p: point.parameters(),
            marker: point.marker.iter().copied().collect(),
        }
    }
}

/// Tapes of all functions of a model, in the order of [`codegen::Compiled::functions`]. The first tape computes values
/// that depend on parameters only; the other tapes read them.
pub(super) struct Tapes(Vec<Tape>);

impl Tapes {
    pub fn new<'a>(programs: impl IntoIterator<Item = &'a Program>) -> Self {
        Self(programs.into_iter().map(Tape::new).collect())
    }

    /// Concatenated results of all compiled functions of the model at a point, in the order of
    /// [`codegen::Compiled::functions`].
    #[inline(always)]
    pub fn results<T: Real>(&self, at: &Numbers<T>) -> Vec<T> {
        let (mut all, mut prepared, mut scratch) = (Vec::new(), Vec::new(), Vec::new());
        for (k, tape) in self.0.iter().enumerate() {
            let mut out = vec![T::splat(0.0); tape.outputs()];
            let inputs = Inputs {
                t: at.t,
                x: &at.x,
                p: &at.p,
                prepared: &prepared,
                marker: &at.marker,
            };
            tape.eval(inputs, &mut scratch, &mut out);
            if k == 0 {
                prepared.clone_from(&out);
            }
            all.extend(out);
        }
        all
    }

    /// Concatenated results of all compiled functions of the model at each point, computed with one SIMD instruction
    /// set; `None` if this machine lacks it.
    pub fn on_lanes(&self, isa: Isa, points: &[Point<f64>]) -> Option<Vec<Vec<f64>>> {
        dispatch_with(
            isa,
            Batch {
                tapes: self,
                points,
            },
        )
    }
}

struct Batch<'a> {
    tapes: &'a Tapes,
    points: &'a [Point<f64>],
}

impl Kernel for Batch<'_> {
    type Output = Vec<Vec<f64>>;

    #[inline(always)]
    fn run<T: Lanes>(self) -> Vec<Vec<f64>> {
        let mut results = Vec::with_capacity(self.points.len());
        for chunk in self.points.chunks(T::WIDTH) {
            let each: Vec<Numbers<f64>> = chunk.iter().map(Numbers::of).collect();
            // Lanes beyond the last point repeat the last point.
            let pick = |value: &dyn Fn(&Numbers<f64>) -> f64| {
                T::from_fn(|lane| value(&each[lane.min(each.len() - 1)]))
            };
            let at = Numbers {
                t: pick(&|n| n.t),
                x: (0..each[0].x.len()).map(|i| pick(&|n| n.x[i])).collect(),
                p: (0..each[0].p.len()).map(|i| pick(&|n| n.p[i])).collect(),
                marker: (0..3).map(|i| pick(&|n| n.marker[i])).collect(),
            };
            let out = self.tapes.results(&at);
            results.extend((0..chunk.len()).map(|lane| out.iter().map(|v| v.lane(lane)).collect()));
        }
        results
    }
}

/// Concatenated `f64` results, at a point, of all functions of the Rust code generated from a model, in the order of
/// [`Tapes::results`].
pub(super) fn generated_results(m: &generated::Model, at: &Numbers<f64>) -> Vec<f64> {
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
