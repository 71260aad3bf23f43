//! A body that dips below the ground for less than a step has landed.

use crate::rhs;
use ode::{Event, IntegrationOptions, Method, integrate};

/// Number of random smooth flights; a dip is planted in more than half of them.
const FLIGHTS: u64 = 190_000;

/// Duration of each flight, s.
const END: f64 = 4.0;

/// Number of oscillations of the height.
const WAVES: usize = 3;

/// The methods, each with the least depth of a planted dip in units of the tolerance. The dense output of Dop853, whose
/// steps hold several oscillations here, is itself off by up to ten times the tolerance.
const METHODS: [(Method, f64); 2] = [(Method::Tsit5, 10.0), (Method::Dop853, 20.0)];

/// Uniform random numbers in 0 .. 1 (SplitMix64).
struct Random(u64);

impl Random {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// Number whose logarithm is uniform.
    fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
}

/// Height of a flight over time: z₀ + c·t + Σ aₖ·sin(ωₖ·t + φₖ), in m.
struct Height {
    start: f64,
    climb: f64,
    /// Amplitude, m, angular frequency, rad/s, and phase, rad, of each oscillation.
    waves: [[f64; 3]; WAVES],
}

impl Height {
    fn random(random: &mut Random) -> Self {
        let wave = |_| {
            let frequency = random.magnitude(0.3, 10.0);
            [
                random.magnitude(0.01, 3.0),
                frequency,
                random.between(0.0, std::f64::consts::TAU),
            ]
        };
        Height {
            start: 0.0,
            waves: std::array::from_fn(wave),
            climb: random.between(-2.0, 2.0),
        }
    }

    fn at(&self, t: f64) -> f64 {
        let waves = self.waves.iter().map(|[a, w, phi]| a * (w * t + phi).sin());
        self.start + self.climb * t + waves.sum::<f64>()
    }

    /// The first minimum within the flight that is lower than all before it: its time and its height.
    fn first_dip(&self) -> Option<(f64, f64)> {
        const POINTS: usize = 160;
        let time = |k: usize| END * k as f64 / POINTS as f64;
        let mut least = self.at(0.0);
        for k in 1..POINTS {
            let here = self.at(time(k));
            let is_minimum = here < self.at(time(k - 1)) && here <= self.at(time(k + 1));
            if is_minimum && here < least {
                let (mut low, mut high) = (time(k - 1), time(k + 1));
                for _ in 0..80 {
                    let third = (high - low) / 3.0;
                    if self.at(low + third) < self.at(high - third) {
                        high -= third;
                    } else {
                        low += third;
                    }
                }
                return Some((low, self.at(low)));
            }
            least = least.min(here);
        }
        None
    }

    /// The state of its differential equation at the time 0: height, and sine and cosine of each oscillation.
    fn state(&self) -> [f64; 1 + 2 * WAVES] {
        let mut state = [self.at(0.0); 1 + 2 * WAVES];
        for (k, [_, _, phi]) in self.waves.iter().enumerate() {
            [state[1 + 2 * k], state[2 + 2 * k]] = [phi.sin(), phi.cos()];
        }
        state
    }
}

#[test]
fn no_landing_that_exceeds_the_tolerance_tenfold_is_missed() {
    let (mut planted, mut missed) = (0_u32, Vec::new());
    for seed in 0..FLIGHTS {
        let mut random = Random(seed);
        let mut height = Height::random(&mut random);
        let tolerance = random.magnitude(1e-10, 1e-4);
        let Some((when, least)) = height.first_dip() else {
            continue;
        };
        let (method, least_depth) = METHODS[(seed % 2) as usize];
        let depth = random.magnitude(least_depth * tolerance, 1e3 * least_depth * tolerance);
        height.start -= least + depth;
        if height.at(0.0) <= depth {
            continue;
        }
        planted += 1;
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::with_tolerance(tolerance)
        };
        let mut motion = rhs(&[], |_, x: &[f64; 7], dx: &mut [f64; 7]| {
            dx[0] = height.climb;
            for (k, [a, w, _]) in height.waves.iter().enumerate() {
                let [sine, cosine] = [x[1 + 2 * k], x[2 + 2 * k]];
                dx[0] += a * w * cosine;
                [dx[1 + 2 * k], dx[2 + 2 * k]] = [w * cosine, -w * sine];
            }
        });
        let mut ground = [Event::falls_to("ground", 0, 0.0).terminal()];
        let start = (0.0, &height.state());
        let flight = integrate(&mut motion, start, END, &options, &mut ground).unwrap();
        if flight.terminal_event.is_none() || flight.end > when + 1e-6 {
            missed.push((seed, depth / tolerance, flight.end - when));
        }
    }
    assert!(planted > 100_000, "{planted}");
    assert!(
        missed.is_empty(),
        "{} of {planted}: {missed:?}",
        missed.len()
    );
}
