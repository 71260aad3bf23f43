//! Names of statements: the variable names of the model, else names derived from the expressions.

use crate::functions::BinaryFunction;
use crate::graph::{ExprGraph, FastMap, Symbol, opposite_name};
use crate::ssa::{DefId, Ssa, SsaDef};
use std::collections::BTreeSet;

const ARGUMENTS: [&str; 16] = [
    "time",
    "state",
    "parameters",
    "prepared",
    "marker",
    "dx",
    "j",
    "jp",
    "seen",
    "dy_dx",
    "dy_dp",
    "dy_dmarker",
    "values",
    "margins",
    "T",
    "PI",
];

const MAX_NAME_LENGTH: usize = 28;

#[derive(Clone, Debug, Default)]
pub struct Namer {
    taken: BTreeSet<String>,
    /// For a name that is taken, the least number behind it that may be free.
    numbers: FastMap<String, usize>,
    given: FastMap<DefId, String>,
    states: Vec<String>,
    parameters: Vec<String>,
    /// Index of each named value of the model in `Lowered::provenance`, by name.
    origins: FastMap<String, usize>,
}

impl Namer {
    pub fn new(states: &[String], parameters: &[String], origins: &[String]) -> Namer {
        let taken = ARGUMENTS.iter().map(|&name| name.to_string());
        let taken = taken
            .chain(states.iter().cloned())
            .chain(parameters.iter().cloned())
            .collect();
        Namer {
            taken,
            states: states.to_vec(),
            parameters: parameters.to_vec(),
            origins: origins
                .iter()
                .enumerate()
                .map(|(k, name)| (name.clone(), k))
                .collect(),
            ..Namer::default()
        }
    }

    /// Reserves `names`, the names of function arguments, so that no variable is given one of them.
    pub fn reserve(&mut self, names: &[String]) {
        self.taken.extend(names.iter().cloned());
    }

    fn own(&self, ssa: &Ssa, graph: &ExprGraph, id: DefId) -> Option<String> {
        let (minus, node) = ssa.origin[id]?;
        let name = graph.name_of(node)?;
        Some(if minus {
            opposite_name(name)
        } else {
            name.to_string()
        })
    }

    pub fn has_own_name(&self, ssa: &Ssa, graph: &ExprGraph, id: DefId) -> bool {
        self.own(ssa, graph, id).is_some()
    }

    /// Index in `Lowered::provenance` of the auxiliary variable that a definition computes.
    pub fn about(&self, ssa: &Ssa, graph: &ExprGraph, id: DefId) -> Option<usize> {
        let own = self.own(ssa, graph, id)?;
        self.origins.get(own.trim_start_matches("minus_")).copied()
    }

    pub fn name(&mut self, ssa: &Ssa, graph: &ExprGraph, id: DefId) -> String {
        if let Some(known) = self.given.get(&id) {
            return known.clone();
        }
        let wanted = self.describe(ssa, graph, id, 3);
        let name = self.unique(&wanted);
        self.given.insert(id, name.clone());
        name
    }

    /// Names a definition after the output that it computes, if it has no name.
    pub fn suggest(&mut self, ssa: &Ssa, graph: &ExprGraph, id: DefId, name: &str) {
        let leaf = matches!(
            ssa.defs[id],
            SsaDef::Leaf(_) | SsaDef::Constant(_) | SsaDef::Call(..)
        );
        if !leaf && !self.given.contains_key(&id) && !self.has_own_name(ssa, graph, id) {
            let name = self.unique(name);
            self.given.insert(id, name);
        }
    }

    /// Sets the name of the definition `id`, an invariant that `prepare` computes, and reserves this name.
    pub fn give(&mut self, id: DefId, name: &str) {
        self.taken.insert(name.to_string());
        self.given.insert(id, name.to_string());
    }

    /// Frees the name `old`; returns `name`, numbered if it is taken.
    pub fn rename(&mut self, old: Option<String>, name: &str) -> String {
        if let Some(old) = old {
            self.taken.remove(&old);
            self.numbers.clear();
        }
        self.unique(name)
    }

    pub fn negated(&mut self, ssa: &Ssa, graph: &ExprGraph, id: DefId) -> String {
        let wanted = opposite_name(&self.describe(ssa, graph, id, 3));
        self.unique(&wanted)
    }

    fn unique(&mut self, wanted: &str) -> String {
        let wanted = if is_keyword(wanted) {
            format!("{wanted}_")
        } else {
            wanted.to_string()
        };
        if self.taken.insert(wanted.clone()) {
            return wanted;
        }
        let mut number = self.numbers.get(&wanted).copied().unwrap_or(2);
        let mut name = format!("{wanted}_{number}");
        while !self.taken.insert(name.clone()) {
            number += 1;
            name = format!("{wanted}_{number}");
        }
        self.numbers.insert(wanted, number + 1);
        name
    }

    /// Name of a hoisted invariant after its expression; not necessarily unique.
    pub fn constant_name(parameters: &[String], ssa: &Ssa, graph: &ExprGraph, id: DefId) -> String {
        let namer = Namer {
            parameters: parameters.to_vec(),
            ..Namer::default()
        };
        namer.describe(ssa, graph, id, 4)
    }

