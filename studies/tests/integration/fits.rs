//! Random fits, a small fixed part of the study.

use studies::fits::{fits, fits_page};

#[test]
fn fits_of_weak_and_strong_effects_reach_the_noise() {
    let outcomes = fits(&[0, 2, 3, 5], 2, &|_, _| {});
    for outcome in &outcomes {
        assert!(outcome.is_reached(), "{outcome:?}");
        assert!(
            outcome.ratio.is_some_and(|ratio| ratio > 0.98),
            "{outcome:?}"
        );
    }
    let page = fits_page(&outcomes).expect("a page").text;
    assert!(page.contains("100.0 % (4 of 4)"), "{page}");
}
