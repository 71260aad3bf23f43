//! Fits an effect of one's own to simulated throws.
use hyzer::{DatasetBuilder, Effect, Error, Fit, Model, Role};

fn main() -> Result<(), Error> {
    // A built-in model with an effect of our own: drag proportional to the angle of attack.
    let effect = "effect more_drag { site drag; coefficient C_D1 = 0 [1/rad]; replace C_D = previous + C_D1*alpha; }";
    let disc = Model::load("disc")?.with(&Effect::parse(effect)?)?;
    // Three simulated throws, measured at 120 Hz with errors of about 1 mm.
    let markers = [[0.1, 0.0, 0.01], [-0.05, 0.09, 0.01], [-0.05, -0.09, 0.01]];
    let times: Vec<f64> = (0..120).map(|i| f64::from(i) / 120.0).collect();
    let mut errors = (1..).map(|i| 2e-3 * ((f64::from(i) * 12.9898).sin() * 43758.5453).fract());
    let mut dataset = DatasetBuilder::new("disc").markers(&markers);
    for speed in [12.0, 15.0, 18.0] {
        let release = disc.release("backhand")?.with_initial("u", speed);
        let flight = disc.fly(&release.with_coefficient("C_D1", 0.1))?;
        let mut measured = flight.marker_positions(&times, &markers);
        let coordinates = measured.iter_mut().flatten().flatten().flatten();
        coordinates.zip(&mut errors).for_each(|(x, e)| *x += e);
        dataset = dataset.flight(&format!("throw{speed}"), Role::Fit, &times, measured);
    }
    // The coefficient of the effect, with its interval.
    let fit = Fit::of(&disc).run(&dataset.build()?)?;
    let drag = fit.coefficient("C_D1").expect("a coefficient of the model");
    let (value, [low, high]) = (drag.value, drag.interval(0.95));
    println!("C_D1 = {value:.3} 1/rad, 95 % interval {low:.3} to {high:.3}");
    assert!(fit.is_reliable() && (value - 0.1).abs() < 4.0 * drag.std_error);
    Ok(())
}
