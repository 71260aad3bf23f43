//! Names of the new model in terms of the old one, and texts of statements with names replaced.

use model_spec::syntax::ast::{BinaryOp, Expr, ExprKind};
use std::collections::BTreeMap;

/// Name in the old model of each renamed thing of the new one, by class of statement.
#[derive(Clone, Debug, Default)]
pub struct Names {
    renamed: BTreeMap<(&'static str, String), String>,
}

impl Names {
    /// Records that the name `new` of a class was `old`.
    pub fn add(&mut self, class: &'static str, new: &str, old: &str) {
        if new != old {
            self.renamed.insert((class, new.to_owned()), old.to_owned());
        }
    }

    /// Name in the old model of what has a name in the new one.
    pub fn old(&self, class: &'static str, new: &str) -> String {
        let found = self.renamed.get(&(class, new.to_owned()));
        found.map_or_else(|| new.to_owned(), Clone::clone)
    }

    /// Name in the old model of a word of the new model's text.
    fn word(&self, word: &str) -> Option<&str> {
        let of = |word: &str| {
            let mut entries = self.renamed.iter();
            entries
                .find(|((_, new), _)| new == word)
                .map(|(_, old)| old.as_str())
        };
        of(word)
    }
}

/// Names in a text, those of frames in `in_F` included.
pub fn words(text: &str) -> Vec<&str> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let mut out: Vec<&str> = Vec::new();
    for word in text.split(|c| !is_name(c)).filter(|word| !word.is_empty()) {
        out.push(word);
        out.extend(word.strip_prefix("in_"));
        // Components of an input have its name.
        out.extend(
            ["_x", "_y", "_z"]
                .iter()
                .find_map(|axis| word.strip_suffix(axis)),
        );
    }
    out
}

/// The text with every name of the new model replaced by that of the old one.
pub fn renamed_text(text: &str, names: &Names) -> String {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let mut out = String::with_capacity(text.len());
    let mut word = String::new();
    let flush = |word: &mut String, out: &mut String| {
        if word.is_empty() {
            return;
        }
        let frame = word.strip_prefix("in_").and_then(|w| names.word(w));
        match (names.word(word), frame) {
            (Some(old), _) => out.push_str(old),
            (None, Some(old)) => {
                out.push_str("in_");
                out.push_str(old);
            }
            (None, None) => out.push_str(word),
        }
        word.clear();
    };
    for c in text.chars() {
        if is_name(c) {
            word.push(c);
        } else {
            flush(&mut word, &mut out);
            out.push(c);
        }
    }
    flush(&mut word, &mut out);
    out
}

/// Terms of a sum with their signs, in the names of the old model where these are given.
pub fn terms(e: &Expr, names: Option<&Names>) -> Vec<String> {
    fn walk(e: &Expr, negative: bool, out: &mut Vec<String>) {
        match &e.kind {
            ExprKind::Binary(BinaryOp::Add, a, b) => {
                walk(a, negative, out);
                walk(b, negative, out);
            }
            ExprKind::Binary(BinaryOp::Sub, a, b) => {
                walk(a, negative, out);
                walk(b, !negative, out);
            }
            ExprKind::Neg(a) => walk(a, !negative, out),
            _ => out.push(if negative {
                format!("-{e}")
            } else {
                e.to_string()
            }),
        }
    }
    let mut out = Vec::new();
    walk(e, false, &mut out);
    match names {
        Some(names) => out.iter().map(|term| renamed_text(term, names)).collect(),
        None => out,
    }
}
