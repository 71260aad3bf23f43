//! Command `hyzer models`: lists the built-in models.

use model_spec::ModelTree;
use model_spec::load::{BODIES, MODELS};

use crate::{Answer, output};

/// Runs `hyzer models`: prints the built-in models with the first sentences of their documentation.
pub fn run() -> anyhow::Result<Answer> {
    let mut text = String::from("model: its equations\n");
    for (name, of_model) in MODELS {
        text += &line(name, of_model);
    }
    text += "\nbody: a model with the parameters and coefficients of a real body\n";
    for (name, of_body) in BODIES {
        text += &line(name, of_body);
    }
    text += "\nhyzer check NAME prints what a model declares, hyzer effects NAME what can be added to it.\n";
    text += "The path of a file of your own can stand wherever one of these names can.\n";
    output::print(text)?;
    Ok(Answer::Yes)
}

/// Line of the list: name, and the first sentence of the documentation in `text`.
fn line(name: &str, text: &str) -> String {
    let doc = ModelTree::parse(name, text).map(|tree| tree.file().doc.clone());
    let doc = doc.unwrap_or_default();
    let paragraph = doc.split("\n\n").next().unwrap_or_default();
    let sentence = paragraph.split(". ").next().unwrap_or_default();
    let sentence = sentence.trim_end_matches('.').replace('\n', " ");
    format!("  {name:<18} {sentence}\n")
}
