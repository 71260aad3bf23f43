//! Files beside a model: the statements of `include "aero.hyz";`, and the knots of `table C_D(Ma) = "drag.csv";`.
//!
//! Both are read where the text has been read from a file: their paths are relative to its folder and lead to no place
//! outside of it. They become part of the tree and of the sources of the model.

mod csv;

use crate::diagnostic::{self, Diagnostic, Kind};
use crate::location::Source;
use crate::read::{LoadError, read};
use crate::syntax::ast::{EffectPart, File, Item, ItemKind, Name, Table};
use crate::syntax::{expand, parse_statements};
use std::path::{Component, Path, PathBuf};

const MAX_DEPTH: usize = 8;
const MAX_FILES: usize = 100;
/// Maximum length of all texts of a model, bytes.
const MAX_BYTES: usize = 10_000_000;

/// A text with the files that belong to it.
pub(crate) struct Complete {
    /// Syntax tree, with arrays and calls of functions written out, if there are no diagnostics.
    pub file: File,
    /// The text, then the files, in the order of [`Span::source`].
    pub sources: Vec<Source>,
    /// Errors, in the order of their source spans.
    pub diagnostics: Vec<Diagnostic>,
}

/// Parses a text whose spans have this [`Span::source`], and reads the files that it names; these lie beside the file
/// of the name `name`, if there is one.
pub(crate) fn parse(name: &str, text: &str, source: u16) -> Complete {
    parse_with(name, text, source, &|_| None)
}

/// Parses a text as [`parse`] does; of a file that is `open` elsewhere, the text is taken from there.
pub(crate) fn parse_with(name: &str, text: &str, source: u16, open: &Open<'_>) -> Complete {
    let parsed = parse_statements(name, text, source);
    let path = Path::new(name);
    let mut reader = Reader {
        first: source,
        bytes: text.len(),
        sources: vec![parsed.source],
        diagnostics: parsed.diagnostics,
        known: path.canonicalize().into_iter().collect(),
        open,
    };
    let folder = path.is_file().then(|| path.parent().unwrap_or(path));
    let mut file = parsed.file;
    file.items = reader.complete(file.items, folder, 0);
    let mut diagnostics = reader.diagnostics;
    // Arrays and functions of an incomplete tree would be reported as missing.
    if diagnostics.is_empty() {
        diagnostics = expand::expand(&mut file);
    }
    diagnostic::sort(&mut diagnostics);
    Complete {
        file,
        sources: reader.sources,
        diagnostics,
    }
}

/// Text of a file that counts in place of what is stored, by its path.
pub type Open<'a> = dyn Fn(&Path) -> Option<String> + 'a;

struct Reader<'a> {
    /// [`Span::source`] of the first of the sources.
    first: u16,
    bytes: usize,
    sources: Vec<Source>,
    diagnostics: Vec<Diagnostic>,
    /// Files whose statements are in the tree, or that are being read.
    known: Vec<PathBuf>,
    open: &'a Open<'a>,
}

