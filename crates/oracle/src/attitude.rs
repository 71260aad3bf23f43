//! Rotations as unit quaternions.

use crate::scalar::{Field, Real};
use nalgebra::{Matrix3, Vector3};

/// Rotation as a quaternion q, scalar part first. It maps the components v of a vector in the rotated frame to those in
/// the original frame N: v_N = q v q*.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quaternion<T> {
    /// Scalar part w of the quaternion.
    pub w: T,
    /// Vector part (x, y, z) of the quaternion.
    pub v: Vector3<T>,
}

impl<T: Field> Quaternion<T> {
    /// The identity rotation.
    pub fn identity() -> Self {
        Self {
            w: T::one(),
            v: Vector3::zeros(),
        }
    }

    /// Quaternion from its components [w, x, y, z].
    pub fn from_parts([w, x, y, z]: [T; 4]) -> Self {
        Self {
            w,
            v: Vector3::new(x, y, z),
        }
    }

    /// Components [w, x, y, z] of the quaternion.
    pub fn parts(self) -> [T; 4] {
        [self.w, self.v.x, self.v.y, self.v.z]
    }

    /// Hamilton product `self` ⊗ `o`: applies the rotation `o` first, then `self`.
    pub fn times(self, o: Self) -> Self {
        Self {
            w: self.w * o.w - self.v.dot(&o.v),
            v: o.v * self.w + self.v * o.w + self.v.cross(&o.v),
        }
    }

    /// Conjugate quaternion: the inverse rotation, if the quaternion has unit norm.
    pub fn conjugate(self) -> Self {
        Self {
            w: self.w,
            v: -self.v,
        }
    }

    /// Rotates a vector: from components in the rotated frame to components in the original frame.
    pub fn carry(self, v: Vector3<T>) -> Vector3<T> {
        self.times(Self { w: T::zero(), v })
            .times(self.conjugate())
            .v
    }

    /// Inverse of [`carry`](Self::carry): from components in the original frame to components in the rotated frame.
    pub fn bring_back(self, v: Vector3<T>) -> Vector3<T> {
        self.conjugate().carry(v)
    }

    /// Unit vector along axis 1, 2 or 3 of the rotated frame, in components of the original frame.
    pub fn axis(self, axis: u8) -> Vector3<T> {
        self.carry(unit(axis))
    }

    /// Rotation matrix: the axes of the rotated frame as columns.
    pub fn matrix(self) -> Matrix3<T> {
        Matrix3::from_columns(&[self.axis(1), self.axis(2), self.axis(3)])
    }
}

impl<T: Real> Quaternion<T> {
    /// Rotation about axis 1, 2 or 3 by `angle`, rad.
    pub fn turn(axis: u8, angle: T) -> Self {
        let half = angle * T::lit(0.5);
        Self {
            w: half.cos(),
            v: unit::<T>(axis) * half.sin(),
        }
    }
}

impl Quaternion<f64> {
    /// Unit quaternion of a proper rotation matrix.
    pub fn from_matrix(m: &Matrix3<f64>) -> Self {
        let q = nalgebra::UnitQuaternion::from_matrix(m);
        Self {
            w: q.w,
            v: q.imag(),
        }
    }
}

/// Unit vector along coordinate axis 1, 2 or 3: (1, 0, 0), (0, 1, 0) or (0, 0, 1).
pub fn unit<T: Field>(axis: u8) -> Vector3<T> {
    let mut e = Vector3::zeros();
    e[usize::from(axis) - 1] = T::one();
    e
}
