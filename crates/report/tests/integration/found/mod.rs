//! A diagnosis and its evidence, made up from formulas: for tests and for looking at the page, and for nothing else.

use std::collections::BTreeMap;

use diagnose::*;
use identify::{FlightEvidence, FlightOutcome, MARKER, NoiseReport};

/// Standard deviation of the noise of a measured marker coordinate in the example, m.
const SIGMA: f64 = 0.0015;
/// Candidate effects of the example diagnosis: name, coefficient, unit, quantity on which the effect acts, score
/// statistic.
const LOOKED_FOR: [(&str, &str, &str, &str, f64); 26] = [
    ("zero-lift-drag-angle", "alpha_0", "rad", "drag", 812.4),
    ("cubic-drag", "C_Daaa", "1/rad^3", "drag", 604.2),
    ("side-force-by-spin", "C_Yr", "s", "side", 96.1),
    ("wind", "wind_x", "m/s", "wind", 41.7),
    ("air-density-by-height", "rho_z", "1/m", "lift", 18.2),
    ("lift-by-spin-parameter", "C_Ls", "1", "lift", 9.61),
    ("tilted-vertical", "tilt_x", "rad", "vertical", 5.2),
    ("reynolds-number-drag", "C_DRe", "1", "drag", 4.3),
    ("marker-height-offset", "marker_z", "m", "marker", 3.8),
    ("pitching-moment-at-zero-angle", "C_M0", "1", "pitch", 3.1),
    ("clock-rate", "clock", "1", "clock", 2.9),
    ("scale-of-lengths", "scale", "1", "scale", 2.4),
    ("gravity", "g_extra", "m/s^2", "gravity", 2.2),
    ("roll-by-angle-of-attack", "C_Ra", "1/rad", "roll", 1.9),
    ("spin-damping-squared", "C_Nrr", "s^2", "spin", 1.7),
    ("lift-stall", "alpha_stall", "rad", "lift", 1.4),
    ("added-mass", "m_added", "kg", "inertia", 1.2),
    ("wobble-damping-by-spin", "C_Mqr", "s^2", "pitch", 0.9),
    ("axial-inertia", "I_a_extra", "kg*m^2", "inertia", 0.7),
    ("crosswind", "wind_y", "m/s", "wind", 0.6),
    ("updraft", "wind_z", "m/s", "wind", 0.4),
    ("side-force-by-sideslip", "C_Yb", "1/rad", "side", 0.3),
    ("magnus-moment", "C_np", "s", "roll", 0.2),
    ("drag-by-rates", "C_Dq", "s", "drag", 0.1),
    ("lift-by-rates", "C_Lq", "s", "lift", 0.0),
    ("heave", "C_Lw", "s", "lift", 0.0),
];

fn estimate(value: f64, std_error: f64, unit: &str, negligible: Option<f64>) -> Estimate {
    Estimate {
        value,
        std_error,
        unit: unit.into(),
        smallest_effect_of_interest: negligible,
    }
}

fn explanation(at: usize, value: f64, std_error: f64) -> Explanation {
    let (name, coefficient, unit, site, sigmas) = LOOKED_FOR[at];
    let found = estimate(value, std_error, unit, Some(0.002));
    Explanation {
        effects: vec![ExplanationEffect {
            name: name.into(),
            description: format!(
                "What {name} says, in the words of its own file: it acts on the {site}"
            ),
            site: site.into(),
            variables: vec!["alpha".into(), "speed".into()],
            estimates: BTreeMap::from([(coefficient.to_owned(), found)]),
            score_chi2: sigmas * sigmas,
            negligible: false,
        }],
        chi2_decrease: 659_973.0,
        explained_fraction: 0.98,
        remaining_rms_m: 0.0002,
        strongest_remaining: Some(RemainingEffect {
            name: "tilted-vertical".into(),
            p_value: 0.31,
        }),
    }
}

