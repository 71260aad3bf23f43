//! A model compiled to values only, without derivatives and `prepare`: a tenth of the compilation time.

use crate::engine::outputs;
use crate::evaluation::{self, Inputs};
use crate::subject::Equations;
use codegen::Layout;
use codegen::program::Program;
use codegen::tape::Tape;
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::Point;
use oracle::scalar::ErrorBound;

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
        match self.eval(point).get(self.layout.states.len()..)? {
            &[x, y, z] => Some(Vector3::new(x, y, z)),
            _ => None,
        }
    }

    fn magnitudes(&self, point: &Point<f64>) -> Vec<f64> {
        let outputs = evaluation::outputs::<ErrorBound>(&self.program, &Inputs::of(&point.lift()));
        outputs.iter().map(|output| output.magnitude).collect()
    }
}
