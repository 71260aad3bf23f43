//! Disc-golf throws filmed from above: flown by the oracle with a computed aerodynamic table, from launches that are known within limits.

pub mod page;
mod read;

use flight::batch;
use model_spec::model::Model;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use oracle::{Physical, Point, Quaternion, Reference};
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};

pub use read::{disc, throws};

use crate::oracle_flights::{angle_of_attack, integrate_with_constants, set_curves};
use crate::real_data::wind_tunnel::{Measured, interpolated};

/// A disc: what it weighs and measures, and its table.
#[derive(Clone, Debug, PartialEq)]
pub struct Disc {
    /// Diameter, m.
    pub diameter: f64,
    /// Moments of inertia over the mass, m²: about a diameter, about the axis.
    pub inertia: [f64; 2],
    /// Lift, drag, pitching moment (nose-up negative) by angle of attack.
    pub table: Vec<Measured>,
}

/// Its mass, kg, as the paper of the throws states it.
const MASS: f64 = 0.175;

/// Density of the air that the paper reckons with, kg/m³.
const DENSITY: f64 = 1.225;

/// Roughness of the ground in the paper's wind by height, m, and the height at which the wind was measured.
const ROUGHNESS: (f64, f64) = (0.1, 1.5);

/// What is known of a launch.
pub const LAUNCH: [&str; 7] = [
    "speed",
    "pitch",
    "roll",
    "nose",
    "yaw",
    "tailwind",
    "crosswind",
];

/// How well: m/s and rad; the crosswind is taken to be as uncertain as the wind along the field.
pub const SPREAD: [f64; 7] = [0.6, RAD * 2.0, RAD * 5.0, RAD * 2.0, RAD * 2.0, 1.0, 1.0];

const RAD: f64 = std::f64::consts::PI / 180.0;

/// Factors on lift, drag and pitching moment of the table.
pub type Factors = [f64; 3];

/// How far a point of a track may be off, m: at a camera 100 m up, a disc 5 to 10 m high seems 5 to 10 % too far from its foot.
pub const TRACK: f64 = 1.0;

/// Between times so far apart a path is straight enough, s.
const PIECE: f64 = 0.02;

/// Points of a track that are compared: neighbours are off alike.
const POINTS: usize = 12;

/// A throw.
#[derive(Clone, Debug, PartialEq)]
pub struct Throw {
    /// Its number.
    pub number: u32,
    /// As [`LAUNCH`], SI.
    pub launch: [f64; 7],
    /// Spin, rad/s, and height of the hand, m.
    pub spin_and_height: [f64; 2],
    /// Times from the first, s, and places on the ground, m.
    pub track: Vec<(f64, [f64; 2])>,
}

/// Below this angle of attack (rad) the tabulated pitching moment is taken as 0.
const MIN_ALPHA: f64 = 1e-4;

/// Flies discs of one table.
pub struct Flyer<'a> {
    model: &'a Model,
    reference: Reference,
    constants: Point<f64>,
    table: &'a [Measured],
}

impl<'a> Flyer<'a> {
    /// For a disc, with the model's own damping of pitch and spin, of which the table says nothing.
    ///
    /// # Errors
    /// In words.
    pub fn new(model: &'a Model, disc: &'a Disc) -> Result<Self, String> {
        let reference = Reference::bind(model)
            .ok_or("the disc has no reference")?
            .map_err(|error| format!("{error:?}"))?;
        let mut constants = Point::defaults(model);
        let radius = disc.diameter / 2.0;
        let known = [
            ("m", MASS),
            ("I_d", MASS * disc.inertia[0]),
            ("I_a", MASS * disc.inertia[1]),
            ("d", disc.diameter),
            ("A", std::f64::consts::PI * radius * radius),
            ("rho", DENSITY),
        ];
        for (name, value) in known {
            let place = model.params.iter().position(|p| p.name == name);
            constants.params[place.ok_or(format!("the disc has no {name}"))?] = value;
        }
        if let Some(place) = model.coefficients.iter().position(|c| c.name == "C_Rr") {
            constants.coefficients[place] = 0.0;
        }
        Ok(Self {
            model,
            reference,
            constants,
            table: &disc.table,
        })
    }

