//! How a body moves at its first sample, from its poses in the samples after it.

use nalgebra::{DMatrix, DVector, UnitQuaternion, Vector3};

use crate::noise::median;
use crate::observations::Observations;
use crate::pose::{Pose, pose};
use crate::problem::FitProblem;

/// How a body moves at one instant, in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion {
    /// Where its origin is, m.
    pub position: Vector3<f64>,
    /// Its velocity, m/s.
    pub velocity: Vector3<f64>,
    /// How it is turned; none for a point.
    pub attitude: Option<UnitQuaternion<f64>>,
    /// Its angular velocity, rad/s; none for a point.
    pub rates: Option<Vector3<f64>>,
}

impl RigidMotion {
    /// The same with so many whole turns more between samples; `whole` is the rate of one, rad/s.
    pub fn with_turns(&self, turns: i32, whole: f64) -> RigidMotion {
        let rates = self.rates.map(|rates| {
            let axis = rates.try_normalize(1e-9).unwrap_or_else(Vector3::z);
            if turns == 0 {
                rates
            } else {
                rates + axis * (f64::from(turns) * whole)
            }
        });
        RigidMotion { rates, ..*self }
    }
}

/// Samples that the motion is taken from: enough to average the noise, few enough for a parabola.
const SAMPLES: usize = 16;

/// Poses further apart than this many intervals do not tell a rate.
const GAP: f64 = 3.5;

/// What was seen of a body in one sample.
struct SeenFrame {
    time: f64,
    position: Vector3<f64>,
    attitude: Option<UnitQuaternion<f64>>,
    squares: f64,
}

/// The first samples that show the body's pose, or the point's position.
fn seen(problem: &FitProblem, observations: &Observations, most: usize) -> Vec<SeenFrame> {
    let rows = (0..observations.times.len()).filter_map(|sample| {
        let (time, row) = (observations.times[sample], observations.points(sample));
        if problem.has_attitude {
            let pose = pose(&problem.markers, row)?;
            return Some(SeenFrame {
                time,
                position: pose.position,
                attitude: Some(pose.attitude),
                squares: pose.variance(),
            });
        }
        let points = row.iter().zip(&problem.markers);
        let points = points
            .filter_map(|(seen, marker)| Some(Vector3::from((*seen)?) - Vector3::from(*marker)));
        let points: Vec<Vector3<f64>> = points.collect();
        let position = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
        (!points.is_empty()).then_some(SeenFrame {
            time,
            position,
            attitude: None,
            squares: 0.0,
        })
    });
    rows.take(most).collect()
}

/// Samples that the noise is first estimated from, at most.
const FLOOR_SAMPLES: usize = 400;

/// A first estimate of the noise of one coordinate, m: by how far the markers are from a rigid body in these poses, or for a
/// point by how rough its path is. None where too little was seen.
pub fn sigma0(
    problem: &FitProblem,
    observations: &Observations,
    poses: &[Option<Pose>],
) -> Option<f64> {
    if problem.has_attitude && problem.markers.len() >= 3 {
        let poses = poses.iter().flatten().take(FLOOR_SAMPLES);
        let mut squares: Vec<f64> = poses.map(Pose::variance).collect();
        // Of three squares of normal numbers the median sum is 2.366.
        return (squares.len() >= 3).then(|| (median(&mut squares) * 3.0 / 2.366).sqrt());
    }
    let seen = seen(problem, observations, FLOOR_SAMPLES);
    // Third differences: what is left of a smooth path is far below the noise, whose variance they multiply by 20.
    let mut rough: Vec<f64> = seen
        .windows(4)
        .flat_map(|w| {
            let third = w[3].position - 3.0 * w[2].position + 3.0 * w[1].position - w[0].position;
            third.abs().as_slice().to_vec()
        })
        .collect();
    (rough.len() >= 3).then(|| 1.4826 * median(&mut rough) / 20.0_f64.sqrt())
}

