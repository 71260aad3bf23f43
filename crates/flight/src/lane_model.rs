//! Evaluation of a model in SIMD lanes: by generated code if its source hash equals that of the model, otherwise by a
//! tape.

use std::marker::PhantomData;
use std::sync::OnceLock;

use crate::CompiledModel;
use crate::inputs::InputsOverTime;
use crate::single_flights;
use crate::switches::SwitchTape;
use crate::time_breaks::TimeBreaks;
use codegen::Layout;
use codegen::compile::{Selection, compile_for};
use codegen::rust::source_hash;
use codegen::tape::Inputs;
use codegen::tape_model::{TapeFunction, TapeModel};
use generated::{Equations, Visitor};
use lanes::{Enclosure, Isa, LaneKernel, Lanes, Switch};
use model_spec::layout::ParamId;
use model_spec::model::Model;
use ode::{
    FlightQueue, FlightSpan, IntegrationOptions, LanePoint, LaneRhs, LaneSizes, fly_on,
    fly_on_widest,
};

/// A model whose flights are integrated in SIMD lanes, one flight per lane.
pub struct LaneModel {
    model: Model,
    /// Whether flights are integrated with Rust code generated from the model rather than with a tape; of a model with
    /// switches never.
    is_generated: bool,
    /// The model compiled to a tape; compiled on the first use of the tape.
    tape: OnceLock<TapeModel>,
    /// The model compiled for flights one by one; compiled on the first use, if the model has constraints.
    constrained: OnceLock<CompiledModel>,
    /// Lower bounds of the validity limits, SI, in the order of the model's limits.
    bounds: Vec<f64>,
    time_breaks: TimeBreaks,
    switches: Option<SwitchTape>,
    /// Inputs over time, the same in all flights.
    inputs: InputsOverTime,
}

impl LaneModel {
    /// Prepares `model` for SIMD lanes, with generated Rust code of the same source hash, or else a tape.
    pub fn new(model: &Model) -> LaneModel {
        let generated = generated::model(&model.name);
        let is_current = generated.is_some_and(|code| code.source_hash == source_hash(model));
        let interpreted = LaneModel::interpreted(model);
        LaneModel {
            is_generated: is_current && interpreted.switches.is_none(),
            ..interpreted
        }
    }

    /// Prepares `model` for integration in SIMD lanes by a tape, even if generated Rust code for the model exists.
    pub fn interpreted(model: &Model) -> LaneModel {
        let time_breaks = TimeBreaks::of(model, &Layout::new(model));
        LaneModel {
            model: model.clone(),
            is_generated: false,
            tape: OnceLock::new(),
            constrained: OnceLock::new(),
            bounds: model.limits.iter().map(|limit| limit.bound).collect(),
            switches: SwitchTape::of(model, &time_breaks),
            time_breaks,
            inputs: InputsOverTime::default(),
        }
    }

    /// The model with inputs over time, which are the same in all flights; they are evaluated with the tape.
    pub fn with_inputs(self, inputs: InputsOverTime) -> LaneModel {
        LaneModel {
            is_generated: self.is_generated && inputs.is_empty(),
            inputs,
            ..self
        }
    }

    /// Whether flights use generated Rust code rather than a tape. It exists only for the widest instruction sets
    /// ([`ode::fly_on_widest`]); results are the same.
    pub fn is_generated(&self) -> bool {
        self.is_generated
    }

    /// Integrates all flights of `queue` with [`ode::fly_on`] to the end in `span`, and returns the number of vectorized
    /// evaluations. `isa` is the instruction set, or `None` for the widest; 0, without integrating, if the processor
    /// lacks it. Flights of a model with constraints are integrated one by one, as those of
    /// [`BoundModel::integrate_to_end`](crate::BoundModel::integrate_to_end), which holds them to the constraints.
    ///
    /// # Panics
    /// Under the conditions for which [`ode::fly_on`] panics.
    pub fn fly(
        &self,
        queue: &mut dyn FlightQueue,
        span: &FlightSpan,
        options: &IntegrationOptions,
        isa: Option<Isa>,
    ) -> u64 {
        if self.has_constraints() {
            let new = || CompiledModel::compiled_for(&self.model, &Selection::Only(Vec::new()));
            let model = self.constrained.get_or_init(new);
            return single_flights::fly(model, &self.inputs, queue, span, options);
        }
        let isa = isa.unwrap_or_else(Isa::best);
        if self.is_generated {
            let task = GeneratedTask {
                model: self,
                queue: &mut *queue,
                span,
                options,
                isa,
            };
            if let Some(Some(evaluations)) = generated::visit(&self.model.name, task) {
                return evaluations;
            }
        }
        let rhs = TapeRhs {
            model: self,
            tape: self.tape(),
        };
        fly_on(isa, &rhs, queue, span, options).unwrap_or(0)
    }

