//! What is observed at many states, in lanes, is the formula of the observation.

use flight::LaneObserver;

const PROBE: &str = "model probe;
param a = 2;
param b = 3 m;
frame N;
state x = 1 m;
der(x) = 0 [m/s];
observe place = (a*x, sin(a)*b, b + x) in N;
";

#[test]
fn each_state_is_observed_with_its_parameters() {
    let model = model_spec::load::from_text("probe.hyz", PROBE, &[]).expect("a model");
    let observer = LaneObserver::new(&model);
    let x: Vec<f64> = (0..19).map(|k| 0.3 * f64::from(k)).collect();
    let varied: Vec<f64> = x.iter().map(|x| 1.0 + x).collect();
    for a in [None, Some(&varied[..])] {
        let columns: Vec<(usize, &[f64])> = a.iter().map(|a| (0, *a)).collect();
        let observed = observer.observe(std::slice::from_ref(&x), &[2.0, 3.0], &columns);
        for (k, x) in x.iter().enumerate() {
            let a = a.map_or(2.0, |a| a[k]);
            let expected = [a * x, a.sin() * 3.0, 3.0 + x];
            for (column, expected) in observed.iter().zip(expected) {
                assert!(
                    (column[k] - expected).abs() < 1e-14,
                    "{k}: {} {expected}",
                    column[k]
                );
            }
        }
    }
}