    /// Where a throw is over the ground, at the times of its track; where it has come down it stays.
    pub fn track(
        &self,
        throw: &Throw,
        launch: &[f64; 7],
        factors: &Factors,
        times: &[f64],
    ) -> Vec<[f64; 2]> {
        let [speed, pitch, roll, nose, yaw, tail, side] = *launch;
        let wind = |height: f64| {
            let (rough, at) = ROUGHNESS;
            let part = ((height.max(0.0) + rough) / rough).ln() / ((at + rough) / rough).ln();
            Vector3::new(tail * part, side * part, 0.0)
        };
        let follow = |body: &Physical<f64>| self.constants_at(body, wind(body.position.z), factors);
        let turned = |v: Vector3<f64>| {
            let (sin, cos) = yaw.sin_cos();
            Vector3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z)
        };
        // The launch's angles as the paper's program takes them: the pitch is added to the attitude of a disc that is rolled.
        let bank = roll + roll.sin() * nose.sin() * pitch;
        let rise = nose + roll.cos() * pitch;
        let axis = turned(Vector3::new(
            -rise.sin(),
            bank.sin() * rise.cos(),
            bank.cos() * rise.cos(),
        ));
        let first = Vector3::x().cross(&axis).cross(&axis).normalize();
        let matrix = Matrix3::from_columns(&[first, axis.cross(&first), axis]);
        let [spin, height] = throw.spin_and_height;
        let start = Physical {
            position: Vector3::new(0.0, 0.0, height),
            velocity: turned(Vector3::new(speed * pitch.cos(), 0.0, speed * pitch.sin())),
            attitude: Quaternion::from_matrix(&matrix),
            // A right hand's backhand: clockwise, seen from above.
            angular_velocity: axis * -spin,
        };
        let last = times.last().copied().unwrap_or(0.0);
        let pieces = (last / PIECE).ceil().max(1.0);
        let fine: Vec<f64> = (0..=pieces as usize)
            .map(|k| k as f64 * last / pieces)
            .collect();
        let flown = integrate_with_constants(&self.reference, &follow, start, &fine);
        let path: Vec<Vector3<f64>> = flown.iter().map(|body| body.position).collect();
        let at = |time: f64| {
            let place = (time / last * pieces).clamp(0.0, pieces);
            let k = (place as usize).min(path.len().saturating_sub(2));
            path[k] + (path[k + 1] - path[k]) * (place - k as f64)
        };
        let ground = path.windows(2).find(|two| two[1].z < 0.0).map(|two| {
            let part = two[0].z / (two[0].z - two[1].z);
            two[0] + (two[1] - two[0]) * part
        });
        let down = fine.iter().zip(&path).find(|(_, place)| place.z < 0.0);
        let down = down.map_or(f64::INFINITY, |(time, _)| *time);
        let places = times.iter().map(|time| {
            let there = at(*time);
            let landed = *time >= down || there.z < 0.0;
            let there = ground.filter(|_| landed).unwrap_or(there);
            [there.x, there.y]
        });
        places.collect()
    }

    fn constants_at(
        &self,
        body: &Physical<f64>,
        wind: Vector3<f64>,
        factors: &Factors,
    ) -> Point<f64> {
        let alpha = angle_of_attack(body, wind);
        let found = interpolated(self.table, alpha);
        let mut here = self.constants.clone();
        if let Some(place) = here.inputs.first_mut() {
            *place = wind;
        }
        let curves = [0, 1, 2].map(|k| factors[k] * found[k]);
        set_curves(self.model, &mut here, alpha, curves, MIN_ALPHA);
        here
    }
}

/// The points of a throw's track that are compared.
pub fn compared(throw: &Throw) -> Vec<(f64, [f64; 2])> {
    let last = throw.track.len().saturating_sub(1);
    (1..=POINTS)
        .filter_map(|k| throw.track.get(k * last / POINTS).copied())
        .collect()
}

