//! The next throw: of many that could be made, the one after which the remaining causes would look least alike.

use flight::batch;
use identify::{
    FitProblem, Iterate, Loss, NoiseModel, NormalBlock, Observations, RigidMotion, Unknowns,
    eliminate, linearise, state_for_motion,
};
use nalgebra::{DMatrix, DVector, UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use crate::bench::Bench;
use crate::causes::Cause;
use crate::report::NextThrow;
use crate::scores::inverse;

/// Releases that are tried.
const TRIED: usize = 96;

/// How long each is watched, s, and samples each second.
const WATCHED: (f64, f64) = (1.5, 120.0);

/// Heights of release, m.
const HEIGHT: f64 = 1.5;

/// Two causes that are so many standard deviations apart are told apart.
const APART: f64 = 3.0;

/// A throw that separates them by no more than this times what is there already is none that helps.
const HELPS: f64 = 1.3;

/// A release.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Release {
    speed: f64,
    climb: f64,
    nose: f64,
    hyzer: f64,
    spin: f64,
    heading: f64,
}

impl Release {
    fn draw(random: &mut ChaCha12Rng) -> Self {
        let mut even = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
        let whole = std::f64::consts::TAU;
        Self {
            speed: even(6.0, 24.0),
            climb: even(-0.1, 0.5),
            nose: even(-0.15, 0.4),
            hyzer: even(-0.6, 0.6),
            heading: (even(0.0, 8.0).floor() / 8.0) * whole,
            spin: even(20.0, 90.0) * if even(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 },
        }
    }

    /// How the body moves at it.
    fn motion(&self, turns: bool) -> RigidMotion {
        let about = UnitQuaternion::from_axis_angle;
        let path = about(&Vector3::z_axis(), self.heading) * about(&Vector3::y_axis(), -self.climb);
        let attitude =
            path * about(&Vector3::x_axis(), self.hyzer) * about(&Vector3::y_axis(), -self.nose);
        RigidMotion {
            position: Vector3::new(0.0, 0.0, HEIGHT),
            velocity: path * Vector3::new(self.speed, 0.0, 0.0),
            attitude: turns.then_some(attitude),
            rates: turns.then(|| attitude * Vector3::new(0.0, 0.0, self.spin)),
        }
    }
}

/// The throw that would best separate some causes, and by how much; none where there are not two of them.
pub fn next_throw(
    bench: &Bench,
    causes: &[Cause],
    blocks: &[NormalBlock],
    noise: &NoiseModel,
    seed: u64,
) -> Option<NextThrow> {
    let best = causes.first()?;
    if causes.len() < 2 || bench.observation_sets.is_empty() {
        return None;
    }
    let known = information(bench, blocks)?;
    let now = separation(bench, causes, &known);
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let releases: Vec<Release> = (0..TRIED).map(|_| Release::draw(&mut random)).collect();
    let tried = batch::each_on(bench.threads, releases.len(), |index| {
        let more = flown((bench, &best.problem), &releases[index], &best.point, noise)?;
        let more = information_of(bench, &more)?;
        Some(separation(bench, causes, &(&known + more)))
    });
    let each = tried.into_iter().zip(&releases);
    let (after, release) = each
        .filter_map(|(after, release)| Some((after?, release)))
        .max_by(|a, b| a.0.total_cmp(&b.0))?;
    let degrees = |angle: f64| format!("{:.0}°", angle.to_degrees());
    let says = if after < APART && after < HELPS * now.max(1.0) {
        format!(
            "none helps: after the best of {TRIED} throws that were tried the causes would still be {after:.1} standard deviations \
             apart ({now:.1} now). Measure what they stand for by other means."
        )
    } else {
        format!(
            "throw at {:.0} m/s, climbing {}, nose {} to the path, leaning {}, with a spin of {:.0} rad/s, heading {}: the causes that are most alike \
             would be {after:.1} standard deviations apart ({now:.1} now)",
            release.speed,
            degrees(release.climb),
            degrees(release.nose),
            degrees(release.hyzer),
            release.spin,
            degrees(release.heading)
        )
    };
    Some(NextThrow {
        says,
        speed: release.speed,
        climb: release.climb,
        nose: release.nose,
        hyzer: release.hyzer,
        spin: release.spin,
        heading: release.heading,
        separation: after,
        separation_now: now,
    })
}

