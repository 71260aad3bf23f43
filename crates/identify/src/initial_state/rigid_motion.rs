//! Rigid-body motion at the first sample, estimated from the poses in the first samples.

use nalgebra::{DMatrix, DVector, UnitQuaternion, Vector3};

use crate::error::FlightError;
use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::levels::{OUTLIER_VARIANCE, RANK, UNLIKE};
use dataset::pose::{Pose, RigidMotion, pose};
use dataset::statistics::{median, median_of, median_vector, robust_sigma};
use dataset::{Seen, seen_path};
use flight::moore_penrose;

/// Maximum number of samples of the motion: enough to average the noise, few enough for a parabola.
const MAX_SAMPLES: usize = 16;

/// Maximum time between two poses from which an angular velocity is computed, in sampling intervals.
const MAX_GAP: f64 = 3.5;

/// The first samples, at most `most`, in which a pose or the position of a point mass is measured; times from the first on.
fn first_seen(problem: &FitProblem, observations: &Observations, most: usize) -> Vec<Seen> {
    let points = |sample: usize| observations.points(sample);
    let pose = |sample: usize| pose(&problem.points.markers, points(sample));
    let seen = seen_path(&problem.points, &observations.times, points, pose).take(most);
    // Times of an arc do not start at 0.
    let since = |own: Seen| Seen {
        time: own.time - observations.times[0],
        ..own
    };
    seen.map(since).collect()
}

/// Maximum number of samples of a flight from which the initial noise estimate is computed.
const MAX_NOISE_SAMPLES: usize = 400;

/// Initial noise of a coordinate, m: of a rigid body by the distances of its markers from it, otherwise by third
/// differences of its path.
pub fn sigma0(
    problem: &FitProblem,
    observations: &Observations,
    poses: &[Option<Pose>],
) -> Option<f64> {
    if problem.points.has_attitude
        && problem.points.markers.len() >= 3
        && problem.points.are_markers
    {
        let poses = poses.iter().flatten().take(MAX_NOISE_SAMPLES);
        let mut squares: Vec<f64> = poses.map(Pose::variance).collect();
        // The median of χ² with 3 degrees of freedom is 2.366.
        return (squares.len() >= 3).then(|| (median(&mut squares) * 3.0 / 2.366).sqrt());
    }
    let seen = first_seen(problem, observations, MAX_NOISE_SAMPLES);
    // Third differences of a smooth path are far below the noise, whose variance they multiply by 20.
    let mut rough: Vec<f64> = seen
        .windows(4)
        .flat_map(|w| {
            let third = w[3].position - 3.0 * w[2].position + 3.0 * w[1].position - w[0].position;
            <[f64; 3]>::from(third.abs())
        })
        .collect();
    (rough.len() >= 3).then(|| robust_sigma(&mut rough) / 20.0_f64.sqrt())
}

/// Returns the motion at the first sample of a flight.
pub fn first_motion(
    problem: &FitProblem,
    observations: &Observations,
) -> Result<RigidMotion, FlightError> {
    let mut seen = first_seen(problem, observations, MAX_SAMPLES);
    let least = if problem.points.has_attitude { 3 } else { 4 };
    if seen.len() < least {
        let (found, needed) = (seen.len(), least);
        return Err(match problem.points.has_attitude {
            true => FlightError::TooFewPoses { found, needed },
            false => FlightError::TooFewPositions { found, needed },
        });
    }
    // A sample whose marker distances differ much from the rigid body contains an outlier.
    let usual = median_of(seen.iter().map(Seen::variance));
    let limit = OUTLIER_VARIANCE * usual.unwrap_or(0.0);
    let is_rigid = |own: &Seen| own.variance() <= limit;
    if seen.iter().filter(|frame| is_rigid(frame)).count() >= least {
        seen.retain(is_rigid);
    }
    let (position, velocity) = path(&seen);
    let mut motion = RigidMotion {
        position,
        velocity,
        attitude: None,
        rates: None,
    };
    if problem.points.has_attitude {
        let rates = rates(&seen)?;
        motion.attitude = attitude(&seen, rates);
        motion.rates = Some(rates);
    }
    Ok(motion)
}

