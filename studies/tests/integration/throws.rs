//! What others report of launches, and what is found.

use studies::throws::{launches, winds};

#[test]
fn the_pitches_of_crowther_and_potts_are_found_with_their_coefficients() {
    let all = launches().expect("flights");
    let tunnel = &all[1];
    assert!((tunnel.level.0 - 10.0).abs() <= 2.0, "{:?}", tunnel.level);
    assert!((tunnel.level.1 - 20.0).abs() <= 2.0, "{:?}", tunnel.level);
    for of in &all {
        assert!(of.curvature.len() >= 5, "{}", of.name);
        for pair in of.curvature.windows(2) {
            assert!(
                pair[0].0 < pair[1].0 && pair[0].1 > pair[1].1,
                "{}: {:?}",
                of.name,
                of.curvature
            );
        }
    }
}

#[test]
fn a_discus_goes_farther_against_a_moderate_wind_than_with_it() {
    let all = winds().expect("designs");
    let upright = |wind: f64| all.iter().find(|w| w.wind == wind).expect("a wind").upright;
    for wind in [4.0, 8.0, 12.0] {
        assert!(
            upright(-wind) > upright(0.0) && upright(0.0) > upright(wind),
            "{wind}"
        );
    }
    // With the tilt free a throw is at least as long.
    assert!(all.iter().all(|w| w.range > w.upright - 0.01));
}
