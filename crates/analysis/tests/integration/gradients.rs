//! Compares the derivatives of the landing position with respect to the quantities of a throw and to parameters with
//! finite differences of flights.

use analysis::design::{By, ThrownBody};
use flight::throw::{FIELDS, Throw};
use ode::{IntegrationOptions, Method};

fn tight() -> IntegrationOptions {
    IntegrationOptions {
        method: Method::Dop853,
        ..IntegrationOptions::with_tolerance(1e-12)
    }
}

fn backhand() -> Throw {
    Throw {
        launch: 8.0,
        heading: 12.0,
        height: 1.5,
        nose: Some(3.0),
        hyzer: Some(9.0),
        spin: Some(620.0),
        wobble: Some(4.0),
        ..Throw::at_speed(18.0)
    }
}

#[test]
fn derivatives_are_the_slopes_of_flights() {
    for name in ["disc", "disc_quaternion", "discus", "ball"] {
        let body = ThrownBody::new(model_spec::load::load(name, &[]).expect(name)).expect(name);
        let parameters = body.compiled.layout().default_parameters();
        let flights = body.with_parameters(parameters.clone());
        let mut throw = backhand();
        if !body.thrown.has_attitude() {
            throw = Throw {
                nose: None,
                hyzer: None,
                spin: None,
                wobble: None,
                ..throw
            };
        }
        let fields = body.fields();
        let names = ["I_a", "C_D0", "C_D", "wind_y", "rho"];
        let layout = body.compiled.layout();
        let places = names
            .iter()
            .filter_map(|name| Some(layout.parameter(name)?.index()));
        let places: Vec<usize> = places.collect();
        let mut by: Vec<By> = places.iter().map(|k| By::Parameter(*k)).collect();
        by.extend(fields.iter().map(|k| By::Throw(*k)));
        let exact = flights
            .fly_with_derivatives(&throw, None, &by, &tight())
            .expect(name)
            .landing();
        assert_eq!(exact.position_by.len(), by.len());
        for (k, by) in by.iter().enumerate() {
            let at = |steps: f64| {
                let (mut throw, mut parameters) = (throw, parameters.clone());
                let step = match by {
                    By::Throw(_) => 4e-3,
                    By::Parameter(place) if parameters[*place] == 0.0 => 1e-3,
                    By::Parameter(place) => 1e-3 * parameters[*place].abs(),
                };
                match by {
                    By::Throw(field) => {
                        let name = FIELDS[*field].0;
                        throw.set(name, throw.field(name).expect(name) + steps * step);
                    }
                    By::Parameter(place) => parameters[*place] += steps * step,
                };
                let flights = body.with_parameters(parameters);
                let landing = flights.fly(&throw, None, &tight()).expect(name).landing();
                (landing.position / step, landing.time / step)
            };
            // Of fourth order.
            let [a, b, c, d] = [1.0, -1.0, 2.0, -2.0].map(at);
            let slope = (a.0 - b.0) * (2.0 / 3.0) - (c.0 - d.0) / 12.0;
            let time = (a.1 - b.1) * (2.0 / 3.0) - (c.1 - d.1) / 12.0;
            let error = (slope - exact.position_by[k]).norm() / slope.norm().max(1e-3);
            assert!(
                error < 1e-5,
                "{name} {by:?}: {slope} {}",
                exact.position_by[k]
            );
            let error = (time - exact.time_by[k]).abs() / time.abs().max(1e-3);
            assert!(error < 1e-5, "{name} {by:?}: {time} {}", exact.time_by[k]);
        }
    }
}
