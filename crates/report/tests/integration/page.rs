//! The page of a fit, made from reports that never were.

use crate::made;
use std::collections::BTreeMap;

use identify::{FitReport, FlightEvidence, MARKER};
use model_spec::model::Model;
use report::fit::{Figure, FitPage};

const TWO_MEGABYTES: usize = 2_000_000;

fn disc() -> Model {
    model_spec::load::load("disc", &[]).unwrap()
}

fn made(report: &FitReport, evidence: &[FlightEvidence]) -> (String, Vec<Figure>) {
    let model = disc();
    let page = FitPage {
        fit: None,
        report,
        evidence,
        model: &model,
        dataset: "throws",
    };
    let (html, figures) = report::fit::page(&page).parts();
    for figure in &figures {
        well_formed(figure);
    }
    loads_nothing(&html);
    assert!(html.len() < TWO_MEGABYTES, "{} bytes", html.len());
    (html, figures)
}

fn well_formed(figure: &Figure) {
    let svg = roxmltree::Document::parse(&figure.svg);
    let svg = svg.unwrap_or_else(|fault| panic!("{}: {fault}", figure.name));
    assert_eq!(svg.root_element().tag_name().name(), "svg");
    let safe = |c: char| c.is_ascii_alphanumeric() || c == '-';
    assert!(figure.name.chars().all(safe), "{}", figure.name);
    for node in svg.descendants().filter(roxmltree::Node::is_element) {
        for attribute in node.attributes() {
            let value = attribute.value();
            let number = matches!(
                attribute.name(),
                "x" | "y" | "d" | "cx" | "cy" | "width" | "height"
            );
            let broken = value.contains("NaN") || value.contains("inf");
            assert!(!number || !broken, "{}: {value}", figure.name);
        }
    }
}

/// Asserts that the HTML contains nothing that a browser would fetch.
fn loads_nothing(html: &str) {
    let without = html.replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for load in [
        "http:", "https:", "//cdn", "url(", "@import", " src=", "<script", "<link", "<img",
        "<iframe",
    ] {
        assert!(!without.contains(load), "{load}");
    }
}

/// Text of an HTML page, without figures and tags.
fn text(html: &str) -> String {
    let body = &html[html.find("<body>").unwrap()..];
    let (mut text, mut in_tag, mut skip) = (String::new(), false, 0);
    let mut rest = body;
    while let Some(c) = rest.chars().next() {
        if rest.starts_with("<svg") {
            skip += 1;
        } else if rest.starts_with("</svg>") {
            skip -= 1;
        }
        match c {
            '<' => {
                let cell = ["</td", "</th"].iter().any(|t| rest.starts_with(t));
                text.push_str(if cell && skip == 0 { " | " } else { "" });
                in_tag = true;
            }
            '>' => in_tag = false,
            c if !in_tag && skip == 0 => text.push(c),
            _ => {}
        }
        rest = &rest[c.len_utf8()..];
    }
    let lines = text.lines().map(|l| l.trim().trim_end_matches('|').trim());
    lines
        .filter(|l| !l.is_empty())
        .collect::<Vec<_>>()
        .join("\n")
}

#[test]
fn the_words_of_a_page() {
    let (html, figures) = made(&made::report(4), &made::evidence(4));
    insta::assert_snapshot!("words", text(&html));
    let names: Vec<String> = figures
        .iter()
        .map(|f| format!("{}: {}", f.name, f.title))
        .collect();
    insta::assert_snapshot!("figures", names.join("\n"));
}

#[test]
fn the_same_report_gives_the_same_page() {
    let (report, evidence) = (made::report(9), made::evidence(5));
    assert_eq!(made(&report, &evidence), made(&report, &evidence));
}

#[test]
fn names_from_outside_are_escaped() {
    const EVIL: &str = "<script>alert(1)</script>\"'&\u{1}\u{ffff}";
    let (mut report, mut evidence) = (made::report(8), made::evidence(3));
    report.model = EVIL.into();
    report.schema = EVIL.into();
    report.effects = vec![EVIL.into()];
    report.not_identifiable[0].reason = EVIL.into();
    report.not_identifiable[0].combination = vec![EVIL.into()];
    report.flights[1].file = EVIL.into();
    report.flights[2].notes = vec![EVIL.into()];
    report.profiles[0].name = EVIL.into();
    report.seconds.insert(EVIL.into(), 1.0);
    let mut coefficient = report.coefficients["C_L0"].clone();
    coefficient.unit = EVIL.into();
    report.coefficients.insert(EVIL.into(), coefficient);
    let row = report.correlations["C_L0"].clone();
    report.correlations.insert(EVIL.into(), row);
    let axis = report.residuals["x"].clone();
    report.residuals = BTreeMap::from([(EVIL.into(), axis)]);
    let noise = report.noise.get_mut(MARKER).unwrap();
    noise.axes.insert(format!("a{EVIL}"), noise.axes["x"]);
    evidence[0].file = EVIL.into();
    evidence[0].markers[0] = EVIL.into();
    evidence[0].state_names[0] = EVIL.into();
    let model = disc();
    let page = FitPage {
        fit: None,
        report: &report,
        evidence: &evidence,
        model: &model,
        dataset: EVIL,
    };
    let (html, figures) = report::fit::page(&page).parts();
    loads_nothing(&html);
    assert!(html.contains("&lt;script&gt;alert(1)"));
    figures.iter().for_each(well_formed);
}

