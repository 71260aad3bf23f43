//! Derivatives in a wind against the oracle, which evaluates the same syntax tree with vectors and without the compiler.

use nalgebra::Vector3;
use ode::OdeRhs;
use oracle::{Point, derivatives};

use super::{MODELS, compiled, released, throw};

#[test]
fn the_tape_has_the_derivatives_of_the_vector_tree() {
    const WINDS: [&str; 3] = [
        "profile = \"log\"\nspeed = 6.0\ndirection = 50.0\n[wind.gusts]\nmodel = \"dryden\"\nseed = 3\nheading = 15.0",
        "profile = \"power\"\nspeed = 6.0\nexponent = 0.3\n[wind.gusts]\nmodel = \"dryden\"\nseed = 3\nsd = [1.0, 0.8, 0.5]\nlength = [9.0, 8.0, 2.0]",
        "table = [[0.0, 1.0, -2.0, 0.0], [3.0, 4.0, 1.0, 0.5], [6.0, 2.0, 1.0, 0.0]]",
    ];
    for name in MODELS {
        for wind in WINDS {
            let text = format!("{}[wind]\n{wind}\n", throw(name, "duration = 1.0"));
            let (release, model) = released(&text);
            let compiled = compiled(&model);
            let parameters = compiled.release_parameters(&release).constants;
            let layout = compiled.layout();
            let value = |name: &str| parameters[layout.parameter(name).expect(name).index()];
            let mut point = Point::defaults(&model);
            point.params = model.params.iter().map(|c| value(&c.name)).collect();
            let bound = compiled.bind(parameters.clone());
            let height = layout.state("z").expect("a height").index();
            for (time, z) in [(0.0, 1.5), (0.7, 4.2), (1.9, 0.02), (2.0, -0.1)] {
                let mut state = release.state();
                state[height] = z;
                (point.time, point.states) = (time, state.clone());
                point.inputs = vec![Vector3::zeros(); model.inputs.len()];
                let expected = derivatives(&model, &point).expect("derivatives");
                let mut found: Box<[f64]> = vec![0.0; state.len()].into();
                bound.rhs().derivative(time, &state.into(), &mut found);
                let size = expected.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
                for (a, b) in found.iter().zip(&expected) {
                    assert!((a - b).abs() < 1e-11 * size, "{name} {wind} {z} {a} {b}");
                }
            }
        }
    }
}
