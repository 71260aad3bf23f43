//! Fits a disc to throws that three markers and a gyroscope measured, built in memory.
use hyzer::{DatasetBuilder, Error, Fit, Instrument, Model, Role, SensorKind};
const THROW: &str = "model='disc_quaternion'\nduration=1\n[throw]\nspin=700\nwobble=3\nspeed=";

fn main() -> Result<(), Error> {
    let disc = Model::load("disc_quaternion")?;
    let markers = [[0.1, 0.0, 0.01], [-0.05, 0.09, 0.01], [-0.05, -0.09, 0.01]];
    let times: Vec<f64> = (0..240).map(|i| f64::from(i) / 240.0).collect();
    let mut uniform = (1..).map(|i| ((f64::from(i) * 12.9898).sin() * 43758.5453).fract());
    let mut measured = |value: f64, error: f64| value + error * uniform.next().unwrap_or(0.0);
    let mut data = DatasetBuilder::new("disc_quaternion").markers(&markers);
    let gyroscope = SensorKind::Instrument(Instrument::Gyroscope);
    data = data.sensor("tag", gyroscope, [0.0; 3]);
    for speed in [12, 14, 16, 18] {
        let flight = disc.fly(&disc.parse_release("throw", &format!("{THROW}{speed}"))?)?;
        let mut positions = flight.marker_positions(&times, &markers);
        let coordinates = positions.iter_mut().flatten().flatten().flatten();
        coordinates.for_each(|x| *x = measured(*x, 2e-3));
        let mut rate = |name, t| Some(measured(flight.state(name, t)?, 0.05));
        let mut at = |t| Some([rate("p", t)?, rate("q", t)?, rate("r", t)?]);
        let rates: Vec<_> = times.iter().map(|&t| at(t)).collect();
        data = data.flight(&format!("throw{speed}"), Role::Fit, &times, positions);
        data = data.readings("tag", &rates);
    }
    let fit = Fit::of(&disc).fix("C_Da", 1.24).run(&data.build()?)?;
    let damping = fit.coefficient("C_Mq").expect("a coefficient");
    println!("C_Mq = {:.5} ± {:.5} s", damping.value, damping.std_error);
    assert!(fit.is_reliable() && (damping.value + 0.005).abs() < 4.0 * damping.std_error);
    Ok(())
}
