//! Compares the statements of two model files: added, removed, changed, rewritten, renamed. Also determines which
//! statements a derivative depends on.

use super::names::{Names, differing_terms, renamed_text};
use model_spec::syntax::ast::{Expr, ExprKind, File, Item, ItemKind, LoadClass};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// Kind of difference of a statement between two models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Change {
    /// Only the new model has the statement.
    Added,
    /// Only the old model has the statement.
    Removed,
    /// The text of the statement differs, and so does the function that the statement computes.
    Changed,
    /// The text of the statement differs, but the function that it computes is the same.
    Rewritten,
    /// The statement in the two models differs only in the name of what it declares.
    Renamed,
    /// The declaration of a constant, an input or a state differs, in its default value, unit or bounds.
    Restated,
}

/// A statement that differs between the two models.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Statement {
    /// How the statement differs between the two models: added, removed, changed, rewritten, renamed or restated.
    pub change: Change,
    /// Class and name of the statement, such as `let alpha` or `der(u)`, in the new model; in the old model if the
    /// statement was removed.
    pub what: String,
    /// Class and name of the statement in the old model, such as `let alpha`; `None` if they are the same as in the new
    /// model.
    pub was: Option<String>,
    /// Text of the statement in the old model; `None` if it was added.
    pub old: Option<String>,
    /// Text of the statement in the new model; `None` if it was removed.
    pub new: Option<String>,
    /// Terms of the sum on the statement's right-hand side that only the old model has.
    pub terms_removed: Vec<String>,
    /// Terms of the sum on the statement's right-hand side that only the new model has.
    pub terms_added: Vec<String>,
    /// Class (such as `let`) and name of the statement in the new model; `None` if it was removed. Used to decide
    /// whether a row (state derivative, component of the observation, validity limit) depends on the statement.
    #[serde(skip)]
    key_new: Option<Key>,
    /// Class (such as `let`) and name of the statement in the old model; `None` if it was added. Used to decide whether
    /// a row (state derivative, component of the observation, validity limit) depends on the statement.
    #[serde(skip)]
    key_old: Option<Key>,
}

