//! Sampled spread of landings: throws drawn from the scatter, a flight for each, and quantile bands of their paths.

use flight::parallel::each_on;
use flight::throw::{FIELDS, Throw};
use nalgebra::{DVector, Matrix2, Vector2, Vector3};
use ode::IntegrationOptions;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::linear::Landings;
use super::scattered::Scattered;
use super::{Aims, SampleOptions};
use crate::design::goal::Obstacle;
use crate::design::throw_flight::{By, ThrowFlights};

/// Number of distances from the release with quantiles of the sampled paths.
const STATIONS: usize = 40;
/// Probabilities of the quantiles of lateral offset and height in each [`Band`].
pub const QUANTILES: [f64; 3] = [0.05, 0.5, 0.95];

/// Landings and paths of sampled flights.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// Mean and covariance of the landing positions.
    pub landings: Landings,
    /// Landing positions (x, y) of the sampled flights, m.
    pub points: Vec<Vector2<f64>>,
    /// Number of draws that cannot be flown.
    pub failed: usize,
    /// Number of flights that come within the radius of the landing circle of the target in the air.
    pub near_target: usize,
    /// Number of flights that enter the obstacle.
    pub touching: usize,
    /// Quantiles of the paths at increasing distances along the line to the mean landing of the linear spread.
    pub bands: Vec<Band>,
}

/// Quantiles of the paths where they first reach a distance along the line to the mean landing of the linear spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Distance from the release, m.
    pub distance: f64,
    /// Number of flights that reach it.
    pub flights: usize,
    /// Quantiles of the lateral offset from the line, left positive, m, at the probabilities [`QUANTILES`].
    pub left: [f64; 3],
    /// Quantiles of the height, m.
    pub height: [f64; 3],
}

/// What is kept of a sampled flight.
struct Drawn {
    landing: Vector2<f64>,
    /// Lateral offset and height where the path first reaches each station.
    passes: Vec<Option<(f64, f64)>>,
    is_near_target: bool,
    touches: bool,
}

/// Draws throws and parameters from the distribution `scattered` about those of `throw` and `flights`, and flies them;
/// `target` is the mean landing of the linear spread. `None` if fewer than three flights land.
pub(super) fn sampled(
    flights: &ThrowFlights<'_>,
    throw: &Throw,
    (target, aims): (Vector2<f64>, &Aims),
    scattered: &Scattered,
    options: &SampleOptions,
    settings: &IntegrationOptions,
) -> Option<Sampled> {
    let root = scattered.root();
    let n = scattered.by.len();
    let near = flights.state(throw, None).ok()?;
    let length = target.norm().max(1e-6);
    let (along, left) = (target / length, Vector2::new(-target.y, target.x) / length);
    let stations: Vec<f64> = (1..=STATIONS)
        .map(|k| 1.15 * length * k as f64 / STATIONS as f64)
        .collect();
    let flown = each_on(options.threads, options.count, |i| {
        // Each draw has its own random stream, so the number of threads has no effect.
        let mut random = ChaCha8Rng::seed_from_u64(options.seed);
        random.set_stream(i as u64);
        let normal = DVector::from_fn(n, |_, _| StandardNormal.sample(&mut random));
        let offset: DVector<f64> = &root * normal;
        let (mut moved, mut parameters) = (*throw, flights.parameters.clone());
        for (by, offset) in scattered.by.iter().zip(offset.iter()) {
            match by {
                By::Throw(field) => {
                    let name = FIELDS[*field].0;
                    let value = throw.field(name).unwrap_or(0.0) + offset;
                    moved.set(name, if name == "wobble" { value.abs() } else { value });
                }
                By::Parameter(place) => parameters[*place] += offset,
            }
        }
        let own = flights.body.with_parameters(parameters);
        let path = own.fly(&moved, Some(&near), settings).ok()?;
        let end = path.trajectory.end;
        let steps = 160;
        let places: Vec<Vector3<f64>> = (0..=steps)
            .map(|k| path.position(end * f64::from(k) / f64::from(steps)))
            .collect();
        let landing = places[places.len() - 1].xy();
        let passes = stations
            .iter()
            .map(|station| pass(&places, along, left, *station));
        let within = |place: Vector3<f64>, flat: bool, radius: f64| {
            let mut nearest = path.nearest_times(place, flat).into_iter();
            nearest.any(|t| {
                let away = path.position(t) - place;
                if flat {
                    away.xy().norm() < radius
                } else {
                    away.norm() <= radius
                }
            })
        };
        let axis = |o: &Obstacle| within(o.place.push(0.0), true, o.radius);
        Some(Drawn {
            landing,
            passes: passes.collect(),
            is_near_target: aims.target.is_some_and(|at| within(at, false, aims.circle)),
            touches: aims.obstacle.as_ref().is_some_and(axis),
        })
    });
    let flown: Vec<Drawn> = flown.into_iter().flatten().collect();
    let points: Vec<Vector2<f64>> = flown.iter().map(|drawn| drawn.landing).collect();
    if points.len() < 3 {
        return None;
    }
    let band = |(k, distance): (usize, &f64)| {
        let passes: Vec<(f64, f64)> = flown.iter().filter_map(|drawn| drawn.passes[k]).collect();
        // With fewer flights, the 5 % quantile would be an extreme value.
        (passes.len() >= 20).then(|| Band {
            distance: *distance,
            flights: passes.len(),
            left: quantiles(passes.iter().map(|pass| pass.0)),
            height: quantiles(passes.iter().map(|pass| pass.1)),
        })
    };
    Some(Sampled {
        bands: stations.iter().enumerate().filter_map(band).collect(),
        failed: options.count - points.len(),
        near_target: flown.iter().filter(|drawn| drawn.is_near_target).count(),
        touching: flown.iter().filter(|drawn| drawn.touches).count(),
        landings: moments(&points),
        points,
    })
}

/// Lateral offset, left positive, and height, m, where a path first reaches `station`, m, in the direction `along`.
fn pass(
    places: &[Vector3<f64>],
    along: Vector2<f64>,
    left: Vector2<f64>,
    station: f64,
) -> Option<(f64, f64)> {
    let reach = |place: &Vector3<f64>| place.xy().dot(&along) - station;
    let pair = places
        .windows(2)
        .find(|pair| reach(&pair[0]) < 0.0 && reach(&pair[1]) >= 0.0)?;
    let part = reach(&pair[0]) / (reach(&pair[0]) - reach(&pair[1]));
    let place = pair[0] + (pair[1] - pair[0]) * part;
    Some((place.xy().dot(&left), place.z))
}

fn quantiles(values: impl Iterator<Item = f64>) -> [f64; 3] {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    QUANTILES.map(|q| values[((values.len() - 1) as f64 * q).round() as usize])
}

/// Mean and sample covariance of landing positions, m.
pub fn moments(points: &[Vector2<f64>]) -> Landings {
    let count = points.len() as f64;
    let mean = points.iter().sum::<Vector2<f64>>() / count;
    let outer = |point: &Vector2<f64>| (point - mean) * (point - mean).transpose();
    Landings {
        mean,
        covariance: points.iter().map(outer).sum::<Matrix2<f64>>() / (count - 1.0),
    }
}
