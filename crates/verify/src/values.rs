//! A model compiled to values only, without derivatives and without hoisting of parameter-only code. This is sufficient
//! for mutants and effects, and takes a tenth of the compilation time.

use crate::engine::outputs;
use crate::evaluation::Inputs;
use crate::subject::Equations;
use codegen::Layout;
use codegen::program::Program;
use codegen::tape::Tape;
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::Point;

/// Compiled program of the state derivatives and the observation of a model: its operations in evaluation order.
pub struct Values {
    /// Order of the states and parameters among the inputs of `program`.
    pub layout: Layout,
    /// Compiled program whose outputs are the state derivatives, then the observation.
    pub program: Program,
    tape: Tape,
}

impl Values {
    /// Compiles the state derivatives and the observation of a model to one program.
    pub fn of(model: &Model) -> Self {
        let (layout, program) = codegen::compile_values(model);
        let tape = Tape::new(&program);
        Self {
            layout,
            program,
            tape,
        }
    }

    /// Number of operations for one evaluation of the state derivatives and the observation.
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
        match self.eval(point).get(self.layout.states.len()..)? {
            &[x, y, z] => Some(Vector3::new(x, y, z)),
            _ => None,
        }
    }
}
