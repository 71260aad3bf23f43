//! Coefficients of flights that the oracle made, found again by the fit.

use dataset::synthesize::{Corruption, corrupt};
use dataset::{Dataset, KnownValue, Role};
use identify::{CancellationToken, Fit, FitError, FitOptions, FitReport, Prior, fit};
use studies::identification::coverage;
use studies::oracle_flights::{
    Plan, TRUTH, TWELVE, Throws, disc, flights, noise_conditions, paper_flight,
};

const WHITE: Corruption = Corruption {
    sigma: 0.0015,
    ar1: 0.0,
    outliers: 0.0,
    outlier_size: 0.05,
    dropouts: 0.0,
};

fn noisy(plan: &Plan<'_>, noise: &Corruption, seed: u64) -> Dataset {
    let mut dataset = flights(&disc(), plan, seed);
    for (index, flight) in dataset.flights.iter_mut().enumerate() {
        corrupt(&mut flight.positions, noise, 100 * seed + index as u64);
    }
    dataset
}

fn fitted(dataset: &Dataset) -> Fit {
    fit(&disc(), dataset, &FitOptions::default()).expect("a fit")
}

/// Maximum, over the coefficients, of |estimate − true value| / standard error.
fn worst(report: &FitReport) -> f64 {
    let errors = TRUTH.map(|(name, truth)| {
        let found = &report.coefficients[name];
        (found.value - truth).abs() / found.std_error
    });
    errors.into_iter().fold(0.0, f64::max)
}

#[test]
fn twelve_flights_give_every_coefficient() {
    let report = fitted(&noisy(&TWELVE, &WHITE, 3)).report;
    assert!(report.iterations.converged);
    assert!(worst(&report) < 3.0, "{:#?}", report.coefficients);
    assert!(
        (report.noise["marker"].sigma / 0.0015 - 1.0).abs() < 0.03,
        "{:?}",
        report.noise
    );
    assert!(
        report.noise["marker"].lag1_autocorrelation.abs() < 0.03,
        "{:?}",
        report.noise
    );
    assert!(
        report.not_identifiable.is_empty(),
        "{:?}",
        report.not_identifiable
    );
    assert!(report.flights.iter().all(|flight| flight.notes.is_empty()));
    // A tenth of a standard error would already say that the answer is told more exactly than it is known.
    let drag = &report.coefficients["C_D0"];
    assert!(drag.std_error < 0.01 * drag.value);
}

#[test]
fn the_intervals_hold_the_truth_under_every_noise() {
    for condition in noise_conditions() {
        let found = coverage(&TWELVE, &condition, 8);
        assert_eq!(found.failed, 0, "{}", condition.name);
        // Of 64 intervals 61 should hold; fewer than 55 would be one in a thousand.
        assert!(found.covered() >= 55.0 / 64.0, "{found:#?}");
        for row in &found.coefficients {
            assert!(
                row.max_z < 5.0,
                "{} under {}: {row:?}",
                row.name,
                condition.name
            );
        }
    }
}

#[test]
fn the_same_bits_on_any_number_of_threads() {
    let plan = Plan {
        flights: 5,
        ..TWELVE
    };
    let dataset = noisy(
        &plan,
        &Corruption {
            dropouts: 0.1,
            outliers: 0.01,
            ..WHITE
        },
        4,
    );
    let on = |threads| {
        let options = FitOptions {
            threads: Some(threads),
            ..FitOptions::default()
        };
        let mut report = fit(&disc(), &dataset, &options).expect("a fit").report;
        report.seconds.clear();
        serde_json::to_string(&report).expect("a report")
    };
    let one = on(1);
    assert_eq!(one, on(3));
    assert_eq!(one, on(16));
}

#[test]
fn the_quaternion_disc_says_the_same() {
    let plan = Plan {
        flights: 4,
        ..TWELVE
    };
    let dataset = noisy(&plan, &WHITE, 5);
    let quaternion = model_spec::load::load("disc_quaternion", &[]).expect("a model");
    let angles = fitted(&dataset).report;
    let turned = fit(&quaternion, &dataset, &FitOptions::default())
        .expect("a fit")
        .report;
    for (name, found) in &angles.coefficients {
        let other = &turned.coefficients[name];
        let apart = (found.value - other.value).abs() / found.std_error;
        assert!(apart < 0.01, "{name}: {found:?} {other:?}");
        // The noise is estimated until it changes by less than half a percent.
        assert!(
            (found.std_error / other.std_error - 1.0).abs() < 6e-3,
            "{name}: {found:?} {other:?}"
        );
    }
}