/// Example of a diagnosis report with the given verdict on the given flights.
pub fn report(verdict: Verdict, flights: &[FlightEvidence]) -> Report {
    let extended = matches!(
        verdict,
        Verdict::Identified | Verdict::Ambiguous | Verdict::Unattributed
    );
    let explanations = match verdict {
        Verdict::Adequate | Verdict::Unattributed => Vec::new(),
        Verdict::Identified => vec![explanation(0, -0.0702, 0.0021)],
        Verdict::Ambiguous => {
            let mut both = explanation(2, 0.0123, 0.0011);
            both.effects.extend(explanation(3, -0.41, 0.05).effects);
            vec![
                explanation(0, -0.0702, 0.0021),
                explanation(1, 4.23, 0.17),
                both,
            ]
        }
        Verdict::Negligible => {
            let mut small = explanation(0, -0.0009, 0.0001);
            small.effects[0].negligible = true;
            vec![small]
        }
    };
    let weak = if explanations.is_empty() { 0.004 } else { 1.0 };
    let candidates = LOOKED_FOR
        .iter()
        .map(|(name, coefficient, unit, site, sigmas)| {
            let sigmas = sigmas * weak;
            CandidateTest {
                name: (*name).into(),
                description: format!("What {name} says"),
                site: (*site).into(),
                score_chi2: sigmas * sigmas,
                degrees_of_freedom: 1,
                ln_p_value: -0.5 * sigmas * sigmas - 0.7,
                z: sigmas,
                significant: sigmas > 4.1,
                tolerance: 0.8 / (1.0 + sigmas / 50.0),
                one_step_estimates: BTreeMap::from([(
                    (*coefficient).to_owned(),
                    estimate(-0.071, 0.0023, unit, None),
                )]),
            }
        });
    let candidates: Vec<CandidateTest> = candidates.collect();
    let number = LOOKED_FOR.len();
    let alike = |i: usize, j: usize| match (i.min(j), i.max(j)) {
        (i, j) if i == j => 1.0,
        (0, 1) => 0.985,
        (2, 3) => -0.93,
        (i, j) => 0.8 * (i as f64 * 1.7 + j as f64 * 3.1).sin().powi(3),
    };
    let coefficients = [
        ("C_L0", "1", 0.1934, 0.0041, 0.188),
        ("C_La", "1/rad", 2.352, 0.047, 2.37),
        ("C_D0", "1", 0.1472, 0.0062, 0.1871),
        ("C_Da", "1/rad^2", 1.31, 0.16, 0.24),
        ("C_Ma", "1/rad", -0.371, 0.012, -0.38),
        ("C_Mq", "s", -0.00512, 0.00061, -0.005),
        ("C_Nr", "N*m*s", -3.31e-5, 1.4e-6, -3.4e-5),
    ];
    let coefficient = |(name, unit, value, std_error, before): (&str, &str, f64, f64, f64)| {
        let found = Coefficient {
            value,
            std_error,
            unit: unit.into(),
            before: extended.then_some(before),
        };
        (name.to_owned(), found)
    };
    let mut coefficients: BTreeMap<String, Coefficient> =
        coefficients.into_iter().map(coefficient).collect();
    if extended {
        let new = Coefficient {
            value: -0.0702,
            std_error: 0.0021,
            unit: "rad".into(),
            before: None,
        };
        coefficients.insert("alpha_0".into(), new);
    }
    let each = |(i, f): (usize, &FlightEvidence)| FlightGain {
        file: f.file.clone(),
        role: f.role,
        outcome: FlightOutcome::Fitted,
        rms_before_m: Some(if extended {
            0.012 + 0.004 * (i as f64 * 2.3).sin()
        } else {
            SIGMA
        }),
        rms_after_m: extended.then_some(SIGMA * (1.05 + 0.1 * (i as f64 * 1.1).sin())),
    };
    let x: Vec<f64> = (0..24).map(|i| -0.12 + 0.02 * f64::from(i)).collect();
    let along = |f: &dyn Fn(f64) -> f64| x.iter().map(|x| f(*x)).collect::<Vec<f64>>();
    let before = along(&|a| 0.187 + 0.24 * a * a);
    let after = along(&|a| 0.147 + 1.31 * (a + 0.07).powi(2));
    let lift = along(&|a| 0.19 + 2.35 * a);
    let support = x
        .iter()
        .map(|a| (400.0 * (-(a - 0.1).powi(2) / 0.01).exp()) as usize);
    let curve = |quantity: &str, before: &[f64], after: &[f64]| CoefficientCurve {
        quantity: quantity.into(),
        over: "alpha".into(),
        unit: "rad".into(),
        x: x.clone(),
        before: before.to_vec(),
        after: after.to_vec(),
        support: support.clone().collect(),
    };
    let curves = vec![
        curve("C_L", &lift, &lift),
        curve("C_D", &before, if extended { &after } else { &before }),
    ];
    Report {
        schema: "hyzer.diagnosis/2".into(),
        dataset: "throws".into(),
        model: "disc".into(),
        effects: Vec::new(),
        reliable: true,
        cautions: Vec::new(),
        verdict,
        summary: if verdict == Verdict::Adequate {
            "The flights are what the model and the noise say.".into()
        } else {
            "The drag is least not at zero angle of attack but at −0.0702 ± 0.0021 rad; without it the model's drag is \
             wrong by up to a third at the angles of these flights."
                .into()
        },
        explanations,
        noise: BTreeMap::from([(
            MARKER.to_owned(),
            NoiseReport {
                sigma: SIGMA,
                unit: "m".into(),
                lag1_autocorrelation: 0.24,
                outlier_fraction: 0.006,
                ..NoiseReport::default()
            },
        )]),
        predictive_gain: extended.then_some(PredictiveGain {
            rms_before_m: 0.0137,
            rms_after_m: 0.00162,
            std_error_m: 0.0009,
            noise_m: SIGMA,
            has_summaries: false,
            flights: flights.len() / 4,
            without: 0,
            held_out_by_dataset: true,
            improved: flights.len() / 4,
            median_before_m: 0.0131,
            median_after_m: 0.0016,
            ..PredictiveGain::default()
        }),
        coefficients,
        not_identifiable: vec![
            NotIdentifiable {
                name: "air-density".into(),
                confounded_with: ["C_L0", "C_La", "C_D0", "C_Da"].map(str::to_owned).to_vec(),
            },
            NotIdentifiable {
                name: "unequal-inertia".into(),
                confounded_with: Vec::new(),
            },
        ],
        minimum_detectable_effects: LOOKED_FOR
            .iter()
            .map(|(name, coefficient, unit, _, _)| MinDetectableEffect {
                name: (*name).into(),
                coefficient: (*coefficient).into(),
                value: 0.00213,
                unit: (*unit).into(),
            })
            .collect(),
        proposed_throw: (verdict == Verdict::Ambiguous).then(|| ProposedThrow {
            description: "A fast flat throw with little spin, nose up".into(),
            speed: 18.2,
            launch: 0.12,
            nose: 0.21,
            hyzer: -0.05,
            spin: -31.4,
            heading: 0.0,
            separation: 7.9,
            separation_now: 1.3,
        }),
        extended_model: extended.then(|| "extended.hyz".into()),
        seconds: BTreeMap::from([("total".into(), 2.31), ("scores".into(), 0.4)]),
        tests: candidates,
        threshold: Threshold {
            alpha: 0.001,
            ln_p_value: -10.2,
            z: 4.1,
        },
        score_correlations: ScoreCorrelations {
            names: LOOKED_FOR.iter().map(|l| l.1.to_owned()).collect(),
            matrix: (0..number)
                .map(|i| (0..number).map(|j| alike(i, j)).collect())
                .collect(),
        },
        data_faults: Vec::new(),
        flights: flights.iter().enumerate().map(each).collect(),
        curves,
        unattributed: (verdict == Verdict::Unattributed).then(|| outside(flights)),
        consensus: None,
        converged: true,
        complete: true,
        lack_of_fit: None,
        verified: extended.then(|| Verified {
            holds: true,
            checks: vec![
                ("units and frames".into(), "holds".into()),
                (
                    "vectors against the compiler".into(),
                    "holds to 3e-14".into(),
                ),
            ],
        }),
        notes: if verdict == Verdict::Adequate {
            Vec::new()
        } else {
            vec!["throw03.csv was cut where it touched the ground".into()]
        },
    }
}

