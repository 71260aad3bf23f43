//! An effect as a syntax tree, which is parsed from text or built from parts.

use std::fmt;
use std::path::Path;
use std::sync::LazyLock;

use super::instrument::Instrument;
use crate::diagnostic::{Diagnostic, Kind, Source};
use crate::error::LoadError;
use crate::library::{EFFECTS, GENERAL_EFFECTS};
use crate::read::read;
use crate::source::Span;
use crate::syntax::ast::{Effect, EffectPart, Item, ItemKind, Need};
use crate::syntax::{self, Parsed};

/// An effect as a syntax tree with its source text, ready to be applied to a [`ModelTree`](super::ModelTree).
#[derive(Clone, Debug)]
pub struct EffectTree {
    tree: Effect,
    /// Source text that the tree's spans refer to; `None` for an effect declared in a model's file.
    source: Option<Source>,
}

impl EffectTree {
    /// Creates the effect from the syntax tree of an effect declared in a model file; it has no separate source text.
    pub(super) fn of_model(tree: Effect) -> EffectTree {
        EffectTree { tree, source: None }
    }

    /// Builds an effect from a syntax tree; its source text is the printed tree.
    ///
    /// ```
    /// use model_spec::compose::{EffectTree, ModelTree};
    /// # let parsed = EffectTree::parse("lift.hyz",
    /// #     "effect more_lift { site lift; coefficient k = 0 [1]; replace C_L = previous + k; }")?;
    /// let mut tree = parsed.tree().clone();
    /// tree.name.text = "other_lift".to_owned();
    /// let effect = EffectTree::new(tree);
    /// let model = ModelTree::load("disc")?.with(&effect)?.check()?;
    /// assert_eq!(model.effects[0].name, "other_lift");
    /// # Ok::<(), model_spec::LoadError>(())
    /// ```
    pub fn new(mut tree: Effect) -> EffectTree {
        let text = tree.to_string();
        let whole = Span {
            start: 0,
            end: u32::try_from(text.len()).unwrap_or(u32::MAX),
            source: 0,
        };
        tree.change_spans(&mut |span| *span = whole);
        let source = Source {
            name: format!("{}.hyz", tree.name.text),
            text,
        };
        EffectTree {
            tree,
            source: Some(source),
        }
    }

    /// Loads an effect from a file. The file must declare exactly one effect, or several effects of which one is named
    /// like the file without its extension.
    ///
    /// # Errors
    /// [`LoadError::Unreadable`] if the file cannot be read; [`LoadError::Faults`] if it has syntax errors or contains
    /// no such effect.
    pub fn load(path: &str) -> Result<EffectTree, LoadError> {
        EffectTree::parse(path, &read(path)?)
    }

    /// Built-in effect of the given name, specific or general.
    pub(super) fn built_in(name: &str) -> Option<&'static EffectTree> {
        static BUILT_IN: LazyLock<Vec<EffectTree>> = LazyLock::new(|| {
            let all = EFFECTS.iter().chain(GENERAL_EFFECTS);
            let parse =
                |(name, text): &(&str, &str)| EffectTree::parse(&format!("{name}.hyz"), text).ok();
            all.filter_map(parse).collect()
        });
        BUILT_IN.iter().find(|effect| effect.name() == name)
    }

    /// More specific effects, of which this one is the general form.
    pub fn generalises(&self) -> impl Iterator<Item = &str> {
        self.tree.parts.iter().flat_map(|part| match part {
            EffectPart::Generalises(names) => names.iter().map(|name| name.text.as_str()).collect(),
            _ => Vec::new(),
        })
    }

    /// Parses an effect from text; messages refer to the text as `name`. The text must declare exactly one effect, or
    /// several effects of which one is named like the file `name` without its extension.
    ///
    /// # Errors
    /// [`LoadError::Faults`] if the text has syntax errors or contains no such effect.
    pub fn parse(name: &str, text: &str) -> Result<EffectTree, LoadError> {
        let Parsed {
            file,
            source,
            mut diagnostics,
        } = syntax::parse(name, text);
        let is_check = |item: &&Item| matches!(item.kind, ItemKind::Check(_));
        let (checks, others): (Vec<&Item>, Vec<&Item>) = file.items.iter().partition(is_check);
        if let Some(case) = checks.first()
            && others.len() == file.effects().count()
        {
            let message = "a check in the file of an effect is not run";
            let fault = Diagnostic::new(Kind::Grammar, case.span, message);
            diagnostics.push(fault.help("move it to the file of a model"));
        }
        let mut effects: Vec<Effect> = file.effects().cloned().collect();
        if effects.len() > 1 {
            let wanted = Path::new(name).file_stem().unwrap_or_default();
            let wanted = wanted.to_string_lossy().replace('-', "_");
            effects.retain(|effect| effect.name.text == wanted);
        }
        if diagnostics.is_empty() && effects.is_empty() {
            let fault = Diagnostic::new(Kind::Missing, file.end, "the file has no effect");
            diagnostics.push(fault.help("write `effect NAME { … }`"));
        }
        match effects.into_iter().next() {
            Some(tree) if diagnostics.is_empty() => Ok(EffectTree {
                tree,
                source: Some(source),
            }),
            _ => Err(LoadError::Faults {
                diagnostics,
                sources: vec![source],
            }),
        }
    }

    /// Quantities that a model must have: those needed without a fallback.
    pub fn needs(&self) -> impl Iterator<Item = &Need> {
        let all = self.tree.parts.iter().flat_map(|part| match part {
            EffectPart::Needs(needs) => needs.as_slice(),
            _ => &[],
        });
        all.filter(|need| need.otherwise.is_none())
    }

    /// Instruments whose measured quantities the effect needs.
    pub(crate) fn instruments(&self) -> Vec<Instrument> {
        let is_needed = |instrument: &Instrument| {
            let mut needs = self.needs();
            needs.any(|need| need.name.text == instrument.name())
        };
        Instrument::ALL.into_iter().filter(is_needed).collect()
    }

    /// Name of the effect, words separated by underscores.
    pub fn name(&self) -> &str {
        &self.tree.name.text
    }

    /// Syntax tree of the effect.
    pub fn tree(&self) -> &Effect {
        &self.tree
    }

    /// Source text of a span; empty for an effect of a model file.
    pub(crate) fn text(&self, span: Span) -> &str {
        let source = self.source.as_ref();
        source
            .and_then(|source| source.text.get(span.range()))
            .unwrap_or_default()
    }

    /// Copy of the tree with spans that refer to `sources`, to which its text is added.
    pub(super) fn in_sources(&self, sources: &mut Vec<Source>) -> Effect {
        let mut tree = self.tree.clone();
        if let Some(own) = &self.source {
            let place = sources.iter().position(|source| source == own);
            let place = place.unwrap_or_else(|| {
                sources.push(own.clone());
                sources.len() - 1
            });
            let place = u16::try_from(place).unwrap_or(u16::MAX);
            tree.change_spans(&mut |span| span.source = place);
        }
        tree
    }
}

impl fmt::Display for EffectTree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.tree.fmt(f)
    }
}
