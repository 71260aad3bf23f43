//! Values of a model that a dataset or a release overrules.

use model_spec::load::{MODELS, from_text};
use model_spec::model::Model;

/// Values of parameters and coefficients of a model that differ from those of the built-in model of its name: what
/// somebody replaced.
pub fn replaced(model: &Model) -> Vec<(String, f64)> {
    let Some(built_in) = MODELS
        .iter()
        .find(|(name, _)| *name == model.name)
        .and_then(|(name, text)| from_text(name, text, &[]).ok())
    else {
        return Vec::new();
    };
    let values = |model: &Model| -> Vec<(String, f64)> {
        let each = model.params.iter().chain(&model.coefficients);
        each.map(|own| (own.name.clone(), own.value)).collect()
    };
    let (known, mut own) = (values(&built_in), values(model));
    own.retain(|(name, value)| known.iter().any(|(k, v)| k == name && v != value));
    own
}

/// A note for each of the `replaced` values of a model that does not count, as `what` states another.
pub fn overruled<'s>(
    replaced: &[(String, f64)],
    stated: impl IntoIterator<Item = (&'s String, &'s f64)>,
    what: &str,
) -> Vec<String> {
    let each = stated.into_iter().filter_map(|(name, value)| {
        let is_other = |(known, own): &&(String, f64)| known == name && own != value;
        let (_, own) = replaced.iter().find(is_other)?;
        Some(format!(
            "{what} states {name} = {value}, which counts, and not {own} of the model: state the right one in {what}, or \
             none for that of the model"
        ))
    });
    each.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_replaced_value_that_does_not_count_is_noted() {
        let mut disc = model_spec::load::load("disc", &[]).expect("a model");
        assert_eq!(replaced(&disc), []);
        disc.params[0].value = 0.35;
        let own = replaced(&disc);
        assert_eq!(own, [("m".to_owned(), 0.35)]);
        let (m, d) = ("m".to_owned(), "d".to_owned());
        let notes = overruled(&own, [(&m, &0.175), (&d, &0.21)], "the dataset");
        assert_eq!(notes.len(), 1);
        assert!(
            notes[0].starts_with(
                "the dataset states m = 0.175, which counts, and not 0.35 of the model"
            )
        );
        assert!(overruled(&own, [(&m, &0.35)], "the dataset").is_empty());
    }
}
