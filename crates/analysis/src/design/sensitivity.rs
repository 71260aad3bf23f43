//! Effect of each quantity of a throw on the position and time of the landing.

use flight::throw::{FIELDS, Throw};
use nalgebra::Vector3;
use ode::IntegrationOptions;

use crate::design::goal::Goal;
use crate::design::throw_flight::{By, ThrowFlightError, ThrowFlights};

/// Influence of one quantity of a throw on the landing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// Index of the quantity in [`FIELDS`].
    pub field: usize,
    /// Derivative of the landing position, m per unit of the quantity.
    pub landing: Vector3<f64>,
    /// Derivative of the duration of the flight, s per unit of the quantity.
    pub time: f64,
    /// Derivative of [`Design::figure`](crate::design::Design::figure) per unit; `None` for a distance or a spread.
    pub figure: Option<f64>,
    /// What one unit less and one unit more change, each from a separate flight; `None` if it cannot be flown.
    pub one_unit: [Option<OneUnit>; 2],
}

/// Change of a flight if one quantity of the throw changes by its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneUnit {
    /// Change of the landing position, m.
    pub landing: Vector3<f64>,
    /// Change of the duration, s.
    pub time: f64,
    /// Smallest distance of the changed path from the target, m; 0 without a target.
    pub miss: f64,
}

/// Influence of each quantity that the throw and the body have on the landing, in the order of [`FIELDS`].
///
/// # Errors
/// [`ThrowFlightError`] if the throw cannot be flown.
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
            Some(OneUnit {
                landing: there.position - landing.position,
                time: there.time - landing.time,
                miss: goal.miss(&path),
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
