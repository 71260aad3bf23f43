use super::*;
use crate::layout::Layout;
use crate::load::from_text;

fn library_of(model: &ModelTree) -> (Arc<TermLibrary>, ModelTree) {
    TermLibrary::for_model(&model.check().unwrap()).expect("a library")
}

#[test]
fn a_model_without_a_library_gets_one_from_its_own_quantities() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../studies/models");
    for (name, channels, variables) in [
        ("shuttlecock", 3, vec!["speed", "height", "time"]),
        ("pendulum", 3, vec!["speed", "rho", "height", "time"]),
        (
            "spinning_ball",
            6,
            vec![
                "speed",
                "sine-of-yaw",
                "stream-1",
                "stream-2",
                "stream-3",
                "spin",
                "height",
                "rate-1",
                "rate-2",
                "rate-3",
                "q",
                "time",
            ],
        ),
        (
            "quaternion_dart",
            6,
            vec![
                "speed", "stream-1", "stream-2", "stream-3", "height", "rate-1", "rate-2",
                "rate-3", "time",
            ],
        ),
        ("glider", 4, vec!["range", "height", "V", "gamma", "time"]),
        (
            "kite",
            1,
            vec!["beta", "betadot", "wind-x", "wind-z", "airspeed", "time"],
        ),
    ] {
        let model = ModelTree::load(&format!("{folder}/{name}.hyz")).unwrap();
        let (library, with_loads) = library_of(&model);
        let layout = Layout::new(&with_loads.check().unwrap());
        assert_eq!(library.channels.len(), channels, "{name}");
        let names: Vec<&str> = library.variables.iter().map(|v| v.name.as_str()).collect();
        let mut sorted = (names.clone(), variables);
        sorted.0.sort_unstable();
        sorted.1.sort_unstable();
        assert_eq!(sorted.0, sorted.1, "{name}: {names:?}");
        for variable in library.variables.iter() {
            assert!(
                layout.quantity(&variable.quantity).is_some(),
                "{variable:?}"
            );
        }
        assert!(
            library.terms().count() <= 160,
            "{name}: {}",
            library.terms().count()
        );
        for term in library.terms() {
            let extended = model.with(&library.effect(term, "Found."));
            let checked = extended.and_then(|extended| extended.check());
            let checked = checked.unwrap_or_else(|e| panic!("{name} {}\n{e}", library.name(term)));
            assert_eq!(checked.effects[0].site, library.channels[term.channel].site);
        }
    }
}

#[test]
fn every_term_can_be_written_into_its_model() {
    for (name, terms) in [("disc", 132), ("ball", 40)] {
        let model = ModelTree::load(name).unwrap();
        let coefficients = model.check().unwrap().coefficients.len();
        let (library, with_loads) = library_of(&model);
        let layout = Layout::new(&with_loads.check().unwrap());
        for channel in library.channels.iter() {
            assert!(
                layout.parameter(&channel.coefficient).is_some(),
                "{channel:?}"
            );
        }
        for variable in library.variables.iter() {
            assert!(
                layout.quantity(&variable.quantity).is_some(),
                "{variable:?}"
            );
        }
        assert_eq!(library.terms().count(), terms);
        for term in library.terms() {
            let effect = library.effect(term, "Found.");
            let extended = model.with(&effect).unwrap_or_else(|e| panic!("{e}"));
            let checked = extended.check().unwrap_or_else(|e| panic!("{e}"));
            let applied = &checked.effects[0];
            let coefficient = applied.coefficients[0];
            assert_eq!(coefficient.index, coefficients);
            assert_eq!(applied.site, library.channels[term.channel].site);
            let text = extended.to_text("Extended.");
            let again = from_text("extended.hyz", &text, &[]);
            assert_eq!(again.unwrap().coefficients.len(), coefficients + 1);
        }
    }
}

#[test]
fn a_term_is_written_as_its_formula_is_read() {
    let model = ModelTree::load("disc").unwrap();
    let (library, _) = library_of(&model);
    for term in library.terms() {
        let effect = library.effect(term, "One line.\nAnother.");
        let coefficient = format!("k_{}", effect.name());
        let value = match library.formula(term).as_str() {
            "1" => coefficient,
            formula => format!("{coefficient}*{formula}"),
        };
        let text = effect.to_string();
        let read = EffectTree::parse("term.hyz", &text).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(read.to_string(), text);
        let channel = &library.channels[term.channel];
        let statement = channel
            .template
            .to_string()
            .replace("TERM", &format!("({value})"));
        let statement = statement.replace("NAME", effect.name());
        let by_text = EffectTree::parse("term.hyz", &statement).unwrap();
        let last = |effect: &EffectTree| {
            let text = effect.to_string();
            text.lines().rev().nth(1).map(str::to_owned)
        };
        assert_eq!(last(&by_text), last(&effect));
    }
}

#[test]
fn a_template_may_replace_a_load_of_the_model() {
    let (name, text) = *TERM_LIBRARIES
        .iter()
        .find(|(name, _)| name.starts_with("disc"))
        .expect("a library of discs");
    let (force, product) = ("force NAME = q*A*TERM*d2", "products = [");
    assert!(text.contains(force) && text.contains(product));
    let text = text
        .replacen(force, "replace force weight = previous + q*A*TERM*d2", 1)
        .replacen(
            product,
            &format!("{product} [{}],", [r#""alpha""#; 4].join(", ")),
            1,
        );
    let library = TermLibrary::parse(name, &text).unwrap();
    let side = library
        .terms()
        .find(|term| library.channels[term.channel].name == "side");
    let effect = library.effect(side.unwrap(), "Doc.");
    assert!(effect.name().ends_with("alpha_to_the_4"), "{effect}");
    assert!(
        effect.to_string().contains("replace force weight ="),
        "{effect}"
    );
}

#[test]
fn each_fault_of_a_library_has_its_error() {
    let (name, text) = TERM_LIBRARIES[0];
    let faulty = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        TermLibrary::parse(name, &text.replacen(from, to, 1)).unwrap_err()
    };
    let error = faulty("[\"spin\"]", "[\"spni\"]");
    assert!(matches!(error, TermLibraryError::UnknownVariable { factor, .. } if factor == "spni"));
    let error = faulty("site unknown;", "site unknown");
    assert!(matches!(error, TermLibraryError::Effect(_)));
    let error = faulty("products =", "product =");
    assert!(matches!(error, TermLibraryError::Form { .. }));
}
