//! Every plausible mistake in a model is noticed.

use crate::support::{QUICK, built_in, with_lines};
use verify::Options;
use verify::mutants::status::MutantStatus;
use verify::mutants::{MutationMatrix, mutants};
use verify::report::Verdict;

fn table(loaded: &model_spec::load::Loaded) -> MutationMatrix {
    verify::run(
        loaded,
        &Options {
            mutants: true,
            ..QUICK
        },
    )
    .mutants
    .unwrap()
}

#[test]
fn every_mutant_of_the_disc_is_killed() {
    let table = table(&built_in("disc"));
    assert!(table.mutants() >= 200, "{}", table.table());
    assert_eq!(table.killed(), table.mutants(), "{}", table.table());
    assert!(table.not_covered.is_empty(), "{}", table.table());
    // Each check that mutants are put to is of use, and each kind of mistake is made.
    for (k, check) in table.checks.iter().enumerate() {
        assert!(table.rows.iter().any(|row| row.noticed[k] > 0), "{check}");
    }
    assert!(
        table.rows.iter().all(|row| row.mutants > 0),
        "{}",
        table.table()
    );
}

#[test]
fn every_mutant_of_the_other_models_is_killed() {
    for name in ["ball", "disc_appendix", "disc_quaternion"] {
        let table = table(&built_in(name));
        assert!(table.survivors.is_empty(), "{name}: {}", table.table());
        assert_eq!(table.killed(), table.mutants(), "{name}");
    }
}

#[test]
fn what_is_the_same_is_proved_to_be() {
    let disc = table(&built_in("disc"));
    let proof = |mutant: &str| {
        disc.equivalent
            .iter()
            .find(|(m, _)| m == mutant)
            .map(|(_, why)| *why)
    };
    let by_structure = proof("let V: `air_velocity` negated").unwrap();
    assert!(by_structure.contains("node for node"), "{by_structure}");
    let ball = table(&built_in("ball"));
    let halved = ball
        .equivalent
        .iter()
        .find(|(m, _)| m == "force air: `air_velocity` times 0.5")
        .unwrap();
    assert!(
        halved.1.contains("random points of the field"),
        "{}",
        halved.1
    );
}

#[test]
fn a_survivor_is_a_failure() {
    let loaded = built_in("ball");
    let made = mutants(&loaded.file, &loaded.sources);
    let mut statuses = vec![MutantStatus::Killed(vec![0]); made.len()];
    assert_eq!(
        MutationMatrix::of(&made, &statuses).row().verdict,
        Verdict::Holds
    );
    statuses[3] = MutantStatus::Survived;
    let table = MutationMatrix::of(&made, &statuses);
    assert_eq!(table.row().verdict, Verdict::Refuted);
    assert!(table.table().contains("SURVIVED"), "{}", table.table());
}

#[test]
fn mistakes_in_a_term_of_ones_own_are_told_apart() {
    let own = "coefficient C_Y = 0.1 s; let side = q*A*C_Y*r; force side = side*d2;";
    let table = table(&with_lines("disc", own));
    // Nobody but its author knows what it should be; what the law knows is watched as before.
    assert!(
        !table.not_covered.is_empty() && table.survivors.is_empty(),
        "{}",
        table.table()
    );
    let its_own = |name: &String| name.contains("side") || name.contains("C_Y");
    assert!(
        table.not_covered.iter().all(its_own),
        "{:#?}",
        table.not_covered
    );
}
