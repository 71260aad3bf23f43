//! Discovery end to end, a small fixed part of it: quiet where nothing is hidden, right where something strong is.

use identify::{FitOptions, fit};
use studies::discovery::{Case, Row, RowResult, plan, run_rows};

/// Executes `runs` runs (simulated and diagnosed datasets) of each combination of the discovery study's simulation
/// settings whose key (text of these settings) contains the given words.
fn tried(words: &[&str], runs: usize) -> Vec<RowResult> {
    let all = plan(100);
    let rows = words.iter().map(|words| {
        let mut found = all.iter().filter(|row| row.has(words));
        let row = found.next().unwrap_or_else(|| panic!("no row `{words}`"));
        assert!(found.next().is_none(), "`{words}` is more than one row");
        Row {
            runs,
            ..row.clone()
        }
    });
    run_rows(&rows.collect::<Vec<Row>>(), 2, &|_, _| {})
}

#[test]
fn nothing_is_found_where_nothing_is_hidden() {
    let noises = ["white", "AR(0.6)", "outliers", "dropouts"];
    let words = noises.map(|noise| format!("null {noise}"));
    for tried in tried(&words.each_ref().map(String::as_str), 1) {
        for outcome in &tried.outcomes {
            assert!(outcome.failure.is_none(), "{outcome:?}");
            assert!(
                !outcome.is_detected(),
                "{}: {}",
                tried.row.key(),
                outcome.answer()
            );
            assert_eq!(outcome.held_out_ratio(), Some(1.0));
        }
    }
}

#[test]
fn what_is_strong_is_found_and_no_wrong_cause_stands_alone() {
    let words = [
        "effects constant_pitching_moment strong white",
        "effects marker_2_misplaced strong outliers",
        "effects tilted_vertical strong white",
        "ball drag_crisis strong",
        "ball wind strong",
        "ball buoyancy strong",
        "ball magnus spin_decay strong",
        "pairs cubic_pitching_moment with marker_2_misplaced",
        "outside drag_by_height strong",
    ];
    let mut strong = 0;
    for tried in tried(&words, 1) {
        for outcome in &tried.outcomes {
            assert!(outcome.failure.is_none(), "{outcome:?}");
            assert!(
                !outcome.uniquely_wrong,
                "{}: {}",
                tried.row.key(),
                outcome.answer()
            );
            let outside = tried.row.unlisted.is_some();
            if outside || outcome.is_detectable(3.0) {
                strong += 1;
                assert!(outcome.in_set, "{}: {}", tried.row.key(), outcome.answer());
                assert!(
                    outcome.held_out.after < outcome.held_out.before,
                    "{outcome:?}"
                );
            }
        }
    }
    assert!(strong >= 8, "only {strong} are strong");
}

#[test]
fn what_flights_agree_on_is_named_and_those_that_contradict_are_listed() {
    let words = [
        "told off20% swapped0%",
        "told off0% swapped33%",
        "told off0% swapped100%",
    ];
    let all = tried(&words, 1);
    let [off, some, every] = &all[..] else {
        panic!("three rows");
    };
    for tried in [off, some] {
        let outcome = &tried.outcomes[0];
        assert!(outcome.in_set, "{}: {}", tried.row.key(), outcome.answer());
        assert!(outcome.held_out.after < outcome.held_out.before);
    }
    let discordant = some.outcomes[0].discordant;
    let (listed, right) = (discordant.listed, discordant.exchanged);
    assert!(listed >= 4 && right == listed, "{right} of {listed}");
    // Where every flight was told another's spin nothing is said of spin.
    let outcome = &every.outcomes[0];
    assert!(
        !outcome.uniquely_wrong && !outcome.in_set,
        "{}",
        outcome.answer()
    );
}

#[test]
fn what_each_flight_has_for_itself_is_named_only_where_it_predicts() {
    let all = tried(
        &["outside swerve weak", "effects wind_of_each_flight weak"],
        1,
    );
    let [swerve, wind] = &all[..] else {
        panic!("two rows");
    };
    let outcome = &swerve.outcomes[0];
    assert!(
        outcome.is_detected() && !outcome.uniquely_wrong,
        "{}",
        outcome.answer()
    );
    let outcome = &wind.outcomes[0];
    assert!(
        outcome.in_set && !outcome.uniquely_wrong,
        "{}",
        outcome.answer()
    );
}

#[test]
fn samples_that_are_left_out_at_the_ends_do_not_lead_the_fit_of_a_wrong_model_astray() {
    let rows = plan(100);
    let mut rows = rows.iter();
    let row = rows.find(|row| row.has("effects wind_by_height strong AR(0.6)"));
    let dataset = Case::of(row.expect("a row"), 1).dataset();
    let model = model_spec::load::load("disc", &[]).unwrap();
    let fitted = fit(&model, &dataset, &FitOptions::default()).unwrap();
    // The wind changes by 0.4 m/s in a metre of height.
    let residuals = fitted.noise().overall();
    assert!((0.01..0.02).contains(&residuals), "{residuals}");
}
