//! Shape of a rigid set of points: generalised Procrustes analysis of samples with gaps and outliers.
//!
//! J. C. Gower, "Generalized Procrustes analysis", Psychometrika 40 (1975).

use nalgebra::{DMatrix, Matrix3, Vector3};

use super::{FreeFlight, MIN_SAMPLES, TemplateError};
use crate::statistics::{median, median_of, median_vector};
use crate::takes::throws::{centred, fitted, moments};

/// Maximum number of iterations for the marker positions, and of the first ones, which also decide on outliers.
const PASSES: (usize, usize) = (60, 8);
/// Maximum change of a marker position in one iteration, m, at which the estimate counts as converged.
const CONVERGED: f64 = 1e-9;
/// Factors a and b of the maximum sum of squared residuals of a pose, σ² (f + a √(2f) + b) for f degrees of freedom and
/// the standard deviation σ of a coordinate; beyond it, a marker position is removed as an outlier.
const MISFIT: (f64, f64) = (4.0, 8.0);
/// Lower bound of the standard deviation of a coordinate, m; otherwise samples without noise would be outliers.
const FINEST: f64 = 1e-7;
/// Ratio of the second to the first singular value of points, up to which they count as lying on a line.
const FLAT: f64 = 0.05;

pub(super) struct Shape {
    /// Positions of the markers relative to their mean, m, in body-fixed axes of arbitrary orientation.
    pub points: Vec<Vector3<f64>>,
    /// Covariance of the coordinates of `points`, m², marker by marker; its rank is 3 × number of markers − 6.
    pub covariance: DMatrix<f64>,
    /// Estimated standard deviation of one coordinate of a measured marker position, m.
    pub sigma: f64,
    /// Poses of the body in the samples: one list for each flight.
    pub poses: Vec<Vec<Placed>>,
    pub outliers: usize,
}

#[derive(Clone)]
pub(super) struct Placed {
    pub sample: usize,
    /// Position in the room, m, of the point of the body that is the mean of all marker positions.
    pub position: Vector3<f64>,
    pub rotation: Matrix3<f64>,
    pub used: Vec<bool>,
    /// Sum of the squared residuals of the pose over the markers used for it, m².
    squares: f64,
}

type Row = Vec<Option<Vector3<f64>>>;

pub(super) fn shape(labels: &[String], flights: &[FreeFlight<'_>]) -> Result<Shape, TemplateError> {
    if labels.len() < 3 {
        let labels = labels.to_vec();
        return Err(TemplateError::FewPoints(labels));
    }
    let rows: Vec<Vec<Row>> = flights.iter().map(rows).collect();
    let all = || rows.iter().flatten();
    let mut points = first_shape(labels, all())?;
    let mut sigma = f64::INFINITY;
    let mut poses: Vec<Vec<Placed>> = Vec::new();
    for pass in 0..PASSES.0 {
        poses = match pass < PASSES.1 {
            true => rows
                .iter()
                .map(|rows| placed(&points, rows, sigma))
                .collect(),
            false => replaced(&points, &rows, poses),
        };
        let is_first = sigma.is_infinite();
        sigma = match is_first {
            true => robust_sigma(&poses),
            false => pooled_sigma(&poses, points.len()),
        }
        .max(FINEST);
        let next = means(&points, &rows, &poses, is_first);
        let change = points.iter().zip(&next).map(|(a, b)| (a - b).norm());
        let change = change.fold(0.0, f64::max);
        points = next;
        if pass > PASSES.1 && change < CONVERGED {
            break;
        }
    }
    let found = poses.iter().map(Vec::len).max().unwrap_or(0);
    if found < MIN_SAMPLES {
        let expected = MIN_SAMPLES;
        return Err(TemplateError::FewSamples { found, expected });
    }
    if is_flat(&points) {
        return Err(TemplateError::Collinear);
    }
    let seen = all().flatten().filter(|seen| seen.is_some()).count();
    let placed = poses.iter().flatten();
    let used = placed.map(|pose| pose.used.iter().filter(|used| **used).count());
    let lonely = all().map(|row| row.iter().flatten().count());
    let lonely: usize = lonely.filter(|seen| *seen < 3).sum();
    Ok(Shape {
        covariance: covariance(&points, &poses) * (sigma * sigma),
        sigma,
        outliers: seen.saturating_sub(used.sum::<usize>() + lonely),
        points,
        poses,
    })
}

fn rows(flight: &FreeFlight<'_>) -> Vec<Row> {
    let row = |row: &Vec<Option<[f64; 3]>>| row.iter().map(|p| p.map(Vector3::from)).collect();
    flight.positions.iter().map(row).collect()
}

/// Initial estimate of the marker positions on the body.
fn first_shape<'r>(
    labels: &[String],
    rows: impl Iterator<Item = &'r Row> + Clone,
) -> Result<Vec<Vector3<f64>>, TemplateError> {
    let count = labels.len();
    let pairs: Vec<(usize, usize)> = (0..count)
        .flat_map(|i| (i + 1..count).map(move |j| (i, j)))
        .collect();
    let distance = |row: &Row, (i, j): (usize, usize)| Some((row[i]? - row[j]?).norm());
    let typical = pairs.iter().map(|&pair| {
        let each = rows.clone().filter_map(|row| distance(row, pair));
        median_of(each).unwrap_or(0.0)
    });
    let typical: Vec<f64> = typical.collect();
    let off = |row: &Row| {
        let each = pairs.iter().zip(&typical);
        let each = each.filter_map(|(&pair, typical)| Some((distance(row, pair)? - typical).abs()));
        each.fold(0.0, f64::max)
    };
    let seen = |row: &Row| row.iter().flatten().count();
    let best = rows.clone().max_by(|a, b| {
        let by_count = seen(a).cmp(&seen(b));
        by_count.then_with(|| off(b).total_cmp(&off(a)))
    });
    let mut known: Row = best.cloned().unwrap_or_default();
    if known.iter().flatten().count() < 3 {
        let (found, expected) = (0, MIN_SAMPLES);
        return Err(TemplateError::FewSamples { found, expected });
    }
    while let Some(lacking) = known.iter().position(Option::is_none) {
        let template: Vec<Vector3<f64>> = known.iter().map(|p| p.unwrap_or_default()).collect();
        let place = |k: usize| {
            let places = rows.clone().filter_map(|row| {
                let both: Row = (0..count).map(|k| known[k].and(row[k])).collect();
                let (position, rotation) = fitted(&template, &both)?;
                Some(rotation.transpose() * (row[k]? - position))
            });
            let place = median_vector(&places.collect::<Vec<_>>());
            place.map(|place| (k, place))
        };
        let next = (0..count).filter(|&k| known[k].is_none()).find_map(place);
        let Some((k, point)) = next else {
            let label = labels[lacking].clone();
            return Err(TemplateError::Unplaced(label));
        };
        known[k] = Some(point);
    }
    let points: Vec<Vector3<f64>> = known.into_iter().flatten().collect();
    if is_flat(&points) {
        return Err(TemplateError::Collinear);
    }
    Ok(centred(points))
}

