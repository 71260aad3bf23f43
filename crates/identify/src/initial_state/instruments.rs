//! Initial motions of a flight without measured positions. Position, heading and attitude are unknown: several
//! attitudes and speeds are tried.

use model_spec::compose::Instrument;
use nalgebra::{UnitQuaternion, Vector3};

use super::{RigidMotion, TriedMotion};
use crate::channel::ChannelKind;
use crate::error::FlightError;
use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::statistics::{median_of, median_vector};

/// Time from the first accelerometer reading over which the specific force is averaged, s.
const AVERAGED: f64 = 0.15;

/// Initial speeds of the body that are tried if no speed is measured, m/s.
const SPEEDS: [f64; 3] = [6.0, 12.0, 22.0];

/// Angles tried, rad, of the initial velocity below the plane perpendicular to the spin axis.
const ANGLES: [f64; 2] = [0.05, 0.25];

/// Rotations about the x and y axes, in both senses, of the initial attitudes that are tried, rad.
const TILT: f64 = 0.35;

/// Angular rate above which the body is considered to spin about an axis, rad/s.
const SPINS: f64 = 5.0;

/// Motions at the first sample that are compatible with the first readings, each with the index of its speed.
pub fn motions(
    problem: &FitProblem,
    observations: &Observations,
) -> Result<Vec<TriedMotion>, FlightError> {
    let readings = |wanted: Instrument| -> Vec<(f64, Vector3<f64>, Vector3<f64>)> {
        let is_wanted = |kind: &ChannelKind| matches!(kind, ChannelKind::Instrument(index) if problem.instruments[*index].0 == wanted);
        let channels = problem.channels.iter().enumerate();
        let Some((channel, own)) = channels.clone().find(|(_, own)| is_wanted(&own.kind)) else {
            return Vec::new();
        };
        let samples = observations.times.iter().enumerate();
        let seen = samples.filter_map(|(sample, time)| {
            let value = observations.inlier(sample, channel)?;
            Some((*time, Vector3::from(value), Vector3::from(own.position)))
        });
        seen.collect()
    };
    let rates = readings(Instrument::Gyroscope);
    let forces = readings(Instrument::Accelerometer);
    let speeds: Vec<f64> = readings(Instrument::Speed)
        .iter()
        .map(|(_, v, _)| v.x)
        .collect();
    if rates.is_empty() && forces.is_empty() && speeds.is_empty() {
        return Err(FlightError::NoMatchingState);
    }
    let first_rates = rates.iter().take(5).map(|(_, rate, _)| *rate);
    let spin = median_vector(&first_rates.collect::<Vec<_>>()).unwrap_or_default();
    let force = mean_force(&rates, &forces);
    let (across, axis) = match spin.norm() > SPINS {
        true => {
            let axis = spin.normalize();
            (force - axis * axis.dot(&force), axis)
        }
        false => (force, Vector3::z()),
    };
    let along = (-across).try_normalize(1e-6).unwrap_or_else(Vector3::x);
    let up = if axis.dot(&force) < 0.0 { -axis } else { axis };
    let measured = median_of(speeds.iter().take(5).copied());
    let speeds = measured.map_or(SPEEDS.to_vec(), |speed| vec![speed]);
    let mut motions = Vec::new();
    for attitude in attitudes() {
        for (index, &speed) in speeds.iter().enumerate() {
            for angle in ANGLES {
                let velocity = speed * (angle.cos() * along - angle.sin() * up);
                let motion = RigidMotion {
                    position: Vector3::zeros(),
                    velocity: attitude * velocity,
                    attitude: problem.points.has_attitude.then_some(attitude),
                    rates: problem.points.has_attitude.then(|| attitude * spin),
                };
                motions.push((index, 0, motion));
            }
        }
    }
    Ok(motions)
}

/// Initial attitudes that are tried: level and tilted, each upright and upside down.
fn attitudes() -> Vec<UnitQuaternion<f64>> {
    let tilts = [
        Vector3::zeros(),
        Vector3::x() * TILT,
        Vector3::x() * -TILT,
        Vector3::y() * TILT,
        Vector3::y() * -TILT,
    ];
    let over = UnitQuaternion::from_scaled_axis(Vector3::x() * std::f64::consts::PI);
    let upright = tilts.map(UnitQuaternion::from_scaled_axis);
    let all = upright.iter().copied();
    all.chain(upright.iter().map(|tilt| *tilt * over)).collect()
}

/// Mean specific force at the centre of mass over the first samples, m/s², in the body axes at the first sample.
/// `rates` and `forces` are readings (time in s, value, position of the sensor in m).
fn mean_force(
    rates: &[(f64, Vector3<f64>, Vector3<f64>)],
    forces: &[(f64, Vector3<f64>, Vector3<f64>)],
) -> Vector3<f64> {
    let Some(first) = forces.first().map(|(time, ..)| *time) else {
        return Vector3::zeros();
    };
    let mut turned = UnitQuaternion::identity();
    let (mut sum, mut count) = (Vector3::zeros(), 0.0);
    let mut before = first;
    let mut rates = rates.iter().peekable();
    let mut rate = rates
        .peek()
        .map_or_else(Vector3::zeros, |(_, rate, _)| *rate);
    for (time, force, place) in forces
        .iter()
        .take_while(|(time, ..)| *time <= first + AVERAGED)
    {
        while let Some((_, next, _)) = rates.next_if(|(at, ..)| at <= time) {
            rate = *next;
        }
        turned *= UnitQuaternion::from_scaled_axis(rate * (time - before));
        before = *time;
        sum += turned * (force - rate.cross(&rate.cross(place)));
        count += 1.0;
    }
    sum / count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::FitOptions;
    use dataset::synthesize::Plan;
    use dataset::{Sensor, SensorKind};

    /// A body that spins flies across its axis, against the force of the air; it sinks along the axis.
    #[test]
    fn a_spinning_body_flies_against_the_force_across_its_axis() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 1,
            duration: Some(0.5),
            ..Plan::default()
        };
        let mut dataset = crate::fit::tests::simulated(&model, "backhand", &plan);
        dataset.markers.clear();
        let kinds = [Instrument::Gyroscope, Instrument::Accelerometer].map(SensorKind::Instrument);
        let sensors = ["gyro", "acc"].into_iter().zip(kinds);
        let sensors = sensors.map(|(name, kind)| Sensor::new(name, kind, [0.0; 3]));
        dataset.sensors = sensors.collect();
        let flight = &mut dataset.flights[0];
        flight.positions.fill(Vec::new());
        let row = [[50.0, 0.0, 0.0, 0.0], [5.0, 2.0, -3.0, 0.0]].map(Some);
        // Before the force has turned with the body.
        flight.readings = vec![vec![Some([50.0, 0.0, 0.0, 0.0]), None]; flight.times.len()];
        flight.readings[0] = row.to_vec();
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        let observations = Observations::new(&problem, &dataset.flights[0]).unwrap();
        let tried = motions(&problem, &observations).unwrap();
        assert!(tried.len() > 10);
        let against = -Vector3::new(0.0, 2.0, -3.0).normalize();
        for (_, _, motion) in tried {
            let velocity = motion.attitude.unwrap().inverse() * motion.velocity;
            let direction = velocity.normalize();
            assert!(direction.dot(&against) > 0.9, "{direction}");
            assert!(
                direction.x < 0.0 && direction.cross(&against).x.abs() < 1e-9,
                "{direction}"
            );
        }
    }
}
