//! Values at the events of a flight with their derivatives: the time of an event moves with the initial state.

use dataset::SummaryEvent;
use flight::release::Release;
use flight::{ModelObserver, ModelState};
use ode::{AlignedVec, Event, Occurrence, OdeRhs, Sensitivities};

use super::FlightAt;
use super::jacobian_columns::JacobianColumns;
use super::observed_point::{ObservedPoint, Residuals, integration_options};
use crate::channel::{Channel, ChannelKind};
use crate::error::FlightError;
use crate::observations::Observations;
use crate::problem::FitProblem;
use crate::summary::{SummaryModel, event, vectors};
use crate::summary_value::{SummaryValue, Vectors, value};
use dataset::SummaryQuantity;

/// Motion at an event.
struct AtEvent {
    time: f64,
    vectors: Vectors,
    /// Derivatives of the components of the vectors, and of the time, with the event moving; empty without derivatives.
    rows: Vec<[Vec<f64>; 3]>,
    time_row: Vec<f64>,
}

/// Name of the event at a highest point.
const PEAK: &str = "apex";

/// Event at which the mass centre falls to the ground, and those at which it is highest.
fn events<'e, X: ode::StateVector>(summary: &SummaryModel) -> Vec<Event<'e, X>> {
    let height = summary.position[2];
    vec![
        Event::falls_to("landing", height, 0.0).terminal(),
        Event::peak_of(PEAK, height),
    ]
}

/// Time and state of an event among those that occurred; `None` for that of the release.
fn occurred(found: &[Occurrence], event: SummaryEvent, height: usize) -> Option<&Occurrence> {
    match event {
        SummaryEvent::Release => None,
        SummaryEvent::Landing => found.last(),
        SummaryEvent::Apex => {
            let peaks = found.iter().filter(|own| own.event == PEAK);
            peaks.max_by(|a, b| a.state[height].total_cmp(&b.state[height]))
        }
    }
}

/// The events at which a value of the flight is seen.
fn seen(problem: &FitProblem, observations: &Observations) -> Vec<SummaryEvent> {
    let all = [
        SummaryEvent::Release,
        SummaryEvent::Apex,
        SummaryEvent::Landing,
    ];
    let is_seen = |wanted: &SummaryEvent| {
        let mut channels = problem.channels.iter().enumerate();
        channels
            .any(|(k, own)| event(own.kind) == Some(*wanted) && observations.value(0, k).is_some())
    };
    all.into_iter().filter(is_seen).collect()
}

fn summary_of(problem: &FitProblem) -> Result<&SummaryModel, FlightError> {
    problem.summary.as_deref().ok_or(FlightError::NoMeasurement)
}

fn residual(own: &Channel, of: SummaryValue, at: &AtEvent, measured: f64) -> f64 {
    let predicted = match of {
        SummaryValue::Column(SummaryQuantity::HangTime) => at.time,
        of => value(of, &at.vectors).value,
    };
    (predicted / own.to_si - measured) * own.scale
}

