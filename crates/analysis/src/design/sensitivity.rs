//! Effect of each quantity of a throw on the position and time of the landing.

use flight::throw::{FIELDS, Throw};
use nalgebra::Vector3;
use ode::IntegrationOptions;

use crate::design::goal::Goal;
use crate::design::throw_flight::{By, ThrowFlightError, ThrowFlights};

/// Influence of one quantity of a throw, such as the speed, on the position and time of the landing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// Index of the quantity of the throw in [`FIELDS`], the list of these quantities.
    pub field: usize,
    /// Derivative of the landing position, m per unit of the quantity.
    pub landing: Vector3<f64>,
    /// Derivative of the duration of the flight, s per unit of the quantity.
    pub time: f64,
    /// Derivative of the value by which the goal is judged (see [`Goal::figure`]), per unit of the quantity; `None` for
    /// a goal judged by a distance from its target or by a spread.
    pub figure: Option<f64>,
    /// Changes of the flight if the quantity decreases and if it increases by one unit, each from a separate flight;
    /// `None` if the throw with the changed quantity cannot be flown.
    pub one_unit: [Option<OneUnit>; 2],
}

/// Change of the flight of a throw if one quantity of the throw changes by one unit: the unit that [`FIELDS`] states
/// for the quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneUnit {
    /// Change of the landing position that the change of the quantity causes, m.
    pub landing: Vector3<f64>,
    /// Increase of the duration of the flight that the change of the quantity causes, s; negative for a shorter flight.
    pub time: f64,
    /// Minimum distance between the path of the throw with the changed quantity and the goal's target point, m; 0 for a
    /// goal without a point.
    pub miss: f64,
}

/// Computes the influence of the quantities of a throw on its landing, in the order of [`FIELDS`]. Quantities without a
/// value in the throw, or that the body cannot have (such as the spin of a point mass), are omitted.
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