/// Class (such as `let`) and name of a statement. Parameters and coefficients have the same class, so that a parameter
/// that becomes a coefficient is still recognized.
pub type Key = (&'static str, String);

/// Function that decides whether a statement of the old file and one of the new file compute the same function; `None`
/// if that is unknown.
pub type IsSame<'a> = dyn Fn(&Key, &Key) -> Option<bool> + 'a;

/// Compares the statements of two model files and returns those that differ. `same` decides whether a statement with
/// changed text still computes the same function; `names` are the renamed items.
pub fn compare(old: &File, new: &File, names: &Names, same: &IsSame<'_>) -> Vec<Statement> {
    let (olds, news) = (keyed(old), keyed(new));
    let mut out = Vec::new();
    let mut kept: BTreeSet<Key> = BTreeSet::new();
    for (key, item) in &news {
        let was = (key.0, names.old(key.0, &key.1));
        let old_item = olds.iter().find(|(k, _)| *k == was).map(|(_, item)| *item);
        let text = item.kind.to_string();
        let Some(old_item) = old_item else {
            out.push(Statement {
                new: Some(text),
                key_new: Some(key.clone()),
                ..Statement::new(Change::Added, key)
            });
            continue;
        };
        kept.insert(was.clone());
        let old_text = old_item.kind.to_string();
        let equal = renamed_text(&text, names) == old_text;
        let change = match (equal, same(&was, key)) {
            (true, _) if was == *key => continue,
            (true, _) => Change::Renamed,
            (false, Some(true)) if ["constant", "input", "state"].contains(&key.0) => {
                Change::Restated
            }
            (false, Some(true)) => Change::Rewritten,
            (false, _) => Change::Changed,
        };
        let (terms_removed, terms_added) = match (value(old_item), value(item)) {
            (Some(before), Some(after)) if change == Change::Changed => {
                differing_terms(before, after, names)
            }
            _ => Default::default(),
        };
        out.push(Statement {
            was: (was != *key).then(|| title(&was)),
            old: Some(old_text),
            new: Some(text),
            terms_removed,
            terms_added,
            key_new: Some(key.clone()),
            key_old: Some(was),
            ..Statement::new(change, key)
        });
    }
    for (key, item) in olds.iter().filter(|(key, _)| !kept.contains(key)) {
        out.push(Statement {
            old: Some(item.kind.to_string()),
            key_old: Some(key.clone()),
            ..Statement::new(Change::Removed, key)
        });
    }
    out
}

/// Descriptions of the statements that cause the difference of a row (state derivative, component of the observation,
/// validity limit). These are the added, removed and changed statements on which the row depends in the old or the new
/// model. Each description contains the terms that differ.
pub fn causes(
    statements: &[Statement],
    old: &Reach,
    new: &Reach,
    old_row: &str,
    new_row: &str,
) -> Vec<String> {
    let (before, after) = (old.of(old_row), new.of(new_row));
    let changes = statements.iter().filter(|s| {
        let moves = matches!(s.change, Change::Added | Change::Removed | Change::Changed);
        let there = |key: &Option<Key>, set: &BTreeSet<Key>| {
            key.as_ref().is_some_and(|key| set.contains(key))
        };
        moves && (there(&s.key_new, &after) || there(&s.key_old, &before))
    });
    changes.map(Statement::cause).collect()
}

impl Statement {
    /// Creates the description of a change of the statement with class and name `key`; texts, differing terms and keys
    /// are empty.
    fn new(change: Change, key: &Key) -> Self {
        Self {
            change,
            what: title(key),
            was: None,
            old: None,
            new: None,
            terms_removed: Vec::new(),
            terms_added: Vec::new(),
            key_new: None,
            key_old: None,
        }
    }

    /// Describes the statement as the cause of a difference between the models: class, name and differing terms.
    fn cause(&self) -> String {
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

fn title((class, name): &Key) -> String {
    match *class {
        "der" => format!("der({name})"),
        "constant" | "clock" => name.clone(),
        class => format!("{class} {name}").trim_end().to_owned(),
    }
}

/// Statements of a model file, each with its class and name, such as `let alpha`. Statements that do not influence the
/// motion are left out: the model's name, reference law, check cases and effects (optional extensions).
pub fn keyed(file: &File) -> Vec<(Key, &Item)> {
    let mut limits = 0;
    let mut key = |item: &Item| {
        let name = |class, name: &model_spec::syntax::ast::Name| Some((class, name.text.clone()));
        match &item.kind {
            ItemKind::Parameter(c) => name("constant", &c.name),
            ItemKind::Input(i) => name("input", &i.name),
            ItemKind::State(s) => name("state", &s.name),
            ItemKind::Frame(f) => name("frame", &f.name),
            ItemKind::Body(_) => Some(("body", String::new())),
            ItemKind::Claim(_) => Some(("claim", String::new())),
            ItemKind::Table(t) => name("table", &t.name),
            ItemKind::Let(l) => name("let", &l.name),
            ItemKind::Load(l) if l.class == LoadClass::Force => name("force", &l.name),
            ItemKind::Load(l) => name("moment", &l.name),
            ItemKind::Equation(e) => name("der", &e.state),
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
    items.filter_map(|item| Some((key(item)?, item))).collect()
}

/// The expression on the right-hand side of a statement; `None` for a statement of a kind that has none or several,
/// such as a declaration.
pub fn value(item: &Item) -> Option<&Expr> {
    match &item.kind {
        ItemKind::Limit(l) => Some(&l.value),
        other => other.value(),
    }
}

/// For each row of a model (state derivative, component of the observation, validity limit), the statements on which it
/// depends.
pub struct Reach {
    uses: BTreeMap<Key, BTreeSet<Key>>,
    roots: BTreeMap<String, BTreeSet<Key>>,
}

impl Reach {
    /// Determines which statements of a file depend on which others. `rows` contains the name and the kind of each row
    /// (state derivative, component of the observation, validity limit), see [`super::rows`].
    pub fn of_file(file: &File, rows: &[(String, super::rows::RowKind)]) -> Self {
        let items = keyed(file);
        let by_name = |name: &str| -> Vec<Key> {
            let classes = ["let", "table", "constant", "input", "frame", "state", "der"];
            let is = |key: &Key| key.1 == name && classes.contains(&key.0);
            let found = items.iter().map(|(key, _)| key).filter(|key| is(key));
            found.cloned().collect()
        };
        let mut uses = BTreeMap::new();
        for (key, item) in &items {
            let text = item.kind.to_string();
            let words = super::names::words(&text);
            let mut found: BTreeSet<Key> = words.iter().flat_map(|w| by_name(w)).collect();
            found.remove(key);
            // Only `der(…)` refers to the equation of a state; the name of the state does not.
            let mut used = BTreeSet::new();
            if let Some(value) = value(item) {
                derivatives(value, &mut used);
            }
            found.retain(|k| k.0 != "der" || used.contains(&k.1));
            uses.insert(key.clone(), found);
        }
        let of = |classes: &[&str]| -> BTreeSet<Key> {
            let keys = items.iter().map(|(key, _)| key.clone());
            keys.filter(|key| classes.contains(&key.0)).collect()
        };
        let roots = rows.iter().map(|(row, kind)| {
            use super::rows::RowKind as K;
            let set = match kind {
                K::Stated(state) => BTreeSet::from([("der", state.clone())]),
                K::Position => of(&["body", "frame"]),
                K::Velocity => of(&["force", "body", "frame"]),
                K::Rotation => of(&["moment", "body", "frame"]),
                K::Observation => of(&["observe", "marker", "frame"]),
                K::Limit(k) => BTreeSet::from([("limit", k.to_string())]),
            };
            let clock = match kind {
                K::Observation | K::Limit(_) => BTreeSet::new(),
                _ => of(&["clock"]),
            };
            (row.clone(), &set | &clock)
        });
        Self {
            roots: roots.collect(),
            uses,
        }
    }

    /// All statements on which a row (scalar function, such as a state derivative) depends, directly or indirectly;
    /// empty for an unknown row.
    fn of(&self, row: &str) -> BTreeSet<Key> {
        let mut out = BTreeSet::new();
        let mut open: Vec<Key> = self.roots.get(row).into_iter().flatten().cloned().collect();
        while let Some(key) = open.pop() {
            if out.insert(key.clone()) {
                open.extend(self.uses.get(&key).into_iter().flatten().cloned());
            }
        }
        out
    }
}

fn derivatives(e: &Expr, out: &mut BTreeSet<String>) {
    if let ExprKind::Derivative(state) = &e.kind {
        out.insert(state.text.clone());
    }
    e.children(&mut |child| derivatives(child, out));
}
