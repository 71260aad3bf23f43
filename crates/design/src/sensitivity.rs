//! What each number of a throw does to where and when it lands.

use flight::throw::{FIELDS, Throw};
use nalgebra::Vector3;
use ode::IntegrationOptions;

use crate::goal::Goal;
use crate::throw_flight::{By, ThrowFlightError, ThrowFlights};

/// Effect of one number of a throw.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// Index of the number in [`FIELDS`].
    pub field: usize,
    /// Derivative of the place of the landing, m per unit of the number.
    pub landing: Vector3<f64>,
    /// Derivative of the duration of the flight, s per unit.
    pub time: f64,
    /// Derivative of the goal's own figure, per unit; `None` for a goal whose figure is a distance from its target or a spread.
    pub figure: Option<f64>,
    /// What one unit less and one unit more do, each flown; `None` where that throw has no flight.
    pub one_unit: [Option<OneUnit>; 2],
}

/// Effect of one unit of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneUnit {
    /// How far the landing moves, m.
    pub landing: Vector3<f64>,
    /// By how much the flight is longer, s.
    pub time: f64,
    /// Distance of the path from the goal's point, m; 0 for a goal without a point.
    pub miss: f64,
}

/// Sensitivities of a throw, by every number that the body can have; the wobble where the throw has one.
///
/// # Errors
/// [`ThrowFlightError`] where the throw has no flight.
pub fn sensitivities(
    flights: &ThrowFlights<'_>,
    throw: &Throw,
    goal: Goal,
    options: &IntegrationOptions,
) -> Result<Vec<Sensitivity>, ThrowFlightError> {
    let mut fields = flights.body.fields();
    fields.retain(|field| throw.field(FIELDS[*field].0).is_some());
    let by: Vec<By> = fields.iter().map(|field| By::Throw(*field)).collect();
    let path = flights.fly_with_derivatives(throw, None, &by, options)?;
    let landing = path.landing();
    let values = goal.values(&path, None);
    let sign = match goal {
        Goal::Range | Goal::HangTime => Some(-1.0),
        Goal::Flare(_) => Some(1.0),
        Goal::Hit(_) | Goal::Curve(_) | Goal::Spread(_) => None,
    };
    let all = fields.iter().enumerate().map(|(k, field)| {
        let name = FIELDS[*field].0;
        let one_unit = [-1.0, 1.0].map(|step| {
            let mut moved = *throw;
            moved.set(name, throw.field(name)? + step);
            let path = flights.fly(&moved, None, options).ok()?;
            let there = path.landing();
            let miss = goal.target().map_or(0.0, |target| {
                let away = path.position(goal.time(&path)) - target;
                if target.z > 0.0 {
                    away.norm()
                } else {
                    away.xy().norm()
                }
            });
            Some(OneUnit {
                landing: there.position - landing.position,
                time: there.time - landing.time,
                miss,
            })
        });
        Sensitivity {
            field: *field,
            landing: landing.position_by[k],
            time: landing.time_by[k],
            figure: sign.map(|sign| sign * values.gradient[k]),
            one_unit,
        }
    });
    Ok(all.collect())
}
