//! Evaluation of a model's measurement equation at many states, in SIMD lanes.

use codegen::compile::{Selection, compile_for};
use codegen::tape::Inputs;
use codegen::tape_model::TapeModel;
use lanes::{Kernel, Lanes, dispatch};
use model_spec::model::Model;

/// The measurement equation of a model, compiled to a tape that is evaluated in SIMD lanes, one state vector per lane.
pub struct LaneObserver {
    tape: TapeModel,
}

impl LaneObserver {
    /// Compiles the measurement equation of `model`, which must not depend on time or a marker: both are set to 0.
    pub fn new(model: &Model) -> LaneObserver {
        let compiled = compile_for(model, &Selection::Only(Vec::new()));
        LaneObserver {
            tape: TapeModel::new(&compiled),
        }
    }

    /// Computes the observed position, m, at many states. The result has one column for each of the three components.
    ///
    /// `states` has one column per state, `parameters` the values for all states, and `varied` indices of parameters
    /// with columns of values instead, row by row.
    ///
    /// # Panics
    /// If a column is shorter than the first column of `states`, or there are fewer states or parameters than the model
    /// has.
    pub fn observe(
        &self,
        states: &[Vec<f64>],
        parameters: &[f64],
        varied: &[(usize, &[f64])],
    ) -> [Vec<f64>; 3] {
        let len = states.first().map_or(0, Vec::len);
        let mut observed = [const { Vec::new() }; 3];
        for column in &mut observed {
            column.resize(len, f64::NAN);
        }
        dispatch(Observe {
            tape: &self.tape,
            states,
            parameters,
            varied,
            observed: &mut observed,
        });
        observed
    }
}

struct Observe<'a> {
    tape: &'a TapeModel,
    states: &'a [Vec<f64>],
    parameters: &'a [f64],
    varied: &'a [(usize, &'a [f64])],
    observed: &'a mut [Vec<f64>; 3],
}

impl Kernel for Observe<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let zero = T::splat(0.0);
        let (prepare, observe) = (&self.tape.prepare.tape, &self.tape.observe.tape);
        let mut scratch = vec![zero; prepare.registers().max(observe.registers())];
        let mut x = vec![zero; self.states.len()];
        let mut p: Vec<T> = Vec::with_capacity(self.parameters.len());
        for value in self.parameters {
            p.push(T::splat(*value));
        }
        let mut prepared = vec![zero; self.tape.prepared];
        let marker = [zero; 3];
        let mut out = vec![zero; observe.outputs()];
        let len = self.observed[0].len();
        let mut first = 0;
        while first < len {
            for (x, column) in x.iter_mut().zip(self.states) {
                *x = T::load_part(&column[first..], 0.0);
            }
            for (index, column) in self.varied {
                p[*index] = T::load_part(&column[first..], 1.0);
            }
            if first == 0 || !self.varied.is_empty() {
                let inputs = Inputs {
                    t: zero,
                    x: &[],
                    p: &p,
                    prepared: &[],
                    marker: &[],
                };
                prepare.eval_in(inputs, &mut scratch, &mut prepared);
            }
            let inputs = Inputs {
                t: zero,
                x: &x,
                p: &p,
                prepared: &prepared,
                marker: &marker,
            };
            observe.eval_in(inputs, &mut scratch, &mut out);
            for (column, value) in self.observed.iter_mut().zip(&out) {
                value.store_part(&mut column[first..]);
            }
            first += T::WIDTH;
        }
    }
}
