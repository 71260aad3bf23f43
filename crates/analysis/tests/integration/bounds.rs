//! Bounds files: what they state, and the faults of broken ones with their places.

use analysis::design::{Bounds, DesignError, Goal, SearchOptions, Side, design};
use flight::throw::FIELDS;

use crate::support::body;

#[test]
fn a_file_changes_what_it_states() {
    let disc = body("disc");
    let text = "speed = [10, 20.5]\nspin = 800\n[obstacle]\nx = 5\ny = -1.5\nradius = 2\nside = \"right\"\n[circle]\nradius = 4\n[scatter]\nnose = 2\nwind = [1, 0, 0.5]\n";
    let bounds = Bounds::read("b.toml", text, &disc).expect("bounds");
    let range = |name: &str| {
        let own = bounds
            .ranges
            .iter()
            .find(|(field, ..)| FIELDS[*field].0 == name);
        own.map(|(_, least, greatest)| (*least, *greatest))
            .expect(name)
    };
    assert_eq!(
        (range("speed"), range("spin"), range("launch")),
        ((10.0, 20.5), (800.0, 800.0), (-10.0, 60.0))
    );
    let obstacle = bounds.obstacle.expect("an obstacle");
    assert_eq!(
        (
            obstacle.place.x,
            obstacle.place.y,
            obstacle.radius,
            obstacle.side
        ),
        (5.0, -1.5, 2.0, Some(Side::Right))
    );
    assert_eq!(
        (
            bounds.circle,
            bounds.scatter.wind,
            bounds.scatter.release.len()
        ),
        (4.0, [1.0, 0.0, 0.5], 1)
    );
    let free: Vec<&str> = bounds.free().map(|(field, ..)| FIELDS[*field].0).collect();
    assert_eq!(free, ["speed", "heading", "launch", "nose", "hyzer"]);
}

#[test]
fn a_search_on_no_threads_is_an_error() {
    let disc = body("disc");
    let flights = disc.with_parameters(disc.compiled.layout().default_parameters());
    let options = SearchOptions {
        threads: 0,
        ..SearchOptions::default()
    };
    let found = design(&flights, Goal::Range, &Bounds::standard(&disc), &options);
    assert_eq!(found.err(), Some(DesignError::NoThreads));
}

#[test]
fn every_fault_has_its_place_and_what_was_expected() {
    let disc = body("disc");
    for (text, place, words) in [
        ("sped = 3", "1:1", "unknown key \"sped\"; expected speed"),
        (
            "\nspeed = [30, 10]",
            "2:9",
            "from 30 to 10; expected the least value first",
        ),
        (
            "nose = \"x\"",
            "1:8",
            "nose is a string; expected a number or a range in deg",
        ),
        ("nose = [1, 2, 3]", "1:8", "a list of 3"),
        ("nose = nan", "1:8", "nose is nan"),
        ("nose = [-inf, 3]", "1:9", "nose is -inf"),
        (
            "launch = 400",
            "1:10",
            "launch is 400; expected a number from -90 to 90 deg",
        ),
        ("speed = 0", "1:9", "speed is 0; expected a number above 0"),
        ("speed = 1e999", "1:9", "speed is 1e999"),
        ("obstacle = 3", "1:12", "obstacle is 3; expected a table"),
        (
            "[obstacle]\nx = 1\ny = 2",
            "1:1",
            "found no radius in [obstacle]",
        ),
        (
            "[obstacle]\nx = 1\ny = 2\nradius = 0",
            "1:1",
            "the radius of the obstacle is 0",
        ),
        (
            "[obstacle]\nx = 1\ny = 2\nradius = 1\nside = \"up\"",
            "5:8",
            "expected \"left\" or \"right\"",
        ),
        (
            "[obstacle]\nx = 1\ny = 2\nradius = 1\nz = 3",
            "5:1",
            "unknown key \"z\" in [obstacle]",
        ),
        ("[circle]\nradius = -1", "2:10", "the radius is -1"),
        ("[circle]", "1:1", "found no radius in [circle]"),
        (
            "[scatter]\nhyzer = -1",
            "2:9",
            "the standard deviation of hyzer is -1",
        ),
        ("[scatter]\nwind = [1]", "2:8", "expected [x, y, z], m/s"),
        (
            "[scatter]\nwnd = 1",
            "2:1",
            "unknown key \"wnd\" in [scatter]",
        ),
        ("speed = [", "1:10", "this is no TOML"),
        ("ü = 1", "1:1", ""),
    ] {
        let error = Bounds::read("b.toml", text, &disc)
            .expect_err(text)
            .to_string();
        assert!(
            error.starts_with(&format!("b.toml:{place}: ")),
            "{text:?}: {error}"
        );
        assert!(error.contains(words), "{text:?}: {error}");
    }
}

#[test]
fn a_point_mass_has_no_attitude_to_bound() {
    let ball = body("ball");
    let error = Bounds::read("b.toml", "speed = 5\nspin = 3\n[scatter]\nhyzer = 2", &ball)
        .expect_err("refused");
    assert_eq!(
        error
            .faults
            .iter()
            .map(|fault| fault.location)
            .collect::<Vec<_>>(),
        [Some((2, 1)), Some((4, 1))]
    );
}
