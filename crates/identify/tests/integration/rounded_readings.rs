//! Readings rounded to coarse steps, whose scatter does not show their errors.

use dataset::synthesize::{Plan, flights};
use identify::{FitOptions, fit};
use model_spec::compose::Instrument;

use crate::support::release;
use crate::units_of_readings::{readings, with_readings};

#[test]
fn rounded_readings_do_not_outweigh_the_markers() {
    let model = model_spec::load::load("disc", &[]).expect("built in");
    let release = release("backhand", &model);
    let plan = Plan {
        flights: 4,
        duration: Some(0.6),
        ..Plan::default()
    };
    let dataset = flights(&model, &[release], &plan).expect("made").dataset;
    let alone = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
    for (instrument, step) in [(Instrument::Speed, 1.0), (Instrument::Gyroscope, 2.0)] {
        let exact = readings(&model, &dataset, instrument);
        let rounded = |part: f64| (part / step).round() * step;
        let dataset = with_readings(&dataset, instrument, None, |flight, sample| {
            exact[flight][sample].map(rounded)
        });
        let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
        let found = found.with_lack_of_fit(1).expect("a test").report;
        assert!(found.reliable, "{instrument:?}: {:?}", found.cautions);
        let sigma = found.noise[instrument.name()].sigma;
        assert!(sigma > 0.28 * step, "{instrument:?}: {sigma}");
        let [own, alone] = [&found, &alone.report].map(|report| &report.coefficients["C_L0"]);
        let difference = (own.value - alone.value).abs();
        assert!(difference < 3.0 * alone.std_error, "{own:?} {alone:?}");
    }
}
