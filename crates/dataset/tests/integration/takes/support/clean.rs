//! Recordings of nothing but a free flight: a disc with lift, drag, moments and wobble, from an integrator of the test's own.

use dataset::takes::{Format, LengthUnit, Point, Take};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

type V = [f64; 3];
type Q = [f64; 4];

fn add(a: V, b: V, s: f64) -> V {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V, b: V) -> V {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn scaled(a: V, s: f64) -> V {
    a.map(|x| s * x)
}

/// Simulated disc. Its force coefficients are multiplied by ½ρA/mass (1/m), its moment coefficients by ½ρAd divided by
/// the moment of inertia about a diameter (1/m²).
struct Disc {
    lift: (f64, f64),
    drag: (f64, f64),
    pitch: f64,
    damping: f64,
    /// Moment of inertia about the spin axis divided by that about a diameter.
    ratio: f64,
}

/// State of the disc: position and velocity in axes of the room, attitude from body to room, angular velocity in body
/// axes.
#[derive(Clone, Copy)]
struct State {
    x: V,
    v: V,
    q: Q,
    w: V,
}

impl Disc {
    fn rate(&self, s: &State) -> State {
        let axis = dataset::takes::rotated(s.q, [0.0, 0.0, 1.0]);
        let speed = dot(s.v, s.v).sqrt();
        let along = scaled(s.v, 1.0 / speed);
        let side = cross(axis, along);
        let side = scaled(side, 1.0 / dot(side, side).sqrt().max(1e-9));
        let up = cross(along, side);
        let attack = -dot(axis, along).asin();
        let squared = speed * speed;
        let lift = squared * (self.lift.0 + self.lift.1 * attack);
        let drag = squared * (self.drag.0 + self.drag.1 * attack * attack);
        let air = add(scaled(up, lift), along, -drag);
        // Moments along the room's axes over the inertia about a diameter, then along the body's.
        let moment = scaled(side, -squared * self.pitch * attack);
        let back = [s.q[0], -s.q[1], -s.q[2], -s.q[3]];
        let moment = dataset::takes::rotated(back, moment);
        let (k, [p, q, r]) = (self.ratio, s.w);
        let slow = self.damping * squared;
        let w = [
            (1.0 - k) * q * r + moment[0] - slow * p,
            (k - 1.0) * p * r + moment[1] - slow * q,
            0.0,
        ];
        let [a, b, c, d] = s.q;
        let q = [
            0.5 * (-b * p - c * q - d * r),
            0.5 * (a * p + c * r - d * q),
            0.5 * (a * q - b * r + d * p),
            0.5 * (a * r + b * q - c * p),
        ];
        State {
            x: s.v,
            v: add(air, [0.0, 0.0, -9.81], 1.0),
            q,
            w,
        }
    }

    fn step(&self, s: &State, dt: f64) -> State {
        let moved = |k: &State, h: f64| State {
            x: add(s.x, k.x, h),
            v: add(s.v, k.v, h),
            q: [0, 1, 2, 3].map(|i| s.q[i] + h * k.q[i]),
            w: add(s.w, k.w, h),
        };
        let a = self.rate(s);
        let b = self.rate(&moved(&a, 0.5 * dt));
        let c = self.rate(&moved(&b, 0.5 * dt));
        let d = self.rate(&moved(&c, dt));
        let mut next = *s;
        for (k, h) in [(a, 1.0), (b, 2.0), (c, 2.0), (d, 1.0)] {
            let h = h * dt / 6.0;
            next.x = add(next.x, k.x, h);
            next.v = add(next.v, k.v, h);
            next.q = [0, 1, 2, 3].map(|i| next.q[i] + h * k.q[i]);
            next.w = add(next.w, k.w, h);
        }
        let norm = next.q.iter().map(|x| x * x).sum::<f64>().sqrt();
        next.q = next.q.map(|x| x / norm);
        next
    }
}

/// Simulates a recording of one free flight of a disc, in m with z up; also returns the maximum lift acceleration,
/// m/s².
pub fn clean_flight(seed: u64) -> (Take, f64) {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let r = &mut random;
    let rate = [100.0, 120.0, 200.0, 240.0][r.random_range(0..4)];
    let noise = Normal::new(0.0, r.random_range(0.0003..0.0015)).expect("a width");
    let seconds = r.random_range(0.4..1.2);
    let disc = Disc {
        lift: (r.random_range(0.01..0.05), r.random_range(0.2..0.6)),
        drag: (r.random_range(0.015..0.04), r.random_range(0.1..0.35)),
        pitch: r.random_range(0.0..3.0),
        damping: r.random_range(0.002..0.05),
        ratio: 1.93,
    };
    let speed: f64 = r.random_range(7.0..28.0);
    let (heading, launch): (f64, f64) = (r.random_range(-3.1..3.1), r.random_range(-0.1..1.1));
    let (attack, bank): (f64, f64) = (r.random_range(-0.1..0.3), r.random_range(-0.6..0.6));
    let nose = launch + attack;
    // Yaw, then pitch about −y, then roll about x.
    let turn = |angle: f64, axis: V| {
        let (s, c) = (0.5 * angle).sin_cos();
        [c, s * axis[0], s * axis[1], s * axis[2]]
    };
    let product = |a: Q, b: Q| {
        let (va, vb) = ([a[1], a[2], a[3]], [b[1], b[2], b[3]]);
        let v = add(add(cross(va, vb), vb, a[0]), va, b[0]);
        [a[0] * b[0] - dot(va, vb), v[0], v[1], v[2]]
    };
    let q = product(
        product(turn(heading, [0.0, 0.0, 1.0]), turn(-nose, [0.0, 1.0, 0.0])),
        turn(bank, [1.0, 0.0, 0.0]),
    );
    let sign = if r.random_bool(0.5) { 1.0 } else { -1.0 };
    let spin = sign * r.random_range(30.0..110.0);
    let wobble: f64 = r.random_range(0.0..12.0);
    let angle: f64 = r.random_range(-3.1..3.1);
    let mut state = State {
        x: [0.0, 0.0, 2.0],
        v: [
            speed * launch.cos() * heading.cos(),
            speed * launch.cos() * heading.sin(),
            speed * launch.sin(),
        ],
        q,
        w: [wobble * angle.cos(), wobble * angle.sin(), spin],
    };
    // Not about the centre: their centroid circles.
    let markers: [V; 4] = [
        [0.1, 0.0, 0.01],
        [-0.04, 0.09, 0.01],
        [-0.03, -0.1, 0.012],
        [0.02, 0.01, 0.02],
    ];
    let names = ["m1", "m2", "m3", "m4"];
    let mut points: Vec<Point> = names
        .iter()
        .map(|name| Point {
            label: (*name).to_owned(),
            positions: Vec::new(),
        })
        .collect();
    const STEPS: usize = 20;
    let mut strongest: f64 = 0.0;
    let samples = (seconds * rate) as usize;
    for _ in 0..samples {
        for (point, marker) in points.iter_mut().zip(markers) {
            let place = add(state.x, dataset::takes::rotated(state.q, marker), 1.0);
            let noisy = place.map(|x| x + noise.sample(r));
            point
                .positions
                .push((!r.random_bool(0.02)).then_some(noisy));
        }
        let air = add(disc.rate(&state).v, [0.0, 0.0, 9.81], 1.0);
        let along = dot(air, state.v) / dot(state.v, state.v).sqrt();
        strongest = strongest.max((dot(air, air) - along * along).max(0.0).sqrt());
        for _ in 0..STEPS {
            state = disc.step(&state, 1.0 / (rate * STEPS as f64));
        }
    }
    let take = Take {
        format: Format::Plain,
        times: (0..samples).map(|i| i as f64 / rate).collect(),
        points,
        bodies: Vec::new(),
        length: LengthUnit::Metre,
        up: None,
        left_handed: Some(false),
        notes: Vec::new(),
    };
    (take, strongest)
}