    fn has_constraints(&self) -> bool {
        let mut systems = self.model.systems.iter();
        systems.any(|own| !own.constraints.is_empty())
    }

    #[inline(always)]
    fn subtract_bounds<T: Lanes>(&self, margins: &mut [T]) {
        for (margin, bound) in margins.iter_mut().zip(&self.bounds) {
            *margin = *margin - T::splat(*bound);
        }
    }

    /// Times at which the right-hand side is not smooth, for the parameters `p`.
    fn breaks(&self, p: &[f64], breaks: &mut Vec<f64>) {
        breaks.extend(self.time_breaks.at(p));
        breaks.extend(self.inputs.breaks(p));
        breaks.sort_unstable_by(f64::total_cmp);
    }

    fn switches(&self) -> &[Switch] {
        self.switches.as_ref().map_or(&[], |own| &own.switches)
    }

    fn switch_registers(&self) -> usize {
        let switches = self.switches.as_ref();
        switches.map_or(0, |own| own.arguments.tape.registers())
    }

    #[inline(always)]
    fn switch_arguments<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], to: &mut [T]) {
        if let Some(own) = &self.switches {
            evaluate(&own.arguments, at, scratch, to);
        }
    }

    fn switch_bounds(
        &self,
        t: Enclosure,
        x: &[Enclosure],
        p: &[f64],
        to: &mut [Enclosure],
    ) -> bool {
        let Some(own) = self.switches.as_ref().filter(|_| self.inputs.is_empty()) else {
            return false;
        };
        own.bounds(t, x, p, &mut Vec::new(), to);
        true
    }

    /// Number of margins: of the validity limits of the model, and of the ends of the inputs.
    fn limits(&self) -> usize {
        self.bounds.len() + self.inputs.iter().count()
    }

    /// Room for the parameters at the time of an evaluation.
    fn varied(&self, parameters: usize) -> usize {
        if self.inputs.is_empty() {
            0
        } else {
            parameters
        }
    }

    fn tape(&self) -> &TapeModel {
        // No derivatives by parameters are evaluated.
        let selection = Selection::Only(Vec::new());
        self.tape
            .get_or_init(|| TapeModel::new(&compile_for(&self.model, &selection)))
    }
}

/// Arguments of an integration of flights with Rust code generated from the model, passed to [`generated::visit`].
struct GeneratedTask<'a> {
    model: &'a LaneModel,
    queue: &'a mut dyn FlightQueue,
    span: &'a FlightSpan,
    options: &'a IntegrationOptions,
    isa: Isa,
}

impl Visitor for GeneratedTask<'_> {
    type Output = Option<u64>;

    fn visit<E: Equations>(self) -> Option<u64> {
        let rhs = GeneratedRhs::<E> {
            model: self.model,
            equations: PhantomData,
        };
        fly_on_widest(self.isa, &rhs, self.queue, self.span, self.options)
    }
}

/// Right-hand side and validity limits of a model in SIMD lanes, by the generated Rust code of the type `E`.
struct GeneratedRhs<'a, E> {
    model: &'a LaneModel,
    equations: PhantomData<E>,
}

impl<E: Equations> LaneRhs for GeneratedRhs<'_, E> {
    fn sizes(&self) -> LaneSizes {
        LaneSizes {
            states: E::MODEL.states.len(),
            parameters: E::MODEL.parameters.len(),
            prepared: E::MODEL.prepared.len(),
            limits: self.model.limits(),
            scratch: 0,
        }
    }

    fn time_breaks(&self, p: &[f64], breaks: &mut Vec<f64>) {
        self.model.breaks(p, breaks);
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
        self.model.subtract_bounds(margins);
    }
}

