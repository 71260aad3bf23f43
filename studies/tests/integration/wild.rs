//! Fits and diagnoses in the wild, a small fixed part of the study.

use std::collections::BTreeSet;

use studies::wild::{Case, Group, Outcome, cases, wild, wild_page};

fn run(words: &str, diagnosed_of: u64) -> Vec<Outcome> {
    let cases: Vec<Case> = cases(1, words)
        .into_iter()
        .filter(|case| case.run == 0)
        .collect();
    assert!(!cases.is_empty(), "{words}");
    wild(&cases, diagnosed_of, 2, &|_, _| {})
}

#[test]
fn the_study_has_a_thousand_datasets_and_each_of_them_once() {
    let all = cases(16, "");
    assert!(all.len() >= 1000, "{}", all.len());
    let names: BTreeSet<(String, u64)> = all.iter().map(|case| (case.class(), case.run)).collect();
    assert_eq!(names.len(), all.len());
    for group in [Group::Clean, Group::Mistake, Group::Hidden] {
        let of = all.iter().filter(|case| case.group() == group).count();
        assert!(of > 250, "{}: {of}", group.label());
    }
}

#[test]
fn a_right_recording_is_fitted_and_mistakes_are_not_relied_on() {
    let right = run("nothing wrong: markers", 0);
    for outcome in &right {
        assert!(!outcome.is_vetoed(), "{:?}", outcome.fitted);
        assert!(
            !outcome.fitted.is_confidently_wrong(),
            "{:?}",
            outcome.fitted
        );
        let worst = outcome.fitted.worst.as_ref();
        assert!(worst.is_some_and(|(_, z)| *z > 0.0), "{:?}", outcome.fitted);
    }
    let wrong = ["conjugated", "prior in conflict", "bound excludes"].map(|words| run(words, 0));
    let wrong = wrong.concat();
    for outcome in &wrong {
        assert!(!outcome.fitted.reliable, "{:?}", outcome.fitted);
        assert!(!outcome.fitted.reasons.is_empty() && !outcome.is_vetoed());
    }
    let page = wild_page(&[right, wrong].concat(), 1, 0)
        .expect("a page")
        .text;
    assert!(page.contains("| 0.0 % (0 of 2) |"), "{page}");
}

#[test]
fn a_wrong_mass_scales_the_coefficients_of_force() {
    let found = run("wrong mass", 0);
    let worst = found[0].fitted.worst.as_ref();
    assert!(
        worst.is_some_and(|(_, z)| *z < 4.0),
        "{:?}",
        found[0].fitted
    );
}

#[test]
fn hidden_physics_leaves_a_misfit_that_a_diagnosis_explains() {
    let found = run("hidden side_force_by_spin, severe, 20 flights", 1);
    let diagnosed = found[0].diagnosed.as_ref().expect("a diagnosis");
    assert!(
        diagnosed.misfit.is_some_and(|misfit| misfit.ratio > 1.0),
        "{diagnosed:?}"
    );
    assert!(
        !diagnosed.is_wrong() && !found[0].fitted.reliable,
        "{found:?}"
    );
}
