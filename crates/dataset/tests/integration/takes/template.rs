//! The template is found from free flights that an integrator of the test's own made.

use super::support::spun::{Flights, Plan, USUAL, flights};
use dataset::takes::{
    CentreHeight, EstimatedTemplate, FreeFlight, TemplateError, estimate_template,
};

fn labels(count: usize) -> Vec<String> {
    (1..=count).map(|k| format!("m{k}")).collect()
}

fn estimated(made: &Flights, height: Option<f64>) -> Result<EstimatedTemplate, TemplateError> {
    let flights = made.flights.iter();
    let flights: Vec<FreeFlight<'_>> = flights
        .map(|(times, positions)| FreeFlight { times, positions })
        .collect();
    estimate_template(&labels(made.markers.len()), &flights, height)
}

/// True marker positions on the body, rotated about the third body axis so that the second coordinate of the marker
/// with the index `first` is 0 and its first coordinate is positive.
fn turned(markers: &[[f64; 3]], first: usize) -> Vec<[f64; 3]> {
    let [x, y, _] = markers[first];
    let (s, c) = (y / x.hypot(y), x / x.hypot(y));
    let each = markers.iter();
    each.map(|[x, y, z]| [c * x + s * y, c * y - s * x, *z])
        .collect()
}

/// Errors of the estimated marker positions on a body: maximum distance from the true positions across the spin axis,
/// m; maximum difference along the axis, relative to the mean of the markers, m; and error of the estimated height of
/// the centre of mass in standard errors, `None` if it was not estimated.
fn errors(made: &Flights, found: &EstimatedTemplate) -> (f64, f64, Option<f64>) {
    let truth = turned(&made.markers, found.first);
    let pairs = || found.markers.iter().zip(&truth);
    let across = pairs().map(|(m, t)| (m.position[0] - t[0]).hypot(m.position[1] - t[1]));
    let mean = pairs().map(|(m, t)| m.position[2] - t[2]).sum::<f64>() / truth.len() as f64;
    let z = match found.height {
        CentreHeight::Estimated { std_error, .. } => Some(mean / std_error),
        _ => None,
    };
    let along = pairs().map(|(m, t)| (m.position[2] - t[2] - mean).abs());
    (across.fold(0.0, f64::max), along.fold(0.0, f64::max), z)
}

/// Numbers of random seeds for which the estimated marker positions meet a criterion, such as an error below 1 mm.
#[derive(Debug, Default)]
struct Counts {
    across: usize,
    along: usize,
    heights: usize,
    heights_within: usize,
}

/// Simulates flights for seeds 0 to `seeds` − 1 and counts the seeds whose estimated marker positions are within 1 mm
/// of the true ones across the spin axis, and those within 1 mm along it apart from the error of the centre of mass.
/// Also counts the seeds with an estimated height of the centre of mass, and those whose height is within 1.96 standard
/// errors.
fn over_seeds(plan: &Plan, seeds: u64) -> Counts {
    let mut counts = Counts::default();
    let mut squares = 0.0;
    for seed in 0..seeds {
        let made = flights(plan, seed);
        let found = estimated(&made, None).expect("a template");
        let (across, along, z) = errors(&made, &found);
        counts.across += usize::from(across < 0.001);
        counts.along += usize::from(along < 0.001);
        if let Some(z) = z {
            counts.heights += 1;
            counts.heights_within += usize::from(z.abs() < 1.96);
            squares += z * z;
        }
    }
    let rms = (squares / counts.heights.max(1) as f64).sqrt();
    eprintln!("{seeds} seeds: {counts:?}, rms of the heights' errors {rms:.2} standard errors");
    counts
}

#[test]
fn the_markers_are_found_within_a_millimetre_and_their_standard_errors() {
    let counts = over_seeds(&USUAL, 40);
    assert!(counts.across >= 38 && counts.along >= 38, "{counts:?}");
    assert!(counts.heights >= 20, "{counts:?}");
    assert!(
        counts.heights_within * 100 >= counts.heights * 95,
        "{counts:?}"
    );
}

#[test]
fn a_body_that_wobbles_much_shows_the_height_of_its_centre() {
    let plan = Plan {
        wobble: 6.0,
        ..USUAL
    };
    let counts = over_seeds(&plan, 30);
    assert!(counts.across >= 29 && counts.along >= 29, "{counts:?}");
    assert!(counts.heights >= 27, "{counts:?}");
    assert!(
        counts.heights_within * 100 >= counts.heights * 95,
        "{counts:?}"
    );
}

