//! The page of a diagnosis, made from reports that never were.

use crate::found;
use crate::made;
use dataset::Role;
use diagnose::{Report, Verdict};
use identify::FlightEvidence;
use report::diagnosis::DiagnosisPage;
use report::fit::Figure;

const TWO_MEGABYTES: usize = 2_000_000;

/// HTML report of a diagnosis and its figures.
#[derive(Debug, PartialEq)]
pub struct Made {
    pub html: String,
    pub figures: Vec<Figure>,
}

fn make(page: &DiagnosisPage<'_>) -> Made {
    let (html, figures) = report::diagnosis::page(page).parts();
    Made { html, figures }
}

pub fn page(report: &Report, before: &[FlightEvidence], after: &[FlightEvidence]) -> Made {
    let extended = report.extended_model.as_ref().map(|_| found::EXTENDED);
    let made = make(&DiagnosisPage {
        report,
        fits: None,
        before,
        after,
        extended,
    });
    check(&made);
    made
}

/// Asserts what must hold for every report: it loads nothing, contains no script, and contains each of its figures
/// exactly once, as valid SVG.
fn check(made: &Made) {
    let without = made
        .html
        .replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for load in [
        "http:", "https:", "//cdn", "url(", "@import", " src=", "<script", "<link", "<img",
        "<iframe",
    ] {
        assert!(!without.contains(load), "{load}");
    }
    assert!(made.html.len() < TWO_MEGABYTES, "{} bytes", made.html.len());
    for Figure {
        name: stem, svg, ..
    } in &made.figures
    {
        let tree =
            roxmltree::Document::parse(svg).unwrap_or_else(|fault| panic!("{stem}: {fault}"));
        assert!(
            stem.chars().all(|c| c.is_ascii_alphanumeric() || c == '-'),
            "{stem}"
        );
        assert_eq!(made.figures.iter().filter(|f| f.name == *stem).count(), 1);
        assert!(
            made.html.contains(&format!("<figure id=\"{stem}\">")),
            "{stem}"
        );
        let has = |tag: &str| {
            tree.root_element()
                .children()
                .any(|n| n.has_tag_name(("http://www.w3.org/2000/svg", tag)) && n.text().is_some())
        };
        assert!(has("title") && has("desc"), "{stem} is not told in words");
        for node in tree.descendants().filter(roxmltree::Node::is_element) {
            for attribute in node.attributes().filter(|a| a.name() != "aria-label") {
                let value = attribute.value();
                assert!(
                    !value.contains("NaN") && !value.contains("inf"),
                    "{stem}: {value}"
                );
            }
        }
    }
    assert!(!made.html.contains("<desc></desc>"));
}

/// Example of a diagnosis report with the given verdict, and the HTML page made from it.
pub fn of(verdict: Verdict) -> (Report, Made) {
    let after = made::evidence(9);
    let before = found::without(&after);
    let report = found::report(verdict, &after);
    let after = if report.extended_model.is_some() {
        after
    } else {
        Vec::new()
    };
    let made = page(&report, &before, &after);
    (report, made)
}

fn has(made: &Made, section: &str) -> bool {
    made.html.contains(&format!("id=\"{section}\""))
}

#[test]
fn verdicts_have_their_words() {
    for (verdict, words) in [
        (Verdict::Adequate, "No model error detected."),
        (
            Verdict::Identified,
            "The model lacks one effect: zero-lift-drag-angle.",
        ),
        (
            Verdict::Ambiguous,
            "The model lacks one of 3 effects; these flights cannot distinguish them.",
        ),
        (
            Verdict::Unattributed,
            "The model lacks an effect, and no candidate explains what is missing.",
        ),
        (
            Verdict::Negligible,
            "The model lacks an effect below the smallest size of interest: zero-lift-drag-angle.",
        ),
    ] {
        let (_, made) = of(verdict);
        assert!(made.html.contains(&format!("\">{words}</p>")), "{words}");
    }
    let (mut report, _) = of(Verdict::Ambiguous);
    report.verdict = Verdict::Identified;
    report.explanations.swap(0, 2);
    report.explanations.truncate(1);
    let made = page(&report, &[], &[]);
    assert!(
        made.html
            .contains("The model lacks 2 effects, side-force-by-spin and wind together.")
    );
    assert!(made.html.contains("<h2>Explanation</h2>"));
}

