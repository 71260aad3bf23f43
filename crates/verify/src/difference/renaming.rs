//! Maps names of the new model to those of the old model by comparing the computed functions.

use super::function;
use super::names::{self, Names};
use super::pairing::{Pairing, Renamed};
use super::statements::{self, Key};
use super::values::Everything;
use model_spec::model::Model;

/// Whether an input, named `was` in the old and `is` in the new model, has its components in the same frame in both.
pub fn same_frame(old: &Model, new: &Model, names: &Names, was: &str, is: &str) -> bool {
    let frame = |model: &Model, name: &str| {
        let input = model.inputs.iter().find(|input| input.name == name)?;
        Some(model.frames[input.frame].name.clone())
    };
    frame(old, was) == frame(new, is).map(|frame| names.old("frame", &frame))
}

/// Whether an auxiliary variable or load, named `was` in the old and `is` in the new model, computes the same function
/// in both; `None` if it is missing in one of the models.
pub fn same_named(
    a: &Everything<'_>,
    b: &Everything<'_>,
    pairing: &Pairing,
    was: &Key,
    is: &Key,
) -> Option<bool> {
    let find = |of: &Everything<'_>, key: &Key| {
        let mut named = of.named.iter();
        let found = named.find(|n| n.class == key.0 && n.name == key.1);
        found.map(|n| n.outputs.clone())
    };
    let (old, new) = (find(a, was)?, find(b, is)?);
    Some(same_outputs(a, b, pairing, old, new))
}

fn same_outputs(
    a: &Everything<'_>,
    b: &Everything<'_>,
    pairing: &Pairing,
    old: std::ops::Range<usize>,
    new: std::ops::Range<usize>,
) -> bool {
    if old.len() != new.len() {
        return false;
    }
    let pairs: Vec<(usize, usize)> = old.zip(new).collect();
    let compared = function::compare(a, b, pairing, &pairs, false);
    !compared.iter().any(|c| c.is_changed())
}

/// Names of the items that are renamed in the new model `b`, with their names in the old model `a`. States, constants
/// and inputs correspond by `pairing`. Auxiliary variables and loads correspond if they compute equal functions, frames
/// if their declarations are equal.
pub fn renamed(a: &Everything<'_>, b: &Everything<'_>, pairing: &Pairing) -> Names {
    let mut names = Names::default();
    for Renamed { from, to } in pairing.renamed(a, b) {
        for class in ["state", "constant", "der"] {
            names.add(class, &to, &from);
        }
        let input = |name: &str| Some(name.strip_suffix("_x")?.to_owned());
        if let (Some(from), Some(to)) = (input(&from), input(&to)) {
            names.add("input", &to, &from);
        }
    }
    // A body derives the names of some states from its angles; these follow the angles.
    let (olds, news) = (
        statements::keyed(&a.model.tree),
        statements::keyed(&b.model.tree),
    );
    let lacks = |list: &[(Key, &_)], key: &Key| list.iter().all(|(k, _)| k != key);
    let mut taken = Vec::new();
    for (key, item) in &news {
        let class = key.0;
        if !lacks(&olds, key) || !["let", "force", "moment", "frame"].contains(&class) {
            continue;
        }
        let found = olds.iter().find(|(old, old_item)| {
            old.0 == class
                && lacks(&news, old)
                && !taken.contains(old)
                && if class == "frame" {
                    let text = item.kind.to_string();
                    let mut with = names.clone();
                    with.add("frame", &key.1, &old.1);
                    names::renamed_text(&text, &with) == old_item.kind.to_string()
                } else {
                    same_named(a, b, pairing, old, key) == Some(true)
                }
        });
        if let Some((old, _)) = found {
            taken.push(old.clone());
            names.add(class, &key.1, &old.1);
        }
    }
    names
}
