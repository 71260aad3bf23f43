//! Vertical axis of a C3D file, derived from the corners of its force platforms.
//!
//! The corners of a platform are listed by the quadrants of the platform's own axes, whose z axis points into the floor
//! (C3D user guide, FORCE_PLATFORM:CORNERS). Forces cannot be interpreted in any other way, so this order is reliable.
//! `POINT:Y_SCREEN` states only how a program first draws the points.

use nalgebra::Vector3;

use crate::takes::axes::Axis;

/// Minimum cosine between a force platform's normal and a coordinate axis for the platform to be level.
const LEVEL: f64 = 0.98;

pub(super) fn up(corners: &[f64]) -> Option<Axis> {
    let mut found = None;
    for platform in corners.chunks_exact(12) {
        let up =
            above([0, 3, 6].map(|first| Vector3::from_column_slice(&platform[first..first + 3])))?;
        if *found.get_or_insert(up) != up {
            return None;
        }
    }
    found
}

/// Axis that points upwards out of the floor, from three consecutive corners of a platform; `None` if it is not level.
fn above([a, b, c]: [Vector3<f64>; 3]) -> Option<Axis> {
    let into = (a - b).cross(&(b - c));
    let index = (0..3).find(|&axis| into[axis].abs() > LEVEL * into.norm())?;
    Some(Axis {
        index,
        negative: into[index] > 0.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Corners of a level force platform in the order of its quadrants, seen from below the floor; +z points up.
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
