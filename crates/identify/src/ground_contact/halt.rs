//! Detects whether a body is stopped, as by a hand; the ground leaves a flying body most of its speed.

use nalgebra::Vector3;

use super::PathPoint;

/// Maximum number of points within which a hand stops a body, counted from an interval in which a contact with the
/// ground is suspected. A disc that slides on the ground takes longer to stop.
const WITHIN: usize = 24;
/// Number of points from which the final speed of the body is computed: the last ones of the `WITHIN` points that
/// follow a suspected ground contact. A hand that catches the body must stop it within these `WITHIN` points.
const LAST: usize = 3;
/// Maximum ratio of the final speed to the speed before the suspected ground contact for a body to be considered at
/// rest. The limit allows for noise and for samples that end shortly before a caught body is at rest.
const REST: f64 = 0.2;

/// Whether a body that has the velocity `velocity`, m/s, before point `index` comes to rest within the next `WITHIN`
/// points, as if stopped by a hand.
pub fn is_stopped(points: &[PathPoint], index: usize, velocity: &Vector3<f64>) -> bool {
    let end = index.saturating_add(WITHIN).min(points.len());
    let soon = points.get(index..end).unwrap_or_default();
    let Some([first, .., last]) = soon.last_chunk::<LAST>() else {
        return false;
    };
    let moved = (last.position - first.position).norm();
    moved < REST * velocity.norm() * (last.time - first.time)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Interval between samples, s.
    const INTERVAL: f64 = 1.0 / 120.0;

    /// Simulated points of a body that flies at 9 m/s and, from point 40 on, loses the fraction `lost` of its speed
    /// over `braked` sampling intervals.
    fn points(count: usize, braked: usize, lost: f64) -> Vec<PathPoint> {
        let mut position = Vector3::new(0.0, 0.0, 1.0);
        let each = (0..count).map(|sample| {
            let part = (sample.saturating_sub(40) as f64 / braked as f64).min(1.0);
            position += VELOCITY * (1.0 - lost * part) * INTERVAL;
            PathPoint {
                sample,
                time: sample as f64 * INTERVAL,
                position,
                attitude: None,
            }
        });
        each.collect()
    }

    const VELOCITY: Vector3<f64> = Vector3::new(8.0, 0.0, -4.0);

    #[test]
    fn a_body_that_is_caught_is_stopped() {
        for braked in [1, 8, 15] {
            assert!(is_stopped(&points(80, braked, 1.0), 38, &VELOCITY));
        }
        assert!(is_stopped(&points(50, 9, 1.0), 38, &VELOCITY), "to its end");
    }

    #[test]
    fn a_body_that_slides_on_is_not_stopped() {
        for lost in [0.0, 0.3, 0.6] {
            assert!(!is_stopped(&points(80, 2, lost), 38, &VELOCITY));
        }
    }

    #[test]
    fn too_few_points_show_no_rest() {
        let points = points(40, 1, 0.0);
        for index in [38, 39, 40, 100] {
            assert!(!is_stopped(&points, index, &VELOCITY));
        }
    }
}