fn is_flat(points: &[Vector3<f64>]) -> bool {
    let [_, second, third] = moments(&centred(points.to_vec()));
    second <= FLAT * FLAT * third
}

/// Pose of the sample with the index `sample`, whose measured marker positions are `row`, from the markers marked as
/// `used`; `points` are the marker positions on the body. `None` if the used markers do not fix the attitude.
fn pose(points: &[Vector3<f64>], row: &Row, used: Vec<bool>, sample: usize) -> Option<Placed> {
    let seen: Row = row
        .iter()
        .zip(&used)
        .map(|(p, used)| p.filter(|_| *used))
        .collect();
    let chosen: Vec<Vector3<f64>> = points
        .iter()
        .zip(&seen)
        .filter_map(|(own, seen)| seen.map(|_| *own))
        .collect();
    if chosen.len() < 3 || is_flat(&chosen) {
        return None;
    }
    let (position, rotation) = fitted(points, &seen)?;
    let squares = points.iter().zip(&seen).filter_map(|(own, seen)| {
        let seen = (*seen)?;
        Some((position + rotation * own - seen).norm_squared())
    });
    Some(Placed {
        sample,
        position,
        rotation,
        squares: squares.sum(),
        used,
    })
}

impl Placed {
    /// Degrees of freedom of the residuals: number of used coordinates less that of fitted pose parameters.
    fn freedom(&self) -> f64 {
        3.0 * self.used.iter().filter(|used| **used).count() as f64 - 6.0
    }

    fn fits(&self, sigma: f64) -> bool {
        let freedom = self.freedom();
        self.squares <= sigma * sigma * (freedom + MISFIT.0 * (2.0 * freedom).sqrt() + MISFIT.1)
    }
}

/// Poses of the body in the samples `rows` of a flight; `sigma` is the standard deviation of a coordinate, m. While the
/// residuals of a sample are too large, the marker whose removal reduces them most is removed from it. A sample whose
/// remaining markers do not fix the pose is left out.
fn placed(points: &[Vector3<f64>], rows: &[Row], sigma: f64) -> Vec<Placed> {
    let place = |(sample, row): (usize, &Row)| {
        let all: Vec<bool> = row.iter().map(Option::is_some).collect();
        let mut now = pose(points, row, all, sample)?;
        while !now.fits(sigma) {
            let without = (0..points.len()).filter(|&k| now.used[k]).filter_map(|k| {
                let mut used = now.used.clone();
                used[k] = false;
                pose(points, row, used, sample)
            });
            now = without.min_by(|a, b| a.squares.total_cmp(&b.squares))?;
        }
        Some(now)
    };
    rows.iter().enumerate().filter_map(place).collect()
}

