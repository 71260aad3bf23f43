//! The disc in three forms is one motion; the printed appendix is another.

use crate::support::{QUICK, built_in};
use verify::report::Verdict;
use verify::same_motion;

#[test]
fn the_disc_in_three_forms_is_one_motion() {
    let models =
        ["disc", "disc_appendix", "disc_quaternion"].map(|name| built_in(name).model.unwrap());
    let same = same_motion(&models, &QUICK);
    assert_eq!(same.pairs.len(), 3);
    assert!(same.holds(), "{}", same.table());
    for pair in &same.pairs {
        assert!(
            pair.accelerations.worst < 1e-12 && pair.flights.worst < 1e-9,
            "{}",
            same.table()
        );
        assert_eq!(pair.flights.verdict, Verdict::Holds);
    }
}

#[test]
fn the_printed_appendix_is_another() {
    let models = ["disc", "disc_appendix_printed"].map(|name| built_in(name).model.unwrap());
    let same = same_motion(&models, &QUICK);
    assert!(!same.holds());
    assert!(same.table().contains("DIFFERENT"), "{}", same.table());
}