/// The normal equations of a throw that nobody has made yet.
fn flown(
    (bench, problem): (&Bench, &FitProblem),
    release: &Release,
    at: &Iterate,
    noise: &NoiseModel,
) -> Option<NormalBlock> {
    let count = (WATCHED.0 * WATCHED.1) as usize;
    let mut parameters = bench.observation_sets[0].parameters.clone();
    let layout = problem.body.layout();
    if !problem.has_attitude && layout.parameter("omega_x").is_some() {
        let axis = release.motion(true).rates?;
        for (name, value) in ["omega_x", "omega_y", "omega_z"].iter().zip(axis.iter()) {
            parameters[layout.parameter(name)?.index()] = *value;
        }
    }
    let observations = Observations {
        times: (0..count).map(|k| k as f64 / WATCHED.1).collect(),
        measured: vec![Some([0.0; 3]); count * problem.markers.len()],
        outlier: vec![false; count * problem.markers.len()],
        parameters,
        known_states: Vec::new(),
        ..bench.observation_sets[0].clone()
    };
    let local = state_for_motion(
        problem,
        &observations,
        &release.motion(problem.has_attitude),
    )
    .ok()?;
    let unknowns = (&at.global, &local);
    linearise(
        problem,
        &observations,
        unknowns,
        count,
        Unknowns::All,
        Loss::Whitened(noise),
    )
    .ok()
}

fn information(bench: &Bench, blocks: &[NormalBlock]) -> Option<DMatrix<f64>> {
    let size = bench.problem.globals.len();
    let mut sum = DMatrix::zeros(size, size);
    for block in blocks {
        sum += information_of(bench, block)?;
    }
    Some(sum)
}

/// The information of the shared unknowns once a flight's own are eliminated.
fn information_of(bench: &Bench, block: &NormalBlock) -> Option<DMatrix<f64>> {
    let size = bench.problem.globals.len();
    let blocks = [block.clone()];
    let system = eliminate(&blocks, 1e-12).ok()?;
    Some(system.reduced.view((0, 0), (size, size)).clone_owned())
}

/// By how many standard deviations the two causes that are most alike differ, each taken for the true one in turn.
fn separation(bench: &Bench, causes: &[Cause], information: &DMatrix<f64>) -> f64 {
    let columns = |cause: &Cause| -> Vec<usize> {
        let each = cause.effects.iter();
        each.flat_map(|&e| bench.candidates[e].global.clone())
            .collect()
    };
    let mut least = f64::INFINITY;
    for truth in causes {
        for other in causes {
            let local: Vec<usize> = columns(truth)
                .into_iter()
                .filter(|c| !columns(other).contains(c))
                .collect();
            if local.is_empty() {
                continue;
            }
            let mut free = bench.base.clone();
            free.extend(columns(other));
            let part = |rows: &[usize], columns: &[usize]| {
                DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
                    information[(rows[i], columns[j])]
                })
            };
            let Some(inverse) = inverse(&part(&free, &free)) else {
                continue;
            };
            let cross = part(&free, &local);
            let left = part(&local, &local) - cross.tr_mul(&(inverse * &cross));
            let size = DVector::from_fn(local.len(), |i, _| {
                let unknown = local[i];
                truth.point.global[unknown] - bench.problem.globals[unknown].model_value
            });
            least = least.min(size.dot(&(left * &size)).max(0.0).sqrt());
        }
    }
    if least.is_finite() { least } else { 0.0 }
}
