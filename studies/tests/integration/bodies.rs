//! The program's bodies: what their flights do, and a driver's filmed throws.

use std::path::PathBuf;

use studies::bodies::{DISCS, curves, filmed, turns_and_fades};

#[test]
fn golf_discs_turn_and_then_fade() {
    let rows = turns_and_fades(&[18.0], 1.0).expect("flights");
    assert_eq!(rows.len(), DISCS.len());
    for row in rows.iter().filter(|row| row.disc.starts_with("golf_")) {
        // To the right first, then to the left: the path bends back.
        assert!(row.turn > 0.0 && row.turned > 0.0, "{row:?}");
        assert!(row.faded > 2.0 * row.turned, "{row:?}");
        assert!(row.landing > 0.0, "{row:?}");
        assert!((30.0..90.0).contains(&row.length), "{row:?}");
    }
    // The other hand throws the mirror image.
    let right = turns_and_fades(&[24.0], 1.0).expect("flights");
    let left = turns_and_fades(&[24.0], -1.0).expect("flights");
    for (right, left) in right.iter().zip(&left) {
        assert!(
            (right.landing + left.landing).abs() < 1e-4,
            "{right:?} {left:?}"
        );
        assert!(
            (right.length - left.length).abs() < 1e-4,
            "{right:?} {left:?}"
        );
    }
}

#[test]
fn a_driver_has_the_least_drag_and_a_putter_the_most_of_golf_discs() {
    let curves = curves(-5, 10).expect("coefficients");
    let least = |name: &str| {
        let curve = curves.iter().find(|curve| curve.name == name).expect(name);
        let drags = curve.points.iter().map(|(_, [_, drag, _])| *drag);
        drags.fold(f64::MAX, f64::min)
    };
    assert!(least("golf_driver") < least("golf_midrange"));
    assert!(least("golf_midrange") < least("golf_putter"));
    assert!(least("golf_putter") < least("ultimate_disc"));
}

#[test]
fn filmed_throws_of_a_driver() {
    let folder = PathBuf::from(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../shared/data/discgolf"
    ));
    if !folder.is_dir() {
        eprintln!("skipped: no measured data at {}", folder.display());
        return;
    }
    let throws = filmed(&folder).expect("throws");
    assert_eq!(throws.len(), 3);
    for throw in &throws {
        // Within twice what the stated uncertainties of the launch make of it.
        assert!(throw.miss < 2.0 * throw.all_moves, "{throw:?}");
        assert!(throw.rms < 10.0, "{throw:?}");
    }
}