/// What launches within their limits do: the middle and the standard deviation of the place where the track ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Mean of the last place, m.
    pub mean: [f64; 2],
    /// Its standard deviation, m.
    pub spread: [f64; 2],
    /// Part of the draws whose root mean square distance from the track is below [`TRACK`] along each axis.
    pub within: f64,
}

/// Draws launches.
pub fn band(flyer: &Flyer<'_>, throw: &Throw, draws: usize, seed: u64) -> Band {
    let points = compared(throw);
    let times: Vec<f64> = points.iter().map(|p| p.0).collect();
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let launches: Vec<[f64; 7]> = (0..draws)
        .map(|_| {
            std::array::from_fn(|k| {
                let size: f64 = StandardNormal.sample(&mut random);
                throw.launch[k] + SPREAD[k] * size
            })
        })
        .collect();
    let tracks = batch::each(draws, |k| {
        flyer.track(throw, &launches[k], &[1.0; 3], &times)
    });
    let count = draws.max(1) as f64;
    let last = |k: usize| tracks.iter().filter_map(move |t| Some(t.last()?[k]));
    let mean = [0, 1].map(|k| last(k).sum::<f64>() / count);
    let spread =
        [0, 1].map(|k| (last(k).map(|x| (x - mean[k]).powi(2)).sum::<f64>() / count).sqrt());
    let within = tracks
        .iter()
        .filter(|track| distance(track, &points) < TRACK)
        .count();
    Band {
        mean,
        spread,
        within: within as f64 / count,
    }
}

/// Root mean square of the distance of a coordinate, m.
pub fn distance(track: &[[f64; 2]], points: &[(f64, [f64; 2])]) -> f64 {
    let squares = track
        .iter()
        .zip(points)
        .flat_map(|(a, (_, b))| [a[0] - b[0], a[1] - b[1]]);
    let squares: f64 = squares.map(|d| d * d).sum();
    (squares / (2 * points.len().max(1)) as f64).sqrt()
}

/// A launch fitted to its track, what is known of it held as priors.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitted {
    /// The launch before and after leaves so much, m.
    pub rms: [f64; 2],
    /// By how many of their standard deviations the launch's numbers move.
    pub moved: [f64; 7],
    /// Factors on lift, drag, moment, where they are fitted.
    pub factors: Factors,
    /// Their standard errors.
    pub errors: Factors,
}

/// How uncertain a factor is taken to be where it is fitted.
const FACTOR: f64 = 1.0;

