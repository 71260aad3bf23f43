//! Verdicts about each simulator: as published, and after each change.

use model_spec::load::inspect_text;
use model_spec::model::{Expr, Model};
use nalgebra::Vector3;
use oracle::scalar::{Dual, ErrorBound, Field};
use oracle::{BalanceLaw, ClaimedBody, Point, Tree, Value, claimed_rates, derivatives, moving};
use serde::Serialize;
use verify::checks::claim::CLAIM;
use verify::report::Verdict;

use super::flight::{fly, position};
use super::simulator::{SIMULATORS, Simulator};
use crate::error::StudyError;

/// Options of the verification of a simulator's equations. A few random test points suffice, because a violated law is
/// violated at nearly every point.
const OPTIONS: verify::Options = verify::Options {
    seed: 1,
    cases: 24,
    mutants: false,
    effects: false,
};

/// Results of the verification of one published simulator's equations of motion.
#[derive(Clone, Debug)]
pub struct Verdicts {
    /// Published simulator whose equations were verified.
    pub simulator: Simulator,
    /// Comparison of the two sides of each balance law along the flight that is simulated with the published equations.
    pub laws: Vec<LawInFlight>,
    /// Published rates and the rates implied by the laws of motion, along the flight, for the states where they differ.
    /// Empty if no rates satisfy all laws.
    pub rates: Vec<RateInFlight>,
    /// Results for the published equations, then after each correction of them. The corrections are cumulative.
    pub stages: Vec<Stage>,
}

/// One balance law, with the maximum magnitudes, along a flight, of its right-hand side and of the difference between
/// its two sides.
#[derive(Clone, Copy, Debug)]
pub struct LawInFlight {
    /// Balance law whose left-hand and right-hand sides are compared, such as d(momentum)/dt = force.
    pub law: BalanceLaw,
    /// Maximum magnitude of the law's right-hand side (such as the force) along the flight, SI.
    pub cause: f64,
    /// Maximum magnitude of the difference between the left-hand and the right-hand side of the law along the flight,
    /// SI.
    pub difference: f64,
}

/// Rate of change of one state along a flight: as given by the simulator's equations, and as implied by the laws of
/// motion.
#[derive(Clone, Debug, Serialize)]
pub struct RateInFlight {
    /// Name of the state whose rates are compared.
    pub state: String,
    /// Unit of the state; the rates are in this unit per second.
    pub unit: String,
    /// Maximum magnitude, along the flight, of the state's rate of change as given by the simulator's equations, in the
    /// state's unit per second.
    pub stated: f64,
    /// Maximum magnitude, along the flight, of the state's rate of change as implied by the laws of motion, in the
    /// state's unit per second.
    pub implied: f64,
    /// Maximum magnitude, along the flight, of the difference between the rate according to the simulator's equations
    /// and the rate implied by the laws of motion, in the state's unit per second.
    pub difference: f64,
}

/// A simulator's equations as published or after a correction, with the result of their verification and of a simulated
/// flight.
#[derive(Clone, Debug)]
pub struct Stage {
    /// Description of the correction that was applied last; `None` for the published equations.
    pub change: Option<&'static str>,
    /// Violations of balance laws that `hyzer verify` reports for the body that the model describes, one line each;
    /// empty if the equations obey every law.
    pub broken: Vec<String>,
    /// Whether none of the checks of `hyzer verify` refutes the equations of this stage (as published or corrected).
    pub holds: bool,
    /// States whose rates of change in these equations differ from those before the last correction, along the flight
    /// simulated before that correction. For each: name, maximum magnitude of the earlier rate, maximum magnitude of
    /// the difference (in the state's unit per second). Empty for the published equations.
    pub moved: Vec<(String, f64, f64)>,
    /// Position of the body at the end of the simulated flight, m.
    pub end: Vector3<f64>,
}

/// Verifies the equations of every simulator in [`SIMULATORS`] and simulates a flight with them.
///
/// # Errors
/// [`StudyError`] if a model or a corrected version of it does not load, or if the simulation of its flight fails.
pub fn others() -> Result<Vec<Verdicts>, StudyError> {
    SIMULATORS.iter().map(judge).collect()
}

/// Verifies the equations of one simulator, as published and after each correction, and simulates a flight with each
/// version.
///
/// # Errors
/// [`StudyError`] if the model or a corrected version of it does not load, or if the simulation of its flight fails.
pub fn judge(simulator: &Simulator) -> Result<Verdicts, StudyError> {
    let absent = |name: &str| StudyError::Name {
        of: simulator.model,
        name: name.to_owned(),
    };
    let published = model_spec::load::load(simulator.model, &[])?;
    let mut text = published.sources[0].text.clone();
    let start = Point::defaults(&published);
    let mut before = (
        published.clone(),
        fly(&published, &start).ok_or_else(|| absent("flight"))?,
    );
    let (laws, rates) = (laws(&published, &before.1), rates(&published, &before.1));
    let mut stages = vec![stage(&text, None, &before, Vec::new())?];
    for change in simulator.changes {
        for (from, to) in change.edits {
            if !text.contains(from) {
                return Err(absent(from));
            }
            text = text.replace(from, to);
        }
        let model = model_spec::load::from_text(simulator.model, &text, &[])?;
        let mut start = Point::defaults(&model);
        for (state, vector, component) in change.starts {
            let place = model.states.iter().position(|s| s.name == *state);
            let value = started(&before.0, &before.1[0], vector, *component);
            match (place, value) {
                (Some(place), Some(value)) => start.states[place] = value,
                _ => return Err(absent(state)),
            }
        }
        let flight = fly(&model, &start).ok_or_else(|| absent("flight"))?;
        let moved = moved(&before.0, &before.1, &model);
        before = (model, flight);
        stages.push(stage(&text, Some(change.description), &before, moved)?);
    }
    Ok(Verdicts {
        simulator: *simulator,
        laws,
        rates,
        stages,
    })
}

