//! Axes of an instrument along those of the body, each with a sign.

use std::fmt;

use nalgebra::{Matrix3, Vector3};

/// For each axis of the body: the axis of the instrument along it, and its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignedAxes([(usize, f64); 3]);

impl Default for SignedAxes {
    /// The axes of the body.
    fn default() -> Self {
        Self([0, 1, 2].map(|axis| (axis, 1.0)))
    }
}

impl SignedAxes {
    /// All three in the opposite sense.
    pub const OPPOSITE: Self = Self([(0, -1.0), (1, -1.0), (2, -1.0)]);

    /// The other axes than this one exchanged.
    pub fn exchanged(axis: usize) -> Self {
        let mut own = Self::default();
        own.0.swap((axis + 1) % 3, (axis + 2) % 3);
        own
    }

    /// All others than those of the body, right-handed ones first, as an instrument is turned rather than that its axes are
    /// those of a mirror, and simple ones before others: rather all signs are opposite than one.
    pub fn simple() -> Vec<Self> {
        let mut all = Self::all();
        all.remove(0);
        all.sort_by_key(|own| {
            (
                !own.is_right_handed(),
                own.changes(),
                *own != Self::OPPOSITE,
            )
        });
        all
    }

    /// All 48, those of the body first.
    pub fn all() -> Vec<Self> {
        const ORDERS: [[usize; 3]; 6] = [
            [0, 1, 2],
            [1, 0, 2],
            [2, 1, 0],
            [0, 2, 1],
            [1, 2, 0],
            [2, 0, 1],
        ];
        let signs = |k: u32| [0, 1, 2].map(|axis| if k >> axis & 1 == 0 { 1.0 } else { -1.0 });
        let each = ORDERS.into_iter().flat_map(|order| {
            (0..8).map(move |k| {
                let signs = signs(k);
                Self([0, 1, 2].map(|axis| (order[axis], signs[axis])))
            })
        });
        each.collect()
    }

    /// Those that are nearest to a rotation from the axes of the instrument to those of the body.
    pub fn nearest(turn: &Matrix3<f64>) -> Self {
        let likeness = |own: &Self| -> f64 {
            let each = (0..3).map(|body| own.along(body).1 * turn[(body, own.along(body).0)]);
            each.sum()
        };
        let all = Self::all().into_iter();
        all.max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
            .unwrap_or_default()
    }

    /// Whether the axes are those of the body.
    pub fn is_identity(self) -> bool {
        self.changes() == 0
    }

    /// 0 for the axes of the body, 1 with other signs, 2 with other axes.
    pub fn changes(self) -> usize {
        let each = || self.0.iter().enumerate();
        if each().any(|(body, (own, _))| body != *own) {
            return 2;
        }
        usize::from(each().any(|(_, (_, sign))| *sign < 0.0))
    }

    /// Whether the axes are of one hand with those of the body.
    pub fn is_right_handed(self) -> bool {
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| self.turned(axis));
        x.cross(&y).dot(&z) > 0.0
    }

    /// Axis of the instrument along an axis of the body, and its sign.
    pub fn along(self, body: usize) -> (usize, f64) {
        self.0[body]
    }

    /// Components of a reading along the axes of the body.
    pub fn turned(self, reading: Vector3<f64>) -> Vector3<f64> {
        Vector3::from(self.0.map(|(own, sign)| sign * reading[own]))
    }

    /// As an array of TOML.
    pub fn toml(self) -> String {
        let names = self.0.map(|(own, sign)| {
            let sign = if sign < 0.0 { '-' } else { '+' };
            format!("\"{sign}{}\"", crate::AXES[own])
        });
        format!("[{}]", names.join(", "))
    }
}

impl fmt::Display for SignedAxes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = self.0.map(|(own, sign)| {
            let sign = if sign < 0.0 { "−" } else { "" };
            format!("{sign}{}", crate::AXES[own])
        });
        write!(f, "({})", names.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Rotation3;

    #[test]
    fn an_exchange_keeps_one_axis() {
        let reading = Vector3::new(1.0, 2.0, 3.0);
        let exchanged = [0, 1, 2].map(|axis| SignedAxes::exchanged(axis).turned(reading));
        let expected = [[1.0, 3.0, 2.0], [3.0, 2.0, 1.0], [2.0, 1.0, 3.0]];
        assert_eq!(exchanged, expected.map(Vector3::from));
    }

    #[test]
    fn the_nearest_axes_of_a_turn_are_those_that_it_brings_nearest() {
        for (angle, axes) in [(0.6, [1.0, 2.0, 3.0]), (1.2, [-2.0, 1.0, 3.0])] {
            let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), angle).into_inner();
            let nearest = SignedAxes::nearest(&turn);
            assert_eq!(
                nearest.turned(Vector3::new(1.0, 2.0, 3.0)),
                Vector3::from(axes)
            );
        }
    }
}