/// Fits a launch by steps of Gauss and Newton, with factors on the table or without.
pub fn fitted(flyer: &Flyer<'_>, throw: &Throw, with_factors: bool) -> Option<Fitted> {
    let points = compared(throw);
    let times: Vec<f64> = points.iter().map(|p| p.0).collect();
    let count = if with_factors { 10 } else { 7 };
    let fly = |sizes: &[f64]| {
        let launch = std::array::from_fn(|k| throw.launch[k] + SPREAD[k] * sizes[k]);
        let factors = std::array::from_fn(|k| 1.0 + FACTOR * sizes.get(7 + k).unwrap_or(&0.0));
        flyer.track(throw, &launch, &factors, &times)
    };
    let left = |sizes: &[f64]| {
        let track = fly(sizes);
        let apart = track
            .iter()
            .zip(&points)
            .flat_map(|(a, (_, b))| [b[0] - a[0], b[1] - a[1]]);
        let apart = apart
            .map(|d| d / TRACK)
            .chain(sizes.iter().map(|size| -size));
        DVector::from_iterator(2 * points.len() + count, apart)
    };
    let mut sizes = vec![0.0; count];
    let mut here = left(&sizes);
    let mut covariance = DMatrix::identity(count, count);
    for _ in 0..8 {
        const STEP: f64 = 0.05;
        let columns = batch::each(count, |k| {
            let mut moved = sizes.clone();
            moved[k] += STEP;
            (&here - left(&moved)) / STEP
        });
        let design = DMatrix::from_columns(&columns);
        covariance = (design.transpose() * &design).try_inverse()?;
        let step = &covariance * (design.transpose() * &here);
        // Half steps until it is better.
        let mut part = 1.0;
        let better = (0..6).find_map(|_| {
            let next: Vec<f64> = sizes
                .iter()
                .zip(step.iter())
                .map(|(s, d)| s + part * d)
                .collect();
            part /= 2.0;
            let there = left(&next);
            (there.norm_squared() < here.norm_squared()).then_some((next, there))
        });
        let Some((next, there)) = better else { break };
        let gain = here.norm_squared() - there.norm_squared();
        (sizes, here) = (next, there);
        if gain < 1e-3 {
            break;
        }
    }
    let factor = |k: usize| 1.0 + FACTOR * sizes.get(7 + k).unwrap_or(&0.0);
    let error = |k: usize| match with_factors {
        true => FACTOR * covariance[(7 + k, 7 + k)].max(0.0).sqrt(),
        false => 0.0,
    };
    Some(Fitted {
        rms: [
            distance(&fly(&vec![0.0; count]), &points),
            distance(&fly(&sizes), &points),
        ],
        moved: std::array::from_fn(|k| sizes[k]),
        factors: std::array::from_fn(factor),
        errors: std::array::from_fn(error),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc whose table is that of a smooth made-up one.
    fn made() -> Disc {
        let row = |k: i32| {
            let alpha = f64::from(k).to_radians();
            Measured {
                alpha,
                coefficients: [
                    0.1 + 2.5 * alpha,
                    0.06 + 2.0 * alpha * alpha,
                    0.01 - 0.2 * alpha,
                ],
            }
        };
        Disc {
            diameter: 0.21,
            inertia: [3.7e-3, 7.4e-3],
            table: (-45..=45).step_by(5).map(row).collect(),
        }
    }

    #[test]
    fn a_launch_is_fitted_to_the_track_of_another() {
        let (disc, model) = (made(), crate::oracle_flights::disc());
        let flyer = Flyer::new(&model, &disc).unwrap();
        let launch = [22.0, 0.15, 0.1, 0.0, 0.1, 2.0, 0.0];
        let mut throw = Throw {
            number: 1,
            launch,
            spin_and_height: [120.0, 1.5],
            track: Vec::new(),
        };
        let times: Vec<f64> = (0..60).map(|k| f64::from(k) * 0.04).collect();
        let mut other = launch;
        other[0] += 1.2;
        other[4] += 4.0 * RAD;
        let track = flyer.track(&throw, &other, &[1.0; 3], &times);
        throw.track = times.into_iter().zip(track).collect();
        let found = fitted(&flyer, &throw, false).unwrap();
        assert!(found.rms[0] > 1.5 && found.rms[1] < 0.3, "{found:?}");
        assert!(found.moved[0] > 1.0 && found.moved[4] > 1.0, "{found:?}");
    }

    #[test]
    fn what_has_landed_stays() {
        let (disc, model) = (made(), crate::oracle_flights::disc());
        let flyer = Flyer::new(&model, &disc).unwrap();
        let throw = Throw {
            number: 1,
            launch: [15.0, -0.2, 0.0, 0.0, 0.0, 0.0, 0.0],
            spin_and_height: [100.0, 0.5],
            track: Vec::new(),
        };
        let track = flyer.track(&throw, &throw.launch, &[0.0, 0.0, 0.0], &[0.1, 1.0, 2.0]);
        // Without air: down where 0.5 - 15 sin(0.2) t - g t²/2 is 0.
        let fall = 15.0 * 0.2_f64.sin();
        let time = (-fall + (fall * fall + 2.0 * 9.81 * 0.5).sqrt()) / 9.81;
        assert!(
            (track[1][0] - 15.0 * 0.2_f64.cos() * time).abs() < 0.01,
            "{track:?}"
        );
        assert_eq!(track[1], track[2]);
    }
}
