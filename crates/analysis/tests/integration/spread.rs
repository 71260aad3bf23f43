//! Spread of landings: linear and sampled agree where they should, and the case where they do not is told.

use analysis::design::{Aims, Obstacle, SampleOptions, Scatter, Scattered, spread};
use analysis::{Estimated, Estimates};
use flight::throw::{FIELDS, Throw};
use nalgebra::{Matrix2, Vector2};
use ode::IntegrationOptions;

use crate::support::body;

fn field(name: &str) -> usize {
    FIELDS
        .iter()
        .position(|(known, ..)| *known == name)
        .expect(name)
}

fn throw() -> Throw {
    Throw {
        launch: 10.0,
        nose: Some(0.0),
        hyzer: Some(10.0),
        spin: Some(600.0),
        ..Throw::at_speed(15.0)
    }
}

fn scatter(of: f64) -> Scatter {
    let sds = [
        ("speed", 0.3),
        ("heading", 1.0),
        ("launch", 0.5),
        ("nose", 0.5),
        ("hyzer", 1.0),
    ];
    Scatter {
        release: sds
            .iter()
            .map(|(name, sd)| (field(name), of * sd))
            .collect(),
        wind: [0.2 * of, 0.2 * of, 0.0],
        parameters: Vec::new(),
    }
}

#[test]
fn linear_and_sampled_agree_for_a_small_scatter_and_not_for_a_great_one() {
    let disc = body("disc");
    let flights = disc.with_parameters(disc.compiled.layout().default_parameters());
    let options = SampleOptions {
        count: 2000,
        ..SampleOptions::default()
    };
    let of = |size: f64| {
        let scattered = Scattered::of(&flights, &scatter(size));
        spread(&flights, &throw(), &NO_TARGET, &scattered, &options).expect("a spread")
    };
    let small = of(0.2);
    let agreement = small.agreement.expect("samples");
    assert!(agreement.agrees, "{agreement:?}");
    assert!(
        agreement.ratios.0 > 0.9 && agreement.ratios.1 < 1.1 && agreement.shift < 0.1,
        "{agreement:?}"
    );
    let great = of(8.0).agreement.expect("samples");
    assert!(!great.agrees, "{great:?}");
    println!("{agreement:?} {great:?}");
    // The linear spread is proportional to the scatter.
    let ratio = of(0.4).linear.covariance.norm() / small.linear.covariance.norm();
    assert!((ratio - 4.0).abs() < 1e-9, "{ratio}");
}

#[test]
fn errors_of_coefficients_count_with_their_correlations() {
    let disc = body("disc");
    let flights = disc.with_parameters(disc.compiled.layout().default_parameters());
    let none = Scatter {
        release: Vec::new(),
        wind: [0.0; 3],
        parameters: Vec::new(),
    };
    let of = |correlation: f64| -> (Matrix2<f64>, Vec<String>) {
        let own = [("C_L0", 0.01), ("C_La", 0.1), ("C_absent", 1.0)];
        let own = own.map(|(name, error)| Estimated {
            name: name.to_owned(),
            value: 0.0,
            std_error: Some(error),
        });
        let errors = Estimates {
            coefficients: own.to_vec(),
            correlations: vec![("C_La".into(), "C_L0".into(), correlation)],
            doubt: None,
        };
        let (scattered, unknown) =
            Scattered::of(&flights, &none).with_coefficients(&flights, &errors);
        let options = SampleOptions {
            count: 3000,
            ..SampleOptions::default()
        };
        let found = spread(&flights, &throw(), &NO_TARGET, &scattered, &options).expect("a spread");
        let sampled = found.sampled.expect("samples").landings.covariance;
        // The samples have the same covariance, correlations included.
        assert!(
            (sampled.trace() / found.linear.covariance.trace() - 1.0).abs() < 0.15,
            "{sampled} {}",
            found.linear.covariance
        );
        (found.linear.covariance, unknown)
    };
    let (apart, together) = (of(0.0), of(-0.9));
    assert_eq!(apart.1, ["C_absent"]);
    // More lift at zero angle with less slope: the landing moves less.
    assert!(
        together.0.trace() < 0.9 * apart.0.trace(),
        "{} {}",
        together.0,
        apart.0
    );
}

#[test]
fn samples_do_not_depend_on_the_threads() {
    let disc = body("disc");
    let flights = disc.with_parameters(disc.compiled.layout().default_parameters());
    let scattered = Scattered::of(&flights, &scatter(1.0));
    let on = |threads| {
        let options = SampleOptions {
            count: 40,
            threads,
            ..SampleOptions::default()
        };
        spread(&flights, &throw(), &NO_TARGET, &scattered, &options).expect("a spread")
    };
    assert_eq!(on(1), on(3));
}

/// A landing circle about the release alone.
const NO_TARGET: Aims = Aims {
    landing: Vector2::new(0.0, 0.0),
    circle: 3.0,
    target: None,
    obstacle: None,
};

#[test]
fn half_of_the_scattered_throws_touch_an_obstacle_that_the_throw_grazes() {
    let disc = body("disc");
    let flights = disc.with_parameters(disc.compiled.layout().default_parameters());
    let options = SampleOptions {
        count: 400,
        ..SampleOptions::default()
    };
    let scattered = Scattered::of(&flights, &scatter(0.3));
    let settings = IntegrationOptions::with_tolerance(1e-9);
    let path = flights.fly(&throw(), None, &settings).expect("a flight");
    let point = path.point(0.6 * path.duration());
    let touching = |clearance: f64| {
        let radius = 0.4;
        let place = point.position.xy() + point.left() * (radius + clearance);
        let aims = Aims {
            target: Some(point.position),
            obstacle: Some(Obstacle {
                place,
                radius,
                side: None,
            }),
            ..NO_TARGET
        };
        let found = spread(&flights, &throw(), &aims, &scattered, &options).expect("a spread");
        assert_eq!(found.near_target, Some(1.0), "all pass within 3 m");
        found.touching.expect("samples")
    };
    let shares = [0.0, 20.0, -0.2].map(touching);
    assert!((0.35..0.65).contains(&shares[0]), "{shares:?}");
    assert_eq!(shares[1], 0.0);
    assert!(shares[2] > 0.65, "{shares:?}");
}