    fn describe(&self, ssa: &Ssa, graph: &ExprGraph, id: DefId, depth: u32) -> String {
        if let Some(given) = self.given.get(&id) {
            return given.clone();
        }
        if let Some(own) = self.own(ssa, graph, id) {
            return own;
        }
        let inner = |id: DefId| {
            if depth == 0 {
                String::from("part")
            } else {
                self.describe(ssa, graph, id, depth - 1)
            }
        };
        if let Some(name) = self.norm(ssa, graph, id, depth) {
            return name;
        }
        let name = match &ssa.defs[id] {
            SsaDef::Leaf(Symbol::Time) => "time".into(),
            SsaDef::Leaf(Symbol::Pi) => "pi".into(),
            SsaDef::Leaf(Symbol::State(k)) => self
                .states
                .get(*k as usize)
                .cloned()
                .unwrap_or_else(|| format!("x{k}")),
            SsaDef::Leaf(Symbol::Parameter(k)) => self
                .parameters
                .get(*k as usize)
                .cloned()
                .unwrap_or_else(|| format!("p{k}")),
            SsaDef::Leaf(Symbol::Marker(k)) => format!("mark_{}", ["x", "y", "z"][*k as usize % 3]),
            SsaDef::Leaf(Symbol::Local(k)) => format!("local_{k}"),
            SsaDef::Constant(number) => match number.value() {
                0.5 => "half".into(),
                1.0 => "one".into(),
                2.0 => "two".into(),
                value if value.fract() == 0.0 && value < 1e6 => format!("n{value}"),
                _ => "const".into(),
            },
            SsaDef::Sum(terms) => {
                let mut name = String::new();
                for (k, &(minus, term)) in terms.iter().enumerate() {
                    name.push_str(match (k, minus) {
                        (0, false) => "",
                        (0, true) => "minus_",
                        (_, false) => "_plus_",
                        (_, true) => "_minus_",
                    });
                    name.push_str(&inner(term));
                }
                name
            }
            SsaDef::Product(factors) => {
                let mut name = String::new();
                for group in factors.chunk_by(|a, b| a == b) {
                    if !name.is_empty() {
                        name.push('_');
                    }
                    name.push_str(&inner(group[0]));
                    match group.len() {
                        1 => {}
                        2 => name.push_str("_sq"),
                        n => name.push_str(&format!("_pow{n}")),
                    }
                }
                name
            }
            SsaDef::Root(x) => format!("sqrt_{}", inner(*x)),
            SsaDef::Recip(x) => format!("inv_{}", inner(*x)),
            SsaDef::Call(function, (minus, x)) => {
                let sign = if *minus { "minus_" } else { "" };
                format!("{}_{sign}{}", graph.function_name(*function), inner(*x))
            }
            SsaDef::Call2(function, (_, a), (_, b)) => {
                let word = match function {
                    BinaryFunction::Atan2 => "angle",
                    BinaryFunction::Min => "min",
                    BinaryFunction::Max => "max",
                    BinaryFunction::Table(function) => &graph.tables().name(*function),
                };
                format!("{word}_{}_{}", inner(*a), inner(*b))
            }
            SsaDef::IfZero(c, ..) => format!("unless_{}", inner(*c)),
        };
        if name.len() <= MAX_NAME_LENGTH {
            name
        } else {
            shorten(ssa, &name, id)
        }
    }

    /// Name of a sum of squares (`V_sq`, `air_velocity_12_sq`) or its square root, after its root or its components,
    /// spelled out up to `depth`.
    fn norm(&self, ssa: &Ssa, graph: &ExprGraph, id: DefId, depth: u32) -> Option<String> {
        match &ssa.defs[id] {
            SsaDef::Root(x) => {
                let name = self.norm(ssa, graph, *x, depth)?;
                name.strip_suffix("_sq").map(str::to_string)
            }
            SsaDef::Sum(terms) => {
                let root = ssa.find(&SsaDef::Root(id));
                if let Some(name) = root.and_then(|root| self.own(ssa, graph, root)) {
                    return Some(format!("{name}_sq"));
                }
                let mut prefix: Option<String> = None;
                let mut suffixes = Vec::new();
                for &(minus, term) in terms {
                    let factor = match &ssa.defs[term] {
                        SsaDef::Product(factors)
                            if !minus && factors.len() == 2 && factors[0] == factors[1] =>
                        {
                            factors[0]
                        }
                        _ => return None,
                    };
                    let name = self.describe(ssa, graph, factor, depth.min(1));
                    let name = name.trim_start_matches("minus_");
                    let (head, tail) = name.rsplit_once('_')?;
                    if prefix.get_or_insert_with(|| head.to_string()) != head {
                        return None;
                    }
                    suffixes.push(tail.to_string());
                }
                suffixes.sort();
                Some(format!("{}_{}_sq", prefix?, suffixes.concat()))
            }
            _ => None,
        }
    }
}

fn shorten(ssa: &Ssa, name: &str, id: DefId) -> String {
    let kind = match ssa.defs[id] {
        SsaDef::Sum(_) => "sum",
        SsaDef::Product(_) => "product",
        _ => "of",
    };
    let mut end = MAX_NAME_LENGTH - kind.len() - 1;
    while !name.is_char_boundary(end) {
        end -= 1;
    }
    let cut = name[..end].rfind('_').filter(|&at| at > 6).unwrap_or(end);
    format!("{}_{kind}", name[..cut].trim_end_matches('_'))
}

fn is_keyword(name: &str) -> bool {
    const KEYWORDS: [&str; 41] = [
        "as", "async", "await", "box", "break", "const", "continue", "crate", "do", "dyn", "else",
        "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop",
        "match", "mod", "move", "mut", "pub", "ref", "return", "self", "static", "struct", "super",
        "trait", "true", "try", "type", "use", "where", "while",
    ];
    KEYWORDS.contains(&name)
}
