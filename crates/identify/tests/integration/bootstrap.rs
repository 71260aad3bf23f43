//! The bootstrap over flights against the standard errors of the fit.

use crate::support::release;
use dataset::synthesize::{Corruption, Plan, flights};
use identify::{FitOptions, fit};

#[test]
fn its_scatter_is_the_cluster_robust_standard_error() {
    let model = model_spec::load::load("ball", &[]).expect("built in");
    let release = release("serve", &model);
    let plan = Plan {
        flights: 40,
        noise: Corruption {
            sigma: 2e-3,
            ..Corruption::default()
        },
        ..Plan::default()
    };
    let made = flights(&model, &[release], &plan).expect("made");
    let options = FitOptions::default();
    let fitted = fit(&model, &made.dataset, &options).expect("a fit");
    let coefficient = &fitted.report.coefficients["C_D"];
    let draw = |seed: u64, number: u64| {
        let refit = fitted.bootstrap(seed, number, &options);
        refit.expect("not interrupted").expect("converges")[0]
    };
    let estimates: Vec<f64> = (0..300).map(|number| draw(1, number)).collect();
    let mean = estimates.iter().sum::<f64>() / 300.0;
    let square = |estimate: &f64| (estimate - mean).powi(2);
    let sd = (estimates.iter().map(square).sum::<f64>() / 299.0).sqrt();
    let robust = coefficient.std_error_cluster_robust.expect("of 40 flights");
    // 300 draws of 40 flights: 4 % by their number, and as much again by the shape of the distribution.
    assert!((sd / robust - 1.0).abs() < 0.15, "{sd} {robust}");
    assert!(
        (mean - coefficient.value).abs() < 0.3 * sd,
        "{mean} {coefficient:?}"
    );
    assert_eq!(draw(1, 7), estimates[7]);
    assert_ne!(draw(2, 7), estimates[7]);
}