/// Right-hand side of the equations of motion and validity limits of a model, evaluated in SIMD lanes by a tape.
struct TapeRhs<'a> {
    model: &'a LaneModel,
    tape: &'a TapeModel,
}

impl LaneRhs for TapeRhs<'_> {
    fn sizes(&self) -> LaneSizes {
        let of = |function: &TapeFunction| function.tape.registers();
        let tape = self.tape;
        LaneSizes {
            states: tape.states,
            parameters: tape.parameters,
            prepared: tape.prepared,
            limits: self.model.limits(),
            scratch: self.model.varied(tape.parameters)
                + of(&tape.prepare)
                    .max(of(&tape.f))
                    .max(of(&tape.limits))
                    .max(self.model.switch_registers()),
        }
    }

    fn time_breaks(&self, p: &[f64], breaks: &mut Vec<f64>) {
        self.model.breaks(p, breaks);
    }

    fn switches(&self) -> &[Switch] {
        self.model.switches()
    }

    fn switch_bounds(
        &self,
        t: Enclosure,
        x: &[Enclosure],
        p: &[f64],
        to: &mut [Enclosure],
    ) -> bool {
        self.model.switch_bounds(t, x, p, to)
    }

    #[inline(always)]
    fn switch_arguments<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], to: &mut [T]) {
        self.within(at, scratch, |at, scratch| {
            self.model.switch_arguments(at, scratch, to);
        });
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
        self.within(at, scratch, |at, scratch| {
            evaluate(&self.tape.f, at, scratch, dx);
        });
    }

    #[inline(always)]
    fn limits<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], margins: &mut [T]) {
        let of_model = self.model.bounds.len();
        let (own, ends) = margins.split_at_mut(of_model);
        self.within(at, scratch, |at, scratch| {
            evaluate(&self.tape.limits, at, scratch, own);
        });
        self.model.subtract_bounds(own);
        for (margin, own) in ends.iter_mut().zip(self.model.inputs.iter()) {
            *margin = T::splat(own.series.end()) - at.t;
        }
    }
}

impl TapeRhs<'_> {
    /// Calls `with` at the same point with the values that the inputs over time have there.
    #[inline(always)]
    fn within<T: Lanes>(
        &self,
        at: LanePoint<'_, T>,
        scratch: &mut [T],
        with: impl FnOnce(LanePoint<'_, T>, &mut [T]),
    ) {
        let (varied, scratch) = scratch.split_at_mut(self.model.varied(at.p.len()));
        if varied.is_empty() {
            return with(at, scratch);
        }
        varied.copy_from_slice(at.p);
        for own in self.model.inputs.iter() {
            let value_of = |id: ParamId, lane: usize| at.p[id.index()].lane(lane);
            let read = |lane: usize| own.at(at.t.lane(lane), &[], |id| value_of(id, lane));
            for (place, id) in own.parameters().into_iter().enumerate() {
                if let Some(id) = id {
                    varied[id.index()] = T::from_fn(|lane| read(lane)[place]);
                }
            }
        }
        with(LanePoint { p: varied, ..at }, scratch);
    }
}

#[inline(always)]
fn evaluate<T: Lanes>(
    function: &TapeFunction,
    at: LanePoint<'_, T>,
    scratch: &mut [T],
    out: &mut [T],
) {
    T::outlined(Evaluation {
        function,
        at,
        scratch,
        out,
    });
}

struct Evaluation<'a, T> {
    function: &'a TapeFunction,
    at: LanePoint<'a, T>,
    scratch: &'a mut [T],
    out: &'a mut [T],
}

impl<T: Lanes> LaneKernel<T> for Evaluation<'_, T> {
    #[inline(always)]
    fn run(self) {
        let at = self.at;
        let inputs = Inputs {
            t: at.t,
            x: at.x,
            p: at.p,
            prepared: at.prepared,
            marker: &[],
        };
        self.function.tape.eval_in(inputs, self.scratch, self.out);
    }
}