#[test]
fn what_is_no_number_breaks_nothing() {
    for bad in [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        1e300,
        -1e-300,
    ] {
        let (mut report, mut evidence) = (made::report(9), made::evidence(2));
        report.residual_rms = made::marker_rms(bad);
        let noise = report.noise.get_mut(MARKER).unwrap();
        noise.sigma = bad;
        noise.lag1_autocorrelation = bad;
        noise.interval_s = bad;
        noise.outlier_fraction = bad;
        for axis in noise.axes.values_mut() {
            axis.sigma = bad;
        }
        for (i, coefficient) in report.coefficients.values_mut().enumerate() {
            match i {
                0 => coefficient.value = bad,
                1 => coefficient.std_error = bad,
                2 => coefficient.interval = [bad, bad],
                3 => coefficient.std_error_cluster_robust = Some(bad),
                4 => coefficient.model_value = bad,
                _ => coefficient.prior = Some([bad, bad]),
            }
        }
        report.correlations.values_mut().for_each(|row| {
            row.values_mut().for_each(|v| *v = bad);
        });
        let flights = report.flights.iter_mut();
        flights.for_each(|f| f.residual_rms = made::marker_rms(bad));
        report.not_identifiable[0].relative_error = bad;
        report.not_identifiable[0]
            .weights
            .insert("C_L0".into(), bad);
        for profile in &mut report.profiles {
            profile.points[3] = [bad, bad];
            profile.interval[0] = Some(bad);
        }
        for axis in report.residuals.values_mut() {
            axis.autocorrelation[2] = bad;
            axis.band = bad;
            axis.quantiles[5] = [bad, bad];
        }
        report.seconds.insert("total".into(), bad);
        evidence[0].predicted[10][0] = [bad; 3];
        evidence[0].states[4] = vec![bad; 12];
        evidence[0].quantities[7][0] = bad;
        evidence[1].measured[3][1] = Some([bad; 3]);
        made(&report, &evidence);
    }
}

#[test]
fn little_is_enough() {
    let report = made::report(1);
    let (html, _) = made(&report, &[]);
    assert!(!html.contains("id=\"tracks\"") && !html.contains("id=\"states\""));
    made(&report, &made::evidence(1));
    // A flight of one sample, one of none, one of a marker never seen, one whose tables are shorter than its times.
    let mut evidence = vec![
        made::flight(1, 1),
        made::flight(2, 0),
        made::flight(3, 40),
        made::flight(5, 40),
    ];
    evidence[2]
        .measured
        .iter_mut()
        .for_each(|row| row[1] = None);
    evidence[3].outlier.clear();
    evidence[3].states.truncate(3);
    evidence[3].quantities.clear();
    made(&report, &evidence);
    // Nothing was found at all.
    let mut empty = made::report(0);
    empty.coefficients.clear();
    empty.correlations.clear();
    empty.profiles.clear();
    empty.not_identifiable.clear();
    empty.residuals.clear();
    empty.noise.clear();
    empty.seconds.clear();
    let (_, figures) = made(&empty, &[]);
    assert_eq!(figures, []);
}

#[test]
fn much_stays_small() {
    let mut report = made::report(10_000);
    let long = "a long note ".repeat(400);
    report
        .flights
        .iter_mut()
        .for_each(|f| f.notes = vec![long.clone()]);
    let row = report.correlations["C_L0"].clone();
    for i in 0..200 {
        report.correlations.insert(format!("C_{i}"), row.clone());
    }
    let mut evidence: Vec<FlightEvidence> = (1..=30).map(|n| made::flight(n, 4000)).collect();
    for flight in &mut evidence {
        flight.markers.extend(["m4", "m5", "m6"].map(str::to_owned));
        for row in &mut flight.measured {
            row.extend(row.clone());
        }
        for row in &mut flight.predicted {
            row.extend(row.clone());
        }
    }
    let (html, figures) = made(&report, &evidence);
    assert!(html.contains("of 7500; all are in flights.csv"));
    assert_eq!(
        figures
            .iter()
            .filter(|f| f.name.starts_with("tracks"))
            .count(),
        12
    );
}

