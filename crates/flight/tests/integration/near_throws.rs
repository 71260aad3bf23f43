//! Throws found near a known one have the states that the general search finds.

use flight::throw::{NearThrows, Throw, ThrownModel};
use model_spec::layout::Layout;

fn throw(k: i32) -> Throw {
    let part = |step: f64, most: f64| (f64::from(k) * step).sin() * most;
    let mut throw = Throw::at_speed(22.0 + part(1.3, 6.0));
    throw.heading = part(0.7, 170.0);
    throw.launch = part(1.9, 30.0);
    throw.height = 1.5 + part(2.3, 0.5);
    throw
}

#[test]
fn they_are_those_of_the_general_search() {
    for name in ["disc", "disc_quaternion", "discus", "ball"] {
        let model = model_spec::load::load(name, &[]).expect("a model");
        let mut parameters = Layout::new(&model).default_parameters();
        let thrown = ThrownModel::new(&model).expect("a body");
        let base = Throw {
            launch: 5.0,
            ..Throw::at_speed(20.0)
        };
        let known = thrown.state(&base, [0.0; 2], &parameters).expect("a state");
        let mut near = NearThrows::new(&thrown, &known);
        let mut searched = 0;
        for k in 0..40 {
            let mut throw = throw(k);
            if thrown.has_attitude() {
                let part = |step: f64, most: f64| (f64::from(k) * step).sin() * most;
                throw.nose = Some(part(1.1, 10.0));
                throw.hyzer = Some(part(0.4, 40.0));
                throw.spin = Some(600.0 + part(1.7, 100.0));
                throw.wobble = (k % 3 == 0).then_some(4.0);
                parameters[1] *= 1.0 + 0.01 * part(3.1, 1.0);
            }
            let expected = thrown.state(&throw, [0.0; 2], &parameters);
            let mut found = vec![0.0; known.len()];
            near.state(&throw, [0.0; 2], &parameters, &mut found)
                .unwrap_or_else(|e| panic!("{k} {throw:?}: {e}"));
            // Of the disc's angles another branch may have the same motion.
            let again = thrown.throw(&found, &parameters);
            for field in [
                "speed", "heading", "launch", "height", "nose", "hyzer", "spin", "wobble",
            ] {
                let (a, b) = (
                    again.field(field).unwrap_or(0.0),
                    throw.field(field).unwrap_or(0.0),
                );
                assert!((a - b).abs() < 1e-6, "{name} {k} {field}: {a} {b}");
            }
            // The general search does not find every throw of a quaternion.
            searched += usize::from(expected.is_ok());
            let expected = expected.unwrap_or_else(|_| found.clone());
            for (i, (a, b)) in found.iter().zip(&expected).enumerate() {
                assert!(
                    (a - b).abs() < 1e-6 * b.abs().max(1.0),
                    "{name} {k} state {i}: {a} {b}"
                );
            }
        }
        assert!(searched >= 30, "{name}: {searched}");
    }
}

#[test]
fn what_no_state_has_is_refused() {
    let model = model_spec::load::load("disc", &[]).expect("the disc");
    let parameters = Layout::new(&model).default_parameters();
    let thrown = ThrownModel::new(&model).expect("a body");
    let known = thrown
        .state(&Throw::at_speed(20.0), [0.0; 2], &parameters)
        .expect("a state");
    let mut near = NearThrows::new(&thrown, &known);
    let mut state = vec![0.0; known.len()];
    let upright = Throw {
        launch: 90.0,
        nose: Some(0.0),
        ..Throw::at_speed(20.0)
    };
    assert!(
        near.state(&upright, [0.0; 2], &parameters, &mut state)
            .is_err()
    );
    let too_fast = Throw::at_speed(1e9);
    assert!(
        near.state(&too_fast, [0.0; 2], &parameters, &mut state)
            .is_err()
    );
}
