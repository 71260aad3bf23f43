//! The trajectory table.

use flight::trajectory_csv;
use ode::{Event, IntegrationOptions, integrate, integrate_to_event, rhs_from_fn};

fn stone(_: f64, x: &[f64; 2], dx: &mut [f64; 2]) {
    *dx = [x[1], -10.0];
}

#[test]
fn a_trajectory_has_the_rate_and_the_end() {
    let mut ground = [Event::falls_to("ground", 0, 0.0).terminal()];
    let flight = integrate_to_event(
        &mut rhs_from_fn(&[], stone),
        (0.0, &[0.45, 1e-9]),
        9.0,
        &IntegrationOptions::default(),
        &mut ground,
    )
    .unwrap();
    let csv = trajectory_csv(&flight, &["z", "vz"], 8.0);
    let rows: Vec<Vec<f64>> = csv
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert_eq!(csv.lines().next(), Some("t,z,vz"));
    assert_eq!(
        rows.iter().map(|row| row[0]).collect::<Vec<_>>(),
        [0.0, 0.125, 0.25, flight.end]
    );
    assert_eq!(rows[0], [0.0, 0.45, 1e-9]);
    assert_eq!(
        rows[3][1..],
        flight.end_state,
        "numbers give themselves back"
    );
    assert!((rows[1][1] - (0.45 - 5.0 / 64.0)).abs() < 1e-8);
}

#[test]
fn an_end_on_the_rate_is_one_row() {
    let flight = integrate(
        &mut rhs_from_fn(&[], stone),
        (0.0, &[9.0, 1.0]),
        1.0,
        &IntegrationOptions::default(),
        &mut [],
    )
    .unwrap();
    let csv = trajectory_csv(&flight, &["z", "vz"], 120.0);
    assert_eq!(csv.lines().count(), 1 + 121);
    assert!(csv.lines().last().unwrap().starts_with("1.0,"));
    // 0.07 s at 100/s: 0.07 * 100 is a little more than 7.
    let flight = integrate(
        &mut rhs_from_fn(&[], stone),
        (0.0, &[9.0, 1.0]),
        0.07,
        &IntegrationOptions::default(),
        &mut [],
    )
    .unwrap();
    assert_eq!(
        trajectory_csv(&flight, &["z", "vz"], 100.0).lines().count(),
        1 + 8
    );
}
