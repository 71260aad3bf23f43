//! A compiled model on tapes, for `f64`: changed models and candidate effects run without a compiler.

use crate::compile::Compiled;
use crate::program::{Function, Section};
use crate::tape::{Inputs, Tape};
use lanes::{ScalarKernel, ScalarLane, dispatch_scalar};

/// A function on a tape, with the places of its results.
#[derive(Clone, Debug)]
pub struct TapeFunction {
    /// The instructions.
    pub tape: Tape,
    /// What the results are, section by section.
    pub sections: Vec<Section>,
}

impl TapeFunction {
    fn new(function: &Function) -> TapeFunction {
        TapeFunction {
            tape: Tape::new(&function.program),
            sections: function.sections.clone(),
        }
    }

    /// How many numbers each section holds.
    pub fn lens(&self) -> Vec<usize> {
        self.sections.iter().map(|section| section.len).collect()
    }

    fn pattern(&self, name: &str) -> &[(u32, u32)] {
        let section = self.sections.iter().find(|section| section.name == name);
        section
            .and_then(|section| section.pattern.as_deref())
            .unwrap_or(&[])
    }
}

/// Space that evaluations use again and again.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    registers: Vec<f64>,
    out: Vec<f64>,
}

/// All functions of a model on tapes.
#[derive(Clone, Debug)]
pub struct TapeModel {
    /// The model's name.
    pub name: String,
    /// How many states there are.
    pub states: usize,
    /// How many parameters.
    pub parameters: usize,
    /// How many constants `prepare` computes.
    pub prepared: usize,
    /// `prepare`.
    pub prepare: TapeFunction,
    /// `f`.
    pub f: TapeFunction,
    /// `f_jac`.
    pub f_jac: TapeFunction,
    /// `f_jac_par`.
    pub f_jac_par: TapeFunction,
    /// `observe`.
    pub observe: TapeFunction,
    /// `observe_jac`.
    pub observe_jac: TapeFunction,
    /// `quantities`.
    pub quantities: TapeFunction,
    /// `limits`.
    pub limits: TapeFunction,
}

/// Where and when something is evaluated.
#[derive(Clone, Copy, Debug)]
pub struct At<'a> {
    /// Time since release.
    pub t: f64,
    /// The state.
    pub x: &'a [f64],
    /// Parameters, coefficients, inputs.
    pub p: &'a [f64],
    /// What [`TapeModel::prepare`] made of them.
    pub prepared: &'a [f64],
}

impl TapeModel {
    /// Lays all functions out.
    pub fn new(compiled: &Compiled) -> TapeModel {
        TapeModel {
            name: compiled.name.clone(),
            states: compiled.layout.states.len(),
            parameters: compiled.layout.parameters.len(),
            prepared: compiled.prepared.len(),
            prepare: TapeFunction::new(&compiled.prepare),
            f: TapeFunction::new(&compiled.f),
            f_jac: TapeFunction::new(&compiled.f_jac),
            f_jac_par: TapeFunction::new(&compiled.f_jac_par),
            observe: TapeFunction::new(&compiled.observe),
            observe_jac: TapeFunction::new(&compiled.observe_jac),
            quantities: TapeFunction::new(&compiled.quantities),
            limits: TapeFunction::new(&compiled.limits),
        }
    }

    /// (row, column) of each entry of `j`.
    pub fn j_pattern(&self) -> &[(u32, u32)] {
        self.f_jac_par.pattern("j")
    }

    /// (row, column) of each entry of `jp`.
    pub fn jp_pattern(&self) -> &[(u32, u32)] {
        self.f_jac_par.pattern("jp")
    }

    /// (row, column) of each entry of `dy_dx`.
    pub fn dy_dx_pattern(&self) -> &[(u32, u32)] {
        self.observe_jac.pattern("dy_dx")
    }

    /// (row, column) of each entry of `dy_dp`.
    pub fn dy_dp_pattern(&self) -> &[(u32, u32)] {
        self.observe_jac.pattern("dy_dp")
    }

    /// (row, column) of each entry of `dy_dmarker`.
    pub fn dy_dmarker_pattern(&self) -> &[(u32, u32)] {
        self.observe_jac.pattern("dy_dmarker")
    }

    /// The constants of a flight.
    pub fn prepare(&self, p: &[f64]) -> Vec<f64> {
        let mut prepared = vec![0.0; self.prepared];
        let at = At {
            t: 0.0,
            x: &[],
            p,
            prepared: &[],
        };
        run(
            &self.prepare,
            at,
            &[],
            &mut Scratch::default(),
            &mut [&mut prepared],
        );
        prepared
    }

    /// Derivatives of the states.
    pub fn f(&self, at: At<'_>, scratch: &mut Scratch, dx: &mut [f64]) {
        run(&self.f, at, &[], scratch, &mut [dx]);
    }

    /// Derivatives of the states and their Jacobian.
    pub fn f_jac(&self, at: At<'_>, scratch: &mut Scratch, dx: &mut [f64], j: &mut [f64]) {
        run(&self.f_jac, at, &[], scratch, &mut [dx, j]);
    }

    /// Derivatives of the states, their Jacobian, and that by the parameters.
    pub fn f_jac_par(
        &self,
        at: At<'_>,
        scratch: &mut Scratch,
        dx: &mut [f64],
        j: &mut [f64],
        jp: &mut [f64],
    ) {
        run(&self.f_jac_par, at, &[], scratch, &mut [dx, j, jp]);
    }

    /// The marker in the inertial frame.
    pub fn observe(&self, at: At<'_>, marker: &[f64], scratch: &mut Scratch, y: &mut [f64]) {
        run(&self.observe, at, marker, scratch, &mut [y]);
    }

    /// The marker and its derivatives: `[y, dy_dx, dy_dp, dy_dmarker]`.
    pub fn observe_jac(
        &self,
        at: At<'_>,
        marker: &[f64],
        scratch: &mut Scratch,
        results: [&mut [f64]; 4],
    ) {
        let mut results = results;
        run(&self.observe_jac, at, marker, scratch, &mut results);
    }

    /// Every named quantity.
    pub fn quantities(&self, at: At<'_>, scratch: &mut Scratch, q: &mut [f64]) {
        run(&self.quantities, at, &[], scratch, &mut [q]);
    }

    /// Left sides of the limits.
    pub fn limits(&self, at: At<'_>, scratch: &mut Scratch, l: &mut [f64]) {
        run(&self.limits, at, &[], scratch, &mut [l]);
    }
}

fn run(
    function: &TapeFunction,
    at: At<'_>,
    marker: &[f64],
    scratch: &mut Scratch,
    results: &mut [&mut [f64]],
) {
    let Scratch { registers, out } = scratch;
    let wanted = function.tape.outputs();
    if out.len() < wanted {
        out.resize(wanted, 0.0);
    }
    if registers.len() < function.tape.registers() {
        registers.resize(function.tape.registers(), 0.0);
    }
    dispatch_scalar(Run {
        tape: &function.tape,
        at,
        marker,
        registers,
        out,
    });
    let mut start = 0;
    for (section, result) in function.sections.iter().zip(results) {
        result[..section.len].copy_from_slice(&out[start..start + section.len]);
        start += section.len;
    }
}

/// An evaluation, with the operations of this machine.
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
