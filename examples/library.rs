//! Fits an effect of one's own to simulated throws.

use hyzer::{DatasetBuilder, Error, FitOptions, Model, Role};

fn main() -> Result<(), Error> {
    // A model with an effect of our own: drag that grows with the angle of attack.
    let disc = Model::load("disc")?.with_effect_text(
        "effect more_drag { site drag; coefficient C_D1 = 0 [1/rad]; replace C_D = previous + C_D1*alpha; }",
    )?;
    // Three simulated throws, sampled at 120 Hz with errors of about 1 mm, as a dataset.
    let markers = [[0.1, 0.0, 0.01], [-0.05, 0.09, 0.01], [-0.05, -0.09, 0.01]];
    let times: Vec<f64> = (0..120).map(|i| f64::from(i) / 120.0).collect();
    let mut dataset = DatasetBuilder::new("disc");
    for (i, position) in markers.iter().enumerate() {
        dataset = dataset.marker(&format!("m{i}"), *position);
    }
    let mut error = (1..).map(|i| 2e-3 * ((f64::from(i) * 12.9898).sin() * 43758.5453).fract());
    for (i, speed) in [12.0, 15.0, 18.0].into_iter().enumerate() {
        let release = disc.release("backhand")?;
        let release = release
            .with_initial("u", speed)
            .with_coefficient("C_D1", 0.1);
        let mut positions = disc.fly(&release)?.marker_positions(&times, &markers);
        for coordinate in positions.iter_mut().flatten().flatten().flatten() {
            *coordinate += error.next().unwrap_or(0.0);
        }
        dataset = dataset.flight(&format!("throw{i}"), Role::Fit, times.clone(), positions);
    }
    let fit = hyzer::fit(&disc, &dataset.build()?, &FitOptions::default())?;
    let drag = fit.coefficient("C_D1").expect("a coefficient of the model");
    println!(
        "C_D1 = {:.4} 1/rad, 95 % interval {:.4?}",
        drag.value,
        drag.interval(0.95)
    );
    assert!(fit.converged() && (drag.value - 0.1).abs() < 4.0 * drag.std_error);
    Ok(())
}