#[test]
fn sections_stand_where_their_data_do() {
    let sections = |verdict| {
        let (_, made) = of(verdict);
        [
            "gain",
            "next-throw",
            "flights",
            "unattributed",
            "channel-01",
            "extension",
            "verified",
            "residuals-held-out",
        ]
        .map(|section| has(&made, section))
    };
    assert_eq!(
        sections(Verdict::Identified),
        [true, false, true, false, false, true, true, true]
    );
    assert_eq!(
        sections(Verdict::Ambiguous),
        [true, true, true, false, false, true, true, true]
    );
    assert_eq!(
        sections(Verdict::Unattributed),
        [true, false, true, true, true, true, true, true]
    );
    assert_eq!(
        sections(Verdict::Adequate),
        [false, false, false, false, false, false, false, true]
    );
    let (_, ambiguous) = of(Verdict::Ambiguous);
    for text in [
        "These flights cannot distinguish the following explanations",
        "7.9 standard deviations; it is 1.3",
        "18.2\u{a0}m",
        "−300\u{a0}rpm",
        "The strongest remaining effect is tilted-vertical",
        "On 2 held-out flights",
        "a gain of 12.08 ± 0.90\u{a0}mm",
        "Unchanged by the extension: C_L over α.",
        "<td class=\"n doubt\">−6.4</td>",
        "nothing: it has no influence in these flights",
        "replace C_D = C_D0",
    ] {
        assert!(ambiguous.html.contains(text), "{text}");
    }
    let (_, none) = of(Verdict::Adequate);
    for text in [
        "before</th>",
        "extended</th>\n",
        "class=\"alarms\"",
        "<h2>Notes",
        "too small",
    ] {
        let body = &none.html[none.html.find("<main>").unwrap()..];
        assert!(
            !body[..body.find("Flight by flight").unwrap()].contains(text),
            "{text}"
        );
    }
}

#[test]
fn nothing_at_all_reads_well() {
    let (mut report, _) = of(Verdict::Adequate);
    report.summary.clear();
    report.tests.clear();
    report.score_correlations = Default::default();
    report.flights.clear();
    report.curves.clear();
    report.coefficients.clear();
    report.not_identifiable.clear();
    report.minimum_detectable_effects.clear();
    report.seconds.clear();
    let made = page(&report, &[], &[]);
    assert_eq!(made.figures, []);
    for section in ["evidence", "coefficients", "unattributed", "extension"] {
        assert!(!has(&made, section), "{section}");
    }
    for text in [
        "No effect of the catalogue is needed",
        "Every tested effect is identifiable",
        "0 flights were fitted; 0 effects were tested.",
        "The model is not extended.",
    ] {
        assert!(made.html.contains(text), "{text}");
    }
    assert!(!made.html.contains("<p></p>") && !made.html.contains("<tbody>\n</tbody>"));
    // One of everything, and no coefficient known of a explanation.
    let (mut report, _) = of(Verdict::Identified);
    report.explanations[0].effects[0].estimates.clear();
    report.explanations[0].effects[0].variables.clear();
    report.explanations[0].effects[0].description.clear();
    report.explanations[0].strongest_remaining = None;
    report.predictive_gain = None;
    report.tests.truncate(1);
    report.score_correlations.names.truncate(1);
    report.flights.truncate(1);
    let made = page(&report, &made::evidence(1), &made::evidence(1));
    assert!(
        made.html.contains("It has no description.")
            && made.html.contains("No other effect remains.")
    );
    assert!(
        made.html
            .contains("The gain on flights that were not fitted could not be measured")
    );
}

