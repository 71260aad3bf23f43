//! An effect as a syntax tree, which is parsed from text or built from parts.

use crate::diagnostic::{Diagnostic, Kind, Source};
use crate::files::{self, Complete};
use crate::location::Span;
use crate::read::{EFFECTS, LoadError, read};
use crate::syntax::ast::{Effect, EffectPart, Item, ItemKind, Need};
use std::fmt;
use std::path::Path;
use std::sync::LazyLock;

/// An effect as a syntax tree with its source text, ready to be applied to a [`ModelTree`](super::ModelTree).
#[derive(Clone, Debug)]
pub struct EffectTree {
    tree: Effect,
    /// Source text that the tree's spans refer to; `None` for an effect declared in a model's file.
    /// Its text, then the files that it names; empty for an effect of a model file.
    sources: Vec<Source>,
}

impl EffectTree {
    /// Creates the effect from the syntax tree of an effect declared in a model file; it has no separate source text.
    pub(super) fn of_model(tree: Effect) -> EffectTree {
        EffectTree {
            tree,
            sources: Vec::new(),
        }
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
    pub fn new(tree: Effect) -> EffectTree {
        let source = Source::new(format!("{}.hyz", tree.name.text), tree.to_string());
        EffectTree {
            tree,
            sources: vec![source],
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

    /// Built-in effects: those for certain kinds of models, then those for any, each by name.
    pub fn built_in() -> &'static [EffectTree] {
        static BUILT_IN: LazyLock<Vec<EffectTree>> = LazyLock::new(|| {
            let parse =
                |(name, text): &(&str, &str)| EffectTree::parse(&format!("{name}.hyz"), text).ok();
            let mut all: Vec<EffectTree> = EFFECTS.iter().filter_map(parse).collect();
            all.sort_by_key(EffectTree::is_general);
            all
        });
        &BUILT_IN
    }

    /// Whether the effect is written for models of any kind: it states which effects it `generalises`, if only `none`.
    pub fn is_general(&self) -> bool {
        let states = |part: &EffectPart| matches!(part, EffectPart::Generalises(_));
        self.tree.parts.iter().any(states)
    }

    /// More specific effects, of which this one is the general form.
    pub fn generalises(&self) -> impl Iterator<Item = &str> {
        let names = self.tree.parts.iter().flat_map(|part| match part {
            EffectPart::Generalises(names) => names.as_slice(),
            _ => &[],
        });
        names
            .map(|name| name.text.as_str())
            .filter(|name| *name != "none")
    }

    /// Parses an effect from text; messages refer to the text as `name`. The text must declare exactly one effect, or
    /// several effects of which one is named like the file `name` without its extension.
    pub fn parse(name: &str, text: &str) -> Result<EffectTree, LoadError> {
        let Complete {
            file,
            sources,
            mut diagnostics,
        } = files::parse(name, text, 0);
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
            Some(tree) if diagnostics.is_empty() => Ok(EffectTree { tree, sources }),
            _ => Err(LoadError::Faults {
                diagnostics,
                sources,
            }),
        }
    }

    /// Quantities that a model must have: those needed without a fallback.
    pub fn needs(&self) -> impl Iterator<Item = &Need> {
        self.tree.needs().filter(|need| need.otherwise.is_none())
    }

    /// Whether the effect adds states, whose initial values differ from flight to flight.
    pub fn has_states(&self) -> bool {
        let mut added = self.tree.added();
        added.any(|item| matches!(item.kind, ItemKind::State(_)))
    }

    /// Whether the effect is about the attitudes of poses: by the input `pose_is`, whose first component is 1 for them.
    #[doc(hidden)]
    pub fn is_about_poses(&self) -> bool {
        let mut added = self.tree.added();
        added.any(|item| matches!(&item.kind, ItemKind::Input(own) if own.name.text == "pose_is"))
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
        let source = self.sources.first();
        source
            .and_then(|source| source.text.get(span.range()))
            .unwrap_or_default()
    }

    /// The tree with spans that refer to `sources`, to which its text is added.
    pub(super) fn in_sources(&self, sources: &mut Vec<Source>) -> Effect {
        let Some(own) = self.sources.first() else {
            return self.tree.clone();
        };
        let place = sources.iter().position(|source| source == own);
        let place = place.unwrap_or_else(|| {
            sources.extend(self.sources.iter().cloned());
            sources.len() - self.sources.len()
        });
        let place = u16::try_from(place).unwrap_or(u16::MAX);
        let file = files::parse(&own.name, &own.text, place).file;
        let effect = file
            .effects()
            .find(|own| own.name.text == self.name())
            .cloned();
        Effect {
            doc: self.tree.doc.clone(),
            ..effect.unwrap_or_else(|| self.tree.clone())
        }
    }
}

impl fmt::Display for EffectTree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.tree.fmt(f)
    }
}

/// An instrument mounted on the body. The value that it measures is predicted by an auxiliary variable of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Instrument {
    /// Measures the angular velocity of the body, rad/s, with components in the frame of the model's marker.
    Gyroscope,
    /// Measures the specific force at the model's marker, m/s², with components in the frame of the marker.
    Accelerometer,
    /// Measures a speed, m/s: the variable `speed` of the model, otherwise that of the centre of mass over the ground.
    Speed,
}

impl Instrument {
    /// All instruments.
    pub const ALL: [Self; 3] = [Self::Gyroscope, Self::Accelerometer, Self::Speed];

    /// Name of the predicting variable in models, and of the measurement in datasets.
    #[doc(hidden)]
    pub fn name(self) -> &'static str {
        match self {
            Self::Gyroscope => "gyroscope",
            Self::Accelerometer => "accelerometer",
            Self::Speed => "speed",
        }
    }

    /// Number of scalar components of the measured quantity: 3 for a vector, 1 for a speed.
    #[doc(hidden)]
    pub fn components(self) -> usize {
        match self {
            Self::Gyroscope | Self::Accelerometer => 3,
            Self::Speed => 1,
        }
    }

    /// Default `let` of the measured quantity, in `frame`, at the vector `marker` from the centre of mass.
    pub(super) fn definition(self, frame: &str, marker: &str) -> String {
        match self {
            Self::Gyroscope => format!("let gyroscope = in_{frame}(angular_velocity);"),
            Self::Accelerometer => format!(
                "let accelerometer = in_{frame}(specific_force) + cross(in_{frame}(angular_acceleration), {marker}) \
                 + cross(in_{frame}(angular_velocity), cross(in_{frame}(angular_velocity), {marker}));"
            ),
            Self::Speed => "let speed = norm(velocity);".to_owned(),
        }
    }
}
