//! Samples of a flight for the viewer: position, attitude, markers and further quantities at each time.

use flight::{BoundModel, CompiledModel, FlightParameters};
use identify::FlightEvidence;
use model_spec::model::{Model, Shape};
use ode::Trajectory;
use serde::Serialize;

use crate::angle::is_angle;
use crate::figures::symbol;
use crate::thin::stride;
use identify::numbers::unit;

const MAX_NUMBERS: usize = 10;
const MAX_MARKERS: usize = 12;
/// Units of the quantities over time, in this order after the angles.
const UNITS: [&str; 2] = ["m/s", "rad/s"];

#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(super) struct Flight {
    pub(super) name: String,
    /// Such as whether the flight was fitted.
    pub(super) note: String,
    times: Vec<f64>,
    /// Of the origin of the body frame.
    position: Vec<[f64; 3]>,
    /// Rotation matrix, row by row, from the body frame to the inertial frame; `None` for a point mass.
    attitude: Option<Vec<[f64; 9]>>,
    /// `measured[i][marker]` at `times[i]`; `None` if missing.
    measured: Vec<Vec<Option<[f64; 3]>>>,
    /// `predicted[i][marker]` at `times[i]`.
    predicted: Vec<Vec<[f64; 3]>>,
    /// Times at which all markers are measured, and the mean of their positions.
    trail_times: Vec<f64>,
    trail: Vec<[f64; 3]>,
    arrows: Vec<Arrow>,
    numbers: Vec<Number>,
}

/// Constant vector input, such as the wind.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Arrow {
    name: String,
    value: [f64; 3],
    unit: String,
}

/// Quantity over time; `None` where it is not finite.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Number {
    name: String,
    unit: String,
    values: Vec<Option<f64>>,
}

/// A model with the parameter values of one flight.
pub(super) struct FlightModel<'m> {
    pub(super) model: &'m Model,
    pub(super) body: &'m CompiledModel,
    pub(super) parameters: FlightParameters,
}

impl FlightModel<'_> {
    /// A flight from pairs of time and state; `add` is called with the index of each that has a finite position.
    fn flight(
        &self,
        name: &str,
        samples: &[(f64, &[f64])],
        mut add: impl FnMut(&mut Flight, usize),
    ) -> Flight {
        let bound = self.body.bind(self.parameters.clone());
        let has_attitude = self.model.marker.as_ref().is_some_and(|m| m.frame != 0);
        let mut flight = Flight {
            name: name.to_owned(),
            attitude: has_attitude.then(Vec::new),
            arrows: self.arrows(),
            ..Flight::default()
        };
        let mut states = Vec::new();
        for (i, &(t, state)) in samples.iter().enumerate() {
            let Some((position, attitude)) = self.pose(&bound, t, state) else {
                continue;
            };
            flight.times.push(rounded(t));
            flight.position.push(position.map(rounded));
            if let Some(all) = &mut flight.attitude {
                all.push(attitude.map(rounded));
            }
            states.push((t, state));
            add(&mut flight, i);
        }
        flight.numbers = self.numbers(&bound, &flight.position, &states);
        flight
    }

    /// Position of the origin of the body frame and rotation matrix, 0 without a measurement equation.
    fn pose(&self, bound: &BoundModel<'_>, t: f64, state: &[f64]) -> Option<([f64; 3], [f64; 9])> {
        if self.model.observation.is_none() {
            let layout = self.body.layout();
            let value = |name: &str| Some(*state.get(layout.state(name)?.index())?);
            let origin = [value("x")?, value("y")?, value("z")?];
            let is_finite = origin.iter().all(|v| v.is_finite());
            return is_finite.then_some((origin, [0.0; 9]));
        }
        let mut observer = bound.observer();
        let origin = observer.position(t, state, &[0.0; 3]);
        let mut attitude = [0.0; 9];
        for axis in 0..3 {
            let mut point = [0.0; 3];
            point[axis] = 1.0;
            let end = observer.position(t, state, &point);
            for row in 0..3 {
                attitude[3 * row + axis] = end[row] - origin[row];
            }
        }
        let mut all = origin.iter().chain(&attitude);
        all.all(|v| v.is_finite()).then_some((origin, attitude))
    }

    /// Constant vector inputs in the inertial frame that are not zero.
    fn arrows(&self) -> Vec<Arrow> {
        let layout = self.body.layout();
        let given = self.model.inputs.iter().filter(|input| input.frame == 0);
        let arrows = given.filter_map(|input| {
            let component = |axis: &str| {
                let name = format!("{}_{axis}", input.name);
                let at = layout.parameters.iter().position(|p| *p == name)?;
                self.parameters
                    .constants
                    .get(at)
                    .copied()
                    .filter(|v| v.is_finite())
            };
            Some(Arrow {
                name: input.name.clone(),
                value: [component("x")?, component("y")?, component("z")?],
                unit: input.unit_text.clone(),
            })
        });
        arrows
            .filter(|a| a.value.iter().any(|v| *v != 0.0))
            .collect()
    }

    /// Height, horizontal distance from the first sample, and the model's angles, speeds and angular rates.
    fn numbers(
        &self,
        bound: &BoundModel<'_>,
        position: &[[f64; 3]],
        states: &[(f64, &[f64])],
    ) -> Vec<Number> {
        let first = position.first().copied().unwrap_or_default();
        let number = |name: &str, of: &dyn Fn(&[f64; 3]) -> f64| Number {
            name: name.to_owned(),
            unit: "m".to_owned(),
            values: position.iter().map(|p| Some(rounded(of(p)))).collect(),
        };
        let mut numbers = vec![
            number("height z", &|p| p[2]),
            number("distance", &|p| (p[0] - first[0]).hypot(p[1] - first[1])),
        ];
        let layout = self.body.layout();
        let scalars = self.model.aux_variables.iter().filter_map(|variable| {
            let at = layout.quantities.iter().position(|q| *q == variable.name)?;
            let is_scalar = variable.value.shape == Shape::Scalar;
            let of = variable.value.unit.to_string();
            let rank = if is_angle(&variable.value) {
                0
            } else {
                1 + UNITS.iter().position(|known| *known == of)?
            };
            is_scalar.then_some((rank, at, variable, of))
        });
        let mut scalars: Vec<_> = scalars.collect();
        scalars.sort_by_key(|(rank, ..)| *rank);
        scalars.truncate(MAX_NUMBERS - numbers.len());
        let mut observer = bound.observer();
        let rows: Vec<Vec<f64>> = states
            .iter()
            .map(|(t, x)| observer.quantities(*t, x))
            .collect();
        numbers.extend(scalars.into_iter().map(|(_, at, variable, of)| {
            let (scale, of) = if is_angle(&variable.value) {
                (1f64.to_degrees(), "°".to_owned())
            } else {
                (1.0, unit(&of))
            };
            let name = match variable.doc.split([',', ':']).next() {
                None | Some("") => symbol(&variable.name),
                Some(doc) => format!("{doc} {}", symbol(&variable.name)),
            };
            let value = |row: &Vec<f64>| Some(rounded(row[at] * scale)).filter(|v| v.is_finite());
            Number {
                name,
                unit: of,
                values: rows.iter().map(value).collect(),
            }
        }));
        numbers
    }
}