/// Residuals of a flight from its initial state.
pub(crate) fn residuals(at: FlightAt<'_>) -> Result<Residuals, FlightError> {
    let (problem, observations, start) = (at.problem, at.observations, at.local.as_slice());
    let summary = summary_of(problem)?;
    let parameters = observations.parameters(problem, at.global);
    let bound = summary.bind(&parameters);
    let mut observers: Vec<(usize, ModelObserver<'_>)> =
        bound.iter().map(|(k, own)| (*k, own.observer())).collect();
    let wanted = seen(problem, observations);
    let mut found = Vec::new();
    if wanted.iter().any(|event| *event != SummaryEvent::Release) {
        let body = problem.body.bind(parameters.clone());
        let options = integration_options(observations.residual_tolerance(problem), 1);
        let state: ModelState = start.into();
        let mut events = events(summary);
        let (from, end) = ((0.0, &state), Release::MAX_DURATION);
        found = body
            .integrate_to_event(from, end, &options, &mut events)?
            .events;
    }
    let at = wanted.into_iter().map(|event| {
        let occurred = occurred(&found, event, summary.position[2]);
        let (time, state) = occurred.map_or((0.0, start), |own| (own.time, &own.state[..]));
        let at = AtEvent {
            time,
            vectors: vectors(&mut observers, time, state),
            rows: Vec::new(),
            time_row: Vec::new(),
        };
        (event, at)
    });
    let at: Vec<(SummaryEvent, AtEvent)> = at.collect();
    let mut residuals = vec![vec![None]; observations.channels];
    for (channel, own) in problem.channels.iter().enumerate() {
        let (ChannelKind::Summary(of), Some(measured)) = (own.kind, observations.value(0, channel))
        else {
            continue;
        };
        let mut all = at.iter().filter(|(at, _)| Some(*at) == event(own.kind));
        if let Some((_, at)) = all.next() {
            residuals[channel][0] = Some([residual(own, of, at, measured[0]); 3]);
        }
    }
    Ok(residuals)
}

/// Integrates a flight to its landing and calls `each` with every value and its derivatives.
pub(crate) fn each_point(
    (at, tolerance): (FlightAt<'_>, f64),
    variations: &mut Sensitivities<'_>,
    start: &AlignedVec,
    columns: &JacobianColumns<'_>,
    mut each: impl FnMut(ObservedPoint<'_>),
) -> Result<(), FlightError> {
    let (problem, observations) = (at.problem, at.observations);
    let summary = summary_of(problem)?;
    let bound = summary.bind(&observations.parameters(problem, at.global));
    let mut observers: Vec<(usize, ModelObserver<'_>)> =
        bound.iter().map(|(k, own)| (*k, own.observer())).collect();
    let wanted = seen(problem, observations);
    let mut found = Vec::new();
    if wanted.iter().any(|event| *event != SummaryEvent::Release) {
        let options = integration_options(tolerance, 1);
        let (from, end) = ((0.0, start), Release::MAX_DURATION);
        let mut events = events(summary);
        let path = variations.integrate_to_event(from, end, &options, &mut events)?;
        found = path.events;
    }
    let mut rows = columns.empty_rows();
    for wanted in wanted {
        let occurred = occurred(&found, wanted, summary.position[2]);
        let (time, state) = match occurred {
            Some(own) => (own.time, aligned(&own.state)),
            None => (0.0, start.clone()),
        };
        let kind = occurred.map_or(SummaryEvent::Release, |_| wanted);
        let at = at_event(variations, (time, &state), kind, &mut observers, columns);
        for (channel, own) in problem.channels.iter().enumerate() {
            let measured = observations.value(0, channel);
            let (ChannelKind::Summary(of), Some(measured)) = (own.kind, measured) else {
                continue;
            };
            if event(own.kind) != Some(wanted) {
                continue;
            }
            let residual = residual(own, of, &at, measured[0]);
            derive(of, &at, own.scale / own.to_si, &mut rows);
            each(ObservedPoint {
                channel,
                sample: 0,
                time: 0.0,
                residual: [residual; 3],
                rows: &mut rows,
            });
        }
    }
    Ok(())
}

fn aligned(values: &[f64]) -> AlignedVec {
    let mut aligned = AlignedVec::zeros(values.len());
    aligned.as_mut().copy_from_slice(values);
    aligned
}

/// Motion at an event, with derivatives along the moving event.
fn at_event(
    variations: &mut Sensitivities<'_>,
    (time, both): (f64, &AlignedVec),
    event: SummaryEvent,
    observers: &mut [(usize, ModelObserver<'_>)],
    columns: &JacobianColumns<'_>,
) -> AtEvent {
    let layout = variations.layout();
    let mut rates = both.clone();
    variations.derivative(time, both, &mut rates);
    let (state, rates) = (layout.state(both.as_ref()), layout.state(rates.as_ref()));
    let mut at = AtEvent {
        time,
        vectors: Vectors::default(),
        rows: vec![columns.empty_rows(); Vectors::default().len()],
        time_row: Vec::new(),
    };
    let mut slopes = Vectors::default();
    for (k, observer) in observers {
        let (vector, by) = observer.position_with_jacobians(time, state, &[0.0; 3]);
        at.vectors[*k] = vector;
        columns.derive(&by, (layout, both.as_ref()), &mut at.rows[*k]);
        for (&(axis, state), value) in by.by_state_pattern.iter().zip(by.by_state) {
            slopes[*k][axis] += value * rates[state];
        }
    }
    // The event is where the height, or the vertical velocity, is zero.
    let of_event = match event {
        SummaryEvent::Release => None,
        SummaryEvent::Apex => Some(1),
        SummaryEvent::Landing => Some(0),
    };
    at.time_row = match of_event {
        None => vec![0.0; at.rows[0][0].len()],
        Some(k) => {
            let row = at.rows[k][2].iter();
            row.map(|by| -by / slopes[k][2]).collect()
        }
    };
    for (rows, slopes) in at.rows.iter_mut().zip(slopes) {
        for (row, slope) in rows.iter_mut().zip(slopes) {
            for (by, moved) in row.iter_mut().zip(&at.time_row) {
                *by += slope * moved;
            }
        }
    }
    at
}

/// Writes the derivatives of a value times `scale` to all three of `rows`.
fn derive(of: SummaryValue, at: &AtEvent, scale: f64, rows: &mut [Vec<f64>; 3]) {
    let [first, second, third] = rows;
    first.fill(0.0);
    if of == SummaryValue::Column(SummaryQuantity::HangTime) {
        for (to, by) in first.iter_mut().zip(&at.time_row) {
            *to = scale * by;
        }
    } else {
        let by = value(of, &at.vectors).by;
        let all = at.rows.iter().flatten();
        for (row, weight) in all.zip(&by).filter(|(_, weight)| **weight != 0.0) {
            for (to, from) in first.iter_mut().zip(row) {
                *to += scale * weight * from;
            }
        }
    }
    second.copy_from_slice(first);
    third.copy_from_slice(first);
}