#[test]
fn alarms_are_said() {
    let mut report = made::report(9);
    let (calm, _) = made(&report, &[]);
    assert!(!calm.contains("Do not rely") && !calm.contains("At a bound"));
    report.reliable = false;
    report.cautions = vec!["the fit did not converge in 9 steps".to_owned()];
    report.noise.get_mut(MARKER).unwrap().outlier_fraction = 0.04;
    report.coefficients.get_mut("C_D0").unwrap().at_bound = true;
    report
        .coefficients
        .get_mut("C_La")
        .unwrap()
        .std_error_cluster_robust = Some(0.3);
    report
        .residuals
        .get_mut("y")
        .unwrap()
        .whitened_autocorrelation[1] = 0.4;
    report.flights[7].residual_rms = made::marker_rms(0.01);
    let (html, _) = made(&report, &[]);
    for text in [
        "1 held-out flight was predicted with an error above 3 times",
        "Do not rely on this fit",
        "The fit did not converge in 9 steps",
        "are not valid: C_D0.",
        "4.0\u{a0}% of the points",
        "C_La and C_Da",
        "The whitened residuals along y are autocorrelated",
        "1 flight was cut",
        "throw02.csv: fitted again",
    ] {
        assert!(html.contains(text), "{text}");
    }
}

#[test]
fn what_was_left_out_is_counted_by_itself() {
    let mut report = made::report(13);
    let (_, all) = made(&report, &[]);
    assert!(all.iter().any(|figure| figure.name == "rms"));
    for flight in &mut report.flights {
        let kept = ["throw01.csv", "throw02.csv", "throw04.csv"];
        if !kept.contains(&flight.file.as_str()) {
            flight.initial.clear();
            flight.residual_rms.clear();
            flight.outcome = identify::FlightOutcome::Excluded {
                reason: String::new(),
            };
        }
    }
    let (html, figures) = made(&report, &[]);
    assert!(html.contains("fitted to 2 flights"));
    assert!(html.contains("1 flight held out for validation. 10 flights were excluded."));
    assert!(html.contains("<h3>Excluded</h3>") && !html.contains("0.00\u{a0}mm"));
    // Too few are left for a histogram.
    assert!(figures.iter().all(|figure| figure.name != "rms"));
}

#[test]
fn states_are_drawn_as_they_were_flown() {
    let evidence = made::evidence(1);
    let (_, figures) = made(&made::report(1), &evidence);
    let states = figures.iter().find(|figure| figure.name == "states-01");
    let csv = &states.expect("states").csv;
    // A title may contain commas.
    let lines: Vec<(&str, &str)> = csv
        .lines()
        .filter_map(|line| line.split_once(",line,"))
        .collect();
    let cell =
        |line: &(&str, &str), at: usize| line.1.split(',').nth(at).expect("a cell").to_owned();
    let mut series: Vec<(&str, String)> =
        lines.iter().map(|line| (line.0, cell(line, 0))).collect();
    series.dedup();
    assert!(series.len() >= evidence[0].state_names.len(), "{series:?}");
    let times = lines
        .iter()
        .map(|line| cell(line, 1).parse().expect("a time"));
    let (first, last) = times.fold(
        (f64::INFINITY, 0.0),
        |(first, last): (f64, f64), time: f64| (first.min(time), last.max(time)),
    );
    let end = evidence[0].times[evidence[0].times.len() - 1];
    assert!(
        first == 0.0 && (last - end).abs() < 1e-4,
        "{first} {last} {end}"
    );
    assert!(lines.len() > 2 * series.len());
}

#[test]
fn an_outlier_far_away_does_not_change_the_tracks() {
    let tracks = |at: Option<[f64; 3]>| {
        let mut evidence = made::evidence(1);
        evidence[0].measured[10][0] = at;
        evidence[0].outlier[10][0] = at.is_some();
        let (_, figures) = made(&made::report(1), &evidence);
        let tracks = figures
            .into_iter()
            .filter(|figure| figure.name.starts_with("track"));
        tracks.map(|figure| figure.svg).collect::<Vec<_>>()
    };
    let [x, y, z] = made::evidence(1)[0].predicted[10][0];
    let without = tracks(None);
    assert!(!without.is_empty());
    // Over time it may be drawn by another coordinate.
    assert!(tracks(Some([x + 1000.0, y, z])) == tracks(Some([x + 2000.0, y, z])));
    assert!(tracks(Some([x, y + 1000.0, z])) == tracks(Some([x, y + 2000.0, z])));
    assert!(tracks(Some([x, y, z])) != without);
}

#[test]
fn the_values_of_summaries_are_a_table() {
    let mut report = made::report(2);
    assert_eq!(report::fit::summaries_csv(&report), None);
    report.flights[0].is_summary = true;
    report.flights[0].seen.push(identify::SeenValue {
        name: "Carry".into(),
        measures: "carry".into(),
        unit: "yd".into(),
        measured: 250.0,
        predicted: 247.5,
        sigma: 2.0,
    });
    let csv = report::fit::summaries_csv(&report).expect("a table");
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[1], "throw01.csv,fit,carry,yd,250,247.5,2");
}
