//! A report and its evidence, made up from a formula and a seed: for tests and for looking at the page, and
//! for nothing else.

use std::collections::BTreeMap;

use dataset::Role;
use identify::*;

/// Root mean square residuals of the positions, m, as in a report.
pub fn marker_rms(value: f64) -> BTreeMap<String, Rms> {
    let rms = Rms {
        value,
        unit: "m".into(),
    };
    BTreeMap::from([(MARKER.to_owned(), rms)])
}

/// Noise of the positions, as in a report.
pub fn marker_noise(noise: NoiseReport) -> BTreeMap<String, NoiseReport> {
    BTreeMap::from([(MARKER.to_owned(), noise)])
}

/// Random number generator whose numbers are the same on every machine.
struct Random(u64);

impl Random {
    fn uniform(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((self.0 >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }
    fn normal(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

/// Standard deviation of the noise of a measured marker coordinate in the example, m.
const SIGMA: f64 = 0.0015;

/// Example of a disc flight with three markers and a sample rate of 120 Hz.
pub fn flight(number: usize, samples: usize) -> FlightEvidence {
    let mut random = Random(number as u64 * 7919 + 1);
    let speed = 6.0 + 3.0 * random.uniform();
    let (heading, spin) = (0.3 * random.normal(), -35.0 - 20.0 * random.uniform());
    let names = "x y z u v w phi theta gamma phidot thetadot gammadot";
    let mut flight = FlightEvidence {
        file: format!("throw{number:02}.csv"),
        role: if number.is_multiple_of(4) {
            Role::HeldOut
        } else {
            Role::Fit
        },
        markers: ["m1", "m2", "m3"].map(str::to_owned).to_vec(),
        times: Vec::new(),
        measured: Vec::new(),
        outlier: Vec::new(),
        predicted: Vec::new(),
        sensors: Vec::new(),
        state_names: names.split(' ').map(str::to_owned).collect(),
        states: Vec::new(),
        quantity_names: ["V", "alpha", "d1_x"].map(str::to_owned).to_vec(),
        quantities: Vec::new(),
        input_names: Vec::new(),
        input_units: Vec::new(),
        inputs: Vec::new(),
    };
    let mut drift = [0.0; 3];
    for sample in 0..samples {
        let t = sample as f64 / 120.0;
        let (along, wobble) = (speed * t - 0.6 * t * t, (-4.0 * t).exp() * (30.0 * t).sin());
        let x = along * heading.cos();
        let y = along * heading.sin() - 0.4 * t * t;
        let z = 1.1 + 1.3 * t - 1.4 * t * t;
        let (phi, theta) = (
            -0.08 + 0.25 * t + 0.05 * wobble,
            -0.2 + 0.1 * t + 0.04 * wobble,
        );
        let gamma = 1.0 + spin * t + 0.8 * t * t;
        let marks = [0.0, 2.1, 4.2].map(|a: f64| {
            let (dx, dy) = (0.1 * (gamma + a).cos(), 0.1 * (gamma + a).sin());
            [
                x + dx * theta.cos(),
                y + dy * phi.cos(),
                z - dx * theta + dy * phi,
            ]
        });
        drift = drift.map(|d| 0.3 * d + 0.954 * SIGMA * random.normal());
        let noisy = marks.map(|p| {
            let gone = random.uniform() < 0.02;
            let out = random.uniform() < 0.006;
            let seen = [0, 1, 2].map(|i| {
                let wild = if out { 0.05 * random.normal() } else { 0.0 };
                p[i] + 0.5 * drift[i] + 0.87 * SIGMA * random.normal() + wild
            });
            (Some(seen).filter(|_| !gone), out && !gone)
        });
        flight.times.push(t);
        flight.measured.push(noisy.iter().map(|n| n.0).collect());
        flight.outlier.push(noisy.iter().map(|n| n.1).collect());
        flight.predicted.push(marks.to_vec());
        let (u, v, w) = (speed - 1.2 * t, 0.3 * wobble, -1.2 + 0.5 * t + 0.2 * wobble);
        let rates = [0.25 + 2.0 * wobble, 0.1 - 1.5 * wobble, spin + 1.6 * t];
        let state = [
            x, y, z, u, v, w, phi, theta, gamma, rates[0], rates[1], rates[2],
        ];
        flight.states.push(state.to_vec());
        flight.quantities.push(vec![u.hypot(w), (-w).atan2(u), 1.0]);
    }
    flight
}

/// Simulated measurements and predictions of `flights` disc flights, as input of the figures of a report.
pub fn evidence(flights: usize) -> Vec<FlightEvidence> {
    (1..=flights)
        .map(|n| flight(n, 110 + 10 * (n % 4)))
        .collect()
}

/// Example of a fit report on `flights` flights of a disc.
pub fn report(flights: usize) -> FitReport {
    let mut random = Random(5);
    let found = [
        ("C_L0", "1", 0.1934, 0.0041, 0.188),
        ("C_La", "1/rad", 2.352, 0.047, 2.37),
        ("C_D0", "1", 0.1472, 0.0062, 0.15),
        ("C_Da", "1/rad^2", 1.31, 0.16, 1.24),
        ("C_Ma", "1/rad", -0.371, 0.012, -0.38),
        ("C_Mq", "s", -0.00512, 0.00061, -0.005),
        ("C_Rr", "s", -0.00011, 0.00046, -0.0004),
        ("C_Nr", "N*m*s", -3.31e-5, 1.4e-6, -3.4e-5),
    ];
    let coefficient = |(name, unit, value, error, model): &(&str, &str, f64, f64, f64)| {
        let c = Coefficient {
            value: *value,
            std_error: *error,
            std_error_cluster_robust: (flights >= 8)
                .then_some(if *name == "C_Da" { 2.4 } else { 1.1 } * error),
            interval: [value - 1.96 * error, value + 1.96 * error],
            unit: (*unit).to_owned(),
            at_bound: false,
            fixed: false,
            model_value: *model,
            prior: None,
        };
        ((*name).to_owned(), c)
    };
    let mut correlations: BTreeMap<String, BTreeMap<String, f64>> = BTreeMap::new();
    for (i, a) in found.iter().enumerate() {
        for (j, b) in found.iter().enumerate().skip(i) {
            let value = match (a.0, b.0) {
                (a, b) if a == b => 1.0,
                ("C_D0", "C_Da") => -0.94,
                ("C_L0", "C_La") => -0.88,
                _ => (1.3 * (i as f64 * 3.1 + j as f64 * 1.7).sin()) * 0.35,
            };
            correlations
                .entry(a.0.into())
                .or_default()
                .insert(b.0.into(), value);
            correlations
                .entry(b.0.into())
                .or_default()
                .insert(a.0.into(), value);
        }
    }
    let one = |number: usize, random: &mut Random| FlightReport {
        file: format!("throw{number:02}.csv"),
        role: if number.is_multiple_of(4) {
            Role::HeldOut
        } else {
            Role::Fit
        },
        samples: 110 + 10 * (number % 4),
        outcome: if number.is_multiple_of(4) {
            FlightOutcome::HeldOut
        } else {
            FlightOutcome::Fitted
        },
        residual_rms: marker_rms(
            SIGMA
                * (1.0 + 0.06 * random.normal().abs())
                * if number.is_multiple_of(4) { 1.5 } else { 1.0 },
        ),
        outliers: number % 3,
        initial: BTreeMap::from([(
            "z".to_owned(),
            Estimate {
                value: 1.2,
                std_error: 1e-3,
            },
        )]),
        cut: (number == 3).then(|| Truncation {
            t: 1.083,
            samples: 14,
            reason: "the velocity jumps by 3.1 m/s: the disc touched the ground".into(),
        }),
        is_summary: false,
        seen: Vec::new(),
        notes: if number == 2 {
            vec!["fitted again from the pose of its markers".into()]
        } else {
            Vec::new()
        },
    };
    let flights: Vec<FlightReport> = (1..=flights).map(|n| one(n, &mut random)).collect();
    let axis = |phase: f64| AxisResiduals {
        autocorrelation: (0..30)
            .map(|lag| {
                0.3_f64.powi(lag)
                    + if lag > 0 {
                        0.02 * (f64::from(lag) + phase).sin()
                    } else {
                        0.0
                    }
            })
            .collect(),
        whitened_autocorrelation: (0..30)
            .map(|lag| {
                if lag == 0 {
                    1.0
                } else {
                    0.018 * (2.3 * f64::from(lag) + phase).sin()
                }
            })
            .collect(),
        band: 0.028,
        quantiles: (1..60)
            .map(|i| {
                let normal = 0.08 * f64::from(i - 30);
                [
                    normal,
                    normal + 0.015 * normal.powi(3) * (1.0 + 0.3 * phase),
                ]
            })
            .collect(),
    };
    let profile = |name: &str, value: f64, error: f64, skew: f64| Profile {
        name: name.into(),
        points: (-12..=12)
            .map(|i| {
                let s = f64::from(i) / 4.0;
                [value + error * s, s * s * (1.0 + skew * s)]
            })
            .collect(),
        interval: [
            Some(value - 2.05 * error),
            (skew < 0.1).then_some(value + 1.9 * error),
        ],
    };
    let axes = [("x", 1.48, 0.24), ("y", 1.52, 0.26), ("z", 1.55, 0.22)];
    FitReport {
        schema: "hyzer.fit/2".into(),
        model: "disc".into(),
        dataset: "throws".into(),
        effects: Vec::new(),
        reliable: true,
        cautions: Vec::new(),
        residual_rms: marker_rms(0.001523),
        sensors: Vec::new(),
        notes: Vec::new(),
        noise: marker_noise(NoiseReport {
            sigma: 0.001517,
            unit: "m".into(),
            lag1_autocorrelation: 0.24,
            estimated: true,
            axes: axes
                .into_iter()
                .map(|(name, mm, ar1)| {
                    (
                        name.to_owned(),
                        AxisNoise {
                            sigma: 1e-3 * mm,
                            lag1_autocorrelation: ar1,
                        },
                    )
                })
                .collect(),
            interval_s: 1.0 / 120.0,
            points: 1104,
            outliers: 7,
            outlier_fraction: 7.0 / 1104.0,
            missing: 21,
            floor: Some(0.00149),
        }),
        coefficients: found.iter().map(coefficient).collect(),
        correlations,
        flights,
        data_faults: Vec::new(),
        marker_distances: Vec::new(),
        lack_of_fit: None,
        doubts: Vec::new(),
        far_constants: Vec::new(),
        doubt_of_summaries: None,
        contradicted: Vec::new(),
        misread: Vec::new(),
        excess: None,
        open_side: None,
        not_identifiable: vec![NonIdentifiable {
            combination: vec!["C_Rr".into()],
            weights: BTreeMap::from([("C_Rr".into(), 0.99), ("C_Mq".into(), -0.12)]),
            relative_error: 1.15,
            reason: "its moment turns the disc by less than the noise in flights as short as these"
                .into(),
        }],
        profiles: vec![
            profile("C_Da", 1.31, 0.16, 0.06),
            profile("C_Nr", -3.31e-5, 1.4e-6, -0.03),
            profile("C_Rr", -0.00011, 0.00046, 0.12),
        ],
        residuals: [("x", 0.0), ("y", 1.0), ("z", 2.0)]
            .map(|(a, p)| (a.to_owned(), axis(p)))
            .into(),
        iterations: Iterations {
            steps: 9,
            rounds: 4,
            converged: true,
            status: FitStatus::Converged,
        },
        seconds: BTreeMap::from([
            ("total".into(), 0.91),
            ("fit".into(), 0.55),
            ("profiles".into(), 0.31),
        ]),
    }
}