/// Rounds to five decimals, or to six significant digits below 0.1.
fn rounded(value: f64) -> f64 {
    match value.abs() {
        size if size >= 0.1 => (value * 1e5).round() / 1e5,
        _ => format!("{value:.5e}").parse().unwrap_or(value),
    }
}

/// A simulated flight, with about `most` samples.
pub(super) fn flown(
    flight_model: &FlightModel<'_>,
    name: &str,
    flown: &Trajectory,
    most: usize,
) -> Flight {
    let length = flown.end - flown.start;
    let rate = (most.saturating_sub(2).max(1)) as f64 / length.max(f64::MIN_POSITIVE);
    let samples: Vec<(f64, Vec<f64>)> = flown.at_rate(rate).map(|(t, x)| (t, x.clone())).collect();
    let samples: Vec<(f64, &[f64])> = samples.iter().map(|(t, x)| (*t, x.as_slice())).collect();
    flight_model.flight(name, &samples, |flight, _| {
        flight.measured.push(Vec::new());
        flight.predicted.push(Vec::new());
    })
}

/// A measured flight and its prediction, with at most `most` samples.
pub(super) fn recorded(
    flight_model: &FlightModel<'_>,
    evidence: &FlightEvidence,
    most: usize,
) -> Flight {
    let (measured, predicted) = (&evidence.measured, &evidence.predicted);
    let lengths = [evidence.states.len(), measured.len(), predicted.len()];
    let length = lengths.into_iter().fold(evidence.times.len(), usize::min);
    let chosen = stride(&(0..length).collect::<Vec<_>>(), most);
    let at = |i: &usize| (evidence.times[*i], evidence.states[*i].as_slice());
    let samples: Vec<(f64, &[f64])> = chosen.iter().map(at).collect();
    flight_model.flight(&evidence.file, &samples, |flight, at| {
        let i = chosen[at];
        let measured = measured[i].iter().take(MAX_MARKERS);
        let measured: Vec<Option<[f64; 3]>> = measured.map(|p| p.map(|p| p.map(rounded))).collect();
        let all: Option<Vec<[f64; 3]>> = measured.iter().copied().collect();
        if let Some(all) = all.filter(|all| !all.is_empty()) {
            let mean = |axis: usize| all.iter().map(|p| p[axis]).sum::<f64>() / all.len() as f64;
            flight.trail_times.push(rounded(evidence.times[i]));
            flight.trail.push([0, 1, 2].map(|axis| rounded(mean(axis))));
        }
        flight.measured.push(measured);
        let predicted = predicted[i].iter().take(MAX_MARKERS);
        let predicted = predicted.map(|p| p.map(rounded));
        flight.predicted.push(predicted.collect());
    })
}
