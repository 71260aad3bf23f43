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
fn usual_throws_are_not_truncated_and_every_bounce_has_its_touch() {
    let free = free_flights(1, 1, &quiet);
    assert!(free.iter().all(|flight| flight.cut.is_none()), "{free:?}");
    let bounced = bounces(1, 1, &quiet);
    assert_eq!(bounced.len(), 20);
    for bounce in &bounced {
        let sample = bounce.time * 120.0;
        assert!(
            (-0.01..1.01).contains(&(bounce.before as f64 - sample)),
            "{bounce:?}"
        );
        assert!(
            (0.3..0.85).contains(&bounce.time) && bounce.speed > 0.0,
            "{bounce:?}"
        );
    }
    let section = CutSection::new(&free, &bounced);
    let page = spoiled_page(&[], Some(section)).expect("a page").text;
    assert!(page.contains("## Truncation at the ground"), "{page}");
}
