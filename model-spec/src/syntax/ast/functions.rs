//! Syntax trees of what is expanded before a model is checked: functions, arrays, and the origin of expanded statements.

use std::fmt;
use std::ops::RangeInclusive;
use std::sync::Arc;

use super::{Expr, Item, ItemKind, Let, Name, Number, UnitExpr};
use crate::location::Span;

/// Declaration `function NAME(PARAMETER: TYPE, …): TYPE { let …; return …; }`.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Name of the function, by which expressions call it.
    pub name: Name,
    /// Parameters, in the order of a call's arguments.
    pub parameters: Vec<FunctionParameter>,
    /// Type of the result.
    pub result: Type,
    /// Auxiliary variables of the body, in order.
    pub lets: Vec<Let>,
    /// Expression after `return`.
    pub value: Expr,
    /// Source span of the whole statement.
    pub span: Span,
}

/// A parameter of a function.
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionParameter {
    /// Name of the parameter, declared in the body only.
    pub name: Name,
    /// Type that each argument must have.
    pub of: Type,
}

/// Type of a parameter or of a result: `UNIT`, `vector UNIT in FRAME`, or nothing for a pure number.
#[derive(Clone, Debug, PartialEq)]
pub struct Type {
    /// Unit; `None` for a pure number.
    pub unit: Option<UnitExpr>,
    /// Frame of the components of a vector; `None` for a scalar.
    pub frame: Option<Name>,
}

/// An index with its values, as in `i in 1..8`.
#[derive(Clone, Debug, PartialEq)]
pub struct Index {
    /// Name of the index, which is a number where it is used.
    pub name: Name,
    /// Values of the index, in order.
    pub values: RangeInclusive<u32>,
}

/// A statement for each element of an array, such as `let r[i] for i in 1..8 = …;`.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// Subscripts of the declared name.
    pub subscripts: Vec<Expr>,
    /// Indices after `for`; the last one runs fastest.
    pub indices: Vec<Index>,
    /// Values of a parameter's elements, in the unit of its default; empty if all have the same.
    pub values: Vec<Number>,
    /// The statement, with the name of the array.
    pub statement: Box<ItemKind>,
}

/// The expected type of an argument or a result of a function.
#[derive(Clone, Debug, PartialEq)]
pub struct Ascription {
    /// Name of the function.
    pub function: String,
    /// Parameter to which the expression is the argument; `None` for the result.
    pub parameter: Option<Name>,
    /// Expected type.
    pub of: Type,
}

impl fmt::Display for Ascription {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.parameter {
            Some(parameter) => write!(f, "the argument `{}` of", parameter.text)?,
            None => write!(f, "the result of")?,
        }
        write!(f, " `{}`", self.function)
    }
}

impl Function {
    /// What an argument for `parameter` must be.
    pub(crate) fn of_argument(&self, parameter: &FunctionParameter) -> Ascription {
        Ascription {
            function: self.name.text.clone(),
            parameter: Some(parameter.name.clone()),
            of: parameter.of.clone(),
        }
    }

    /// What the result must be.
    pub(crate) fn of_result(&self) -> Ascription {
        Ascription {
            function: self.name.text.clone(),
            parameter: None,
            of: self.result.clone(),
        }
    }
}

/// A statement of the text, and the statements that it was expanded to.
#[derive(Clone, Debug, PartialEq)]
pub struct Template {
    /// The statement as it was written.
    pub written: Item,
    /// Contents of the statements that stand for it, in order.
    pub expanded: Vec<ItemKind>,
}

/// Origin of an expanded statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Expanded {
    /// The statement that was written, shared by all to which it was expanded.
    pub from: Arc<Template>,
    /// Source span of the call to whose function an auxiliary variable belongs; `None` for other statements.
    pub call: Option<Span>,
}
