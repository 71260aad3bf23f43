//! Integrates the flights of one part of a sweep and collects the results in one column per quantity.

use flight::{LaneModel, LaneObserver};
use ode::{FlightEnd, FlightOutcome, FlightQueue, FlightSpan};

use crate::sweep::inputs::{InputModel, Inputs};
use crate::sweep::plan::{Plan, Target};

/// Values of the column `status`: how a flight ended.
pub const STATUSES: [&str; 8] = [
    "landed",
    "time",
    "limit",
    "too-many-steps",
    "failed",
    "starts-below-ground",
    "not-finite",
    "refused",
];

/// Index in [`STATUSES`] of a flight that was not integrated.
const REFUSED: u8 = 7;

fn status(outcome: FlightOutcome) -> u8 {
    match outcome {
        FlightOutcome::Ground => 0,
        FlightOutcome::Time => 1,
        FlightOutcome::Limit(_) => 2,
        FlightOutcome::TooManySteps => 3,
        FlightOutcome::StepTooSmall => 4,
        FlightOutcome::StartsBelowGround => 5,
        FlightOutcome::NotFinite => 6,
    }
}

/// Column of the table of flights: an input or a result.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name of the column.
    pub name: String,
    /// Whether it is an input.
    pub is_input: bool,
    /// Value of each flight; NaN if it has none.
    pub values: Vec<f64>,
}

/// Table of consecutive flights: one part of a sweep.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// Number of the first flight.
    pub first: u64,
    /// Columns: the inputs that vary, then the results.
    pub columns: Vec<Column>,
    /// Index in [`STATUSES`] of how each flight ended.
    pub status: Vec<u8>,
}

pub(crate) struct Flier<'p> {
    pub plan: &'p Plan,
    pub inputs: &'p InputModel,
    pub model: &'p LaneModel,
    pub observer: Option<&'p LaneObserver>,
    pub span: FlightSpan,
    /// Indices of the states x, y and z; `None` for one that the model does not have.
    pub position: [Option<usize>; 3],
    pub has_spin: bool,
}

/// Supplies the flights of one part to the integrator, and collects their results.
struct Part<'p> {
    inputs: Inputs<'p>,
    first: u64,
    next: u64,
    last: u64,
    values: Vec<f64>,
    /// Drawn values: one vector per varied quantity, with one value per flight.
    axes: Vec<Vec<f64>>,
    /// State at the end: one vector per state variable, with one value per flight.
    states: Vec<Vec<f64>>,
    start: [Vec<f64>; 2],
    time: Vec<f64>,
    apex_time: Vec<f64>,
    apex: Vec<f64>,
    steps: Vec<f64>,
    status: Vec<u8>,
    position: [Option<usize>; 3],
}

impl FlightQueue for Part<'_> {
    fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64> {
        while self.next < self.last {
            let flight = self.next;
            let row = (flight - self.first) as usize;
            self.next += 1;
            self.inputs.draw(flight, &mut self.values);
            for (axis, value) in self.axes.iter_mut().zip(&self.values) {
                axis[row] = *value;
            }
            if self.inputs.start(flight, &self.values, x, p) {
                for (start, state) in self.start.iter_mut().zip(&self.position) {
                    start[row] = state.map_or(0.0, |state| x[state]);
                }
                return Some(flight);
            }
            self.status[row] = REFUSED;
        }
        None
    }

    fn end(&mut self, end: FlightEnd<'_>) {
        let row = (end.flight - self.first) as usize;
        for (column, value) in self.states.iter_mut().zip(end.state) {
            column[row] = *value;
        }
        self.time[row] = end.time;
        (self.apex_time[row], self.apex[row]) = end.apex;
        self.steps[row] = (end.stats.steps + end.stats.rejected) as f64;
        self.status[row] = status(end.outcome);
    }
}

impl Flier<'_> {
    pub(crate) fn fly(&self, part: u64) -> Rows {
        let plan = self.plan;
        let first = part * plan.part_len();
        let last = (first + plan.part_len()).min(plan.flights);
        let len = (last - first) as usize;
        let missing = || vec![f64::NAN; len];
        let mut flown = Part {
            inputs: Inputs::new(plan, self.inputs),
            first,
            next: first,
            last,
            values: vec![0.0; plan.axes.len()],
            axes: plan.axes.iter().map(|_| missing()).collect(),
            states: plan.model.states.iter().map(|_| missing()).collect(),
            start: [missing(), missing()],
            time: missing(),
            apex_time: missing(),
            apex: missing(),
            steps: missing(),
            status: vec![REFUSED; len],
            position: self.position,
        };
        self.model.fly(&mut flown, &self.span, &plan.options, None);
        let mut columns = Vec::new();
        let mut add = |name: &str, is_input, values| {
            columns.push(Column {
                name: name.to_owned(),
                is_input,
                values,
            });
        };
        let motion = self.observer.map(|observer| {
            let varied = plan.axes.iter().zip(&flown.axes);
            let varied = varied.filter_map(|(axis, values)| match axis.target {
                Target::Parameter(index) => Some((index, values.as_slice())),
                _ => None,
            });
            let varied: Vec<(usize, &[f64])> = varied.collect();
            observer.observe(&flown.states, self.inputs.parameters(), &varied)
        });
        for (axis, values) in plan.axes.iter().zip(flown.axes) {
            add(&axis.name, true, values);
        }
        add("landing_t", false, flown.time);
        for (name, state) in ["landing_x", "landing_y", "landing_z"]
            .into_iter()
            .zip(self.position)
        {
            if let Some(state) = state {
                add(name, false, flown.states[state].clone());
            }
        }
        if self.span.height.is_some() {
            add("apex_t", false, flown.apex_time);
            add("apex_z", false, flown.apex);
        }
        if let [Some(x), Some(y), _] = self.position {
            let (states, start) = (&flown.states, &flown.start);
            let range = (0..len).map(|k| {
                let (dx, dy) = (states[x][k] - start[0][k], states[y][k] - start[1][k]);
                (dx * dx + dy * dy).sqrt()
            });
            add("range", false, range.collect());
        }
        if let Some([speed, spin, _]) = motion {
            add("final_speed", false, speed);
            if self.has_spin {
                add("final_spin", false, spin);
            }
        }
        add("steps", false, flown.steps);
        Rows {
            first,
            columns,
            status: flown.status,
        }
    }
}
