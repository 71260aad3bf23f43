//! Estimation of spin axis and centre of mass: the direction and the point of the body whose trajectories contain no
//! component that rotates with the body.
//!
//! Let R and c be the rotations and positions of the samples, and let (·)~ denote the residual of a signal after a
//! polynomial in time is fitted to it. The trajectory of the body point p is c + R p, and least squares give B p = −Σ
//! R~ᵀ c~ with B = Σ R~ᵀ R~. B is nearly 0 along the spin axis, whose trajectory is smooth except for its wobble. The
//! contribution of the noise of the rotations is subtracted from both sides (method of moments).

use nalgebra::{DMatrix, Matrix3, Rotation3, SymmetricEigen, Vector3};

use super::air::air_motion;
use super::shape::{Placed, Shape};
use super::smooth::Smooth;
use super::{FreeFlight, MIN_SAMPLES, TemplateError, UpVote};

/// Minimum and maximum degree of the polynomial in time that is fitted to the trajectory of a body point.
const DEGREES: (usize, usize) = (2, 10);
/// Maximum degree, per turn of the body, of the polynomial fitted to the trajectory of a body point. At 1 per turn the
/// polynomial has at most half as many waves as the body has turns, and so cannot follow the rotation.
const DEGREES_PER_TURN: f64 = 1.0;
/// Number of iterations of the estimate of the spin axis and the centre of mass.
const PASSES: usize = 3;
/// Criteria for a spin about one axis. The centre of mass p solves the normal equations B p = −b, summed over samples
/// with weights. For such a spin, the matrix B has one small eigenvalue. The values are the minimum ratio of B's middle
/// eigenvalue to the sum of the weights, and the maximum ratio of its least to its middle eigenvalue.
const SPIN: (f64, f64) = (0.05, 0.5);
/// Minimum mean square of the wobble relative to that of the axis's noise for the height of the centre to be estimated.
const WOBBLE: f64 = 0.1;
/// Minimum sine of the spin axis's elevation at the beginning of a flight that counts in which direction is upwards.
const UPWARDS: f64 = 0.2;

/// Spin axis and centre of mass of a body, in the body-fixed axes of [`Shape`] (marker positions on the body).
pub(super) struct Centre {
    /// Unit vector of the spin axis in the axes of [`Shape`], upwards at the beginning of most flights.
    pub axis: Vector3<f64>,
    /// Covariance of the components of that unit vector, in the axes of [`Shape`] (dimensionless).
    pub axis_covariance: Matrix3<f64>,
    /// Point of the spin axis at height 0 (that of the mean of the markers), in the axes of [`Shape`], m.
    pub foot: Vector3<f64>,
    /// Covariance of the coordinates of that point, in the axes of [`Shape`], m².
    pub foot_covariance: Matrix3<f64>,
    /// Derivative of the point of the spin axis at height 0 (field `foot`) with respect to the height of the centre of
    /// mass along the axis (dimensionless). A centre of mass at the height h is at `foot + h * (slope + axis)`.
    pub slope: Vector3<f64>,
    /// Height of the centre of mass over the mean of the markers, and its error, m; `None` with little wobble.
    pub height: Option<(f64, f64)>,
    pub up: Option<UpVote>,
    pub turns: f64,
}

/// Poses in one flight, with the noise of each and the degree of the polynomials fitted to trajectories.
struct Motion {
    times: Vec<f64>,
    centres: DMatrix<f64>,
    rotations: Vec<Matrix3<f64>>,
    noise: Vec<PoseNoise>,
    degree: usize,
    turns: f64,
}

/// What determines the covariance of a pose, per unit variance of a coordinate; it depends only on the markers used.
struct PoseNoise {
    count: f64,
    /// Mean position on the body, in the axes of [`Shape`], of the markers from which the pose is computed, m.
    mean: Vector3<f64>,
    /// E([δ]ₓᵀ [δ]ₓ) of the rotation error δ in the axes of [`Shape`], per unit variance of a coordinate, 1/m².
    rotation: Matrix3<f64>,
}

