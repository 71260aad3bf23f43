//! The opening of the page of a diagnosis, the bands of its predictions, and the viewer, from the flights of
//! `examples/mystery`.

use crate::browser;
use std::sync::OnceLock;

use dataset::Role;
use diagnose::{Diagnosis, DiagnosisOptions, Verdict, diagnose};
use identify::{Fit, FlightEvidence, FlightId};
use report::diagnosis::{DiagnosisPage, Fits};
use report::fit::Figure;
use report::prediction_band;
use report::viewer::View;

/// Diagnosis of the dataset `examples/mystery`, computed once for all tests.
fn mystery() -> &'static Diagnosis {
    static FOUND: OnceLock<Diagnosis> = OnceLock::new();
    FOUND.get_or_init(|| {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/mystery");
        let dataset = dataset::load(folder.as_ref()).unwrap();
        let model = model_spec::load::load(&dataset.model, &[]).unwrap();
        diagnose(&model, &dataset, &DiagnosisOptions::default()).unwrap()
    })
}

fn evidence(fit: &Fit) -> Vec<FlightEvidence> {
    let flights = 0..fit.report.flights.len();
    flights
        .filter_map(|i| fit.evidence(FlightId::new(i)))
        .collect()
}

fn page() -> (String, Vec<Figure>) {
    let found = mystery();
    let after = found.after.as_ref().map(|(_, fit)| fit);
    let page = DiagnosisPage {
        report: &found.report,
        before: &evidence(&found.before),
        after: &evidence(after.unwrap()),
        fits: Some(Fits {
            before: &found.before,
            after,
        }),
        extended: None,
    };
    report::diagnosis::page(&page).parts()
}

#[test]
fn the_page_opens_with_what_is_wrong_and_how_sure_it_is() {
    assert_eq!(mystery().report.verdict, Verdict::Identified);
    let (html, figures) = page();
    let opening = &html[..html.find("id=\"explanations\"").unwrap()];
    for text in [
        "The lift stops growing with the angle of attack",
        "° C_L is ",
        "; the model without it has ",
        "standard errors away from zero",
        "<figure id=\"finding\">",
        "angle of attack α, °",
    ] {
        assert!(opening.contains(text), "{text}");
    }
    let equation = html.find("<math").expect("the equation of the effect");
    assert!(html[equation..].contains("<mi>max</mi>"));
    let text = &figures.iter().find(|f| f.name == "finding").unwrap().csv;
    let rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let of = |series: &str| -> Vec<(f64, f64)> {
        let rows = rows
            .clone()
            .filter(|row| row[1] == "line" && row[2] == series);
        rows.map(|row| (row[3].parse().unwrap(), row[5].parse().unwrap()))
            .collect()
    };
    let (before, after) = (of("before"), of("extended"));
    assert!(before.len() > 20 && before.len() == after.len());
    // What was put in: C_L = 0.188 + 2.37 α − 4 max(α − 8°, 0)².
    for (x, value) in &after {
        let alpha = x.to_radians();
        let truth = 0.188 + 2.37 * alpha - 4.0 * (alpha - 8f64.to_radians()).max(0.0).powi(2);
        assert!((value - truth).abs() < 0.01, "{x}°: {value}, truth {truth}");
    }
    let last = before.last().unwrap().1 - after.last().unwrap().1;
    assert!(last > 0.2, "{last}");
}

#[test]
fn the_bands_hold_what_is_measured() {
    let fit = &mystery().after.as_ref().unwrap().1;
    let sigma = fit.noise().sigma;
    let (mut inside, mut all, mut grows) = (0, 0, true);
    for (i, flight) in fit.report.flights.iter().enumerate() {
        if flight.role != Role::HeldOut {
            continue;
        }
        let id = FlightId::new(i);
        let (band, seen) = (prediction_band(fit, id).unwrap(), fit.evidence(id).unwrap());
        let size = |sample: usize| {
            band.std_error[sample]
                .iter()
                .flatten()
                .copied()
                .fold(0.0, f64::max)
        };
        grows &= size(seen.times.len() - 1) > size(0);
        for sample in band.first..seen.times.len() {
            for marker in 0..seen.markers.len() {
                if seen.measured[sample][marker].is_none() || seen.outlier[sample][marker] {
                    continue;
                }
                let residual = seen.residual(sample, marker).unwrap();
                for axis in 0..3 {
                    let half = 1.96 * band.std_error[sample][marker][axis].hypot(sigma[axis]);
                    assert!(half < 0.05, "a band of {half} m says nothing");
                    inside += usize::from(residual[axis].abs() < half);
                    all += 1;
                }
            }
        }
    }
    assert!(grows && all > 1000);
    assert!(inside as f64 > 0.93 * f64::from(all), "{inside} of {all}");
}

#[test]
fn the_viewer_plays_when_it_is_clicked() {
    let fit = &mystery().before;
    let html = View::of_fit(fit, "").html("mystery").unwrap();
    for load in ["http:", "https:", "//cdn", "@import", " src="] {
        assert!(!html.contains(load), "{load}");
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("flights.html");
    std::fs::write(&file, html).unwrap();
    let Some(mut browser) = browser::Browser::open(&file) else {
        println!("skipped: no chromium");
        return;
    };
    let time = "parseFloat(document.getElementById('time').textContent)";
    assert_eq!(browser.number(time), 0.0);
    browser.click("#play");
    assert!(
        browser.wait_for(&format!("{time} > 0.05")),
        "it does not play"
    );
    browser.click("#play");
    let stopped = browser.number(time);
    assert_eq!(
        browser.text("document.getElementById('play').textContent"),
        "Play"
    );
    std::thread::sleep(std::time::Duration::from_millis(200));
    assert_eq!(browser.number(time), stopped, "it does not pause");
    // The picture changes with the view, and something is drawn.
    let picture = "document.getElementById('view').toDataURL()";
    let free = browser.text(picture);
    browser.click("[data-view=side]");
    let side = browser.text(picture);
    assert!(free.len() > 5000 && side.len() > 2000 && free != side);
    browser.key("ArrowRight");
    assert!(browser.number(time) > stopped);
}
