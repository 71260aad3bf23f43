//! Equations of motion of a compiled model, evaluated by tapes.

use crate::evaluation::{self, Inputs};
use crate::subject::Equations;
use codegen::Layout;
use codegen::compile::Compiled;
use codegen::program::Program;
use codegen::tape::Tape;
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::Point;
use oracle::scalar::ErrorBound;
use std::sync::{Mutex, PoisonError};

/// Compiled equations of motion.
pub struct Engine {
    prepare: Tape,
    /// Parameters of the last evaluation, and the results of `prepare` for them.
    last: Mutex<(Vec<f64>, Vec<f64>)>,
    f: Tape,
    observe: Tape,
    /// The programs of `prepare`, `f` and `observe`.
    programs: [Program; 3],
}

impl Engine {
    /// Creates a tape for the state derivatives and the observation of a compiled model.
    pub fn new(compiled: &Compiled) -> Self {
        let functions = [&compiled.prepare, &compiled.f, &compiled.observe];
        Self {
            programs: functions.map(|function| function.program.clone()),
            prepare: Tape::new(&compiled.prepare.program),
            last: Mutex::default(),
            f: Tape::new(&compiled.f.program),
            observe: Tape::new(&compiled.observe.program),
        }
    }

    fn eval(&self, tape: &Tape, point: &Point<f64>) -> Vec<f64> {
        let mut inputs = Inputs::of(point);
        inputs.prepared = self.prepared(&inputs);
        outputs(tape, &inputs)
    }

    /// Results of `prepare`, computed again only if the parameters differ from those of the last call.
    fn prepared(&self, inputs: &Inputs<f64>) -> Vec<f64> {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        let same = |a: &f64, b: &f64| a.to_bits() == b.to_bits();
        let p = &inputs.parameters;
        let is_last = last.0.len() == p.len() && last.0.iter().zip(p).all(|(a, b)| same(a, b));
        // Without parameters, what was never computed would look like the last.
        if !is_last || last.1.len() != self.prepare.outputs() {
            *last = (p.clone(), outputs(&self.prepare, inputs));
        }
        last.1.clone()
    }
}

/// Floating-point outputs of a tape.
pub fn outputs(tape: &Tape, inputs: &Inputs<f64>) -> Vec<f64> {
    let mut out = vec![0.0; tape.outputs()];
    tape.eval(inputs.of_tape(), &mut Vec::new(), &mut out);
    out
}

fn vector(components: &[f64]) -> Option<Vector3<f64>> {
    <[f64; 3]>::try_from(components).ok().map(Vector3::from)
}

impl Equations for Engine {
    fn rates(&self, point: &Point<f64>) -> Vec<f64> {
        self.eval(&self.f, point)
    }

    fn observation(&self, point: &Point<f64>) -> Option<Vector3<f64>> {
        vector(&self.eval(&self.observe, point))
    }

    fn magnitudes(&self, point: &Point<f64>) -> Vec<f64> {
        let [prepare, f, observe] = &self.programs;
        let mut inputs = Inputs::<ErrorBound>::of(&point.lift());
        inputs.prepared = evaluation::outputs(prepare, &inputs);
        let all = [f, observe].map(|program| evaluation::outputs(program, &inputs));
        all.concat().iter().map(|output| output.magnitude).collect()
    }

    fn overflowing(&self, point: &Point<f64>) -> Option<Vec<f64>> {
        let [prepare, f, observe] = &self.programs;
        Some(evaluation::overflowing(prepare, [f, observe], point, |_| true)?.concat())
    }
}

/// State derivatives and observation of a model as one program.
pub struct Values {
    /// Order of the states and parameters.
    pub layout: Layout,
    /// Program of the state derivatives, then the observation.
    pub program: Program,
    tape: Tape,
}

impl Values {
    /// Compiles a model.
    pub fn of(model: &Model) -> Self {
        let (layout, program) = codegen::compile_values(model);
        let tape = Tape::new(&program);
        Self {
            layout,
            program,
            tape,
        }
    }

    /// Number of operations of one evaluation.
    pub fn operations(&self) -> usize {
        codegen::count::count(&self.program).total()
    }

    fn eval(&self, point: &Point<f64>) -> Vec<f64> {
        outputs(&self.tape, &Inputs::of(point))
    }
}

impl Equations for Values {
    fn rates(&self, point: &Point<f64>) -> Vec<f64> {
        let mut all = self.eval(point);
        all.truncate(self.layout.states.len());
        all
    }

    fn observation(&self, point: &Point<f64>) -> Option<Vector3<f64>> {
        vector(self.eval(point).get(self.layout.states.len()..)?)
    }

    fn magnitudes(&self, point: &Point<f64>) -> Vec<f64> {
        let outputs = evaluation::outputs::<ErrorBound>(&self.program, &Inputs::of(&point.lift()));
        outputs.iter().map(|output| output.magnitude).collect()
    }
}
