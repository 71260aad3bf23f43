//! The measured path of a body's origin, with velocities and accelerations from fitted parabolas.

use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

use super::Body;
use crate::Flight;
use crate::contact::{self, Contact, ContactSearch, PathPoint};
use crate::levels::UNLIKE;
use crate::pose::{Pose, pose};
use crate::seen_path::path_noise;
use crate::statistics::robust_sigma;

/// Minimum number of points of a measured path to which a parabola is fitted.
pub const MIN_POINTS: usize = 6;
/// Target standard error of the acceleration in a window, relative to the flight's mean acceleration.
const WINDOW_ERROR: f64 = 0.04;
/// Minimum and maximum number of windows of a flight.
const WINDOWS: [usize; 2] = [4, 14];

/// Measured path of the body's origin in one flight.
#[derive(Clone, Debug)]
pub struct Track {
    /// Times and positions of the body's origin, one point for each sample in which the position could be determined.
    pub points: Vec<PathPoint>,
    /// Standard deviation of the noise of one coordinate of the measured position of the body's origin, m.
    pub noise: f64,
}

/// Motion at the middle of a time window, from the parabola through its points.
#[derive(Clone, Copy, Debug)]
pub struct Parabola {
    pub velocity: Vector3<f64>,
    /// Acceleration of the body's origin in the time window, m/s²; a parabola in time has a constant acceleration.
    pub acceleration: Vector3<f64>,
    /// Standard error of a component of the acceleration, m/s².
    pub error: f64,
    pub half: f64,
    /// Standard deviation of one coordinate of the measured points about the parabola, m.
    pub deviation: f64,
}

/// Change of the coordinates in which positions and attitudes are recorded.
#[derive(Clone, Copy, Debug)]
pub struct Conversion {
    /// Factor of the positions: a rotation or reflection, times a unit of length.
    pub space: Matrix3<f64>,
    /// Rotation, or with a reflection of the space reflection, from new to recorded body components.
    pub body: Matrix3<f64>,
}

impl Conversion {
    fn apply(&self, point: &mut PathPoint) {
        point.position = self.space * point.position;
        let scale = self.space.determinant().abs().cbrt();
        point.attitude = point.attitude.map(|attitude| {
            let turned = self.space / scale * attitude.to_rotation_matrix() * self.body;
            UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(turned))
        });
    }
}

impl Track {
    /// Path of the body's origin, from its poses or the markers of a point mass, and the poses.
    pub fn of(body: &dyn Body, flight: &Flight) -> (Self, Vec<Option<Pose>>) {
        let rows = body.points().of(flight);
        let has_attitude = body.points().has_attitude;
        let poses: Vec<Option<Pose>> = match has_attitude {
            true => rows
                .iter()
                .map(|row| pose(&body.points().markers, row))
                .collect(),
            false => Vec::new(),
        };
        let mut points = contact::path(body.points(), &flight.times, &poses, |k| &rows[k]);
        // Poses that contain outliers are not on the path.
        points.retain(|point| point.attitude.is_some() == has_attitude);
        (Self::through(points), poses)
    }

    fn through(points: Vec<PathPoint>) -> Self {
        let noise = path_noise(points.iter().map(|point| (point.time, point.position)));
        Self { points, noise }
    }

    /// Path up to the first contact, and the result of the search for it.
    pub fn until_contact(body: &dyn Body, flight: &Flight) -> (Self, ContactSearch) {
        let (track, poses) = Self::of(body, flight);
        let (track, contact) = track.cut();
        (track, ContactSearch { contact, poses })
    }

    /// Path up to the first contact in other coordinates than the recorded ones.
    pub fn converted(body: &dyn Body, flight: &Flight, conversion: &Conversion) -> Self {
        let mut points = Self::of(body, flight).0.points;
        points.iter_mut().for_each(|point| conversion.apply(point));
        Self::through(points).cut().0
    }

    fn cut(mut self) -> (Self, Option<Contact>) {
        let contact = contact::first_change(&self.points);
        if let Some(contact) = &contact {
            self.points.retain(|point| point.sample < contact.sample);
        }
        (self, contact)
    }

