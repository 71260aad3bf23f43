//! Signed coordinate axis of a recording that points up, and the conversion to axes with z up.

use std::fmt;

use crate::takes::quaternion::product;

/// A signed coordinate axis of a recording file, such as `+z` or `-y`, that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis {
    /// Index of the axis: 0, 1 or 2 for x, y or z.
    pub index: usize,
    /// `true` for the negative direction, as in `-y`.
    pub negative: bool,
}

impl Axis {
    /// Parses a signed coordinate axis such as `+z`, `-Y` or `x`; `None` for any other text.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim().to_ascii_lowercase();
        let (negative, name) = match text.strip_prefix('-') {
            Some(name) => (true, name),
            None => (false, text.strip_prefix('+').unwrap_or(&text)),
        };
        let index = ["x", "y", "z"].iter().position(|axis| *axis == name)?;
        Some(Self { index, negative })
    }

    /// Component of a vector, or of the first three of four numbers, along this axis.
    pub(crate) fn part_of<const N: usize>(self, vector: [f64; N]) -> f64 {
        let part = vector[self.index.min(2)];
        if self.negative { -part } else { part }
    }

    /// Converts a position from the file's axes to right-handed axes with z up; `self` is the axis of the file that
    /// points up. If the file's axes are left-handed, the second horizontal axis (y of the result) is mirrored.
    pub fn upright(self, left_handed: bool, position: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = self.turned(position);
        [x, if left_handed { -y } else { y }, z]
    }

    /// Converts an attitude (quaternion w, x, y, z from body to room) from right-handed axes with `self` up to z up.
    pub fn upright_attitude(self, quaternion: [f64; 4]) -> [f64; 4] {
        product(self.to_z(), quaternion)
    }

    /// Converts an attitude (unit quaternion w, x, y, z from body to room) to body axes of which the third is this axis of
    /// the body; the rotation that turns it to +z turns the body axes.
    pub fn third_body_axis(self, quaternion: [f64; 4]) -> [f64; 4] {
        let [w, x, y, z] = self.to_z();
        product(quaternion, [w, -x, -y, -z])
    }

    /// Quaternion w, x, y, z of the rotation that turns this axis to +z.
    pub(crate) fn to_z(self) -> [f64; 4] {
        let h = std::f64::consts::FRAC_1_SQRT_2;
        match (self.index, self.negative) {
            (0, false) => [h, 0.0, -h, 0.0],
            (0, true) => [h, 0.0, h, 0.0],
            (1, false) => [h, h, 0.0, 0.0],
            (1, true) => [h, -h, 0.0, 0.0],
            (_, false) => [1.0, 0.0, 0.0, 0.0],
            (_, true) => [0.0, 1.0, 0.0, 0.0],
        }
    }

    /// Rotates a vector, given in the file's axes, by the rotation that turns this axis to +z.
    pub(crate) fn turned(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match (self.index, self.negative) {
            (0, false) => [-z, y, x],
            (0, true) => [z, y, -x],
            (1, false) => [x, -z, y],
            (1, true) => [x, z, -y],
            (_, false) => [x, y, z],
            (_, true) => [x, -y, -z],
        }
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.negative { '-' } else { '+' };
        write!(f, "{sign}{}", ["x", "y", "z"][self.index.min(2)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::takes::quaternion::rotated;

    #[test]
    fn each_axis_turns_to_z_and_nothing_is_mirrored() {
        for text in ["+x", "-x", "+y", "-y", "z", "-Z"] {
            let axis = Axis::parse(text).expect(text);
            let mut up = [0.0; 3];
            up[axis.index] = if axis.negative { -1.0 } else { 1.0 };
            assert_eq!(axis.turned(up).map(|x| x + 0.0), [0.0, 0.0, 1.0], "{text}");
            let v = [0.3, -1.2, 0.7];
            let by_quaternion = rotated(axis.to_z(), v);
            for (a, b) in by_quaternion.into_iter().zip(axis.turned(v)) {
                assert!((a - b).abs() < 1e-12, "{text}");
            }
        }
        assert_eq!(Axis::parse("up"), None);
    }
}
