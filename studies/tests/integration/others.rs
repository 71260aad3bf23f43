//! What the page on other simulators says is what the command computes.

use std::path::Path;

use oracle::BalanceLaw;
use studies::others::{SIMULATORS, judge, others, others_page};

#[test]
fn the_page_on_other_simulators_is_what_the_command_writes() {
    let written = others_page(&others().expect("the study runs")).expect("a page");
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/studies/others.md");
    let committed = std::fs::read_to_string(page).expect("the page");
    assert_eq!(
        written.text, committed,
        "run `hyzer-studies others --out docs/studies/others.md`"
    );
}

#[test]
fn each_simulator_breaks_laws_and_is_mended_by_its_changes() {
    for simulator in &SIMULATORS {
        let name = simulator.model;
        let verdicts = judge(simulator).expect("it is judged");
        let (first, last) = (&verdicts.stages[0], verdicts.stages.last().unwrap());
        assert!(!first.holds && !first.broken.is_empty(), "{name}");
        assert!(last.holds && last.broken.is_empty(), "{name}: {last:#?}");
        assert!((last.end - first.end).norm() > 0.1, "{name}: {last:#?}");
        // No change is idle: without it the equations are still wrong.
        let before_last = &verdicts.stages[verdicts.stages.len() - 2];
        assert!(!before_last.holds, "{name}: {before_last:#?}");
    }
}

#[test]
fn what_is_found_of_each_is_what_its_equations_are_known_for() {
    let broken = |model: &str| {
        let simulator = SIMULATORS.iter().find(|s| s.model == model).unwrap();
        let verdicts = judge(simulator).expect("it is judged");
        let laws = verdicts.laws.iter();
        let broken = laws.filter(|l| l.difference > 1e-9 * l.cause);
        (broken.map(|l| l.law).collect::<Vec<_>>(), verdicts)
    };
    let (laws, frispy) = broken("frispy");
    assert_eq!(laws, [BalanceLaw::AngularMomentum]);
    let states: Vec<&str> = frispy.rates.iter().map(|r| r.state.as_str()).collect();
    assert_eq!(states, ["dphi", "dtheta", "dgamma"]);
    let (laws, _) = broken("shotshaper");
    assert_eq!(laws, [BalanceLaw::Attitude, BalanceLaw::AngularMomentum]);
}
