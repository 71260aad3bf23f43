//! Symbol table of a model: declaration and lookup of names.

use std::collections::HashMap;

use super::Checker;
use crate::diagnostic::{Diagnostic, Kind, MAX_SHOWN, Span};
use crate::model::Function;
use crate::syntax::ast::Name;
use crate::syntax::reserved::{FIXED, OF_BODY};

/// Declared entity that a name refers to, such as a parameter or a state, by index into the model's vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Symbol {
    Param(usize),
    Coefficient(usize),
    Input(usize),
    /// Component of an input, such as `wind_x`: index into `Model::inputs`, and number of the component (1 to 3).
    InputPart(usize, u8),
    State(usize),
    /// Auxiliary variable: index into `Checker::definitions`.
    Let(usize),
    /// Unknown of a block `solve`: index into `Model::aux_variables`.
    Unknown(usize),
    Marker,
}

#[derive(Default)]
pub(super) struct Scope {
    values: HashMap<String, (Symbol, Span)>,
    frames: HashMap<String, (usize, Span)>,
    tables: HashMap<String, (usize, Span)>,
    functions: HashMap<String, Span>,
    /// Names of all declared values in order of declaration, for spelling suggestions.
    order: Vec<String>,
}

const OTHER_FUNCTIONS: [&str; 12] = [
    "atan2",
    "min",
    "max",
    "norm",
    "unit",
    "dot",
    "cross",
    "ratio",
    "der",
    "partial",
    "diag",
    "in_frame_of",
];

pub(crate) fn function_names() -> impl Iterator<Item = &'static str> {
    let names = Function::NAMES.into_iter().map(|(name, _)| name);
    names.chain(OTHER_FUNCTIONS)
}

impl Scope {
    pub fn find(&self, name: &str) -> Option<Symbol> {
        self.values.get(name).map(|v| v.0)
    }

    pub fn place(&self, name: &str) -> Option<Span> {
        self.values.get(name).map(|v| v.1)
    }

    pub fn frame(&self, name: &str) -> Option<usize> {
        self.frames.get(name).map(|f| f.0)
    }

    pub fn has_function(&self, name: &str) -> bool {
        self.functions.contains_key(name)
    }

    /// Declares a name in a function; returns what it hides.
    pub fn shadow(&mut self, name: &str, symbol: Symbol, span: Span) -> Option<(Symbol, Span)> {
        self.values.insert(name.to_owned(), (symbol, span))
    }

    /// Ends the scope of a name that [`Scope::shadow`] has declared.
    pub fn restore(&mut self, name: &str, hidden: Option<(Symbol, Span)>) {
        match hidden {
            Some(hidden) => self.values.insert(name.to_owned(), hidden),
            None => self.values.remove(name),
        };
    }

    pub fn table(&self, name: &str) -> Option<usize> {
        self.tables.get(name).map(|t| t.0)
    }
}

impl Checker<'_> {
    /// Declares a name; `false`, with an error reported, if it is taken.
    pub fn define(&mut self, name: &Name, symbol: Symbol) -> bool {
        self.define_as(&name.text, name.span, symbol)
    }

    pub fn define_as(&mut self, name: &str, span: Span, symbol: Symbol) -> bool {
        let reserved = if FIXED.contains(&name) {
            Some(format!("`{name}` has a fixed meaning in this language"))
        } else if function_names().any(|known| known == name) {
            Some(format!("`{name}` is a function of this language"))
        } else if OF_BODY.contains(&name) && self.declared_body.is_some() {
            Some(format!(
                "`{name}` is that of the body, and cannot be declared again"
            ))
        } else {
            None
        };
        if let Some(message) = reserved {
            let fault = Diagnostic::new(Kind::Duplicate, span, message);
            self.report(fault.help("choose another name"));
            return false;
        }
        if let Some(&(_, first)) = self.scope.values.get(name) {
            self.report(declared_twice(&format!("`{name}`"), first, span));
            return false;
        }
        self.scope.values.insert(name.to_owned(), (symbol, span));
        self.scope.order.push(name.to_owned());
        true
    }

    pub fn define_frame(&mut self, name: &Name, index: usize) -> bool {
        if let Some(&(_, first)) = self.scope.frames.get(&name.text) {
            let what = format!("the frame `{}`", name.text);
            self.report(declared_twice(&what, first, name.span));
            return false;
        }
        let frames = &mut self.scope.frames;
        frames.insert(name.text.clone(), (index, name.span));
        true
    }

    /// Declares a table, which expressions call as a function.
    pub fn define_table(&mut self, name: &Name, index: usize) {
        if self.is_callable("table", name) {
            let place = (index, name.span);
            self.scope.tables.insert(name.text.clone(), place);
        }
    }

    /// Declares a function of the model.
    pub fn define_function(&mut self, name: &Name) {
        if self.is_callable("function", name) {
            self.scope.functions.insert(name.text.clone(), name.span);
        }
    }

    /// Whether a table or function may have the name; otherwise reports an error.
    fn is_callable(&mut self, what: &str, name: &Name) -> bool {
        let (text, span) = (&name.text, name.span);
        let table = self.scope.tables.get(text).map(|own| own.1);
        let is_built_in = function_names().any(|known| known == text) || text.starts_with("in_");
        let fault = if is_built_in || (what == "function" && text == "sum") {
            let message = format!("`{text}` is a function of this language");
            Diagnostic::new(Kind::Duplicate, span, message).help("choose another name")
        } else if let Some(first) = table.or(self.scope.functions.get(text).copied()) {
            declared_twice(&format!("the {what} `{text}`"), first, span)
        } else {
            return true;
        };
        self.report(fault);
        false
    }

    /// Index of a frame by name; `None`, with an error reported, if there is no such frame.
    pub fn frame_of(&mut self, name: &Name) -> Option<usize> {
        self.frame_named(&name.text, name.span)
    }

    pub fn frame_named(&mut self, name: &str, span: Span) -> Option<usize> {
        if let Some(index) = self.scope.frame(name) {
            return Some(index);
        }
        let names: Vec<&str> = self.model.frames.iter().map(|f| f.name.as_str()).collect();
        let note = match names.len() {
            0 => "no frame is declared; the first is `frame N;`".to_owned(),
            1 => format!("the only frame is {}", crate::diagnostic::listed(&names)),
            _ => format!("the frames are {}", crate::diagnostic::listed(&names)),
        };
        let message = format!("there is no frame `{name}`");
        let fault = Diagnostic::new(Kind::Name, span, message).did_you_mean(name, names);
        self.refuse(fault.note(note))
    }

    /// Names that an error message may suggest; none for errors beyond those shown.
    pub fn declared_names(&self) -> impl Iterator<Item = &str> {
        let is_shown = self.reported.len() < MAX_SHOWN;
        let count = if is_shown { usize::MAX } else { 0 };
        let of_body = OF_BODY.iter().filter(|_| self.declared_body.is_some());
        let names = self.scope.order.iter().map(String::as_str);
        let names = names.chain(["pi", "time"]).chain(of_body.copied());
        names.take(count)
    }
}

fn declared_twice(what: &str, first: Span, again: Span) -> Diagnostic {
    Diagnostic::new(Kind::Duplicate, again, format!("{what} is declared twice"))
        .label(first, "first declared here")
        .label(again, "declared again here")
        .help("rename one of them, or remove it")
}