impl PoseNoise {
    fn new(points: &[Vector3<f64>], pose: &Placed) -> Option<Self> {
        let used = || points.iter().zip(&pose.used).filter(|(_, used)| **used);
        let count = used().count() as f64;
        let mean = used().map(|(point, _)| point).sum::<Vector3<f64>>() / count;
        let tensor = used().map(|(point, _)| {
            let arm = point - mean;
            Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()
        });
        let covariance = tensor.sum::<Matrix3<f64>>().try_inverse()?;
        let rotation = Matrix3::identity() * covariance.trace() - covariance;
        Some(Self {
            count,
            mean,
            rotation,
        })
    }

    /// Weight of the trajectory of a body point: variance of a measured coordinate by that of the computed point.
    fn weight(&self, point: &Vector3<f64>) -> f64 {
        let arm = point - self.mean;
        1.0 / (1.0 / self.count + arm.dot(&(self.rotation * arm)) / 3.0)
    }
}

/// Sums over all flights for the centre of mass: the body point p with the smoothest trajectory solves B p = −b, where
/// B is `raw` − `noise` and b is `right`; `weight` is the sum of the weights.
#[derive(Default)]
struct Sums {
    raw: Matrix3<f64>,
    noise: Matrix3<f64>,
    right: Vector3<f64>,
    weight: f64,
    /// Degrees of freedom of the residuals of the poses, summed over all flights, for the measurement noise.
    freedom: f64,
    /// Contribution to `right` of the assumed unknown displacement by the air, for the error that it causes.
    unknown: Vector3<f64>,
}

