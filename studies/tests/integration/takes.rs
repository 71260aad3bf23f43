//! Round trips of takes, a small fixed part of the study.

use studies::takes::{CoefficientError, session_cuts, sessions, takes_page};

fn quiet(_: usize, _: usize) {}

#[test]
fn takes_of_each_text_format_give_a_template_and_coefficients() {
    let found = sessions(&[0, 1, 2], None, 2, &quiet);
    let formats: Vec<&str> = found.iter().map(|session| session.format).collect();
    assert_eq!(formats, ["Vicon CSV", "Qualisys TSV", "OptiTrack CSV"]);
    let (mut cut, mut all) = (0, 0);
    for session in &found {
        let result = session.result.as_ref().expect("a result");
        assert!(
            result.template.across < 1e-3 && result.template.along < 1e-3,
            "{session:?}"
        );
        if let Some(std_error) = result.template.height_std_error {
            assert!(
                result.template.height.abs() < 4.0 * std_error,
                "{session:?}"
            );
        }
        assert_eq!(result.cuts.len(), 12);
        all += result.cuts.len();
        let near = |ends: &[i64; 2]| ends.iter().all(|end| end.abs() <= 3);
        cut += result
            .cuts
            .iter()
            .flatten()
            .filter(|ends| near(ends))
            .count();
        // With the true cuts and the true template a fit is as good as its intervals say.
        let exact = result.fits.last().expect("a fit").as_ref().expect("fitted");
        let is_near = |error: &CoefficientError| error.z.abs() < 4.5;
        assert!(exact.coefficients.iter().all(is_near), "{exact:?}");
    }
    assert!(cut * 100 >= all * 85, "{cut} of {all} flights");
    let page = takes_page(&found).expect("a page").text;
    assert!(
        page.contains("| sessions without a result | 0 | 0 of 3 | yes |"),
        "{page}"
    );
}

#[test]
fn flights_are_cut_within_three_samples() {
    let seeds: Vec<u64> = (0..30).collect();
    let (cuts, false_throws) = session_cuts(&seeds, 2).expect("takes");
    let near = |ends: &&[i64; 2]| ends.iter().all(|end| end.abs() <= 3);
    let good = cuts.iter().flatten().filter(near).count();
    eprintln!(
        "{good} of {} flights, {false_throws} that are none",
        cuts.len()
    );
    // The criterion is 95 %; a sample of this size is within two standard errors of it.
    let share = good as f64 / cuts.len() as f64;
    let error = (0.95 * 0.05 / cuts.len() as f64).sqrt();
    assert!(share > 0.95 - 2.0 * error, "{good} of {}", cuts.len());
    assert_eq!(false_throws, 0);
}

#[test]
fn slight_touches_that_the_cuts_miss_are_found_by_the_fit() {
    for session in &sessions(&[29, 44], None, 2, &quiet) {
        let result = session.result.as_ref().expect("a result");
        let late = result.cuts.iter().flatten().filter(|cut| cut[1] > 50);
        assert!(late.count() > 0, "{session:?}");
        let fitted = result.fits[0].as_ref().expect("fitted");
        let is_near = |error: &CoefficientError| error.z.abs() < 4.5;
        assert!(fitted.coefficients.iter().all(is_near), "{fitted:?}");
    }
}

#[test]
fn a_python_without_ezc3d_is_named() {
    let found = sessions(&[3], Some("no-such-python".as_ref()), 1, &quiet);
    let error = found[0].result.as_ref().expect_err("no C3D");
    assert!(error.to_string().contains("no-such-python"), "{error}");
}
