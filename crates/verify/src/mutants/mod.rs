//! Mutation testing: generates models with one plausible mistake each, and determines which checks detect them.

pub mod equivalence;
mod matrix;
mod names;
mod rewrite;
mod statement;
pub mod status;
mod verdicts;

use crate::options::Options;
use equivalence::Original;
use flight::parallel;
pub use matrix::{MutationMatrix, MutationRow};
use model_spec::diagnostic::{Source, Span};
use model_spec::syntax::ast::{File, FrameKind, Name};
use names::Names;
use status::evaluate;

/// Kinds of mutations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Operator {
    /// Changes a sign in an expression of the model.
    Sign,
    /// Multiplies an expression of the model by 2, 0.5 or 1.1.
    Factor,
    /// Replaces the name of a frame by that of another.
    Frame,
    /// Replaces the number of an axis or component, or interchanges two components.
    Axis,
    /// Replaces the axis, the parent or the angle of a rotated frame.
    Turn,
    /// Interchanges sine and cosine, drops `sqrt`, `unit` or `abs`, or changes the interpolation of a table.
    Function,
    /// Deletes a term or factor, or a force or moment.
    Dropped,
    /// Changes an exponent in an expression by one.
    Exponent,
    /// Replaces a name by another, or turns a force into a moment or vice versa.
    Exchanged,
    /// Changes the unit in a declaration.
    Unit,
    /// Interchanges the arguments of a function call.
    Order,
}

impl Operator {
    /// All mutation operators, in the order of the rows of a [`MutationMatrix`], with their names in tables.
    pub const ALL: [(Self, &'static str); 11] = [
        (Self::Sign, "sign flipped"),
        (Self::Factor, "factor changed"),
        (Self::Dropped, "left out"),
        (Self::Exchanged, "other name"),
        (Self::Frame, "other frame"),
        (Self::Axis, "other axis"),
        (Self::Turn, "other turn"),
        (Self::Function, "other function"),
        (Self::Exponent, "other exponent"),
        (Self::Order, "arguments swapped"),
        (Self::Unit, "wrong unit"),
    ];
}

/// A mutation of a part of a model file.
struct Mutation<T> {
    /// Mutation operator.
    operator: Operator,
    /// Short description of the mutation, such as `components 1 and 2 swapped`.
    how: String,
    /// Mutated part.
    to: T,
}

/// A model with one mutation.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// Mutation operator.
    pub operator: Operator,
    /// Mutated statement, such as `der(u)` or `frame B`.
    pub place: String,
    /// Description such as `exponent 3 for 2`, usually with the text of the expression.
    pub change: String,
    /// Syntax tree of the mutated model.
    pub file: File,
}

/// Maximum number of random points per check of a mutant.
const MAX_CASES: usize = 6;

/// Runs the checks on every mutant of a model file, in parallel.
pub fn run(
    file: &File,
    sources: &[Source],
    original: &Original<'_>,
    options: &Options,
) -> MutationMatrix {
    let options = Options {
        cases: options.cases.min(MAX_CASES),
        ..*options
    };
    let mutants = mutants(file, sources);
    let statuses = parallel::each(mutants.len(), |index| {
        evaluate(&mutants[index], sources, original, &options)
    });
    MutationMatrix::of(&mutants, &statuses)
}

/// Generates all mutants of a model file, in the order of its statements.
pub fn mutants(file: &File, sources: &[Source]) -> Vec<Mutant> {
    let names = Names::of(file);
    let angles = file.frames().filter_map(|frame| match &frame.kind {
        FrameKind::Turned { angle, .. } => Some(angle.clone()),
        _ => None,
    });
    let angles: Vec<Name> = angles.collect();
    let mut out = Vec::new();
    for (index, item) in file.items.iter().enumerate() {
        if file.is_written_out(item) {
            continue;
        }
        let place = statement::name(item);
        for change in statement::changes(item, &names, &angles) {
            let mut file = file.clone();
            match change.to {
                Some(kind) => file.items[index].kind = kind,
                None => drop(file.items.remove(index)),
            }
            out.push(Mutant {
                operator: change.operator,
                place: place.clone(),
                change: change.how,
                file,
            });
        }
        let text = |span: Span| {
            let source = sources.get(usize::from(span.source));
            let text = source.and_then(|source| source.text.get(span.range()));
            text.unwrap_or_default()
        };
        let mut scratch = item.clone();
        for (k, root) in statement::roots(&mut scratch).into_iter().enumerate() {
            for rewrite in rewrite::everywhere(root, &names, index, &text, &mut 0) {
                let mut file = file.clone();
                *statement::roots(&mut file.items[index]).swap_remove(k) = rewrite.to;
                out.push(Mutant {
                    operator: rewrite.operator,
                    place: place.clone(),
                    change: rewrite.how,
                    file,
                });
            }
        }
    }
    out
}
