//! What the names of a text refer to.

use std::collections::HashMap;
use std::ops::Range;

use super::scan::{Found, Scanned};
use super::{Declaration, Namespace, SymbolKind, Symbols, Word, WordKind};
use crate::check::function_names;
use crate::syntax::reserved::{FIXED, OF_BODY};
use crate::syntax::spelling::plain;

pub(super) fn resolve(scanned: Scanned<'_>) -> Symbols {
    let Scanned {
        text,
        words,
        mut declarations,
        weak,
        ..
    } = scanned;
    for own in &mut declarations {
        own.scope.end = own.scope.end.min(text.len());
    }
    let mut by_name: HashMap<&str, Vec<usize>> = HashMap::new();
    for (i, own) in declarations.iter().enumerate() {
        by_name.entry(&own.name).or_default().push(i);
    }
    for all in by_name.values_mut() {
        all.sort_by_key(|&own| declarations[own].scope.start);
    }
    let names = Names {
        declarations: &declarations,
        weak: &weak,
        by_name,
    };
    let mut resolved: Vec<Word> = Vec::with_capacity(words.len());
    for (range, found) in words {
        let word = |kind| Word {
            range: range.clone(),
            kind,
        };
        resolved.push(match found {
            Found::Keyword => word(WordKind::Keyword),
            Found::Unit => word(WordKind::Unit),
            Found::Declares(index) => match names.stronger(index) {
                Some(other) => word(WordKind::Reference(other)),
                None => word(WordKind::Declaration(index)),
            },
            Found::Name(namespace) => {
                let is_indexed = text[range.end..].trim_start().starts_with('[');
                names.name(&text[range.clone()], range, namespace, is_indexed)
            }
        });
    }
    resolved.sort_by_key(|word| word.range.start);
    Symbols {
        words: resolved,
        declarations,
    }
}

fn is_function(name: &str) -> bool {
    function_names().chain(["sum"]).any(|known| known == name)
}

/// Whether no text can declare a name.
pub(super) fn is_reserved(name: &str) -> bool {
    FIXED.contains(&name) || OF_BODY.contains(&name) || is_function(name)
}

/// Longest part of a name behind that of the declaration to which it belongs, characters.
const MAX_SUFFIX: usize = 12;

/// Number of declarations of one name that are considered in one place.
const MAX_SAME: usize = 16;

struct Names<'a> {
    declarations: &'a [Declaration],
    weak: &'a [bool],
    by_name: HashMap<&'a str, Vec<usize>>,
}

impl Names<'_> {
    /// Another declaration to which a weak one gives way.
    fn stronger(&self, index: usize) -> Option<usize> {
        let own = &self.declarations[index];
        let all = self.by_name.get(own.name.as_str())?;
        let mut all = all
            .iter()
            .copied()
            .take(MAX_SAME)
            .filter(|_| self.weak[index]);
        all.find(|&other| {
            let is_marker = self.declarations[other].kind == SymbolKind::Marker;
            let observed = own.kind == SymbolKind::Observation && is_marker;
            let is_before = self.weak[other] && other < index;
            let gives_way = !self.weak[other] || is_before;
            let is_alike = self.declarations[other].namespace == own.namespace;
            let scope = &self.declarations[other].scope;
            other != index
                && gives_way
                && (is_alike || observed)
                && scope.contains(&own.range.start)
        })
    }

    /// The innermost declaration of a name that is known at an offset; of an array and a scalar there the one that is meant.
    fn find(&self, name: &str, at: usize, namespace: Namespace, is_indexed: bool) -> Option<usize> {
        if namespace == Namespace::FrameOrValue {
            let frame = self.find(name, at, Namespace::Frame, false);
            return frame.or_else(|| self.find(name, at, Namespace::Value, is_indexed));
        }
        let all = self.by_name.get(name)?;
        // In order of the scopes' starts, those of the whole text first.
        let start = |own: usize| self.declarations[own].scope.start;
        let whole = all.partition_point(|&own| start(own) == 0);
        let before = all.partition_point(|&own| start(own) <= at);
        let inner = all[whole..before].iter().rev().take(MAX_SAME);
        let near = inner.chain(all[..whole].iter().take(MAX_SAME)).copied();
        let known = near.filter(|&own| {
            let own = &self.declarations[own];
            own.namespace == namespace && at < own.scope.end
        });
        let innermost = known.min_by_key(|&own| {
            let own = &self.declarations[own];
            (own.scope.len(), own.is_array != is_indexed)
        })?;
        Some(self.stronger(innermost).unwrap_or(innermost))
    }

    fn name(&self, raw: &str, range: Range<usize>, namespace: Namespace, is_indexed: bool) -> Word {
        let name = plain(raw);
        let at = range.start;
        if let Some(own) = self.find(&name, at, namespace, is_indexed) {
            return Word {
                range,
                kind: WordKind::Reference(own),
            };
        }
        if namespace == Namespace::Value
            && let Some((length, own)) = self.derived(raw, at)
        {
            return Word {
                range: at..at + length,
                kind: WordKind::Reference(own),
            };
        }
        let is_built_in = match namespace {
            Namespace::Callable => is_function(&name),
            Namespace::Frame => matches!(&*name, "inertial" | "body"),
            Namespace::Value | Namespace::FrameOrValue => {
                let reserved = FIXED.iter().chain(&OF_BODY);
                reserved
                    .chain(&["mass", "inertial", "body"])
                    .any(|known| *known == name)
                    || name.starts_with("inertia_")
            }
            _ => false,
        };
        let kind = if is_built_in {
            WordKind::BuiltIn
        } else {
            WordKind::Unknown
        };
        Word { range, kind }
    }

    /// The declaration whose part or rate a name is, and the length of the part of the text that is its own name:
    /// `wind` in `wind_x`, `phi` in `phidot`, `φ` in `φ̇`, `c` in `c_3`.
    fn derived(&self, raw: &str, at: usize) -> Option<(usize, usize)> {
        let stems = raw.char_indices().rev().take(MAX_SUFFIX);
        let mut stems = stems.map(|(length, _)| length).filter(|length| *length > 0);
        stems.find_map(|length| {
            let (stem, rest) = raw.split_at(length);
            let rest = plain(rest);
            let is_digit = |c: char| c == '_' || c.is_ascii_digit();
            let is_element = rest.starts_with('_') && rest.len() > 1 && rest.chars().all(is_digit);
            let own = self.find(&plain(stem), at, Namespace::Value, is_element)?;
            let declaration = &self.declarations[own];
            let is_derived = match declaration.kind {
                SymbolKind::Input => matches!(&*rest, "_x" | "_y" | "_z"),
                SymbolKind::State => rest == "dot",
                _ => false,
            };
            (is_derived || is_element).then_some((length, own))
        })
    }
}