#[test]
fn a_slow_camera_does_not_hide_turns() {
    // At 25 samples a second a spin of 100 rad/s is seen as one of -57 rad/s.
    let throws = Throws {
        spin: (95.0, 115.0),
        nose: (0.0, 0.2),
        ..Throws::SPREAD
    };
    let plan = Plan {
        throws,
        flights: 6,
        rate: 25.0,
        ..TWELVE
    };
    let report = fitted(&noisy(&plan, &WHITE, 6)).report;
    for flight in &report.flights {
        let spin = flight.initial["gammadot"].value.abs();
        assert!(
            (85.0..125.0).contains(&spin),
            "{}: {spin} {:?}",
            flight.file,
            flight.notes
        );
        assert!(flight.rms() < 0.003, "{}: {}", flight.file, flight.rms());
        assert!(
            flight.notes.iter().any(|note| note.contains("turns")),
            "{:?}",
            flight.notes
        );
    }
    assert!(worst(&report) < 4.0, "{:#?}", report.coefficients);
}

#[test]
fn gaps_uneven_times_and_a_late_first_sight_are_ordinary() {
    let plan = Plan {
        flights: 6,
        ..TWELVE
    };
    let mut dataset = noisy(
        &plan,
        &Corruption {
            dropouts: 0.12,
            ..WHITE
        },
        7,
    );
    let flight = &mut dataset.flights[0];
    for row in &mut flight.positions[..4] {
        row.fill(None);
    }
    for row in &mut flight.positions[4..7] {
        row[1] = None;
    }
    let flight = &mut dataset.flights[1];
    let mut index = 0;
    let mut kept = |_: &f64| {
        index += 1;
        index % 3 != 0
    };
    let keep: Vec<bool> = flight.times.iter().map(&mut kept).collect();
    let (mut a, mut b) = (keep.iter(), keep.iter());
    flight.times.retain(|_| *a.next().expect("one each"));
    flight.positions.retain(|_| *b.next().expect("one each"));
    for time in &mut flight.times {
        *time += 1e6;
    }
    let report = fitted(&dataset).report;
    assert!(worst(&report) < 3.5, "{:#?}", report.coefficients);
    assert!(
        report.flights[0].notes[0].contains("first 4 samples"),
        "{:?}",
        report.flights[0].notes
    );
}

#[test]
fn a_touch_of_the_ground_is_cut_off_and_said() {
    let mut dataset = noisy(
        &Plan {
            flights: 3,
            ..TWELVE
        },
        &WHITE,
        8,
    );
    // The disc is thrown up again from its hundredth sample on.
    let flight = &mut dataset.flights[1];
    let touch = flight.times[100];
    for (time, row) in flight.times.iter().zip(&mut flight.positions) {
        for point in row.iter_mut().flatten() {
            point[2] += 5.0 * (time - touch).max(0.0);
        }
    }
    let report = fitted(&dataset).report;
    let cut = report.flights[1].cut.as_ref().expect("a cut");
    assert!((cut.t - touch).abs() < 0.03, "{cut:?}");
    assert!(cut.reason.contains("ground"));
    assert!(report.flights[0].cut.is_none() && report.flights[2].cut.is_none());
    assert!(worst(&report) < 4.0, "{:#?}", report.coefficients);
}

#[test]
fn held_out_flights_are_predicted_to_their_noise() {
    let mut dataset = noisy(&TWELVE, &WHITE, 9);
    dataset.flights[10].role = Role::HeldOut;
    dataset.flights[11].role = Role::HeldOut;
    let fitted = fitted(&dataset);
    for index in [10, 11] {
        let flight = &fitted.report.flights[index];
        assert_eq!(flight.role, Role::HeldOut);
        assert!((0.001..0.006).contains(&flight.rms()), "{}", flight.rms());
        assert!(fitted.evidence(identify::FlightId::new(index)).is_some());
    }
}

#[test]
fn one_flight_of_the_paper_does_not_determine_them_all() {
    let mut dataset = paper_flight(&disc(), "fssh3", None);
    corrupt(
        &mut dataset.flights[0].positions,
        &Corruption {
            sigma: 0.0014,
            ..WHITE
        },
        1,
    );
    let report = fitted(&dataset).report;
    let named: Vec<&String> = report
        .not_identifiable
        .iter()
        .flat_map(|u| &u.combination)
        .collect();
    for name in ["C_L0", "C_D0", "C_Nr"] {
        assert!(named.iter().any(|n| *n == name), "{named:?}");
    }
    let why = &report.not_identifiable[0].reason;
    assert!(why.contains("alpha lies between"), "{why}");
}