    /// Extent of the path, m: the largest of the ranges of its x, y and z coordinates.
    pub fn extent(&self) -> f64 {
        let extent = |axis: usize| {
            let values = || self.points.iter().map(|point| point.position[axis]);
            values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min)
        };
        (0..3).map(extent).fold(0.0, f64::max)
    }

    /// Divides the path into windows, longer for noisier paths, so that the error of the acceleration is about
    /// `WINDOW_ERROR`, and fits a parabola to each; empty if none can be fitted to the path.
    pub fn windows(&self) -> Vec<(std::ops::Range<usize>, Parabola)> {
        let count = self.points.len();
        let Some(whole) = parabola(&self.points, self.noise) else {
            return Vec::new();
        };
        let step = 2.0 * whole.half / (count - 1) as f64;
        let wanted = WINDOW_ERROR * whole.acceleration.norm();
        let length = (720.0 * (self.noise / (wanted * step * step)).powi(2)).powf(0.2);
        let [fewest, most] = WINDOWS.map(|windows| count / windows);
        let length = match length.is_finite() {
            true => (length as usize).clamp(most.max(MIN_POINTS), fewest.max(MIN_POINTS).max(most)),
            false => fewest.max(MIN_POINTS),
        };
        let windows = count / length;
        (0..windows)
            .filter_map(|window| {
                let range = window * count / windows..(window + 1) * count / windows;
                let parabola = parabola(&self.points[range.clone()], self.noise)?;
                Some((range, parabola))
            })
            .collect()
    }
}

/// Least-squares parabola in time, refitted once without outliers; `noise`, m, is the least that is assumed.
pub fn parabola(points: &[PathPoint], noise: f64) -> Option<Parabola> {
    let (first, last) = (points.first()?, points.last()?);
    let time = 0.5 * (first.time + last.time);
    let half = 0.5 * (last.time - first.time);
    if points.len() < MIN_POINTS || half <= 0.0 {
        return None;
    }
    let origin = first.position;
    let mut kept = vec![true; points.len()];
    for pass in 0.. {
        let mut normal = Matrix3::zeros();
        let mut right = Matrix3::zeros();
        let mut count = 0;
        for (point, _) in points.iter().zip(&kept).filter(|(_, kept)| **kept) {
            let s = (point.time - time) / half;
            let row = Vector3::new(1.0, s, s * s);
            normal += row * row.transpose();
            right += row * (point.position - origin).transpose();
            count += 1;
        }
        let inverse = normal.try_inverse()?;
        let solved = inverse * right;
        let residual = |point: &PathPoint| {
            let s = (point.time - time) / half;
            let row = Vector3::new(1.0, s, s * s);
            point.position - origin - solved.tr_mul(&row)
        };
        let mut sizes: Vec<f64> = points
            .iter()
            .flat_map(|p| <[f64; 3]>::from(residual(p).abs()))
            .collect();
        let robust = robust_sigma(&mut sizes).max(noise);
        let keep: Vec<bool> = points
            .iter()
            .map(|p| residual(p).amax() <= UNLIKE * robust.max(1e-9))
            .collect();
        let left = keep.iter().filter(|keep| **keep).count();
        if pass > 0 || keep == kept || left < MIN_POINTS {
            let row = |k: usize| Vector3::new(solved[(k, 0)], solved[(k, 1)], solved[(k, 2)]);
            let squares: f64 = (points.iter().zip(&kept).filter(|(_, kept)| **kept))
                .map(|(point, _)| residual(point).norm_squared())
                .sum();
            let deviation = (squares / f64::from((3 * (count - 3)).max(1))).sqrt();
            return Some(Parabola {
                velocity: row(1) / half,
                acceleration: 2.0 * row(2) / (half * half),
                error: 2.0 * deviation.max(noise) * inverse[(2, 2)].sqrt() / (half * half),
                half,
                deviation,
            });
        }
        kept = keep;
    }
    None
}