#[test]
fn names_from_outside_are_escaped() {
    const EVIL: &str = "<script>alert(1)</script>\"'&\u{1}\u{ffff}";
    let evil = || EVIL.to_owned();
    let mut after = made::evidence(3);
    after[0].file = evil();
    after[0].markers[0] = evil();
    let mut report = found::report(Verdict::Unattributed, &after);
    let explanations = found::report(Verdict::Ambiguous, &after);
    report.explanations = explanations.explanations;
    report.proposed_throw = explanations.proposed_throw;
    report.schema = evil();
    report.dataset = evil();
    report.model = evil();
    report.effects = vec![evil()];
    report.summary = evil();
    report.extended_model = Some(evil());
    report.seconds.insert(evil(), 1.0);
    report.notes = vec![evil()];
    report.proposed_throw.as_mut().unwrap().description = evil();
    let explanation = &mut report.explanations[0];
    explanation.strongest_remaining.as_mut().unwrap().name = evil();
    let effect = &mut explanation.effects[0];
    (
        effect.name,
        effect.description,
        effect.site,
        effect.variables,
    ) = (evil(), evil(), evil(), vec![evil()]);
    let mut estimate = effect.estimates["alpha_0"].clone();
    estimate.unit = evil();
    effect.estimates.insert(evil(), estimate.clone());
    let score = &mut report.tests[0];
    (score.name, score.description, score.site) = (evil(), evil(), evil());
    score.one_step_estimates.insert(evil(), estimate);
    let mut coefficient = report.coefficients["C_D0"].clone();
    coefficient.unit = evil();
    report.coefficients.insert(evil(), coefficient);
    report.score_correlations.names[0] = evil();
    report.not_identifiable[0].name = evil();
    report.not_identifiable[0].confounded_with = vec![evil()];
    let least = &mut report.minimum_detectable_effects[0];
    (least.name, least.coefficient, least.unit) = (evil(), evil(), evil());
    let curve = &mut report.curves[0];
    (curve.quantity, curve.over, curve.unit) = (evil(), evil(), evil());
    let outside = report.unattributed.as_mut().unwrap();
    outside.description = evil();
    outside.channels[0].site = evil();
    outside.channels[0].histories[0].file = evil();
    (outside.terms[0].site, outside.terms[0].formula) = (evil(), evil());
    report.verified.as_mut().unwrap().checks[0] = (evil(), evil());
    report.cautions = vec![evil()];
    let made = make(&DiagnosisPage {
        report: &report,
        fits: None,
        before: &after,
        after: &after,
        extended: Some(EVIL),
    });
    check(&made);
    assert!(made.html.matches("&lt;script&gt;alert(1)").count() > 30);
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
        let mut after = made::evidence(5);
        let mut report = found::report(Verdict::Unattributed, &after);
        let explanations = found::report(Verdict::Ambiguous, &after);
        report.explanations = explanations.explanations;
        report.proposed_throw = explanations.proposed_throw;
        let noise = report.noise.get_mut(identify::MARKER).unwrap();
        (noise.sigma, noise.lag1_autocorrelation) = (bad, bad);
        let gain = report.predictive_gain.as_mut().unwrap();
        (gain.rms_after_m, gain.std_error_m, gain.noise_m) = (bad, bad, bad);
        report.flights[0].rms_before_m = Some(bad);
        report.flights[1].rms_after_m = Some(bad);
        report.flights[3].rms_after_m = Some(bad);
        report.threshold.z = bad;
        report.threshold.alpha = bad;
        for (i, score) in report.tests.iter_mut().enumerate() {
            match i % 4 {
                0 => score.z = bad,
                1 => score.score_chi2 = bad,
                2 => score.ln_p_value = bad,
                _ => score.tolerance = bad,
            }
        }
        report.explanations[0].chi2_decrease = bad;
        report.explanations[0]
            .strongest_remaining
            .as_mut()
            .unwrap()
            .p_value = bad;
        report.explanations[0].effects[0]
            .estimates
            .get_mut("alpha_0")
            .unwrap()
            .value = bad;
        report.explanations[1].effects[0]
            .estimates
            .get_mut("C_Daaa")
            .unwrap()
            .std_error = bad;
        report.proposed_throw.as_mut().unwrap().spin = bad;
        report.proposed_throw.as_mut().unwrap().separation = bad;
        report.coefficients.get_mut("C_D0").unwrap().before = Some(bad);
        report.coefficients.get_mut("C_Da").unwrap().std_error = bad;
        report.score_correlations.matrix[3][1] = bad;
        report.score_correlations.matrix[5].clear();
        report.score_correlations.matrix.truncate(9);
        report.minimum_detectable_effects[0].value = bad;
        report.curves[0].x[3] = bad;
        report.curves[1].after[2] = bad;
        report.curves[1].before.truncate(4);
        let outside = report.unattributed.as_mut().unwrap();
        outside.channels[0].explained_fraction = bad;
        outside.channels[0].histories[0].value[3] = bad;
        outside.channels[1].histories[0].std_error[2] = bad;
        outside.channels[2].histories[1].t[2] = bad;
        outside.channels[2].histories[2].t.clear();
        outside.terms[0].score_chi2 = bad;
        after[0].predicted[10][0] = [bad; 3];
        after[1].measured[3][1] = Some([bad; 3]);
        page(&report, &after, &after);
    }
}

