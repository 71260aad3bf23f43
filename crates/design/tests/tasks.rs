//! Design tasks.
use design::*;
use nalgebra::{Vector2, Vector3};
use std::time::Instant;

#[test]
fn tasks() {
    let body = ThrownBody::new(model_spec::load::load("disc", &[]).unwrap()).unwrap();
    let flights = body.with_parameters(body.compiled.layout().default_parameters());
    let standard = Bounds::standard(&body);
    let obstacle = |side| Bounds {
        obstacle: Some(Obstacle {
            place: Vector2::new(15.0, 0.0),
            radius: 3.0,
            side,
        }),
        ..standard.clone()
    };
    let calm = standard.clone().with("heading", 0.0, 0.0);
    let tasks: Vec<(&str, Goal, Bounds)> = vec![
        (
            "hit ground",
            Goal::Hit(Vector3::new(30.0, 5.0, 0.0)),
            standard.clone(),
        ),
        (
            "hit air",
            Goal::Hit(Vector3::new(20.0, -3.0, 2.0)),
            standard.clone(),
        ),
        ("range", Goal::Range, calm.clone()),
        ("hang", Goal::HangTime, calm.clone()),
        (
            "left",
            Goal::Curve(Vector3::new(30.0, 0.0, 0.0)),
            obstacle(Some(Side::Left)),
        ),
        (
            "right",
            Goal::Curve(Vector3::new(30.0, 0.0, 0.0)),
            obstacle(Some(Side::Right)),
        ),
        (
            "either",
            Goal::Curve(Vector3::new(30.0, 0.0, 1.0)),
            obstacle(None),
        ),
        (
            "flare",
            Goal::Flare(Vector3::new(25.0, 0.0, 1.5)),
            standard.clone(),
        ),
        (
            "spread",
            Goal::Spread(Vector3::new(25.0, 0.0, 0.0)),
            standard.clone(),
        ),
        (
            "too far",
            Goal::Hit(Vector3::new(300.0, 0.0, 0.0)),
            standard.clone(),
        ),
    ];
    for (name, goal, bounds) in tasks {
        let start = Instant::now();
        let found = design(&flights, goal, &bounds, &SearchOptions::default()).unwrap();
        let t = start.elapsed().as_secs_f64();
        println!(
            "{name}: {t:.3} s feasible {} figure {:.4} miss {:.2e} vz {:?} clear {:?} landing {:?} T {:.2}\n   {:?}",
            found.feasible,
            found.figure,
            found.miss,
            found.vertical_speed,
            found.clearance,
            found.landing.as_slice(),
            found.time,
            numbers(&found.throw).collect::<Vec<_>>()
        );
    }
}
