//! Names of a model that could be confused with one another.

use model_spec::syntax::ast::{File, ItemKind, Parameter};

/// Names that a mutation may exchange: frames, constants with units, variables with the index of the statement.
pub struct Names {
    frames: Vec<String>,
    constants: Vec<(String, String)>,
    lets: Vec<(usize, String)>,
}

impl Names {
    /// Collects the names of frames, constants and auxiliary variables of a model file.
    pub fn of(file: &File) -> Self {
        let mut names = Self {
            frames: Vec::new(),
            constants: Vec::new(),
            lets: Vec::new(),
        };
        for (index, item) in file.items.iter().enumerate() {
            match &item.kind {
                ItemKind::Frame(f) => names.frames.push(f.name.text.clone()),
                ItemKind::Parameter(c) => names.constants.push((c.name.text.clone(), unit(c))),
                ItemKind::Let(l) => names.lets.push((index, l.name.text.clone())),
                _ => {}
            }
        }
        names
    }

    /// Whether the model file declares a frame of the given name.
    pub fn is_frame(&self, name: &str) -> bool {
        self.frames.iter().any(|f| f == name)
    }

    /// Names of all frames of the model file except the given one.
    pub fn other_frames<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a String> {
        self.frames.iter().filter(move |f| *f != name)
    }

    /// Plausible replacements of a name in the statement `item`: at most two constants of the same unit and one of
    /// another; auxiliary variables declared before, at most two places away.
    pub fn exchanges(&self, name: &str, item: usize) -> Vec<String> {
        let mut out = Vec::new();
        if let Some(at) = self.constants.iter().position(|(n, _)| n == name) {
            let (before, after) = self.constants.split_at(at);
            let mut others = after[1..].iter().chain(before);
            let unit = &after[0].1;
            out.extend(
                others
                    .clone()
                    .filter(|(_, u)| u == unit)
                    .take(2)
                    .map(|(n, _)| n.clone()),
            );
            out.extend(others.find(|(_, u)| u != unit).map(|(n, _)| n.clone()));
        }
        if let Some(at) = self.lets.iter().position(|(_, n)| n == name) {
            let near = |&(k, &(declared, _)): &(usize, &(usize, String))| {
                k != at && k.abs_diff(at) <= 2 && declared < item
            };
            out.extend(
                self.lets
                    .iter()
                    .enumerate()
                    .filter(near)
                    .map(|(_, (_, n))| n.clone()),
            );
        }
        out
    }
}

fn unit(constant: &Parameter) -> String {
    let unit = constant.value.unit.as_ref();
    unit.map(ToString::to_string).unwrap_or_default()
}
