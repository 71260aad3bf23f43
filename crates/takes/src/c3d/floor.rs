//! The vertical of a C3D file, as its force platforms state it.
//!
//! The corners of a platform are listed by the quadrants of its own axes, whose z points into the floor (C3D user guide,
//! FORCE_PLATFORM:CORNERS); forces can be read in no other way. `POINT:Y_SCREEN` only says how a program first draws the
//! points.

use crate::axes::Axis;

/// Least cosine between the normals of the platforms and an axis.
const LEVEL: f64 = 0.98;

/// The axis that points up, by the corners of all platforms: x, y, z of four corners each. `None` where there are none, or
/// where one lies askew or otherwise than the others.
pub(super) fn up(corners: &[f64]) -> Option<Axis> {
    let mut found = None;
    for platform in corners.chunks_exact(12) {
        let corner = |i: usize| [platform[3 * i], platform[3 * i + 1], platform[3 * i + 2]];
        let up = above(corner(0), corner(1), corner(2))?;
        if *found.get_or_insert(up) != up {
            return None;
        }
    }
    found
}

/// The axis that points out of the floor at three corners of a platform, in their order.
fn above(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> Option<Axis> {
    let x = [0, 1, 2].map(|axis| a[axis] - b[axis]);
    let y = [0, 1, 2].map(|axis| b[axis] - c[axis]);
    let into = [
        x[1] * y[2] - x[2] * y[1],
        x[2] * y[0] - x[0] * y[2],
        x[0] * y[1] - x[1] * y[0],
    ];
    let size = into.iter().map(|x| x * x).sum::<f64>().sqrt();
    let index = (0..3).find(|&axis| into[axis].abs() > LEVEL * size)?;
    Some(Axis {
        index,
        negative: into[index] > 0.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Corners by quadrants, seen from below the floor, whose up is z.
    const PLATFORM: [f64; 12] = [1.0, 0.5, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0];

    #[test]
    fn platforms_lie_in_the_floor() {
        let named = |corners: &[f64]| up(corners).map(|axis| axis.to_string());
        assert_eq!(named(&PLATFORM).as_deref(), Some("+z"));
        let mut turned = PLATFORM;
        for corner in turned.chunks_exact_mut(3) {
            corner.rotate_right(1);
        }
        assert_eq!(named(&turned).as_deref(), Some("+x"));
        let mut other_way = PLATFORM;
        other_way.swap(0, 6);
        other_way.swap(3, 9);
        assert_eq!(named(&other_way).as_deref(), Some("-z"));
        assert_eq!(named(&[PLATFORM, turned].concat()), None);
        assert_eq!(named(&[0.0; 12]), None);
        let mut askew = PLATFORM;
        askew[2] = 0.5;
        assert_eq!(named(&askew), None);
    }
}
