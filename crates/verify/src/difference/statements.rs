//! Compares the statements of two model files: added, removed, changed, rewritten, restated.

use super::terms::differing_terms;
use model_spec::syntax::ast::{Expr, File, Item, ItemKind, LoadClass};
use serde::Serialize;

/// Kind of difference of a statement between two models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Change {
    /// Only the new model has the statement.
    Added,
    /// Only the old model has the statement.
    Removed,
    /// Another function.
    Changed,
    /// Another text of the same function.
    Rewritten,
    /// Another default value, unit or bounds of a constant, an input or a state.
    Restated,
}

/// A statement that differs between the two models.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Statement {
    /// How the statement differs.
    pub change: Change,
    /// Class and name of the statement, such as `let alpha` or `der(u)`.
    pub what: String,
    /// Text of the statement in the old model; `None` if it was added.
    pub old: Option<String>,
    /// Text of the statement in the new model; `None` if it was removed.
    pub new: Option<String>,
    /// Terms of its sum that only the old model has.
    pub terms_removed: Vec<String>,
    /// Terms of its sum that only the new model has.
    pub terms_added: Vec<String>,
    #[serde(skip)]
    pub(super) key: Key,
}

/// Class, such as `let`, and name of a statement; parameters and coefficients have the same class.
pub type Key = (&'static str, String);

/// Whether a statement computes the same function in both files; `None` if that is unknown.
pub type IsSame<'a> = dyn Fn(&Key) -> Option<bool> + 'a;

/// Statements that differ between two model files.
pub fn compare(old: &File, new: &File, is_same: &IsSame<'_>) -> Vec<Statement> {
    // A call of a function is compared by the statement that calls it and by the function.
    let written = |file| {
        let mut all = keyed(file);
        all.retain(|(_, item)| !item.is_of_call());
        all
    };
    let (olds, news) = (written(old), written(new));
    let find = |list: &[(Key, &'_ Item)], key: &Key| list.iter().any(|(k, _)| k == key);
    let mut out = Vec::new();
    for (key, item) in &news {
        let old = olds.iter().find(|(k, _)| k == key).map(|(_, item)| *item);
        match old {
            Some(old) => out.extend(changed(key, old, item, is_same)),
            None => out.push(Statement {
                new: Some(item.kind.to_string()),
                ..Statement::new(Change::Added, key)
            }),
        }
    }
    for (key, item) in olds.iter().filter(|(key, _)| !find(&news, key)) {
        out.push(Statement {
            old: Some(item.kind.to_string()),
            ..Statement::new(Change::Removed, key)
        });
    }
    out
}

/// Compares a statement that both model files have; `None` if its texts are equal.
fn changed(key: &Key, old: &Item, new: &Item, is_same: &IsSame<'_>) -> Option<Statement> {
    let (before, after) = (old.kind.to_string(), new.kind.to_string());
    if before == after {
        return None;
    }
    let change = match is_same(key) {
        Some(true) if ["constant", "input", "state"].contains(&key.0) => Change::Restated,
        Some(true) => Change::Rewritten,
        _ => Change::Changed,
    };
    let (terms_removed, terms_added) = match (value(old), value(new)) {
        (Some(old), Some(new)) if change == Change::Changed => differing_terms(old, new),
        _ => Default::default(),
    };
    Some(Statement {
        old: Some(before),
        new: Some(after),
        terms_removed,
        terms_added,
        ..Statement::new(change, key)
    })
}

impl Statement {
    /// Change of the statement `key`, without texts and terms.
    fn new(change: Change, key: &Key) -> Self {
        Self {
            change,
            what: title(key),
            old: None,
            new: None,
            terms_removed: Vec::new(),
            terms_added: Vec::new(),
            key: key.clone(),
        }
    }

    /// The statement as the cause of a difference, with its terms.
    pub(super) fn cause(&self) -> String {
        match self.change {
            Change::Added => format!("{} added", self.what),
            Change::Removed => format!("{} removed", self.what),
            _ if self.terms_removed.is_empty() && self.terms_added.is_empty() => {
                format!("{} changed", self.what)
            }
            _ => {
                let list = |terms: &[String]| match terms {
                    [] => String::from("nothing"),
                    _ => format!("`{}`", terms.join("`, `")),
                };
                let (added, removed) = (list(&self.terms_added), list(&self.terms_removed));
                format!("{}: {added} instead of {removed}", self.what)
            }
        }
    }
}

/// Class and name of a statement as in reports, such as `let alpha` or `der(u)`.
pub fn title((class, name): &Key) -> String {
    match *class {
        "der" => format!("der({name})"),
        "constant" | "clock" => name.clone(),
        class => format!("{class} {name}").trim_end().to_owned(),
    }
}

/// Statements of a model file that influence the motion, by class and name.
pub fn keyed(file: &File) -> Vec<(Key, &Item)> {
    let (mut limits, mut blocks) = (0, 0);
    let mut key = |item: &Item| {
        let name = |class, name: &model_spec::syntax::ast::Name| Some((class, name.text.clone()));
        match &item.kind {
            ItemKind::Parameter(c) => name("constant", &c.name),
            ItemKind::Input(i) => name("input", &i.name),
            ItemKind::State(s) => name("state", &s.name),
            ItemKind::Frame(f) => name("frame", &f.name),
            ItemKind::Body(_) => Some(("body", String::new())),
            ItemKind::Claim(_) => Some(("claim", String::new())),
            ItemKind::Balance(own) => Some(("claim", format!("der({})", own.quantity))),
            ItemKind::Table(t) => name("table", &t.name),
            ItemKind::Function(own) => name("function", &own.name),
            ItemKind::Let(l) => name("let", &l.name),
            ItemKind::Load(l) if l.class == LoadClass::Force => name("force", &l.name),
            ItemKind::Load(l) => name("moment", &l.name),
            ItemKind::Equation(e) => name("der", &e.state),
            ItemKind::Solve(own) => {
                blocks += 1;
                let number = || {
                    if blocks == 1 {
                        String::new()
                    } else {
                        blocks.to_string()
                    }
                };
                let name = own.name.as_ref().map(|name| name.text.clone());
                Some(("solve", name.unwrap_or_else(number)))
            }
            ItemKind::Marker(_) => Some(("marker", String::new())),
            ItemKind::Observe(_) => Some(("observe", String::new())),
            ItemKind::Clock(_) => Some(("clock", String::from("clock"))),
            ItemKind::Limit(_) => {
                limits += 1;
                Some(("limit", limits.to_string()))
            }
            _ => None,
        }
    };
    let items = file.items.iter();
    let items = items.filter(|item| !file.is_written_out(item));
    items.filter_map(|item| Some((key(item)?, item))).collect()
}

/// Right-hand side of a statement that has one.
pub fn value(item: &Item) -> Option<&Expr> {
    match &item.kind {
        ItemKind::Limit(l) => Some(&l.value),
        other => other.value(),
    }
}
