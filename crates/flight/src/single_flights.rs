//! Flights of a queue one by one with the scalar solver, which holds them to the constraints of their model.

use crate::{BoundModel, CompiledModel, FlightParameters, InputsOverTime, ModelState};
use ode::{
    Endpoint, Event, FlightEnd, FlightOutcome, FlightQueue, FlightSpan, IntegrationError,
    IntegrationFailure, IntegrationOptions, SolverStats,
};

/// Name of the event at a highest point.
const APEX: &str = "apex";
/// Name of the event at which a flight lands.
const GROUND: &str = "ground";

/// Integrates all flights of `queue` to the end in `span`, and returns the number of evaluations.
pub(crate) fn fly(
    model: &CompiledModel,
    inputs: &InputsOverTime,
    queue: &mut dyn FlightQueue,
    span: &FlightSpan,
    options: &IntegrationOptions,
) -> u64 {
    let mut state = vec![0.0; model.layout().states.len()];
    let mut constants = vec![0.0; model.layout().parameters.len()];
    let mut evaluations = 0;
    while let Some(flight) = queue.next(&mut state, &mut constants) {
        let bound = model.bind(FlightParameters {
            constants: constants.clone(),
            inputs: inputs.clone(),
        });
        let mut events = bound.limits();
        events.extend(events_of(span));
        let start: ModelState = state.as_slice().into();
        let flown = bound.integrate_to_end((0.0, &start), span.t_end, options, &mut events);
        let end = match &flown {
            Ok(end) => landed(flight, &start, end, span),
            Err(error) => {
                state = error.states.iter().map(|(_, value)| *value).collect();
                if state.is_empty() {
                    state = start.to_vec();
                }
                failed(flight, &state, error, &bound)
            }
        };
        evaluations += end.stats.evaluations as u64;
        queue.end(end);
        state.resize(start.len(), 0.0);
    }
    evaluations
}

/// Events that a flight is asked for.
fn events_of(span: &FlightSpan) -> Vec<Event<'static, ModelState>> {
    let Some(height) = span.height else {
        return Vec::new();
    };
    let apex = Event::peak_of(APEX, height);
    let ground = Event::falls_to(GROUND, height, 0.0).terminal();
    let asked = [(span.seeks_apex, apex), (span.until_ground, ground)];
    asked
        .into_iter()
        .filter_map(|(is_asked, event)| is_asked.then_some(event))
        .collect()
}

/// Result of a flight that reached the ground or its final time.
fn landed<'a>(
    flight: u64,
    start: &[f64],
    end: &'a Endpoint<ModelState>,
    span: &FlightSpan,
) -> FlightEnd<'a> {
    let height = span.height.filter(|_| span.seeks_apex);
    let mut apex = (0.0, height.map_or(f64::NAN, |height| start[height]));
    if let Some(height) = height {
        let peaks = end.occurrences.iter().filter(|own| own.event == APEX);
        let peaks = peaks.map(|own| (own.time, own.state[height]));
        for (time, value) in peaks.chain([(end.time, end.state[height])]) {
            if value > apex.1 {
                apex = (time, value);
            }
        }
    }
    FlightEnd {
        flight,
        outcome: match end.event {
            Some(_) => FlightOutcome::Ground,
            None => FlightOutcome::Time,
        },
        time: end.time,
        state: &end.state,
        apex,
        stats: end.stats,
    }
}

/// Result of a flight whose integration failed, with its last state.
fn failed<'a>(
    flight: u64,
    state: &'a [f64],
    error: &IntegrationError,
    bound: &BoundModel<'_>,
) -> FlightEnd<'a> {
    FlightEnd {
        flight,
        outcome: match &error.cause {
            IntegrationFailure::Limit { reason } => FlightOutcome::Limit(bound.limit_index(reason)),
            IntegrationFailure::TooManySteps { .. } => FlightOutcome::TooManySteps,
            IntegrationFailure::StartsPastEvent { .. } => FlightOutcome::StartsBelowGround,
            IntegrationFailure::InvalidInput { .. } => FlightOutcome::NotFinite,
            _ => FlightOutcome::StepTooSmall,
        },
        time: error.time,
        state,
        apex: (f64::NAN, f64::NAN),
        stats: SolverStats::default(),
    }
}
