//! Parser and printer for functions, and for arrays: their subscripts, indices and elements.

use std::fmt::{self, Display, Formatter, Write};

use super::ast::{
    Array, Expr, Function, FunctionParameter, Index, ItemKind, Let, Name, Number, Type,
};
use super::parser::{Parser, Read, Reported};
use super::print::listed;
use super::token::Token;
use crate::diagnostic::{Diagnostic, Kind, Span};

/// Maximum number of values of an index, and of elements of an array.
pub(super) const MAX_ELEMENTS: u32 = 1_000;

/// Greatest value of an index.
const MAX_INDEX: u32 = 1_000_000;

/// Name of an element of an array: that of the array and the values of the subscripts, joined by `_`.
pub(super) fn element_name(array: &str, subscripts: &[i64]) -> String {
    let mut name = array.to_owned();
    for subscript in subscripts {
        let _ = write!(name, "_{subscript}");
    }
    name
}

enum Part {
    Let(Let),
    Return(Expr, Span),
}

impl Parser<'_> {
    /// Parses `function NAME(PARAMETER: TYPE, …): TYPE { let …; return …; }`.
    pub fn function(&mut self) -> Read<ItemKind> {
        let start = self.here();
        let (_, name) = self.keyword_and_name()?;
        let open = format!("`(` and the parameters of `{}`", name.text);
        self.need(Token::Sign("("), &open)?;
        let parameters = if self.peek() == Token::Sign(")") {
            Vec::new()
        } else {
            self.list(|parser| {
                let name = parser.name("the name of a parameter")?;
                let of = parser.type_behind_colon()?;
                Ok(FunctionParameter { name, of })
            })?
        };
        self.need(Token::Sign(")"), "`,` or `)` after a parameter")?;
        let result = self.type_behind_colon()?;
        if self.peek() == Token::Sign("-") && self.peek_at(1) == Token::Sign(">") {
            let help = "the type of the result stands behind a colon: `function f(a: m): N { … }`";
            return self.expected_help("`:` or `{` after the parameters", Some(help.to_owned()));
        }
        let earlier = self.reports();
        let parts = self.braces(&format!("`function {}`", name.text), Self::function_part)?;
        let mut lets = Vec::new();
        let mut returned: Option<(Expr, Span)> = None;
        for part in parts {
            match (part, &returned) {
                (Part::Let(own), None) => lets.push(own),
                (Part::Return(value, span), None) => returned = Some((value, span)),
                (Part::Let(Let { name, .. }), Some(_)) => return self.unreachable(name.span),
                (Part::Return(_, span), Some(_)) => return self.unreachable(span),
            }
        }
        let Some((value, _)) = returned else {
            if self.reports() > earlier {
                return Err(Reported);
            }
            let message = format!("the function `{}` returns nothing", name.text);
            let fault = Diagnostic::new(Kind::Missing, name.span, message);
            return self.refuse(fault.help("end its block with `return …;`"));
        };
        Ok(ItemKind::Function(Function {
            name,
            parameters,
            result,
            lets,
            value,
            span: start.to(self.behind()),
        }))
    }

    fn unreachable<T>(&mut self, span: Span) -> Read<T> {
        let message = "a function ends with its `return`";
        self.refuse(Diagnostic::new(Kind::Grammar, span, message).help("remove what follows it"))
    }

    fn function_part(&mut self) -> Read<Part> {
        let start = self.here();
        match self.raw() {
            "let" => {
                let (_, name) = self.keyword_and_name()?;
                self.binding_rest(name).map(Part::Let)
            }
            "return" => {
                self.advance();
                let value = self.expr()?;
                self.semicolon("this `return`")?;
                Ok(Part::Return(value, start.to(self.behind())))
            }
            _ => self.expected_statement_of("function"),
        }
    }

    /// Parses the type after a name: `: UNIT`, `: vector UNIT in FRAME`, or nothing for a pure number.
    pub fn type_behind_colon(&mut self) -> Read<Type> {
        let mut of = Type {
            unit: None,
            frame: None,
        };
        if !self.eat(Token::Sign(":")) {
            return Ok(of);
        }
        let is_vector = self.eat_word("vector");
        // The first `in` of `vector in in B` is the inch.
        if !(is_vector && self.at_word("in") && self.raw_at(1) != "in") {
            of.unit = Some(match self.raw_at(1) {
                // What a function takes has a type of its own, not one by its uses.
                "?" => self.unit()?,
                _ => self.unit_in_brackets_or_not()?,
            });
        }
        if is_vector {
            of.frame = Some(self.in_frame("the unit of a vector")?);
        }
        Ok(of)
    }

    /// Parses the subscripts `[i, …]` of a name; none if there is no bracket.
    pub fn subscripts(&mut self) -> Read<Vec<Expr>> {
        let name = self.behind();
        if !self.eat(Token::Sign("[")) {
            return Ok(Vec::new());
        }
        let name = self.slice(name);
        let subscripts = self.list(Self::expr)?;
        if self.at_word("in") {
            let index = subscripts.last().map_or_else(String::new, Expr::to_string);
            let range = match self.peek_at(2) {
                Token::Sign("..") => format!("{}..{}", self.raw_at(1), self.raw_at(3)),
                _ => "1..8".to_owned(),
            };
            let help = format!(
                "the range of an index stands behind: `{name}[{index}] for {index} in {range} = …`"
            );
            return self.expected_help("`]` after the index", Some(help));
        }
        self.need(Token::Sign("]"), "`]` after the index")?;
        Ok(subscripts)
    }

    /// Parses the name of a quantity or of an element such as `r[3]`, which is called `r_3`.
    pub fn name_or_element(&mut self, what: &str) -> Read<Name> {
        let mut name = self.name(what)?;
        if self.eat(Token::Sign("[")) {
            let subscripts = self.list(|parser| parser.index_value("the number of an element"))?;
            self.need(Token::Sign("]"), "`]` after the index")?;
            let subscripts: Vec<i64> = subscripts.into_iter().map(i64::from).collect();
            name.text = element_name(&name.text, &subscripts);
            name.span = name.span.to(self.behind());
        }
        Ok(name)
    }

    /// Parses the indices of an array, `for i in 1..8, …`; none without `for`.
    pub fn indices(&mut self) -> Read<Vec<Index>> {
        if self.eat_word("for") {
            self.list(Self::index)
        } else {
            Ok(Vec::new())
        }
    }

    /// Parses `i in 1..8`.
    pub fn index(&mut self) -> Read<Index> {
        let name = self.name("an index, as in `i in 1..8`")?;
        self.need_word("in", "the index")?;
        let from = self.here();
        let first = self.index_value("the first value of the index, a whole number")?;
        self.need(
            Token::Sign(".."),
            "`..` between the first and the last value",
        )?;
        let last = self.index_value("the last value of the index, a whole number")?;
        let span = from.to(self.behind());
        if first > last {
            let message = format!("the range `{}` is empty", self.slice(span));
            let fault = Diagnostic::new(Kind::Value, span, message);
            return self.refuse(fault.help(format!("write `{last}..{first}`")));
        }
        if last - first >= MAX_ELEMENTS {
            let message = format!(
                "an index has at most {MAX_ELEMENTS} values, but this one has {}",
                last - first + 1
            );
            return self.refuse(Diagnostic::new(Kind::Limit, span, message));
        }
        Ok(Index {
            name,
            values: first..=last,
        })
    }

    fn index_value(&mut self, what: &str) -> Read<u32> {
        let help = match self.peek() {
            Token::Name => {
                "how many elements there are does not change with parameters: write a number"
            }
            Token::Sign("-") => {
                "indices count up from 0 or 1, as in `k in 1..2`; a side that is 1 or -1 is `3 - 2*k`"
            }
            _ => "",
        };
        if !help.is_empty() {
            return self.expected_help(what, Some(help.to_owned()));
        }
        let digits = self.digits(what)?;
        match digits.text.parse::<u32>() {
            Ok(value) if value <= MAX_INDEX => Ok(value),
            _ => {
                let message = format!("`{}` cannot be an index", digits.text);
                let fault = Diagnostic::new(Kind::Value, digits.span, message);
                self.refuse(fault.note(format!("indices are whole numbers from 0 to {MAX_INDEX}")))
            }
        }
    }

    /// Statement for each element of an array; the statement itself if its name has no subscripts and no indices.
    pub fn array(
        &mut self,
        subscripts: Vec<Expr>,
        indices: Vec<Index>,
        values: Vec<Number>,
        statement: ItemKind,
    ) -> Read<ItemKind> {
        if subscripts.is_empty() {
            let Some(index) = indices.first() else {
                return Ok(statement);
            };
            let name = statement.array_name();
            let name = name.map_or("r", |name| &name.text).to_owned();
            let message = format!("`{name}` has no index, so that all elements would be one");
            let fault = Diagnostic::new(Kind::Grammar, index.name.span, message);
            return self.refuse(fault.help(format!("write `{name}[{}]`", index.name.text)));
        }
        Ok(ItemKind::Array(Array {
            subscripts,
            indices,
            values,
            statement: Box::new(statement),
        }))
    }
}

impl Display for Function {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (name, parameters) = (&self.name.text, listed(&self.parameters));
        writeln!(f, "function {name}({parameters}){} {{", self.result)?;
        for own in &self.lets {
            writeln!(f, "  {}", ItemKind::Let(own.clone()))?;
        }
        write!(f, "  return {};\n}}", self.value)
    }
}

impl Display for FunctionParameter {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.name.text, self.of)
    }
}

impl Display for Type {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let unit = self.unit.as_ref().map(ToString::to_string);
        match (&self.frame, unit) {
            (Some(frame), Some(unit)) => write!(f, ": vector {unit} in {}", frame.text),
            (Some(frame), None) => write!(f, ": vector in {}", frame.text),
            (None, Some(unit)) => write!(f, ": {unit}"),
            (None, None) => Ok(()),
        }
    }
}

impl Display for Index {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (first, last) = (self.values.start(), self.values.end());
        write!(f, "{} in {first}..{last}", self.name.text)
    }
}