/// The motion at the track's first sample.
///
/// # Errors
/// In words, where too few samples show it.
pub fn of(problem: &FitProblem, observations: &Observations) -> Result<RigidMotion, String> {
    let mut seen = seen(problem, observations, SAMPLES);
    let least = if problem.has_attitude { 3 } else { 4 };
    if seen.len() < least {
        let what = if problem.has_attitude {
            "show three markers that are not in line"
        } else {
            "show it"
        };
        return Err(format!(
            "only {} of its samples {what}, and a start needs {least}",
            seen.len()
        ));
    }
    // A frame whose markers are far from rigid has an outlier among them.
    let mut sizes: Vec<f64> = seen.iter().map(|seen| seen.squares).collect();
    let usual = median(&mut sizes);
    if seen
        .iter()
        .filter(|seen| seen.squares <= 25.0 * usual)
        .count()
        >= least
    {
        seen.retain(|seen| seen.squares <= 25.0 * usual);
    }
    let (position, velocity) = path(&seen)?;
    let mut motion = RigidMotion {
        position,
        velocity,
        attitude: None,
        rates: None,
    };
    if problem.has_attitude {
        let rates = rates(&seen, observations)?;
        motion.attitude = attitude(&seen, rates);
        motion.rates = Some(rates);
    }
    Ok(motion)
}

/// Position and velocity at time 0 by a parabola through the positions; points far from it are left out and it is
/// drawn again.
fn path(seen: &[SeenFrame]) -> Result<(Vector3<f64>, Vector3<f64>), String> {
    let mut kept: Vec<&SeenFrame> = seen.iter().collect();
    for last in [false, false, true] {
        let powers = kept.len().min(3);
        let design = DMatrix::from_fn(kept.len(), powers, |row, power| {
            kept[row].time.powi(power as i32)
        });
        let factor = design.clone().svd(true, true);
        let (mut position, mut velocity) = (Vector3::zeros(), Vector3::zeros());
        let mut distances = vec![0.0_f64; kept.len()];
        for axis in 0..3 {
            let heights = DVector::from_fn(kept.len(), |row, _| kept[row].position[axis]);
            let parabola = factor.solve(&heights, 1e-12).map_err(str::to_owned)?;
            let residuals = &design * &parabola - heights;
            for (distance, residual) in distances.iter_mut().zip(residuals.iter()) {
                *distance += residual * residual;
            }
            position[axis] = parabola[0];
            velocity[axis] = if powers > 1 { parabola[1] } else { 0.0 };
        }
        let usual = median(&mut distances.clone());
        let near: Vec<&SeenFrame> = kept
            .iter()
            .zip(&distances)
            .filter(|(_, distance)| **distance <= 16.0 * usual)
            .map(|(seen, _)| *seen)
            .collect();
        if last || near.len() == kept.len() || near.len() < 4 {
            return Ok((position, velocity));
        }
        kept = near;
    }
    Err("no parabola".into())
}

/// The angular velocity: the median over neighbouring poses, which a nutation and an outlier leave alone.
fn rates(seen: &[SeenFrame], observations: &Observations) -> Result<Vector3<f64>, String> {
    let usual = observations.interval().unwrap_or(f64::INFINITY);
    let pairs: Vec<Vector3<f64>> = seen
        .windows(2)
        .filter_map(|pair| {
            let gap = pair[1].time - pair[0].time;
            let turn = pair[1].attitude? * pair[0].attitude?.inverse();
            (gap <= GAP * usual).then(|| turn.scaled_axis() / gap)
        })
        .collect();
    if pairs.is_empty() {
        return Err("no two neighbouring samples of it show three markers each".into());
    }
    // A gap of several intervals hides whole turns that one interval would not.
    let rates = [0, 1, 2].map(|axis| {
        let mut values: Vec<f64> = pairs.iter().map(|pair| pair[axis]).collect();
        median(&mut values)
    });
    Ok(rates.into())
}

/// The attitude at time 0: of those that the first poses say, turned back, the one that is nearest to the others.
fn attitude(seen: &[SeenFrame], rates: Vector3<f64>) -> Option<UnitQuaternion<f64>> {
    const FIRST: usize = 5;
    let back = |seen: &SeenFrame| {
        let turned = UnitQuaternion::from_scaled_axis(-rates * seen.time);
        seen.attitude.map(|attitude| turned * attitude)
    };
    let all: Vec<UnitQuaternion<f64>> = seen.iter().take(FIRST).filter_map(back).collect();
    let distance =
        |one: &UnitQuaternion<f64>| -> f64 { all.iter().map(|other| one.angle_to(other)).sum() };
    all.iter()
        .copied()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
}
