//! A recording of nothing but a free flight is one throw from its first sample to its last.

use super::support::clean::clean_flight;
use dataset::takes::{Cause, ThrowOptions, find_throws};

#[test]
fn clean_flights_are_not_cut() {
    let (mut cut, mut strong) = (0, 0);
    for seed in 0..200 {
        let (take, lift) = clean_flight(seed);
        strong += usize::from(lift > 2.0 * 9.81);
        let found = find_throws(&take, &[], &ThrowOptions::default());
        // A sample counts where three of the four points are seen.
        let seen = |i: &usize| {
            take.points
                .iter()
                .filter(|p| p.positions[*i].is_some())
                .count()
                >= 3
        };
        let first = (0..take.times.len()).find(seen);
        let last = (0..take.times.len()).rfind(seen);
        let whole = match &found.throws[..] {
            [throw] => {
                let ends = [throw.release, throw.end];
                ends.iter().all(|end| end.cause == Cause::Recording)
                    && [Some(throw.release.sample), Some(throw.end.sample)] == [first, last]
            }
            _ => false,
        };
        if !whole {
            eprintln!(
                "{seed}: lift {lift:.0} m/s2, {} samples at {:.0} Hz: {:?} {:?}",
                take.times.len(),
                1.0 / take.times[1],
                found.throws,
                found.notes
            );
            cut += 1;
        }
    }
    eprintln!("{cut} of 200 cut; {strong} with more than 2 g of lift");
    assert!(strong >= 60, "{strong} with a strong lift");
    assert_eq!(cut, 0);
}
