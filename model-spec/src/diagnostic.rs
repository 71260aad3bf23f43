//! Diagnostics: errors of a model file, each with a source span and one message.

pub use crate::location::{Source, Span};
use crate::suggest;

/// Maximum number of errors shown, and for which suggestions are searched.
pub(crate) const MAX_SHOWN: usize = 50;

/// Maximum number of names in one sentence.
const MAX_LISTED: usize = 8;

/// Category of an error in a model file, such as a syntax error or a unit error.
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
    /// Stable name of the category, such as `unit`; messages show it in brackets.
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

/// An additional source span with an annotation, such as an earlier declaration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Source span to which the annotation refers.
    pub span: Span,
    /// Annotation of the span, such as `the divisor`.
    pub text: String,
}

/// Replacement of a part of the source text that follows a suggested remedy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// Source span that is replaced; an empty one where text is inserted.
    pub span: Span,
    /// New text of the span.
    pub text: String,
}

/// Error message for a model file: what is wrong, where, and a suggested remedy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Category of the error.
    pub kind: Kind,
    /// Source span of the error.
    pub span: Span,
    /// Description of the error, in one sentence.
    pub message: String,
    /// Annotated source spans that explain the error.
    pub labels: Vec<Label>,
    /// Further explanations, one sentence each.
    pub notes: Vec<String>,
    /// Suggested remedy, such as "did you mean `C_La`?"; `None` if there is no suggestion.
    pub help: Option<String>,
    /// Replacement that carries out the remedy; `None` if it is not certain where or what to write.
    pub fix: Option<Box<Fix>>,
}

pub(crate) fn sort(diagnostics: &mut [Diagnostic]) {
    diagnostics.sort_by_key(|diagnostic| diagnostic.span);
}

impl Diagnostic {
    /// Creates an error without labels, notes or help.
    pub fn new(kind: Kind, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic {
            kind,
            span,
            message: message.into(),
            labels: Vec::new(),
            notes: Vec::new(),
            help: None,
            fix: None,
        }
    }

    /// Adds the source span `span` with the annotation `text`, which helps to explain the error.
    #[must_use]
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Diagnostic {
        self.labels.push(Label {
            span,
            text: text.into(),
        });
        self
    }

    /// Adds a note, one sentence.
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

    /// Sets the suggested remedy if `text` is `Some`; otherwise leaves the remedy unchanged.
    #[must_use]
    pub fn help_if(mut self, text: Option<String>) -> Diagnostic {
        self.help = text.or(self.help);
        self
    }

    /// Sets the text that replaces `span` to carry out the suggested remedy.
    #[must_use]
    pub fn fix(mut self, span: Span, text: impl Into<String>) -> Diagnostic {
        let text = text.into();
        self.fix = Some(Box::new(Fix { span, text }));
        self
    }

    /// Suggests `name` in place of what stands at the source span of the error.
    #[must_use]
    pub(crate) fn suggest(self, name: &str) -> Diagnostic {
        let span = self.span;
        self.help(format!("did you mean `{name}`?")).fix(span, name)
    }

    /// Suggests the name nearest in spelling to `wrong`, if one is near.
    pub(crate) fn did_you_mean<'n>(
        self,
        wrong: &str,
        names: impl IntoIterator<Item = &'n str>,
    ) -> Diagnostic {
        let near = suggest::nearest(wrong, names.into_iter());
        match near {
            Some(near) => self.suggest(near),
            None => self,
        }
    }
}

/// Names in a sentence, each quoted: "`a`, `b` and `c`".
pub(crate) fn listed(names: &[impl AsRef<str>]) -> String {
    let quoted: Vec<String> = names
        .iter()
        .take(MAX_LISTED)
        .map(|n| format!("`{}`", n.as_ref()))
        .collect();
    if names.len() > MAX_LISTED {
        return format!(
            "{} and {} more",
            quoted.join(", "),
            names.len() - MAX_LISTED
        );
    }
    match quoted.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
        None => String::new(),
    }
}
