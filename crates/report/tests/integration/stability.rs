//! The page, the words and the tables of a stability analysis of a disc.

use analysis::stability::{Body, Instant, at, map};
use flight::throw::Throw;
use report::stability::{Found, controls, page, text};

/// A disc at 16 m/s with a spin, rpm, for the release, a flight of two instants, and a map.
fn found(spin: f64) -> Found {
    let model = model_spec::load::load("disc", &[]).expect("the disc");
    let body = Body::new(model).expect("a body");
    let bound = body.with_parameters(body.compiled.layout().default_parameters());
    let throw = Throw {
        spin: Some(spin),
        ..Throw::at_speed(16.0)
    };
    let state = body.thrown.state(&throw, [0.0; 2], &bound.parameters);
    let state = state.expect("a state");
    let instant = |time: f64| -> Instant { at(&bound, time, &state).expect("modes") };
    Found {
        release: instant(0.0),
        flight: vec![instant(0.0), instant(1.5)],
        trim: None,
        map: map(&bound, &throw, &[12.0, 20.0], &[spin, 2.0 * spin]),
    }
}

#[test]
fn the_page_and_the_text_tell_the_criteria() {
    let found = found(700.0);
    let (html, _) = page("disc", &found).parts();
    let text = text("disc", &found);
    for section in ["release", "flight", "speed-and-spin"] {
        assert!(html.contains(&format!("id=\"{section}\"")), "{section}");
    }
    for words in ["stiffness of the spin", "incidence", "wobble"] {
        assert!(html.contains(words), "{words}");
        assert!(text.contains(words), "{words}\n{text}");
    }
    // A disc has no scalar inputs.
    assert_eq!(controls(&found), None);
}

#[test]
fn the_closed_form_is_told_of_a_fast_spin_alone() {
    let told = |spin: f64| text("disc", &found(spin)).contains("in closed form");
    assert!(told(700.0) && !told(20.0));
}
