//! Recordings of throws whose releases and ends are known, made by an integrator of the test's own: a hand, a flight with drag,
//! lift, gravity and spin, and a net, the ground or a catch. They are written as laboratories write them: mm, y up.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

pub type V = [f64; 3];

/// Cause of the end of a simulated flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    Ground,
    Net,
    Catch,
}

/// True times of the release and the end of one simulated throw.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// True time of the release, s.
    pub release: f64,
    /// True time of the end of the flight, s.
    pub end: f64,
    pub kind: End,
}

/// Simulated recording: text of the file, frame rate, and the true throws.
pub struct Made {
    pub text: String,
    pub rate: f64,
    pub truths: Vec<Truth>,
}

fn add(a: V, b: V, s: f64) -> V {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

fn length(a: V) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Simulated body: drag and lift acceleration divided by the square of the speed, 1/m, spin, tilt and marker positions.
struct Body {
    drag: f64,
    lift: f64,
    spin: f64,
    tilt: f64,
    markers: Vec<V>,
}

/// Phase of the motion of a body in one simulated throw, such as in the hand or in flight.
#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Held,
    Pushed { since: f64 },
    Free,
    Stopping,
    Rest,
}

struct Throw {
    direction: V,
    /// Acceleration of the hand, a half sine over time: its peak, m/s², the half period, s, and the fraction of the
    /// half period after which the hand releases the body.
    push: (f64, f64, f64),
    wait: f64,
    longest: f64,
    kind: End,
    stop: f64,
}

impl Body {
    fn air(&self, v: V) -> V {
        let speed = length(v);
        let along = v.map(|x| x / speed.max(1e-9));
        // Across the velocity, as far up as can be.
        let up = add([0.0, 0.0, 1.0], along, -along[2]);
        let up = up.map(|x| x / length(up).max(1e-3));
        let drag = along.map(|x| -self.drag * speed * speed * x);
        add(drag, up, self.lift * speed * speed)
    }

    /// Positions of the markers, m, for a given position of the body's centre (m) and angle of rotation about the spin
    /// axis (rad).
    fn markers(&self, centre: V, angle: f64) -> Vec<V> {
        let (s, c) = angle.sin_cos();
        let (ts, tc) = self.tilt.sin_cos();
        let turned = self.markers.iter().map(|m| {
            let [x, y, z] = [c * m[0] - s * m[1], s * m[0] + c * m[1], m[2]];
            add(centre, [x, tc * y - ts * z, ts * y + tc * z], 1.0)
        });
        turned.collect()
    }
}

/// Simulates a recording of the given number of throws of one body.
pub fn recording(seed: u64, throws: usize) -> Made {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let r = &mut random;
    let rate = [100.0, 120.0, 200.0, 240.0][r.random_range(0..4)];
    let sigma = r.random_range(0.0005..0.0015);
    let is_ball = r.random_bool(0.3);
    let body = Body {
        drag: if is_ball {
            r.random_range(0.005..0.12)
        } else {
            r.random_range(0.01..0.03)
        },
        lift: if is_ball {
            0.0
        } else {
            r.random_range(0.0..0.04)
        },
        spin: if is_ball {
            0.0
        } else {
            r.random_range(10.0..60.0)
        },
        tilt: r.random_range(-0.4..0.4),
        markers: if is_ball {
            vec![[0.0; 3]]
        } else {
            // Not about the centre: their centroid circles.
            vec![
                [0.1, 0.0, 0.01],
                [-0.04, 0.09, 0.01],
                [-0.03, -0.1, 0.012],
                [0.02, 0.01, 0.02],
            ]
        },
    };
    let mut rows: Vec<Vec<Option<V>>> = Vec::new();
    let mut truths = Vec::new();
    for _ in 0..throws {
        let start = rows.len() as f64 / rate;
        let (made, truth) = throw(&body, rate, r);
        let unseen = (truth.release - 0.06, truth.end + 0.06);
        let noise = Normal::new(0.0, sigma).expect("a width");
        let burst = burst(&truth, r);
        for (i, markers) in made.into_iter().enumerate() {
            let t = i as f64 / rate;
            let quiet = (t - truth.release).abs() < 0.06 || (t - truth.end).abs() < 0.06;
            let lost = burst.is_some_and(|(from, to)| t > from && t < to);
            let row = markers.into_iter().map(|m| {
                let noisy = m.map(|x| x + noise.sample(r));
                let dropped = r.random_bool(0.02) && !quiet && t > unseen.0 && t < unseen.1;
                (!lost && !dropped).then_some(noisy)
            });
            rows.push(row.collect());
        }
        truths.push(Truth {
            release: start + truth.release,
            end: start + truth.end,
            ..truth
        });
        // It is fetched: out of sight.
        let count = body.markers.len();
        rows.extend((0..(0.8 * rate) as usize).map(|_| vec![None; count]));
    }
    Made {
        text: vicon(&rows, rate),
        rate,
        truths,
    }
}

/// Draws a time interval, s, away from the ends of the flight, in which no marker is seen, in about every third flight;
/// `None` in the remaining flights.
fn burst(truth: &Truth, r: &mut ChaCha8Rng) -> Option<(f64, f64)> {
    let (from, to) = (truth.release + 0.15, truth.end - 0.2);
    (r.random_bool(0.33) && to > from).then(|| {
        let at = r.random_range(from..to);
        (at, at + r.random_range(0.02..0.06))
    })
}

