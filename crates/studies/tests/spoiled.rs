//! Spoiled data and truncation, a small fixed part of the study.

use studies::cuts::{CutSection, bounces, free_flights};
use studies::spoiled::{Judgement, KINDS, Run, runs, spoiled, spoiled_page};

fn quiet(_: usize, _: usize) {}

#[test]
fn harmless_changes_leave_the_coefficients_right() {
    let kinds = ["flight_off all", "millimetre_steps all", "constant one"].map(|words| {
        let found = runs(words);
        assert_eq!(found.len(), 1, "{words}");
        found[0]
    });
    let runs: Vec<Run> = spoiled(&kinds, 1, 2, &quiet);
    let judgements: Vec<Judgement> = runs.iter().map(|run| run.judged.judgement).collect();
    assert_eq!(
        judgements,
        [Judgement::Right, Judgement::Right, Judgement::Named],
        "{:?}",
        runs.iter().map(|run| &run.judged).collect::<Vec<_>>()
    );
    let page = spoiled_page(&runs, None).expect("a page").text;
    assert!(page.contains("| 3 of 3 |"), "{page}");
}

#[test]
fn there_are_forty_kinds_with_names_of_their_own() {
    let mut names: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), KINDS.len());
    assert!(names.len() >= 40);
}

#[test]
fn bounces_are_truncated_and_usual_throws_are_not() {
    let free = free_flights(1, 1, &quiet);
    assert!(free.iter().all(|flight| flight.cut.is_none()), "{free:?}");
    let bounced = bounces(1, 1, &quiet);
    let there = bounced.iter().filter(|bounce| bounce.is_cut_there());
    assert!(there.count() >= 12, "{bounced:#?}");
    let section = CutSection::new(&free, &bounced);
    let page = spoiled_page(&[], Some(section)).expect("a page").text;
    assert!(page.contains("## Truncation at the ground"), "{page}");
}