#[test]
fn two_flights_with_outliers_and_gaps_are_enough() {
    let plan = Plan {
        flights: 2,
        gaps: 0.15,
        outliers: 0.02,
        ..USUAL
    };
    let counts = over_seeds(&plan, 40);
    assert!(counts.across >= 38 && counts.along >= 38, "{counts:?}");
    let made = flights(&plan, 3);
    let found = estimated(&made, None).expect("a template");
    assert_eq!(found.flights, 2);
    assert!(found.outliers > 0, "{found:?}");
    assert!(
        (found.sigma - plan.sigma).abs() < 0.15 * plan.sigma,
        "{found:?}"
    );
}

#[test]
fn a_marker_that_is_never_seen_with_all_others_is_placed_by_some() {
    let mut made = flights(&USUAL, 4);
    assert_eq!(made.markers.len(), 5);
    for (_, rows) in &mut made.flights {
        for (i, row) in rows.iter_mut().enumerate() {
            row[usize::from(i % 2 != 0)] = None;
        }
    }
    let found = estimated(&made, None).expect("a template");
    let (across, ..) = errors(&made, &found);
    assert!(across < 0.001, "{across}");
}

#[test]
fn what_a_flight_without_wobble_does_not_show_is_assumed_and_said() {
    let plan = Plan {
        wobble: 0.0,
        sigma: 0.0015,
        flights: 2,
        ..USUAL
    };
    let made = flights(&plan, 1);
    let found = estimated(&made, None).expect("a template");
    assert!(
        matches!(found.height, CentreHeight::Assumed { .. }),
        "{found:?}"
    );
    let heights: f64 = found.markers.iter().map(|m| m.position[2]).sum();
    assert!(heights.abs() < 1e-9);
    let text = found.decisions().join("\n");
    assert!(
        text.contains("assumed") && text.contains("--centre-height"),
        "{text}"
    );
    let stated = estimated(&made, Some(-0.012)).expect("a template");
    let heights: f64 = stated.markers.iter().map(|m| m.position[2]).sum();
    assert!((heights / stated.markers.len() as f64 - 0.012).abs() < 1e-9);
    assert!(stated.decisions().join("\n").contains("by --centre-height"));
}

#[test]
fn the_third_axis_points_up_at_the_release_whatever_the_sense_of_the_spin() {
    let made = flights(&USUAL, 4);
    let found = estimated(&made, None).expect("a template");
    let up = found.up.expect("decided");
    assert_eq!((up.for_it, up.against), (8, 0));
    let inverted = flights(
        &Plan {
            inverted: true,
            ..USUAL
        },
        4,
    );
    let found = estimated(&inverted, None).expect("a template");
    assert_eq!(found.up.map(|up| up.against), Some(0));
    // Upside down, the first marker is below the centre of a body whose third axis points up.
    let down = found.markers.iter().all(|m| m.position[2] < 0.01);
    assert!(down, "{found:?}");
}

#[test]
fn bodies_without_shape_or_spin_are_refused() {
    let made = flights(&USUAL, 0);
    let few = Flights {
        markers: made.markers[..2].to_vec(),
        flights: Vec::new(),
    };
    assert!(matches!(
        estimated(&few, None),
        Err(TemplateError::FewPoints { .. })
    ));
    let short = Flights {
        markers: made.markers.clone(),
        flights: vec![(
            made.flights[0].0[..8].to_vec(),
            made.flights[0].1[..8].to_vec(),
        )],
    };
    assert!(matches!(
        estimated(&short, None),
        Err(TemplateError::FewSamples { .. })
    ));
    let still = flights(
        &Plan {
            spin: (0.5, 0.5),
            wobble: 0.1,
            ..USUAL
        },
        0,
    );
    let error = estimated(&still, None).expect_err("no spin");
    assert!(matches!(error, TemplateError::NoSpin { .. }), "{error}");
    let line: Vec<[f64; 3]> = (0..3).map(|k| [0.05 * f64::from(k), 0.0, 0.01]).collect();
    let mut collinear = flights(&USUAL, 0);
    for (_, rows) in &mut collinear.flights {
        for (i, row) in rows.iter_mut().enumerate() {
            let (s, c) = (0.2 * i as f64).sin_cos();
            *row = line
                .iter()
                .map(|p| Some([c * p[0], s * p[0], p[2]]))
                .collect();
        }
    }
    collinear.markers = line;
    assert!(matches!(
        estimated(&collinear, None),
        Err(TemplateError::Collinear)
    ));
}
