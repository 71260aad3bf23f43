//! Free flights of a spinning disc with markers, by an integrator of the test's own.

use nalgebra::{Matrix3, Rotation3, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

/// Settings of simulated flights of a disc whose markers are measured.
#[derive(Clone, Copy)]
pub struct Plan {
    pub flights: usize,
    pub rate: f64,
    pub sigma: f64,
    /// Maximum angular rate of the disc about a diameter (wobble), rad/s.
    pub wobble: f64,
    /// Minimum and maximum spin of the disc, rad/s.
    pub spin: (f64, f64),
    pub seconds: (f64, f64),
    /// Fraction of the marker positions that are missing.
    pub gaps: f64,
    /// Fraction of the marker positions that are outliers, with an error of several centimetres.
    pub outliers: f64,
    /// Whether the flights begin with the disc upside down.
    pub inverted: bool,
}

pub const USUAL: Plan = Plan {
    flights: 8,
    rate: 200.0,
    sigma: 0.001,
    wobble: 2.0,
    spin: (35.0, 65.0),
    seconds: (0.5, 1.0),
    gaps: 0.03,
    outliers: 0.0,
    inverted: false,
};

pub type Rows = Vec<Vec<Option<[f64; 3]>>>;

/// Simulated flights, as times and measured marker positions, with the true marker positions on the body.
pub struct Flights {
    pub markers: Vec<[f64; 3]>,
    pub flights: Vec<(Vec<f64>, Rows)>,
}

#[derive(Clone, Copy)]
struct State {
    x: Vector3<f64>,
    v: Vector3<f64>,
    r: Matrix3<f64>,
    /// Angular velocity of the disc in body axes, rad/s.
    w: Vector3<f64>,
}

/// Linear acceleration in axes of the room and angular acceleration in body axes of a simulated disc with lift, drag
/// and aerodynamic moments.
fn law(s: &State) -> (Vector3<f64>, Vector3<f64>) {
    let (m, ia, id, d, rho) = (0.175, 0.00235, 0.00122, 0.27, 1.2);
    let area = std::f64::consts::PI * d * d / 4.0;
    let speed = s.v.norm();
    let own = s.r.transpose() * s.v;
    let flat = own.x.hypot(own.y).max(1e-9);
    let alpha = (-own.z).atan2(flat);
    let q = 0.5 * rho * speed * speed * area;
    let along = s.v / speed;
    let axis = s.r.column(2).into_owned();
    let up = (axis - along * axis.dot(&along)).normalize();
    let force = up * (q * (0.15 + 2.8 * alpha)) - along * (q * (0.10 + 1.6 * alpha * alpha));
    let forward = Vector3::new(own.x / flat, own.y / flat, 0.0);
    let left = Vector3::z().cross(&forward);
    let arm = 0.5 * q * d;
    let roll = -0.0006 * s.w.z - 0.008 * s.w.dot(&forward);
    let pitch = -0.30 * alpha - 0.008 * s.w.dot(&left);
    let moment = forward * (arm * roll) + left * (arm * pitch) - Vector3::z() * (5e-5 * s.w.z);
    let inertia = Vector3::new(id, id, ia);
    let momentum = inertia.component_mul(&s.w);
    let turn = (moment - s.w.cross(&momentum)).component_div(&inertia);
    (force / m - Vector3::z() * 9.81, turn)
}

fn step(s: &State, h: f64) -> State {
    // Midpoint rule, with the rotation as an exponential.
    let half = advance(s, s, 0.5 * h);
    advance(s, &half, h)
}

fn advance(from: &State, at: &State, h: f64) -> State {
    let (a, turn) = law(at);
    State {
        x: from.x + at.v * h,
        v: from.v + a * h,
        r: from.r * Rotation3::new(at.w * h).into_inner(),
        w: from.w + turn * h,
    }
}

/// Simulates the flights of the disc with the settings `plan`; the same seed gives the same flights.
pub fn flights(plan: &Plan, seed: u64) -> Flights {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let r = &mut random;
    let count = r.random_range(3..6);
    let phase: f64 = r.random_range(0.0..6.0);
    let markers: Vec<[f64; 3]> = (0..count)
        .map(|k| {
            let angle = phase
                + f64::from(k) * std::f64::consts::TAU / f64::from(count)
                + r.random_range(-0.4..0.4);
            let radius = r.random_range(0.05..0.12);
            [
                radius * angle.cos(),
                radius * angle.sin(),
                r.random_range(0.005..0.02),
            ]
        })
        .collect();
    let noise = Normal::new(0.0, plan.sigma).expect("a width");
    let flights = (0..plan.flights).map(|_| {
        let speed = r.random_range(9.0..18.0);
        let launch: f64 = r.random_range(-0.05..0.25);
        let nose: f64 = r.random_range(-0.08..0.3);
        let turned = |axis: Vector3<f64>, angle: f64| Rotation3::new(axis * angle).into_inner();
        let spin = r.random_range(plan.spin.0..plan.spin.1.max(plan.spin.0 + 1e-9));
        let sign = if r.random_bool(0.3) { 1.0 } else { -1.0 };
        let flip = if plan.inverted {
            std::f64::consts::PI
        } else {
            0.0
        };
        let mut w = || r.random_range(-1.0..1.0) * plan.wobble;
        let (wx, wy) = (w(), w());
        let mut state = State {
            x: Vector3::new(0.0, 0.0, 2.0),
            v: Vector3::new(speed * launch.cos(), 0.0, speed * launch.sin()),
            r: turned(Vector3::x(), r.random_range(-0.4..0.4) + flip)
                * turned(Vector3::y(), -launch - nose)
                * turned(Vector3::z(), r.random_range(-3.0..3.0)),
            w: Vector3::new(wx, wy, sign * spin),
        };
        let samples = (r.random_range(plan.seconds.0..plan.seconds.1) * plan.rate) as usize;
        let (mut times, mut rows) = (Vec::new(), Vec::new());
        let steps = (5000.0 / plan.rate).ceil() as usize;
        for sample in 0..samples {
            times.push(3.0 + sample as f64 / plan.rate);
            let row = markers.iter().map(|marker| {
                let exact = state.x + state.r * Vector3::from(*marker);
                let mut noisy = || noise.sample(r);
                let mut seen = exact + Vector3::new(noisy(), noisy(), noisy());
                if r.random_bool(plan.outliers) {
                    seen += Vector3::new(
                        r.random_range(-0.08..0.08),
                        r.random_range(-0.08..0.08),
                        0.03,
                    );
                }
                (!r.random_bool(plan.gaps)).then_some([seen.x, seen.y, seen.z])
            });
            rows.push(row.collect());
            for _ in 0..steps {
                state = step(&state, 1.0 / (plan.rate * steps as f64));
            }
        }
        (times, rows)
    });
    let flights = flights.collect();
    Flights { markers, flights }
}
