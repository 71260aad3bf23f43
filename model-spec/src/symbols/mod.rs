//! Names of a text, where they are declared and where they are used, for editors. They are found by tokens, so that a
//! text with errors, of which no syntax tree is complete, has them too.

mod expression;
mod resolve;
mod scan;
#[cfg(test)]
mod tests;

use std::ops::Range;

pub use crate::syntax::reserved::BodyQuantity;
pub use expression::INNER;

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum SymbolKind {
    Model,
    Parameter,
    Coefficient,
    Input,
    State,
    Frame,
    Body,
    Table,
    Function,
    /// Parameter of a function, or argument of a table.
    Argument,
    Index,
    /// Named by `let`.
    Quantity,
    /// Needed by an effect of the model that it is applied to.
    Need,
    Force,
    Moment,
    Marker,
    Observation,
    Effect,
    /// Block of equations `solve { … }`.
    Solve,
    /// What a block of equations determines.
    Unknown,
}

impl SymbolKind {
    /// The word for it in messages, such as `quantity`.
    pub fn noun(self) -> &'static str {
        match self {
            SymbolKind::Model => "model",
            SymbolKind::Parameter => "parameter",
            SymbolKind::Coefficient => "coefficient",
            SymbolKind::Input => "input",
            SymbolKind::State => "state",
            SymbolKind::Frame => "frame",
            SymbolKind::Body => "body",
            SymbolKind::Table => "table",
            SymbolKind::Function => "function",
            SymbolKind::Argument => "argument",
            SymbolKind::Index => "index",
            SymbolKind::Quantity => "quantity",
            SymbolKind::Need => "needed quantity",
            SymbolKind::Force => "force",
            SymbolKind::Moment => "moment",
            SymbolKind::Marker => "marker",
            SymbolKind::Observation => "observation",
            SymbolKind::Effect => "effect",
            SymbolKind::Solve => "block of equations",
            SymbolKind::Unknown => "unknown",
        }
    }
}

/// Names of one kind; a name may stand for one thing of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Namespace {
    Value,
    Frame,
    /// A frame where there is one of the name, else a value: `N.3`, `v.3`.
    FrameOrValue,
    Force,
    Moment,
    Callable,
    Other,
}

/// A declaration of a name.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Name in ASCII spelling.
    pub name: String,
    /// What the name stands for.
    pub kind: SymbolKind,
    /// Whether it names an array: `v[i]`. A scalar may have the same name.
    pub is_array: bool,
    /// Byte range of the name.
    pub range: Range<usize>,
    /// Byte range of the statement, with its block.
    pub statement: Range<usize>,
    /// Byte range in which the name is known.
    pub scope: Range<usize>,
    /// Documentation: the `///` lines before the statement.
    pub doc: String,
    pub(crate) namespace: Namespace,
}

/// What a word of a text is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WordKind {
    /// A word of the language, such as `param` or `turned`.
    Keyword,
    /// A function or quantity of the language, such as `norm` or `velocity`.
    BuiltIn,
    /// A symbol of a unit.
    Unit,
    /// Declares [`Symbols::declarations`] at this index.
    Declaration(usize),
    /// Refers to [`Symbols::declarations`] at this index.
    Reference(usize),
    /// A name that this text does not declare.
    Unknown,
}

/// A word of a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// Byte range; of `in_B` that of `B`, of `wind_x` that of `wind`.
    pub range: Range<usize>,
    /// What the word is.
    pub kind: WordKind,
}

/// The words and declarations of a text, in order.
#[derive(Clone, Debug, Default)]
pub struct Symbols {
    /// All words but those in comments and quoted texts.
    pub words: Vec<Word>,
    /// All declarations.
    pub declarations: Vec<Declaration>,
}

impl Symbols {
    /// Finds the names of a text.
    pub fn of(text: &str) -> Symbols {
        resolve::resolve(scan::scan(text))
    }

    /// The word at a byte offset, or that ends there.
    pub fn word_at(&self, offset: usize) -> Option<&Word> {
        let after = self
            .words
            .partition_point(|word| word.range.start <= offset);
        let word = self.words[..after].last()?;
        (offset <= word.range.end).then_some(word)
    }

    /// Index of the declaration to which the word at a byte offset belongs.
    pub fn declaration_at(&self, offset: usize) -> Option<usize> {
        match self.word_at(offset)?.kind {
            WordKind::Declaration(own) | WordKind::Reference(own) => Some(own),
            _ => None,
        }
    }

    /// Byte ranges where a name is declared and used.
    pub fn occurrences(&self, declaration: usize) -> impl Iterator<Item = Range<usize>> {
        let of = [
            WordKind::Declaration(declaration),
            WordKind::Reference(declaration),
        ];
        let words = self
            .words
            .iter()
            .filter(move |word| of.contains(&word.kind));
        words.map(|word| word.range.clone())
    }

    /// Why a declaration cannot be renamed to `name`; `None` if it can.
    pub fn refusal(&self, declaration: usize, name: &str) -> Option<String> {
        let own = self.declarations.get(declaration)?;
        let probe = Symbols::of(&format!("let {name} = 1;"));
        let is_name = matches!(&probe.declarations[..], [only] if only.range.len() == name.len());
        if !is_name || name.contains(char::is_whitespace) {
            return Some(format!("`{name}` is not a name: letters, digits and `_`"));
        }
        let name = &probe.declarations[0].name;
        if resolve::is_reserved(name) {
            return Some(format!("`{name}` has a meaning in this language"));
        }
        let is_met = |other: &&Declaration| {
            other.name == *name
                && other.range != own.range
                && other.namespace == own.namespace
                && other.scope.start < own.scope.end
                && own.scope.start < other.scope.end
        };
        let other = self.declarations.iter().find(is_met)?;
        Some(format!("there is a {} `{name}` already", other.kind.noun()))
    }

    /// Declarations that are known at a byte offset.
    pub fn known_at(&self, offset: usize) -> impl Iterator<Item = &Declaration> {
        let all = self.declarations.iter();
        all.filter(move |own| own.scope.start <= offset && offset <= own.scope.end)
    }
}