impl Reader<'_> {
    /// Replaces the statements that name files; `folder` is that of the file of the statements.
    fn complete(&mut self, items: Vec<Item>, folder: Option<&Path>, depth: usize) -> Vec<Item> {
        let mut all = Vec::with_capacity(items.len());
        for mut item in items {
            match &mut item.kind {
                ItemKind::Include(file) => {
                    let file = file.clone();
                    all.extend(self.included(&file, folder, depth).unwrap_or_default());
                    continue;
                }
                ItemKind::Table(table) => self.table(table, folder),
                ItemKind::Effect(effect) => {
                    for part in &mut effect.parts {
                        if let EffectPart::Add(added) = part
                            && let ItemKind::Table(table) = &mut added.kind
                        {
                            self.table(table, folder);
                        }
                    }
                }
                _ => {}
            }
            all.push(item);
        }
        all
    }

    fn refuse<T>(&mut self, fault: Diagnostic) -> Option<T> {
        self.diagnostics.push(fault);
        None
    }

    fn included(&mut self, file: &Name, folder: Option<&Path>, depth: usize) -> Option<Vec<Item>> {
        let path = self.path(file, folder)?;
        if depth == MAX_DEPTH {
            let message = format!("files include one another at most {MAX_DEPTH} deep");
            return self.refuse(Diagnostic::new(Kind::Limit, file.span, message));
        }
        // What two files include is there once, and a circle ends.
        let canonical = path.canonicalize().unwrap_or_else(|_| path.clone());
        if self.known.contains(&canonical) {
            return Some(Vec::new());
        }
        self.known.push(canonical);
        let (name, text, source) = self.text(file, &path)?;
        let parsed = parse_statements(&name, &text, source);
        self.diagnostics.extend(parsed.diagnostics);
        for item in &parsed.file.items {
            if matches!(item.kind, ItemKind::Model(_)) {
                let message = "a file that is included has no `model`";
                let fault = Diagnostic::new(Kind::Duplicate, item.span, message);
                let fault = fault.label(file.span, "included here");
                self.diagnostics
                    .push(fault.help("move what models share to a file of its own"));
            }
        }
        Some(self.complete(parsed.file.items, path.parent(), depth + 1))
    }

    /// Reads the knots of a table from its file.
    fn table(&mut self, table: &mut Table, folder: Option<&Path>) {
        let Some(file) = table.file.clone() else {
            return;
        };
        let Some((path, (_, text, source))) = self
            .path(&file, folder)
            .and_then(|path| Some((path.clone(), self.text(&file, &path)?)))
        else {
            return;
        };
        match csv::knots(&text, source, table.arguments.len()) {
            Ok((columns, rows)) => {
                table.file = None;
                (table.columns, table.rows) = (columns, rows);
            }
            Err(fault) => {
                let read = format!(
                    "read as the table `{}` from {}",
                    table.name.text,
                    path.display()
                );
                self.diagnostics.push(fault.label(file.span, read));
            }
        }
    }

    /// Path of a file that a statement in `folder` names.
    fn path(&mut self, file: &Name, folder: Option<&Path>) -> Option<PathBuf> {
        let Some(folder) = folder else {
            let message = format!(
                "`{}` cannot be found: this text is not in a file",
                file.text
            );
            let fault = Diagnostic::new(Kind::Missing, file.span, message);
            return self.refuse(fault.help("load the model by its path"));
        };
        let relative = Path::new(&file.text);
        let is_below = relative
            .components()
            .all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
        if !is_below || file.text.is_empty() {
            let message = format!("`{}` does not lie beside the file that names it", file.text);
            let fault = Diagnostic::new(Kind::Value, file.span, message);
            return self
                .refuse(fault.note("a path is relative to the folder and leads to no other"));
        }
        Some(folder.join(relative))
    }

    /// Reads a file: its name in messages, its text and its place among the sources.
    fn text(&mut self, file: &Name, path: &Path) -> Option<(String, String, u16)> {
        let name = path.to_string_lossy().into_owned();
        if self.sources.len() == MAX_FILES {
            let message = format!("a model has at most {MAX_FILES} files");
            return self.refuse(Diagnostic::new(Kind::Limit, file.span, message));
        }
        let fault = |message| Diagnostic::new(Kind::Missing, file.span, message);
        if path.exists() && !path.is_file() {
            return self.refuse(fault(format!("`{name}` is no file")));
        }
        let text = match (self.open)(path).map_or_else(|| read(&name), Ok) {
            Ok(text) => text,
            Err(LoadError::Faults { diagnostics, .. }) => {
                let message = diagnostics.first().map_or("", |found| &found.message);
                return self.refuse(fault(format!("`{name}` cannot be read: {message}")));
            }
            Err(error) => return self.refuse(fault(error.to_string())),
        };
        self.bytes += text.len();
        let place = usize::from(self.first) + self.sources.len();
        let Some(place) = u16::try_from(place)
            .ok()
            .filter(|_| self.bytes <= MAX_BYTES)
        else {
            let message = format!("the files of a model have at most {MAX_BYTES} bytes together");
            return self.refuse(Diagnostic::new(Kind::Limit, file.span, message));
        };
        let text = text.strip_prefix('\u{FEFF}').unwrap_or(&text).to_owned();
        self.sources.push(Source::new(&name, &text));
        Some((name, text, place))
    }
}