/// Value of one component (index from 0) of the vector-valued auxiliary variable `name`, in the reference frame in
/// which the model defines this vector, at the time, states and parameters in `point`. `None` if the model has no
/// vector of that name.
fn started(model: &Model, point: &Point<f64>, name: &str, component: usize) -> Option<f64> {
    let tree = Tree::new(model, point);
    let index = { model.aux_variables.iter() }.position(|v| v.name == name)?;
    let model_spec::model::Shape::Vector(frame) = model.aux_variables[index].value.shape else {
        return None;
    };
    let Value::Vector(vector) = tree.aux_variables[index] else {
        return None;
    };
    Some((tree.frames[frame].axes.transpose() * vector)[component])
}

fn stage(
    text: &str,
    change: Option<&'static str>,
    (model, flight): &(Model, Vec<Point<f64>>),
    moved: Vec<(String, f64, f64)>,
) -> Result<Stage, StudyError> {
    let loaded = inspect_text(&model.name, text, &[])?;
    let report = verify::run(&loaded, &OPTIONS);
    let claimed = report.rows.iter().find(|row| row.check == CLAIM);
    let refuted = claimed.filter(|row| row.verdict == Verdict::Refuted);
    let end = flight.last().and_then(|point| position(model, point));
    Ok(Stage {
        change,
        broken: refuted.map_or_else(Vec::new, |row| {
            row.detail.lines().map(str::to_owned).collect()
        }),
        holds: report.holds(),
        moved,
        end: end.ok_or_else(|| StudyError::Name {
            of: "simulator",
            name: String::from("claim"),
        })?,
    })
}

/// For each balance law of the body that the model describes, the maximum magnitudes, over the points of a flight, of
/// the law's right-hand side and of the difference between its two sides.
fn laws(model: &Model, flight: &[Point<f64>]) -> Vec<LawInFlight> {
    let mut out: Vec<LawInFlight> = Vec::new();
    for point in flight {
        let rates = derivatives(model, point).unwrap_or_default();
        let along = moving(point, &rates, 1.0);
        let tree = Tree::<Dual<f64>>::new(model, &along);
        let balances = ClaimedBody::of(&tree).map_or_else(Vec::new, |body| body.balances());
        for balance in balances {
            let (cause, difference) = (
                balance.cause.norm(),
                (balance.change - balance.cause).norm(),
            );
            match out.iter_mut().find(|l| l.law == balance.law) {
                Some(law) => {
                    law.cause = law.cause.max(cause);
                    law.difference = law.difference.max(difference);
                }
                None => out.push(LawInFlight {
                    law: balance.law,
                    cause,
                    difference,
                }),
            }
        }
    }
    out
}

/// Compares, for each state, the rate according to the model's equations with the rate implied by the laws of motion.
/// Returns the maximum magnitudes of the two rates and of their difference over the points of a flight, for the states
/// whose two rates differ. Empty if no rates satisfy all laws.
fn rates(model: &Model, flight: &[Point<f64>]) -> Vec<RateInFlight> {
    let mut out: Vec<RateInFlight> = model
        .states
        .iter()
        .map(|state| RateInFlight {
            state: state.name.clone(),
            unit: state.unit_text.clone(),
            stated: 0.0,
            implied: 0.0,
            difference: 0.0,
        })
        .collect();
    for point in flight {
        let stated = derivatives(model, point).unwrap_or_default();
        let implied = claimed_rates(model, &point.lift::<ErrorBound>(), ErrorBound::integer(1));
        let Some(implied) = implied.filter(|i| i.unsatisfied.is_empty()) else {
            return Vec::new();
        };
        for ((row, stated), implied) in out.iter_mut().zip(stated).zip(implied.rates) {
            let implied = implied.map_or(stated, |rate| rate.value);
            row.stated = row.stated.max(stated.abs());
            row.implied = row.implied.max(implied.abs());
            row.difference = row.difference.max((stated - implied).abs());
        }
    }
    out.retain(|row| row.difference > 1e-9 * (row.stated + row.implied));
    out
}

/// States whose rates according to the models `before` and `after` differ at the points of a flight of `before`. For
/// each: name, maximum magnitude of the rate in `before`, maximum magnitude of the difference (in the state's unit per
/// second). Empty if the models have different numbers of states.
fn moved(before: &Model, flight: &[Point<f64>], after: &Model) -> Vec<(String, f64, f64)> {
    let stated = |model: &Model, name: &str| -> Option<Expr> {
        let state = model.states.iter().position(|s| s.name == name)?;
        let equation = model.equations.iter().find(|e| e.state == state)?;
        Some(equation.value.clone())
    };
    let mut out = Vec::new();
    if before.states.len() != after.states.len() {
        return out;
    }
    for (index, state) in before.states.iter().enumerate() {
        let (mut size, mut difference) = (0.0_f64, 0.0_f64);
        for point in flight {
            let rate = |model: &Model| {
                let tree = Tree::new(model, point);
                stated(model, &state.name).map_or(0.0, |e| tree.scalar(&e))
            };
            let (one, other) = (rate(before), rate(after));
            size = size.max(one.abs());
            difference = difference.max((one - other).abs());
        }
        if difference > 1e-12 * size.max(1e-12) {
            out.push((before.states[index].name.clone(), size, difference));
        }
    }
    out
}
