//! All functions of a model as tapes, evaluated for `f64`. Models that are compiled at run time need no Rust compiler.

use crate::compile::Compiled;
use crate::program::{Function, Section};
use crate::tape::{Inputs, Tape};
use lanes::{ScalarKernel, ScalarLane, dispatch_scalar};

/// One model function as a [`Tape`], with the division of its results into output arrays.
#[derive(Clone, Debug)]
pub struct TapeFunction {
    /// Bytecode of the function.
    pub tape: Tape,
    /// Output sections of the function, each written to an array of its own.
    pub sections: Vec<Section>,
}

impl TapeFunction {
    pub(crate) fn new(function: &Function) -> TapeFunction {
        TapeFunction {
            tape: Tape::new(&function.program),
            sections: function.sections.clone(),
        }
    }

    /// Lengths of the output arrays, one for each of the [`sections`](Self::sections).
    pub fn lens(&self) -> Vec<usize> {
        self.sections.iter().map(|section| section.len).collect()
    }

    /// (row, column) of each entry of the Jacobian `name`, such as `jp`; empty without such a section.
    pub fn pattern(&self, name: &str) -> &[(u32, u32)] {
        let section = self.sections.iter().find(|section| section.name == name);
        section
            .and_then(|section| section.pattern.as_deref())
            .unwrap_or(&[])
    }

    /// Evaluates the function and writes each of the [`sections`](Self::sections) to its array, Jacobians by their
    /// entries. Only `observe` and `observe_jac` read `marker`.
    pub fn eval(
        &self,
        at: At<'_>,
        marker: &[f64],
        scratch: &mut Scratch,
        results: &mut [&mut [f64]],
    ) {
        let Scratch { registers, out } = scratch;
        let wanted = self.tape.outputs();
        if out.len() < wanted {
            out.resize(wanted, 0.0);
        }
        if registers.len() < self.tape.registers() {
            registers.resize(self.tape.registers(), 0.0);
        }
        dispatch_scalar(Run {
            tape: &self.tape,
            at,
            marker,
            registers,
            out,
        });
        let mut start = 0;
        for (section, result) in self.sections.iter().zip(results) {
            result[..section.len].copy_from_slice(&out[start..start + section.len]);
            start += section.len;
        }
    }
}

/// Reusable buffers for registers and results, for any function.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    registers: Vec<f64>,
    out: Vec<f64>,
}

/// Functions of a model, compiled to register bytecode ([`Tape`]).
#[derive(Clone, Debug)]
pub struct TapeModel {
    /// Number of states.
    pub states: usize,
    /// Number of parameters: known constants, coefficients and components of inputs together.
    pub parameters: usize,
    /// Number of invariants that `prepare` computes.
    pub prepared: usize,
    /// Function that computes the invariants of a flight from the parameters.
    pub prepare: TapeFunction,
    /// Function that computes the time derivatives `dx` of the states.
    pub f: TapeFunction,
    /// Computes the state derivatives `dx` with the Jacobians `j` and `jp`.
    pub f_jac_par: TapeFunction,
    /// Function that computes the position `y`, m, of a marker in the inertial frame, from its body-fixed coordinates.
    pub observe: TapeFunction,
    /// Computes `y` and its Jacobians `dy_dx`, `dy_dp` and `dy_dmarker`.
    pub observe_jac: TapeFunction,
    /// Computes [`Layout::quantities`](crate::Layout::quantities).
    pub quantities: TapeFunction,
    /// Computes the left-hand sides of the limits of validity.
    pub limits: TapeFunction,
}

/// Arguments of an evaluation of a model function.
#[derive(Clone, Copy, Debug)]
pub struct At<'a> {
    /// Time since release, s.
    pub t: f64,
    /// State vector, in the order of `Layout::states`.
    pub x: &'a [f64],
    /// Parameters: known constants, then coefficients, then components of inputs.
    pub p: &'a [f64],
    /// Invariants that [`TapeModel::prepare`] returned for the parameters `p`.
    pub prepared: &'a [f64],
}

impl TapeModel {
    /// Compiles all functions of a model to register bytecode.
    pub fn new(compiled: &Compiled) -> TapeModel {
        TapeModel {
            states: compiled.layout.states.len(),
            parameters: compiled.layout.parameters.len(),
            prepared: compiled.prepared.len(),
            prepare: TapeFunction::new(&compiled.prepare),
            f: TapeFunction::new(&compiled.f),
            f_jac_par: TapeFunction::new(&compiled.f_jac_par),
            observe: TapeFunction::new(&compiled.observe),
            observe_jac: TapeFunction::new(&compiled.observe_jac),
            quantities: TapeFunction::new(&compiled.quantities),
            limits: TapeFunction::new(&compiled.limits),
        }
    }

    /// Computes the invariants of a flight: all subexpressions that depend only on the parameters `p`.
    pub fn prepare(&self, p: &[f64]) -> Vec<f64> {
        let mut prepared = vec![0.0; self.prepared];
        let (t, x, none) = (0.0, &[][..], &[][..]);
        let at = At {
            t,
            x,
            p,
            prepared: none,
        };
        let scratch = &mut Scratch::default();
        self.prepare.eval(at, &[], scratch, &mut [&mut prepared]);
        prepared
    }
}

/// Scalar kernel that evaluates one [`Tape`].
struct Run<'a> {
    tape: &'a Tape,
    at: At<'a>,
    marker: &'a [f64],
    registers: &'a mut [f64],
    out: &'a mut [f64],
}

impl ScalarKernel for Run<'_> {
    #[inline(always)]
    fn run<T: ScalarLane>(self) {
        let inputs = Inputs {
            t: T::splat(self.at.t),
            x: T::slice(self.at.x),
            p: T::slice(self.at.p),
            prepared: T::slice(self.at.prepared),
            marker: T::slice(self.marker),
        };
        let (registers, out) = (T::slice_mut(self.registers), T::slice_mut(self.out));
        self.tape.eval_in(inputs, registers, out);
    }
}