fn outside(flights: &[FlightEvidence]) -> Unattributed {
    let channel = |site: &str, explains: f64, size: f64| LoadChannel {
        site: site.into(),
        explained_fraction: explains,
        histories: flights
            .iter()
            .enumerate()
            .map(|(i, f)| {
                let t: Vec<f64> = f.times.iter().step_by(6).copied().collect();
                let value = |t: &f64| size * ((3.0 * t + i as f64).sin() + 0.4);
                LoadHistory {
                    file: f.file.clone(),
                    value: t.iter().map(value).collect(),
                    std_error: t.iter().map(|t| 0.2 * size * (1.0 + t)).collect(),
                    t,
                }
            })
            .collect(),
    };
    let term = |formula: &str, score_chi2: f64, taken: bool| StepwiseTerm {
        name: formula.to_owned(),
        site: "drag".into(),
        formula: formula.into(),
        score_chi2,
        value: -0.0213,
        std_error: 0.0021,
        selected: taken,
    };
    Unattributed {
        description: "The error sits in the drag; it grows with the angle of attack and does not depend on speed.".into(),
        channels: vec![channel("drag", 0.83, 0.04), channel("pitch", 0.12, 3.1e-4), channel("side", 0.02, 2e-3)],
        terms: vec![
            term("abs(alpha)*alpha", 512.3, true),
            term("sin(alpha)^2*V/(V + 1 m/s)", 93.1, false),
            term("beta*r*d/(2*V)", 9.2, false),
        ],
    }
}

/// Returns copies of the flights with predictions of a model that lacks an effect, so that the prediction error grows
/// with time.
pub fn without(flights: &[FlightEvidence]) -> Vec<FlightEvidence> {
    let mut flights = flights.to_vec();
    for (i, flight) in flights.iter_mut().enumerate() {
        for (t, row) in flight.times.iter().zip(&mut flight.predicted) {
            let off = 0.02 * (2.5 * t + i as f64).sin() * t;
            row.iter_mut()
                .for_each(|p| *p = [p[0] + off, p[1] - 0.3 * off, p[2] + 1.6 * off * t]);
        }
    }
    flights
}

/// Text of an example effect in the model language.
pub const EXTENDED: &str = "/// The drag is least near the angle of zero lift.
effect zero_lift_drag_angle on disc {
  site drag;
  coefficient alpha_0 = -0.0702 rad;
  replace C_D = C_D0 + C_Da*(alpha - alpha_0)^2;
}
";