fn throw(body: &Body, rate: f64, r: &mut ChaCha8Rng) -> (Vec<Vec<V>>, Truth) {
    let heading: f64 = r.random_range(-0.5..0.5);
    let climb: f64 = r.random_range(0.0..0.35);
    let speed: f64 = r.random_range(5.0..22.0);
    let half = r.random_range(0.12..0.3);
    let part = r.random_range(0.55..0.85);
    // The integral of the half sine up to where the hand lets go is the speed.
    let pi = std::f64::consts::PI;
    let peak = speed * pi / (half * (1.0 - (pi * part).cos()));
    let throw = Throw {
        direction: [
            climb.cos() * heading.cos(),
            climb.cos() * heading.sin(),
            climb.sin(),
        ],
        push: (peak, half, part),
        wait: r.random_range(0.3..0.8),
        longest: r.random_range(0.4..0.9),
        kind: [End::Ground, End::Net, End::Catch][r.random_range(0..3)],
        stop: r.random_range(60.0..200.0),
    };
    fly(body, rate, &throw)
}

/// Integrates the motion of one throw with small steps; returns the marker positions at the frame rate and the true
/// release and end.
fn fly(body: &Body, rate: f64, throw: &Throw) -> (Vec<Vec<V>>, Truth) {
    const STEPS: usize = 50;
    let dt = 1.0 / (rate * STEPS as f64);
    let mut truth = Truth {
        release: f64::NAN,
        end: f64::NAN,
        kind: throw.kind,
    };
    let (mut x, mut v): (V, V) = ([0.0, 0.0, 1.3], [0.0; 3]);
    let (mut angle, mut spin) = (0.0, 0.0);
    let mut phase = Phase::Held;
    let mut rows = Vec::new();
    let mut rested = 0.0;
    for step in 0.. {
        let t = step as f64 * dt;
        if step % STEPS == 0 {
            // A held body sways.
            let sway = match phase {
                Phase::Held => 0.003 * (4.0 * t).sin(),
                _ => 0.003 * (4.0 * throw.wait).sin(),
            };
            let sway = if phase == Phase::Rest { 0.0 } else { sway };
            rows.push(body.markers(add(x, [sway, 0.0, sway], 1.0), angle));
        }
        let (peak, half, part) = throw.push;
        let acceleration = match phase {
            Phase::Held | Phase::Rest => [0.0; 3],
            Phase::Pushed { since } => {
                let wave = (std::f64::consts::PI * (t - since) / half).sin();
                throw.direction.map(|d| peak * wave * d)
            }
            Phase::Free => add(body.air(v), [0.0, 0.0, -9.81], 1.0),
            Phase::Stopping => v.map(|x| -throw.stop * x / length(v).max(1e-9)),
        };
        // Velocity in the middle of the step: second order.
        let between = add(v, acceleration, 0.5 * dt);
        x = add(x, between, dt);
        v = add(v, acceleration, dt);
        angle += spin * dt;
        match phase {
            Phase::Held if t >= throw.wait => phase = Phase::Pushed { since: t },
            Phase::Pushed { since } => {
                spin = body.spin * ((t - since) / (part * half)).min(1.0);
                if t - since >= part * half {
                    phase = Phase::Free;
                    truth.release = t;
                }
            }
            Phase::Free => {
                let flown = t - truth.release;
                if x[2] <= 0.02 && v[2] < 0.0 {
                    if truth.end.is_nan() {
                        (truth.end, truth.kind) = (t, End::Ground);
                    }
                    v = [0.6 * v[0], 0.6 * v[1], -0.4 * v[2]];
                    spin *= 0.5;
                    if v[2].abs() < 0.4 {
                        (phase, v, spin) = (Phase::Rest, [0.0; 3], 0.0);
                    }
                } else if throw.kind != End::Ground && flown >= throw.longest && truth.end.is_nan()
                {
                    truth.end = t;
                    phase = Phase::Stopping;
                }
            }
            Phase::Stopping if length(v) < throw.stop * dt * 2.0 => {
                (v, spin) = ([0.0; 3], 0.0);
                phase = Phase::Rest;
            }
            Phase::Rest => rested += dt,
            _ => {}
        }
        if rested > 0.4 || t > 6.0 {
            break;
        }
    }
    (rows, truth)
}

/// Formats marker positions, one row per sample, as a Vicon table in mm with y up.
fn vicon(rows: &[Vec<Option<V>>], rate: f64) -> String {
    let count = rows[0].len();
    let mut text = format!("Trajectories\n{rate}\n,");
    for i in 1..=count {
        text += &format!(",disc:m{i},,");
    }
    text += &format!(
        "\nFrame,Sub Frame{}\n,{}\n",
        ",X,Y,Z".repeat(count),
        ",mm,mm,mm".repeat(count)
    );
    for (i, row) in rows.iter().enumerate() {
        text += &format!("{},0", i + 1);
        for point in row {
            match point {
                // z up to y up: x, z, −y.
                Some([x, y, z]) => {
                    text += &format!(",{:.4},{:.4},{:.4}", 1e3 * x, 1e3 * z, -1e3 * y);
                }
                None => text += ",,,",
            }
        }
        text.push('\n');
    }
    text
}