#[test]
fn much_stays_small() {
    let after = made::evidence(3);
    let mut report = found::report(Verdict::Unattributed, &after);
    let one = |report: &Report, role| {
        report
            .flights
            .iter()
            .find(|f| f.role == role)
            .unwrap()
            .clone()
    };
    let mut flight = one(&report, Role::Fit);
    report.flights.clear();
    for i in 0..10_000 {
        flight.file = format!("throw{i:05}.csv");
        flight.role = if i % 3 == 0 { Role::HeldOut } else { Role::Fit };
        flight.rms_before_m = Some(0.01 + 1e-6 * f64::from(i));
        report.flights.push(flight.clone());
    }
    let score = report.tests[0].clone();
    for i in 0..500 {
        report.tests.push(diagnose::CandidateTest {
            name: format!("effect-{i}"),
            ..score.clone()
        });
        report.score_correlations.names.push(format!("C_{i}"));
        report
            .not_identifiable
            .push(report.not_identifiable[0].clone());
    }
    let channel = &mut report.unattributed.as_mut().unwrap().channels[0];
    let history = channel.histories[0].clone();
    channel.histories.extend((0..2000).map(|_| history.clone()));
    let made = page(&report, &after, &after);
    assert!(
        made.html
            .contains("The worst 60 of 10000 flights in numbers")
    );
    assert!(made.html.contains("3322 more flights are not drawn."));
    let ranked = &made
        .figures
        .iter()
        .find(|f| f.name == "flights")
        .unwrap()
        .svg;
    assert!(ranked.contains("flights in order of their RMS residual before"));
}

#[test]
fn the_same_report_gives_the_same_page() {
    assert_eq!(of(Verdict::Unattributed).1, of(Verdict::Unattributed).1);
}

#[test]
fn what_cannot_be_relied_on_says_so_first_and_flights_are_compared_in_pairs() {
    let (mut report, _) = of(Verdict::Identified);
    report.data_faults = vec![identify::DataFault {
        file: "throw03.csv".to_owned(),
        fault: identify::FaultKind::LabelsExchanged,
        detail: "m2 and m3".to_owned(),
        correction: "rename the columns".to_owned(),
    }];
    report.flights[0].outcome = identify::FlightOutcome::Excluded {
        reason: "a metre off".to_owned(),
    };
    report.cautions = vec!["the time limit was reached".to_owned()];
    report.flights[0].rms_before_m = None;
    let gain = report.predictive_gain.as_mut().unwrap();
    (gain.improved, gain.worsened, gain.sign_test_p_value) = (16, 3, 0.0022);
    (gain.median_before_m, gain.median_after_m) = (0.041, 0.030);
    gain.set_apart = vec!["throw09.csv".to_owned()];
    report.explanations[0].explained_fraction = 0.93;
    report.explanations[0].remaining_rms_m = 4e-4;
    let made = make(&DiagnosisPage {
        report: &report,
        before: &[],
        after: &[],
        fits: None,
        extended: None,
    });
    check(&made);
    let body = &made.html[made.html.find("<main>").unwrap()..];
    let place = |text: &str| body.find(text).unwrap_or_else(|| panic!("{text}"));
    assert!(place("Do not rely on this diagnosis") < place("class=\"verdict"));
    for text in [
        "The time limit was reached.",
        "<td>labels exchanged</td>",
        "rename the columns",
        "excluded</span> a metre off",
        "16 of 19 flights improve (sign test p = 0.002)",
        "from 41.0\u{a0}mm to 30.0\u{a0}mm",
        "no model follows them, and not counted: throw09.csv",
        " of the misfit; 0.400\u{a0}mm rms remain beyond the noise",
    ] {
        place(text);
    }
}
