//! Estimates the lift of each flight from its trajectory alone, for comparison with the stated spin.

use dataset::{Dataset, Flight, KnownValue, Role};
use identify::{Fit, FitOptions, FitReport, FlightEvidence, fit};
use model_spec::model::Model;
use nalgebra::Vector3;

use super::models::{LIFT_OF_EACH_FLIGHT, with_effects};
use crate::error::StudyError;

/// Lift of one ball flight, estimated from its path, and the spin specified in the data.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Lift {
    /// File name of the ball's flight in the dataset.
    pub(super) file: String,
    /// Mean speed of the ball over the flight, m/s.
    pub(super) speed: f64,
    /// Unit vector from the first to the last measured position.
    pub(super) direction: Vector3<f64>,
    /// Lift coefficient as a vector C along the axis about which the lift rotates the velocity v: the lift points along
    /// C × v. Dimensionless, in the axes of the measured positions; the y component is 0.
    pub(super) turn: Vector3<f64>,
    /// Spin vector ω that the data state, made dimensionless: ball radius × ω / speed. In the axes of the measured
    /// positions.
    pub(super) spin: Vector3<f64>,
    /// RMS residual of the fitted path along y, the direction of flight, m.
    pub(super) residual_along: f64,
}

impl Lift {
    /// Magnitude of the lift coefficient. The lift may point in any direction perpendicular to the path.
    pub(super) fn coefficient(&self) -> f64 {
        self.across(self.turn).norm()
    }

    /// Advance ratio: radius × spin component perpendicular to the path / speed.
    pub(super) fn advance_ratio(&self) -> f64 {
        self.across(self.spin).norm()
    }

    /// Cosine of the angle between the lift and ω × v, for a spin ω along `spin`.
    pub(super) fn cosine_with(&self, spin: Vector3<f64>) -> f64 {
        let (turn, spin) = (self.across(self.turn), self.across(spin));
        turn.dot(&spin) / (turn.norm() * spin.norm()).max(f64::MIN_POSITIVE)
    }

    /// Cosine of the angle between the lift and ω × v, for the spin ω that the data state.
    pub(super) fn cosine(&self) -> f64 {
        self.cosine_with(self.spin)
    }

    /// Component of the lift coefficient along ω × v, for the spin ω that the data state.
    pub(super) fn coefficient_by_spin(&self) -> f64 {
        self.coefficient() * self.cosine()
    }

    fn across(&self, vector: Vector3<f64>) -> Vector3<f64> {
        vector - self.direction * vector.dot(&self.direction)
    }
}

/// Fits all flights together, each with an unknown lift vector of its own. Returns the lifts and the report of the fit.
/// Flights that cannot be fitted, or whose spin the data do not state, are left out of the lifts.
pub(super) fn lifts(
    model: &Model,
    flights: &Dataset,
) -> Result<(Vec<Lift>, FitReport), StudyError> {
    let mut all = flights.clone();
    for flight in &mut all.flights {
        flight.role = Role::Fit;
    }
    let with_lift = with_effects(model, &[LIFT_OF_EACH_FLIGHT])?;
    let fitted = fit(&with_lift, &all, &FitOptions::default())?;
    let constant = |name: &str| {
        let stated = all.parameters.get(name).copied();
        let default = model.params.iter().find(|p| p.name == name);
        stated
            .or(default.map(|p| p.value))
            .ok_or_else(|| StudyError::Name {
                of: "model of the ball",
                name: name.to_owned(),
            })
    };
    let (mass, radius, rho) = (constant("m")?, constant("radius")?, constant("rho")?);
    let area = std::f64::consts::PI * radius * radius;
    // A lift coefficient C at speed v rotates the velocity at the rate ρ A C v / 2m.
    let scale = |speed: f64| 2.0 * mass / (rho * area * speed);
    let flights = all.flights.iter().enumerate();
    let lifts = flights.filter_map(|(index, flight)| lift(&fitted, index, flight, scale, radius));
    Ok((lifts.collect(), fitted.report.clone()))
}

fn lift(
    fitted: &Fit,
    index: usize,
    flight: &Flight,
    scale: impl Fn(f64) -> f64,
    radius: f64,
) -> Option<Lift> {
    let Some(KnownValue::Vector(omega)) = flight.known.get("omega") else {
        return None;
    };
    let initial = &fitted.report.flights[index].initial;
    let (turn_x, turn_z) = (initial.get("turn_x")?.value, initial.get("turn_z")?.value);
    let velocity = mean_velocity(flight)?;
    let evidence = fitted.evidence(identify::FlightId::new(index))?;
    let speed = velocity.norm();
    Some(Lift {
        file: flight.file.clone(),
        speed,
        direction: velocity / speed,
        turn: Vector3::new(turn_x, 0.0, turn_z) * scale(speed),
        spin: Vector3::from(*omega) * radius / speed,
        residual_along: residual_along(&evidence),
    })
}

/// Mean velocity (m/s) between the first and the last measured position; `None` if it is zero or fewer than two
/// positions are measured.
fn mean_velocity(flight: &Flight) -> Option<Vector3<f64>> {
    let samples = flight.times.iter().zip(&flight.positions);
    let mut measured = samples.filter_map(|(t, row)| Some((*t, Vector3::from((*row.first()?)?))));
    let first = measured.next()?;
    let last = measured.next_back()?;
    let velocity = (last.1 - first.1) / (last.0 - first.0);
    (velocity.norm() > 0.0).then_some(velocity)
}

/// RMS residual of one fitted flight along the y axis (the direction of flight), m.
fn residual_along(evidence: &FlightEvidence) -> f64 {
    let residuals = (0..evidence.times.len()).filter_map(|sample| evidence.residual(sample, 0));
    let (squares, count) = residuals.fold((0.0, 0.0_f64), |(squares, count), residual| {
        (squares + residual[1] * residual[1], count + 1.0)
    });
    (squares / count.max(1.0)).sqrt()
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Lift of a ball that flies along -y, with a given vector lift coefficient (`turn`) and dimensionless spin vector
    /// (`spin`).
    pub(in super::super) fn lift(turn: [f64; 3], spin: [f64; 3]) -> Lift {
        Lift {
            file: "flight001.csv".into(),
            speed: 10.0,
            direction: Vector3::new(0.0, -1.0, 0.0),
            turn: turn.into(),
            spin: spin.into(),
            residual_along: 0.0,
        }
    }

    #[test]
    fn the_side_of_a_lift_is_that_of_its_spin_across_the_path() {
        let same = lift([0.2, 0.0, 0.1], [0.4, 0.7, 0.2]);
        assert!((same.cosine() - 1.0).abs() < 1e-12);
        assert!((same.coefficient_by_spin() - 0.05_f64.sqrt()).abs() < 1e-12);
        assert!((same.advance_ratio() - 0.2_f64.sqrt()).abs() < 1e-12);
        assert!((lift([0.2, 0.0, 0.0], [-0.4, 0.3, 0.0]).cosine() + 1.0).abs() < 1e-12);
        assert!(lift([0.2, 0.0, 0.0], [0.0, 0.3, 0.4]).cosine().abs() < 1e-12);
    }
}