/// Estimates spin axis and centre of mass from the poses of all flights.
pub(super) fn centre(shape: &Shape, flights: &[FreeFlight<'_>]) -> Result<Centre, TemplateError> {
    let each = shape.poses.iter().zip(flights);
    let each = each.filter(|(poses, _)| poses.len() >= MIN_SAMPLES);
    let mut motions: Vec<Motion> = each
        .map(|(poses, flight)| Motion::new(shape, poses, flight))
        .collect();
    let variance = shape.sigma * shape.sigma;
    let mut point = Vector3::zeros();
    let mut axis: Option<Vector3<f64>> = None;
    let mut sums = Sums::default();
    for _ in 0..PASSES {
        sums = Sums::default();
        for motion in &motions {
            flight::cancellation::stop_if_cancelled();
            motion.add(&point, axis.as_ref(), variance, &mut sums);
        }
        let found = axis_of(&sums)
            .ok_or_else(|| TemplateError::NoSpin(motions.iter().map(|m| m.turns).sum()))?;
        axis = Some(found);
        let height = height(&sums, &found, variance).map_or(0.0, |(height, _)| height);
        let (foot, slope, _) = at_height_zero(&sums, &found);
        point = foot + slope * height + found * height;
        for motion in &mut motions {
            motion.choose_degree(&point);
        }
    }
    let mut axis = axis.unwrap_or_else(Vector3::z);
    let (up, votes) = side(&motions, &axis);
    if !up {
        axis = -axis;
    }
    let (spread, residual) = residuals(&motions, &point, &axis);
    let (foot, slope, inverse) = at_height_zero(&sums, &axis);
    Ok(Centre {
        axis,
        axis_covariance: inverse * spread,
        foot,
        foot_covariance: inverse * residual,
        slope,
        height: height(&sums, &axis, residual),
        up: votes,
        turns: motions.iter().map(|motion| motion.turns).sum(),
    })
}

/// Unit vector of the spin axis: the eigenvector of B for its least eigenvalue; `None` without one axis.
fn axis_of(sums: &Sums) -> Option<Vector3<f64>> {
    let eigen = SymmetricEigen::new(sums.raw - sums.noise);
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
    let [least, middle, _] = order.map(|k| eigen.eigenvalues[k]);
    let turns = middle > SPIN.0 * sums.weight && least < SPIN.1 * middle;
    turns.then(|| eigen.eigenvectors.column(order[0]).into_owned())
}

/// Selects, among the body points at the mean height of the markers, the one with the smoothest trajectory. Returns
/// this point, m; the derivative of its components across the axis by the height; and the inverse of the normal matrix
/// in the plane normal to the axis.
fn at_height_zero(sums: &Sums, axis: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>, Matrix3<f64>) {
    let across = Matrix3::identity() - axis * axis.transpose();
    let matrix = sums.raw - sums.noise;
    let size = matrix.trace().max(f64::MIN_POSITIVE);
    // The matrix is regularised along the axis; the regularisation is then projected out of the inverse.
    let regular = across * matrix * across + axis * axis.transpose() * size;
    let inverse = regular.try_inverse().unwrap_or_else(Matrix3::zeros);
    let inverse = across * inverse * across;
    let slope = -inverse * (matrix * axis);
    (-inverse * sums.right, slope, inverse)
}

/// Estimates the height of the centre of mass along the spin axis and the standard error of this height, m.
fn height(sums: &Sums, axis: &Vector3<f64>, variance: f64) -> Option<(f64, f64)> {
    let (foot, slope, _) = at_height_zero(sums, axis);
    let direction = axis + slope;
    let matrix = sums.raw - sums.noise;
    let information = axis.dot(&(matrix * direction));
    let noise = axis.dot(&(sums.noise * axis));
    if information <= WOBBLE * noise || information <= 0.0 {
        return None;
    }
    let height = -axis.dot(&(sums.right + matrix * foot)) / information;
    let by_noise = variance * direction.dot(&(sums.raw * direction)) / information.powi(2);
    let by_air = direction.dot(&sums.unknown) / information;
    // The noise that is subtracted from the matrix is itself an estimate.
    let by_estimate = height * noise / information * (2.0 / sums.freedom.max(1.0)).sqrt();
    Some((
        height,
        (by_noise + by_air * by_air + by_estimate * by_estimate).sqrt(),
    ))
}

/// Weighted mean squares, per degree of freedom, of the residuals after polynomials in time were fitted: those of the
/// direction of the spin axis (dimensionless) and those of the trajectory of the centre of mass, m².
fn residuals(motions: &[Motion], point: &Vector3<f64>, axis: &Vector3<f64>) -> (f64, f64) {
    let (mut axes, mut paths, mut axis_freedom, mut freedom) = (0.0, 0.0, 0.0, -3.0);
    for motion in motions {
        let Some(smooth) = motion.smooth(point) else {
            continue;
        };
        axes += smooth.rest(&motion.directions(axis)).norm_squared();
        paths += smooth.rest(&motion.path(point)).norm_squared();
        // A unit vector has two degrees of freedom.
        let left = (motion.times.len() - motion.degree - 1) as f64;
        axis_freedom += 2.0 * left;
        freedom += 3.0 * left;
    }
    (
        axes / f64::max(axis_freedom, 1.0),
        paths / f64::max(freedom, 1.0),
    )
}

/// Whether the spin axis `axis`, in body-fixed axes, points upwards at the beginning of most flights. An elevation
/// whose sine is at most [`UPWARDS`] does not count; among as many of both, the mean sine decides.
fn side(motions: &[Motion], axis: &Vector3<f64>) -> (bool, Option<UpVote>) {
    let heights = motions.iter().map(|motion| {
        let early = (motion.rotations.len() / 10).max(3);
        let sum = motion.rotations.iter().take(early).map(|r| (r * axis).z);
        sum.sum::<f64>() / early as f64
    });
    let heights: Vec<f64> = heights.collect();
    let counted = |sign: f64| heights.iter().filter(|h| sign * **h > UPWARDS).count();
    let (up, down) = (counted(1.0), counted(-1.0));
    let is_up = match up == down {
        true => heights.iter().sum::<f64>() >= 0.0,
        false => up > down,
    };
    let votes = (up != down).then(|| UpVote {
        for_it: up.max(down),
        against: up.min(down),
    });
    (is_up, votes)
}

impl Motion {
    fn new(shape: &Shape, poses: &[Placed], flight: &FreeFlight<'_>) -> Self {
        let with_noise = poses
            .iter()
            .filter_map(|pose| Some((pose, PoseNoise::new(&shape.points, pose)?)));
        let (poses, noise): (Vec<&Placed>, Vec<PoseNoise>) = with_noise.unzip();
        let rotations: Vec<Matrix3<f64>> = poses.iter().map(|pose| pose.rotation).collect();
        let angles = rotations.windows(2).map(|pair| {
            let between = pair[0].transpose() * pair[1];
            Rotation3::from_matrix_unchecked(between).angle()
        });
        let turns = angles.sum::<f64>() / std::f64::consts::TAU;
        let centres = DMatrix::from_fn(poses.len(), 3, |i, k| poses[i].position[k]);
        let mut motion = Self {
            times: poses.iter().map(|p| flight.times[p.sample]).collect(),
            centres,
            rotations,
            noise,
            degree: 0,
            turns,
        };
        motion.degree = motion.most().min(4);
        motion
    }

    /// Maximum degree of the polynomials of this flight, limited by the numbers of turns and samples.
    fn most(&self) -> usize {
        let by_turns = (DEGREES_PER_TURN * self.turns) as usize;
        let by_samples = self.times.len() / 4;
        by_turns.min(by_samples).clamp(DEGREES.0, DEGREES.1)
    }

    fn weights(&self, point: &Vector3<f64>) -> Vec<f64> {
        self.noise.iter().map(|noise| noise.weight(point)).collect()
    }

    fn smooth(&self, point: &Vector3<f64>) -> Option<Smooth> {
        Smooth::new(&self.times, &self.weights(point), self.degree)
    }

    /// Trajectory of the body point `point` along the axes of the room, m, one row per sample.
    fn path(&self, point: &Vector3<f64>) -> DMatrix<f64> {
        &self.centres + self.directions(point)
    }

    /// Components of a body-fixed vector along the axes of the room, one row per sample.
    fn directions(&self, vector: &Vector3<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(self.rotations.len(), 3, |i, k| {
            (self.rotations[i].row(k) * vector)[0]
        })
    }

    /// Adds this flight to `to`, the normal equations of the centre of mass. The estimate `point`, m, determines the
    /// weights; `variance` is that of a measured coordinate, m². With the spin axis `axis`, the known displacement by
    /// the air is first subtracted from the trajectory. Both are in body-fixed axes.
    fn add(&self, point: &Vector3<f64>, axis: Option<&Vector3<f64>>, variance: f64, to: &mut Sums) {
        let weights = self.weights(point);
        let Some(smooth) = Smooth::new(&self.times, &weights, self.degree) else {
            return;
        };
        let mut centres = self.centres.clone();
        let mut unknown = DMatrix::zeros(self.times.len(), 3);
        if let Some(axis) = axis {
            let path = self.path(point);
            let air = air_motion(&self.times, &smooth, &path, &self.directions(axis));
            centres -= air.known;
            unknown = smooth.rest(&air.unknown);
        }
        let centres = smooth.rest(&centres);
        for room in 0..3 {
            let own = DMatrix::from_fn(self.times.len(), 3, |i, k| self.rotations[i][(room, k)]);
            let own = smooth.rest(&own);
            let squares = own.transpose() * &own;
            to.raw += Matrix3::from_fn(|a, b| squares[(a, b)]);
            let right = own.transpose() * centres.column(room);
            to.right += Vector3::new(right[0], right[1], right[2]);
            let right = own.transpose() * unknown.column(room);
            to.unknown += Vector3::new(right[0], right[1], right[2]);
        }
        for (i, noise) in self.noise.iter().enumerate() {
            let square = noise.rotation * (weights[i] * smooth.left(i) * variance);
            to.noise += square;
            to.right += square * noise.mean;
            to.freedom += 3.0 * noise.count - 6.0;
        }
        to.weight += weights.iter().sum::<f64>();
    }

    /// Sets the degree of the polynomials by the Bayesian information criterion for the body point `point`.
    fn choose_degree(&mut self, point: &Vector3<f64>) {
        let weights = self.weights(point);
        let path = self.path(point);
        let count = (3 * self.times.len()) as f64;
        let criterion = |degree: usize| {
            let smooth = Smooth::new(&self.times, &weights, degree)?;
            let misfit = smooth.rest(&path).norm_squared().max(f64::MIN_POSITIVE);
            Some(count * misfit.ln() + (3 * (degree + 1)) as f64 * count.ln())
        };
        let degrees = (DEGREES.0..=self.most()).filter_map(|d| Some((d, criterion(d)?)));
        let best = degrees.min_by(|a, b| a.1.total_cmp(&b.1));
        self.degree = best.map_or(self.degree, |(degree, _)| degree);
    }
}
