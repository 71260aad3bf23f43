//! Evaluation of a model in SIMD lanes: by generated code if its source hash equals that of the model, otherwise by a
//! tape.

use std::marker::PhantomData;

use codegen::compile::{Selection, compile_for};
use codegen::rust::source_hash;
use codegen::tape::Inputs;
use codegen::tape_model::{TapeFunction, TapeModel};
use generated::{Equations, Visitor};
use lanes::{Isa, Lanes};
use model_spec::model::Model;
use ode::{
    FlightQueue, FlightSpan, IntegrationOptions, LanePoint, LaneRhs, LaneSizes, fly, fly_on,
};

/// A model whose flights are integrated in SIMD lanes, one flight per lane.
pub struct LaneModel {
    code: Code,
    /// Lower bound of each validity limit of the model, SI.
    bounds: Vec<f64>,
}

/// Implementation of the model's functions: generated code or a tape.
enum Code {
    /// Generated code of the built-in model of this name.
    Generated(String),
    Tape(Box<TapeModel>),
}

impl LaneModel {
    /// Creates the lane model. Generated code is used if its source hash equals that of the model; otherwise the model
    /// is compiled to a tape.
    pub fn new(model: &Model) -> LaneModel {
        let is_same = |code: &&generated::Model| code.source_hash == source_hash(model);
        match generated::model(&model.name).filter(is_same) {
            Some(_) => LaneModel {
                code: Code::Generated(model.name.clone()),
                bounds: bounds(model),
            },
            None => LaneModel::interpreted(model),
        }
    }

    /// Creates a lane model that evaluates a tape, even if generated code exists.
    pub fn interpreted(model: &Model) -> LaneModel {
        // No derivatives with respect to parameters are evaluated.
        let tape = TapeModel::new(&compile_for(model, &Selection::Only(Vec::new())));
        LaneModel {
            code: Code::Tape(Box::new(tape)),
            bounds: bounds(model),
        }
    }

    /// Whether the model's functions are generated code rather than a tape.
    pub fn is_generated(&self) -> bool {
        matches!(self.code, Code::Generated(_))
    }

    /// Integrates all flights of `queue` with [`ode::fly`] and returns the number of vectorized evaluations of the
    /// right-hand side. `isa` selects the instruction set; `None` selects the widest that the processor supports.
    /// Returns 0 without integrating if the processor does not support `isa`.
    ///
    /// # Panics
    /// Under the conditions for which [`ode::fly`] panics.
    pub fn fly(
        &self,
        queue: &mut dyn FlightQueue,
        span: &FlightSpan,
        options: &IntegrationOptions,
        isa: Option<Isa>,
    ) -> u64 {
        let task = Task {
            queue,
            span,
            options,
            isa,
        };
        match &self.code {
            Code::Generated(name) => {
                let bounds = &self.bounds;
                generated::visit(name, VisitGenerated { task, bounds }).unwrap_or(0)
            }
            Code::Tape(tape) => task.fly(&TapeRhs {
                tape,
                bounds: &self.bounds,
            }),
        }
    }
}

fn bounds(model: &Model) -> Vec<f64> {
    model.limits.iter().map(|limit| limit.bound).collect()
}

/// Arguments of [`LaneModel::fly`]: flights, time span, options and instruction set.
struct Task<'a> {
    queue: &'a mut dyn FlightQueue,
    span: &'a FlightSpan,
    options: &'a IntegrationOptions,
    isa: Option<Isa>,
}

impl Task<'_> {
    fn fly<R: LaneRhs>(self, rhs: &R) -> u64 {
        let queue = self.queue;
        match self.isa {
            None => fly(rhs, queue, self.span, self.options),
            Some(isa) => fly_on(isa, rhs, queue, self.span, self.options).unwrap_or(0),
        }
    }
}

struct VisitGenerated<'a> {
    task: Task<'a>,
    bounds: &'a [f64],
}

impl Visitor for VisitGenerated<'_> {
    type Output = u64;

    fn visit<E: Equations>(self) -> u64 {
        self.task.fly(&GeneratedRhs::<E> {
            bounds: self.bounds,
            equations: PhantomData,
        })
    }
}

/// Right-hand side of the generated equations `E`, evaluated in lanes.
struct GeneratedRhs<'a, E> {
    bounds: &'a [f64],
    equations: PhantomData<E>,
}

impl<E: Equations> LaneRhs for GeneratedRhs<'_, E> {
    fn sizes(&self) -> LaneSizes {
        LaneSizes {
            states: E::MODEL.states.len(),
            parameters: E::MODEL.parameters.len(),
            prepared: E::MODEL.prepared.len(),
            limits: self.bounds.len(),
            scratch: 0,
        }
    }

    #[inline(always)]
    fn prepare<T: Lanes>(&self, p: &[T], _: &mut [T], prepared: &mut [T]) {
        E::prepare(p, prepared);
    }

    #[inline(always)]
    fn derivative<T: Lanes>(&self, at: LanePoint<'_, T>, _: &mut [T], dx: &mut [T]) {
        E::f(at.t, at.x, at.p, at.prepared, dx);
    }

    #[inline(always)]
    fn limits<T: Lanes>(&self, at: LanePoint<'_, T>, _: &mut [T], margins: &mut [T]) {
        E::limits(at.t, at.x, at.p, at.prepared, margins);
        subtract(self.bounds, margins);
    }
}

/// Right-hand side that a tape evaluates in lanes.
struct TapeRhs<'a> {
    tape: &'a TapeModel,
    bounds: &'a [f64],
}

impl LaneRhs for TapeRhs<'_> {
    fn sizes(&self) -> LaneSizes {
        let of = |function: &TapeFunction| function.tape.registers();
        let tape = self.tape;
        LaneSizes {
            states: tape.states,
            parameters: tape.parameters,
            prepared: tape.prepared,
            limits: self.bounds.len(),
            scratch: of(&tape.prepare).max(of(&tape.f)).max(of(&tape.limits)),
        }
    }

    #[inline(always)]
    fn prepare<T: Lanes>(&self, p: &[T], scratch: &mut [T], prepared: &mut [T]) {
        let at = LanePoint {
            t: T::splat(0.0),
            x: &[],
            p,
            prepared: &[],
        };
        evaluate(&self.tape.prepare, at, scratch, prepared);
    }

    #[inline(always)]
    fn derivative<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], dx: &mut [T]) {
        evaluate(&self.tape.f, at, scratch, dx);
    }

    #[inline(always)]
    fn limits<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], margins: &mut [T]) {
        evaluate(&self.tape.limits, at, scratch, margins);
        subtract(self.bounds, margins);
    }
}

#[inline(always)]
fn evaluate<T: Lanes>(
    function: &TapeFunction,
    at: LanePoint<'_, T>,
    scratch: &mut [T],
    out: &mut [T],
) {
    let inputs = Inputs {
        t: at.t,
        x: at.x,
        p: at.p,
        prepared: at.prepared,
        marker: &[],
    };
    function.tape.eval_in(inputs, scratch, out);
}

#[inline(always)]
fn subtract<T: Lanes>(bounds: &[f64], margins: &mut [T]) {
    for (margin, bound) in margins.iter_mut().zip(bounds) {
        *margin = *margin - T::splat(*bound);
    }
}
