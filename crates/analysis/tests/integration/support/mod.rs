//! Flights by the oracle's vector mechanics and the classic Runge–Kutta method: nothing that `design` flies with takes part.

use analysis::design::{ThrowFlights, ThrownBody};
use flight::throw::Throw;
use nalgebra::Vector3;
use oracle::{Chart, Point, derivatives};

/// Step size of the oracle's integration, s.
const STEP: f64 = 1e-3;

/// Compiles a built-in model, given by its name, as a body that can be thrown.
pub fn body(name: &str) -> ThrownBody {
    ThrownBody::new(model_spec::load::load(name, &[]).expect(name)).expect(name)
}

/// Compiles a model that is not built in: a plate with lift, drag, damping and an unsteady pitching moment. It has
/// neither a roll moment due to spin nor a spin-down, and its states have unusual names.
pub fn plate() -> ThrownBody {
    let text = include_str!("plate.hyz");
    let model = model_spec::load::from_text("plate", text, &[]).unwrap_or_else(|e| panic!("{e}"));
    ThrownBody::new(model).expect("a body")
}

/// Positions of the mass centre in a flight that the oracle simulates, at intervals of [`STEP`]; the last one is the
/// landing.
pub fn oracle_path(flights: &ThrowFlights<'_>, throw: &Throw) -> Vec<Vector3<f64>> {
    let model = &flights.body.model;
    let chart = Chart::declared(model).expect("a chart");
    let mut point = Point::defaults(model);
    if let Some(wind) = model.inputs.iter().position(|input| input.name == "wind") {
        let components = flights.body.compiled.layout().components("wind");
        let values: Vec<f64> = components
            .into_iter()
            .flatten()
            .map(|c| flights.parameters[c.index()])
            .collect();
        point.inputs[wind] = Vector3::from_column_slice(&values);
    }
    let mut x = flights.state(throw, None).expect("a state");
    // The motion at release as the oracle reads it is that of the throw.
    let start = chart.physical(&x);
    let (heading, launch) = (throw.heading.to_radians(), throw.launch.to_radians());
    let along = Vector3::new(
        heading.cos() * launch.cos(),
        heading.sin() * launch.cos(),
        launch.sin(),
    );
    assert!((start.velocity - along * throw.speed).norm() < 1e-8);
    assert!((start.position - Vector3::new(0.0, 0.0, throw.height)).norm() < 1e-8);
    let mut at = |states: &[f64]| {
        point.states = states.to_vec();
        derivatives(model, &point).expect("derivatives")
    };
    let moved = |x: &[f64], d: &[f64], h: f64| -> Vec<f64> {
        x.iter().zip(d).map(|(x, d)| x + h * d).collect()
    };
    let mut step = |x: &[f64], h: f64| -> Vec<f64> {
        let k1 = at(x);
        let k2 = at(&moved(x, &k1, h / 2.0));
        let k3 = at(&moved(x, &k2, h / 2.0));
        let k4 = at(&moved(x, &k3, h));
        let next = x.iter().enumerate();
        next.map(|(i, x)| x + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
            .collect()
    };
    let mut path = vec![start.position];
    for _ in 0..60_000 {
        let next = step(&x, STEP);
        let place = chart.physical(&next).position;
        if place.z <= 0.0 {
            let (mut low, mut high) = (0.0, STEP);
            for _ in 0..30 {
                let middle = 0.5 * (low + high);
                let is_above = chart.physical(&step(&x, middle)).position.z > 0.0;
                *(if is_above { &mut low } else { &mut high }) = middle;
            }
            path.push(chart.physical(&step(&x, low)).position);
            return path;
        }
        x = next;
        path.push(place);
    }
    panic!("the flight does not end");
}

/// Minimum distance, m, between the point `to` and a path, given by points that are joined by straight segments.
pub fn distance(path: &[Vector3<f64>], to: Vector3<f64>) -> f64 {
    let pairs = path.windows(2).map(|pair| {
        let along = pair[1] - pair[0];
        let part = ((to - pair[0]).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
        (pair[0] + along * part - to).norm()
    });
    pairs.fold(f64::INFINITY, f64::min)
}
