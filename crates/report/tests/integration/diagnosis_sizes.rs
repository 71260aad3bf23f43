//! Numbers on the page of a diagnosis: of what is found, and of the data.

use crate::diagnosis::{of, page};
use diagnose::Verdict;

#[test]
fn the_size_of_what_is_found_and_of_the_data_is_told() {
    let (mut report, made) = of(Verdict::Identified);
    for words in [
        // −0.0702 ± 0.0021
        "alpha_0 is 33 standard errors away from zero, far beyond chance.",
        "7 flights were fitted and 2 held out; 26 effects were tested.",
    ] {
        assert!(made.html.contains(words), "{words}");
    }
    assert!(
        made.figures
            .iter()
            .any(|own| own.name == "finding" && own.csv.contains("alpha_0"))
    );
    // A long table is folded.
    let hidden = |number: usize| diagnose::NotIdentifiable {
        name: format!("effect-{number}"),
        confounded_with: Vec::new(),
    };
    report.not_identifiable = (0..20).map(hidden).collect();
    assert!(page(&report, &[], &[]).html.contains(">20 effects<"));
}
