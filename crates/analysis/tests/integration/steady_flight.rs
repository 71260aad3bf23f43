//! Steady flight, which a constant wind carries along.

use crate::eigenvalues::{body, defaults};
use analysis::stability::{BoundBody, Trim, modes, trim};

#[test]
fn a_constant_wind_carries_steady_flight_along() {
    let disc = body("disc");
    let calm = defaults(&disc);
    let mut parameters = calm.parameters.clone();
    let wind = disc.compiled.layout().components("wind").expect("an input");
    for (component, speed) in wind.iter().zip([3.0, -2.0, 0.5]) {
        parameters[component.index()] = speed;
    }
    let windy = disc.with_parameters(parameters);
    let of = |body: &BoundBody<'_>| trim(body, -60.0).expect("a steady flight");
    let (calm, windy) = (of(&calm), of(&windy));
    assert!(calm.turn.abs() > 0.1, "it turns");
    let numbers = |own: &Trim| [own.throw.speed, own.throw.launch, own.turn];
    for (calm, windy) in numbers(&calm).into_iter().zip(numbers(&windy)) {
        assert!((calm - windy).abs() < 1e-6, "{calm} {windy}");
    }
    let values = |own: &Trim| modes(&own.linearised, own.turn).modes;
    for (calm, windy) in values(&calm).iter().zip(values(&windy)) {
        assert!(
            (calm.value - windy.value).norm() < 1e-6,
            "{} {}",
            calm.value,
            windy.value
        );
    }
}