#[test]
fn coefficients_are_held_freed_bounded_and_known_beforehand() {
    let dataset = noisy(
        &Plan {
            flights: 4,
            ..TWELVE
        },
        &WHITE,
        10,
    );
    let hold = [("C_Nr".to_owned(), Some(-5e-5)), ("C_Ma".to_owned(), None)];
    let free = ["wind_x".to_owned()];
    let priors = [Prior {
        name: "C_D0".into(),
        value: 0.2,
        sigma: 1e-7,
    }];
    let options = FitOptions {
        fixed: &hold,
        free: &free,
        priors: &priors,
        ..FitOptions::default()
    };
    let report = fit(&disc(), &dataset, &options).expect("a fit").report;
    assert!(report.coefficients["C_Nr"].fixed && report.coefficients["C_Nr"].value == -5e-5);
    assert!(report.coefficients["C_Ma"].fixed && report.coefficients["C_Ma"].value == -0.38);
    assert!((report.coefficients["C_D0"].value - 0.2).abs() < 1e-5);
    assert_eq!(report.coefficients["wind_x"].unit, "m/s");
    let refused = |options: FitOptions<'_>| {
        let error = fit(&disc(), &dataset, &options).err().expect("refused");
        error.to_string()
    };
    let unknown = ["C_X".to_owned()];
    assert!(
        refused(FitOptions {
            free: &unknown,
            ..FitOptions::default()
        })
        .contains("C_X")
    );
    assert!(
        refused(FitOptions {
            profiles: &unknown,
            ..FitOptions::default()
        })
        .contains("C_X")
    );
}

#[test]
fn a_bound_that_is_hit_is_said() {
    let truth = [("C_Nr", -2e-4), ("C_D0", -0.02)];
    let plan = Plan {
        truth: &truth,
        flights: 6,
        ..TWELVE
    };
    let report = fitted(&noisy(&plan, &WHITE, 11)).report;
    let drag = &report.coefficients["C_D0"];
    assert!(drag.at_bound && drag.value == 0.0, "{drag:?}");
    let options = FitOptions {
        unbounded: true,
        ..FitOptions::default()
    };
    let report = fit(&disc(), &noisy(&plan, &WHITE, 11), &options)
        .expect("a fit")
        .report;
    let drag = &report.coefficients["C_D0"];
    assert!(
        !drag.at_bound && (drag.value + 0.02).abs() < 4.0 * drag.std_error,
        "{drag:?}"
    );
}

#[test]
fn an_effect_that_is_absent_is_found_to_be_nothing() {
    let model = model_spec::load::load("disc", &["zero_lift_drag_angle"]).expect("a model");
    let report = fit(&model, &noisy(&TWELVE, &WHITE, 12), &FitOptions::default())
        .expect("a fit")
        .report;
    let angle = &report.coefficients["alpha_0"];
    assert!(angle.value.abs() < 3.0 * angle.std_error, "{angle:?}");
    assert_eq!(report.effects, ["zero_lift_drag_angle"]);
}

#[test]
fn a_profile_agrees_with_the_standard_error_where_the_model_is_nearly_straight() {
    let dataset = noisy(
        &Plan {
            flights: 4,
            ..TWELVE
        },
        &WHITE,
        13,
    );
    let profiles = ["C_La".to_owned()];
    let options = FitOptions {
        profiles: &profiles,
        ..FitOptions::default()
    };
    let report = fit(&disc(), &dataset, &options).expect("a fit").report;
    let (profile, found) = (&report.profiles[0], &report.coefficients["C_La"]);
    for (end, expected) in profile.interval.iter().zip(found.interval) {
        let end = end.expect("an end");
        assert!(
            (end - expected).abs() < 0.1 * found.std_error,
            "{profile:?} {found:?}"
        );
    }
}

#[test]
fn what_is_known_of_a_flight_is_taken_as_given() {
    let mut dataset = noisy(
        &Plan {
            flights: 3,
            ..TWELVE
        },
        &WHITE,
        14,
    );
    let seen = fitted(&dataset).report.flights[0].initial["z"];
    let known = (1e3 * seen.value).round() / 1e3;
    dataset.flights[0]
        .known
        .insert("z".into(), KnownValue::Scalar(known));
    dataset.flights[1]
        .known
        .insert("wind".into(), KnownValue::Vector([0.5, 0.0, 0.0]));
    let report = fitted(&dataset).report;
    let height = report.flights[0].initial["z"];
    assert!(seen.std_error > 0.0);
    assert_eq!((height.value, height.std_error), (known, 0.0));
    dataset.flights[2]
        .known
        .insert("height".into(), KnownValue::Scalar(1.0));
    let error = fit(&disc(), &dataset, &FitOptions::default())
        .err()
        .expect("refused");
    assert!(
        matches!(error, FitError::Flight { .. }) && error.to_string().contains("height"),
        "{error}"
    );
}

#[test]
fn a_fit_stops_when_told() {
    let dataset = noisy(&TWELVE, &WHITE, 15);
    let token = CancellationToken::default();
    token.cancel();
    let options = FitOptions {
        cancellation: Some(&token),
        ..FitOptions::default()
    };
    let begun = std::time::Instant::now();
    assert_eq!(
        fit(&disc(), &dataset, &options).err(),
        Some(FitError::Interrupted)
    );
    assert!(begun.elapsed().as_secs_f64() < 1.0);
}
