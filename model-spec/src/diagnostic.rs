//! Faults of a model file, each with its place and one message.

pub use crate::source::{Source, Span};

/// Number of faults that are shown, and for which suggestions are looked up; the others are counted.
pub(crate) const MAX_SHOWN: usize = 50;

/// What kind of fault it is; the slug is stable and shown in brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Kind {
    Lexical,
    Grammar,
    Name,
    Unit,
    Frame,
    Shape,
    Singular,
    Cycle,
    Missing,
    Duplicate,
    Value,
    Limit,
}

impl Kind {
    /// The word that stands in brackets before a message.
    pub fn slug(self) -> &'static str {
        match self {
            Kind::Lexical => "lexical",
            Kind::Grammar => "grammar",
            Kind::Name => "name",
            Kind::Unit => "unit",
            Kind::Frame => "frame",
            Kind::Shape => "shape",
            Kind::Singular => "singular",
            Kind::Cycle => "cycle",
            Kind::Missing => "missing",
            Kind::Duplicate => "duplicate",
            Kind::Value => "value",
            Kind::Limit => "limit",
        }
    }
}

/// A place that helps to understand a fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What is there, in a few words.
    pub text: String,
}

/// One fault: what was found, what was expected, where, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Its kind.
    pub kind: Kind,
    /// The place it is reported at.
    pub span: Span,
    /// One sentence: what is wrong.
    pub message: String,
    /// How it came about: the places that led to it.
    pub labels: Vec<Label>,
    /// Further explanation, one sentence each.
    pub notes: Vec<String>,
    /// A suggestion, where there is one ("did you mean `C_La`?").
    pub help: Option<String>,
}

impl Diagnostic {
    /// A fault with its kind, place and sentence.
    pub fn new(kind: Kind, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic {
            kind,
            span,
            message: message.into(),
            labels: Vec::new(),
            notes: Vec::new(),
            help: None,
        }
    }

    /// Adds a place that helps to understand it.
    #[must_use]
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Diagnostic {
        self.labels.push(Label {
            span,
            text: text.into(),
        });
        self
    }

    /// Adds an explanation.
    #[must_use]
    pub fn note(mut self, text: impl Into<String>) -> Diagnostic {
        self.notes.push(text.into());
        self
    }

    /// Sets the suggestion.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Diagnostic {
        self.help = Some(text.into());
        self
    }

    /// Sets the suggestion where there is one.
    #[must_use]
    pub fn help_if(mut self, text: Option<String>) -> Diagnostic {
        self.help = text.or(self.help);
        self
    }
}
