//! Diagnostics: faults of a model file, each with a source span and one message.

pub use crate::source::{Source, Span};

/// Number of faults that are shown, and for which suggestions are looked up; the others are counted.
pub(crate) const MAX_SHOWN: usize = 50;

/// Category of a fault; [`Kind::slug`] is stable and shown in brackets.
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
    /// Stable name of the category, as shown in brackets before a message.
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

/// A source span that explains a fault, with a few words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The span.
    pub span: Span,
    /// Its role in the fault.
    pub text: String,
}

/// One fault: what was found, what was expected, where, and a remedy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Category.
    pub kind: Kind,
    /// Source span at which it is reported.
    pub span: Span,
    /// What is wrong, in one sentence.
    pub message: String,
    /// Other source spans that led to the fault.
    pub labels: Vec<Label>,
    /// Further explanations, one sentence each.
    pub notes: Vec<String>,
    /// A suggested remedy, such as "did you mean `C_La`?".
    pub help: Option<String>,
}

impl Diagnostic {
    /// A fault without labels, notes or help.
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

    /// Adds a source span that explains the fault.
    #[must_use]
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Diagnostic {
        self.labels.push(Label {
            span,
            text: text.into(),
        });
        self
    }

    /// Adds a further explanation.
    #[must_use]
    pub fn note(mut self, text: impl Into<String>) -> Diagnostic {
        self.notes.push(text.into());
        self
    }

    /// Sets the suggested remedy.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Diagnostic {
        self.help = Some(text.into());
        self
    }

    /// Sets the suggested remedy, if one is given.
    #[must_use]
    pub fn help_if(mut self, text: Option<String>) -> Diagnostic {
        self.help = text.or(self.help);
        self
    }
}