/// Recomputes each pose for the marker positions `points` from the same markers; those that fail are left out.
fn replaced(
    points: &[Vector3<f64>],
    rows: &[Vec<Row>],
    poses: Vec<Vec<Placed>>,
) -> Vec<Vec<Placed>> {
    let each = rows.iter().zip(poses).map(|(rows, poses)| {
        let again = poses
            .into_iter()
            .filter_map(|before| pose(points, &rows[before.sample], before.used, before.sample));
        again.collect()
    });
    each.collect()
}

/// Robust standard deviation of a coordinate, m, from the median of the squared residuals of the poses.
fn robust_sigma(poses: &[Vec<Placed>]) -> f64 {
    let each = poses.iter().flatten().map(|pose| {
        // Median of χ² over its degrees of freedom, by Wilson and Hilferty.
        let freedom = pose.freedom();
        pose.squares / (freedom * (1.0 - 2.0 / (9.0 * freedom)).powi(3))
    });
    median(&mut each.collect::<Vec<f64>>()).sqrt()
}

fn pooled_sigma(poses: &[Vec<Placed>], points: usize) -> f64 {
    let squares: f64 = poses.iter().flatten().map(|pose| pose.squares).sum();
    let freedom: f64 = poses.iter().flatten().map(Placed::freedom).sum();
    (squares / (freedom - (3.0 * points as f64 - 6.0)).max(1.0)).sqrt()
}

/// Mean, or median if `by_median`, of each marker's position in the axes of the poses, m, shifted to a mean of 0.
fn means(
    points: &[Vector3<f64>],
    rows: &[Vec<Row>],
    poses: &[Vec<Placed>],
    by_median: bool,
) -> Vec<Vector3<f64>> {
    let each = (0..points.len()).map(|k| {
        let own = rows.iter().zip(poses).flat_map(|(rows, poses)| {
            let used = poses.iter().filter(move |pose| pose.used[k]);
            used.filter_map(move |pose| {
                let seen = rows[pose.sample][k]?;
                Some(pose.rotation.transpose() * (seen - pose.position))
            })
        });
        let own: Vec<Vector3<f64>> = own.collect();
        let mean = || own.iter().sum::<Vector3<f64>>() / own.len() as f64;
        match by_median {
            _ if own.is_empty() => points[k],
            true => median_vector(&own).unwrap_or(points[k]),
            false => mean(),
        }
    });
    centred(each.collect())
}

/// Covariance of the marker positions on the body, per unit variance of a measured coordinate: pseudo-inverse of the
/// normal matrix with the poses eliminated. The six directions of a rigid motion of all markers are left out.
fn covariance(points: &[Vector3<f64>], poses: &[Vec<Placed>]) -> DMatrix<f64> {
    let size = 3 * points.len();
    let mut normal = DMatrix::<f64>::zeros(size, size);
    // Samples with the same markers have the same matrix.
    let mut kinds: std::collections::BTreeMap<&[bool], f64> = std::collections::BTreeMap::new();
    for pose in poses.iter().flatten() {
        *kinds.entry(&pose.used).or_default() += 1.0;
    }
    for (used, times) in kinds {
        let chosen: Vec<usize> = (0..points.len()).filter(|&k| used[k]).collect();
        let mut motion = DMatrix::<f64>::zeros(size, 6);
        let mut own = DMatrix::<f64>::zeros(size, size);
        for &k in &chosen {
            let turn = -points[k].cross_matrix();
            for a in 0..3 {
                own[(3 * k + a, 3 * k + a)] = 1.0;
                motion[(3 * k + a, a)] = 1.0;
                for b in 0..3 {
                    motion[(3 * k + a, 3 + b)] = turn[(a, b)];
                }
            }
        }
        let Some(inverse) = (motion.transpose() * &motion).try_inverse() else {
            continue;
        };
        normal += (own - &motion * inverse * motion.transpose()) * times;
    }
    let eigen = normal.symmetric_eigen();
    let most = eigen.eigenvalues.amax();
    let inverse = eigen.eigenvalues.map(|value| {
        if value > 1e-9 * most {
            1.0 / value
        } else {
            0.0
        }
    });
    &eigen.eigenvectors * DMatrix::from_diagonal(&inverse) * eigen.eigenvectors.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each pose takes six of the coordinates measured; no motion of all markers together has a variance.
    #[test]
    fn the_variance_of_markers_is_that_of_their_mean_without_the_poses() {
        let points = [
            [0.1, 0.0, 0.02],
            [-0.1, 0.05, 0.0],
            [0.0, -0.1, 0.0],
            [0.03, 0.05, -0.02],
        ];
        let points = points.map(Vector3::from);
        let placed = Placed {
            sample: 0,
            position: Vector3::zeros(),
            rotation: Matrix3::identity(),
            used: vec![true; 4],
            squares: 0.0,
        };
        let poses = vec![vec![placed.clone(); 15], vec![placed; 5]];
        let found = covariance(&points, &poses);
        assert!(
            (found.trace() - (12.0 - 6.0) / 20.0).abs() < 1e-12,
            "{}",
            found.trace()
        );
        let shift = DMatrix::from_fn(12, 3, |row, axis| f64::from(row % 3 == axis));
        assert!((found * shift).amax() < 1e-12);
    }
}
