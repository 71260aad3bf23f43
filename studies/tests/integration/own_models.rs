//! Models of a user's own, a small fixed part of the study.

use studies::own_models::{SUBJECTS, own_models, own_models_page, tasks};

#[test]
fn every_model_has_nulls_and_forty_hidden_effects() {
    let all = tasks(1, "");
    for subject in &SUBJECTS {
        let of = all.iter().filter(|task| task.subject.name == subject.name);
        let of: Vec<_> = of.collect();
        let hidden = of.iter().filter(|task| task.hidden.is_some()).count();
        assert_eq!((hidden, of.len() - hidden), (40, 10), "{}", subject.name);
    }
}

#[test]
fn nothing_is_found_where_nothing_is_hidden() {
    let mut all = tasks(1, "nothing");
    all.retain(|task| task.seed == 0 && task.subject.name != "quaternion_dart");
    let outcomes = own_models(&all, 2, &|_, _| {});
    for outcome in &outcomes {
        assert!(
            !outcome.is_detected() && outcome.verdict.is_ok(),
            "{outcome:?}"
        );
    }
    let page = own_models_page(&outcomes).expect("a page").text;
    assert!(page.contains("0.0 % (0 of 5)"), "{page}");
}

#[test]
fn a_hidden_effect_is_detectable_as_its_size_says() {
    let outcomes = own_models(&tasks(1, "shuttlecock side_force"), 2, &|_, _| {});
    let ratios: Vec<f64> = outcomes.iter().filter_map(|o| o.detectability).collect();
    let [weak, strong] = ratios[..] else {
        panic!("{outcomes:?}")
    };
    assert!(strong > 5.0 * weak && weak > 0.3, "{ratios:?}");
}