/// Maximum number of fits of the parabola again without outliers, and number of positions that must remain.
const REFITS: (usize, usize) = (2, 4);

/// Position, m, and velocity, m/s, at time 0 of the least-squares parabola through the positions, without outliers.
fn path(seen: &[Seen]) -> (Vector3<f64>, Vector3<f64>) {
    let mut kept: Vec<&Seen> = seen.iter().collect();
    let mut parabola = Parabola::through(&kept);
    for _ in 0..REFITS.0 {
        let limit = UNLIKE * UNLIKE * median(&mut parabola.squares.clone());
        let distances = kept.iter().zip(&parabola.squares);
        let near = distances.filter(|(_, squares)| **squares <= limit);
        let near: Vec<&Seen> = near.map(|(frame, _)| *frame).collect();
        if near.len() == kept.len() || near.len() < REFITS.1 {
            break;
        }
        kept = near;
        parabola = Parabola::through(&kept);
    }
    (parabola.position, parabola.velocity)
}

/// Least-squares parabola in time through measured positions.
struct Parabola {
    position: Vector3<f64>,
    velocity: Vector3<f64>,
    squares: Vec<f64>,
}

impl Parabola {
    /// Fits a parabola in time to the measured positions, or a polynomial of lower order if there are fewer than three.
    fn through(frames: &[&Seen]) -> Self {
        let powers = frames.len().min(3);
        let design = DMatrix::from_fn(frames.len(), powers, |row, power| {
            frames[row].time.powi(power as i32)
        });
        let inverse = moore_penrose(&design, RANK);
        let (mut position, mut velocity) = (Vector3::zeros(), Vector3::zeros());
        let mut squares = vec![0.0_f64; frames.len()];
        for axis in 0..3 {
            let values = DVector::from_fn(frames.len(), |row, _| frames[row].position[axis]);
            let polynomial = &inverse * &values;
            let residuals = &design * &polynomial - values;
            for (sum, residual) in squares.iter_mut().zip(residuals.iter()) {
                *sum += residual * residual;
            }
            position[axis] = polynomial[0];
            velocity[axis] = if powers > 1 { polynomial[1] } else { 0.0 };
        }
        Self {
            position,
            velocity,
            squares,
        }
    }
}

/// Angular velocity, inertial, rad/s: median over successive poses, which nutation and outliers hardly change.
fn rates(seen: &[Seen]) -> Result<Vector3<f64>, FlightError> {
    let turns = seen.windows(2).filter_map(|pair| {
        let turn = pair[1].pose?.attitude * pair[0].pose?.attitude.inverse();
        Some((pair[1].time - pair[0].time, turn.scaled_axis()))
    });
    let turns: Vec<(f64, Vector3<f64>)> = turns.collect();
    // Other sensors may have samples between those of the poses.
    let usual = median_of(turns.iter().map(|(gap, _)| *gap)).unwrap_or(f64::INFINITY);
    let near = turns.iter().filter(|(gap, _)| *gap <= MAX_GAP * usual);
    let pairs: Vec<Vector3<f64>> = near.map(|(gap, turn)| turn / *gap).collect();
    // A gap of several intervals may hide whole turns that a single interval would show.
    median_vector(&pairs).ok_or(FlightError::NoNeighbouringPoses)
}

/// Attitude at time 0: of the first poses, rotated back with `rates`, rad/s, the one nearest to the others.
fn attitude(seen: &[Seen], rates: Vector3<f64>) -> Option<UnitQuaternion<f64>> {
    const FIRST: usize = 5;
    let back = |seen: &Seen| {
        let turned = UnitQuaternion::from_scaled_axis(-rates * seen.time);
        Some(turned * seen.pose?.attitude)
    };
    let all: Vec<UnitQuaternion<f64>> = seen.iter().take(FIRST).filter_map(back).collect();
    let distance =
        |one: &UnitQuaternion<f64>| -> f64 { all.iter().map(|other| one.angle_to(other)).sum() };
    all.iter()
        .copied()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
}
