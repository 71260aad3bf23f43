//! Parser for statements with a block, except effects.

use super::ast::{
    Body, BodyClass, BodyPart, BodyPartKind, Continuation, Expr, ExprKind, Inertia, InitialValues,
    Interpolation, ItemKind, Name, Quantity, Table, UnitExpr,
};
use super::parser::{Parser, Read};
use super::print::behind;
use super::stated_twice;
use super::token::Token;
use super::words;
use crate::diagnostic::{Diagnostic, Kind, Span};
use std::fmt::{self, Display, Formatter, Write};

impl Parser<'_> {
    pub fn body(&mut self) -> Read<ItemKind> {
        let (word, name) = self.keyword_and_name()?;
        let class = if word == "body" {
            BodyClass::Rigid
        } else {
            BodyClass::Point
        };
        let what = format!("`{word} {}`", name.text);
        let parts = self.block(&what, |parser| parser.body_part(false))?;
        Ok(ItemKind::Body(Body { class, name, parts }))
    }

    fn body_part(&mut self, is_claimed: bool) -> Read<BodyPart> {
        let start = self.here();
        let block = if is_claimed { "claim" } else { "body" };
        let mut known = words::statements_of(block).iter();
        let Some(&word) = known.find(|word| **word == self.raw()) else {
            return self.expected_statement_of(block);
        };
        self.advance();
        let (words, kind) = match word {
            "inertia" => (word, BodyPartKind::Inertia(Box::new(self.inertia()?))),
            "fixed" => ("fixed in", BodyPartKind::Frame(self.in_frame("`fixed`")?)),
            _ => {
                let is_angular = word == "angular";
                if is_angular {
                    self.need_word("velocity", "`angular`")?;
                }
                let words = if is_angular { "angular velocity" } else { word };
                if is_claimed || matches!(word, "mass" | "axis" | "forward") {
                    (words, BodyPartKind::Value(self.expr()?))
                } else if is_angular && self.at_word("in") {
                    let frame = self.in_frame("`angular velocity`")?;
                    ("angular velocity in", BodyPartKind::Frame(frame))
                } else {
                    let names = self.triple_of_names()?;
                    let is_position = word == "position";
                    let after = if is_position {
                        "the coordinates"
                    } else {
                        "the components"
                    };
                    let frame = self.in_frame(after)?;
                    (
                        words,
                        BodyPartKind::States(names, frame, self.initial_values()?),
                    )
                }
            }
        };
        self.semicolon("this statement")?;
        let span = start.to(self.behind());
        Ok(BodyPart { words, kind, span })
    }

    fn initial_values(&mut self) -> Read<Option<Box<InitialValues>>> {
        if !self.eat(Token::Sign("=")) {
            return Ok(None);
        }
        let start = self.here();
        let (values, unit) = (self.triple_of_numbers()?, self.optional_unit()?);
        let span = start.to(self.behind());
        Ok(Some(Box::new(InitialValues { values, unit, span })))
    }

    /// Parses a block in which `let` defines quantities of the model.
    pub fn block<T>(
        &mut self,
        what: &str,
        mut read: impl FnMut(&mut Self) -> Read<T>,
    ) -> Read<Vec<T>> {
        let parts = self.braces(what, |parser| {
            if !parser.at_word("let") {
                return read(parser).map(Some);
            }
            let definition = parser.statement()?;
            parser.block_lets.push(definition);
            Ok(None)
        })?;
        Ok(parts.into_iter().flatten().collect())
    }

    pub fn in_frame(&mut self, after: &str) -> Read<Name> {
        self.need_word("in", after)?;
        self.name("the name of a frame after `in`")
    }

    fn triple_of_names(&mut self) -> Read<[Name; 3]> {
        let open = "`(` and the names of three states";
        self.tuple(open, "name", "names", |p| p.name("the name of a state"))
    }

    /// Parses an inertia tensor: `diag(a, b, c) in FRAME` or `((a, b, c), (d, e, f), (g, h, i)) in FRAME`, with a unit before
    /// `in` if all entries are numbers.
    pub fn inertia(&mut self) -> Read<Inertia> {
        let mut rows = if self.eat_word("diag") {
            let [a, b, c] = self.triple()?;
            [
                [Some(a), None, None],
                [None, Some(b), None],
                [None, None, Some(c)],
            ]
        } else if self.peek() == Token::Sign("(") {
            let rows: [[Expr; 3]; 3] = self.tuple("`(`", "row", "rows", Self::triple)?;
            rows.map(|row| row.map(Some))
        } else {
            return self.expected("`diag(a, b, c)` or three rows `((…), (…), (…))`");
        };
        if let Some(unit) = self.optional_unit()? {
            for entry in rows.iter_mut().flatten().flatten() {
                self.give_unit(entry, &unit)?;
            }
        }
        let frame = self.in_frame("the moments of inertia")?;
        Ok(Inertia { rows, frame })
    }

    /// Gives a number the unit that stands behind the brackets in which it is.
    fn give_unit(&mut self, e: &mut Expr, unit: &UnitExpr) -> Read<()> {
        match &mut e.kind {
            ExprKind::Number(own) if own.unit.is_none() => {
                own.unit = Some(unit.clone());
                Ok(())
            }
            ExprKind::Neg(of) => self.give_unit(of, unit),
            _ => {
                let message =
                    format!("`{e}` is no plain number, but `{unit}` stands behind all entries");
                let fault = Diagnostic::new(Kind::Grammar, e.span, message);
                self.refuse(
                    fault.help("state the unit of each number by itself, as in `2 [kg*m^2]`"),
                )
            }
        }
    }

    fn triple(&mut self) -> Read<[Expr; 3]> {
        let open = "`(` and three moments of inertia";
        self.tuple(open, "of three", "of them", Self::expr)
    }

    pub fn claim(&mut self) -> Read<ItemKind> {
        self.advance();
        let word = self.raw();
        let class = match word {
            "body" => BodyClass::Rigid,
            "point" => BodyClass::Point,
            "der" => return self.balance(),
            _ => {
                let what = "`body`, `point` or `der(…)` after `claim`";
                return self.expected_or(what, &["body", "point", "der"]);
            }
        };
        self.advance();
        let name = self.name(&format!("a name after `claim {word}`"))?;
        let what = format!("`claim {word} {}`", name.text);
        let parts = self.block(&what, |parser| parser.body_part(true))?;
        Ok(ItemKind::Claim(Body { class, name, parts }))
    }
}

impl Display for Body {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} {} {{", self.class.keyword(), self.name.text)?;
        for part in &self.parts {
            writeln!(f, "  {part};")?;
        }
        f.write_char('}')
    }
}

impl Display for BodyPart {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} ", self.words)?;
        match &self.kind {
            BodyPartKind::Inertia(inertia) => write!(f, "{inertia}"),
            BodyPartKind::Frame(frame) => f.write_str(&frame.text),
            BodyPartKind::States([a, b, c], frame, initial) => {
                write!(f, "({}, {}, {}) in {}", a.text, b.text, c.text, frame.text)?;
                let Some(initial) = initial else {
                    return Ok(());
                };
                let [x, y, z] = &initial.values;
                let unit = behind(" ", &initial.unit);
                write!(f, " = ({}, {}, {}){unit}", x.text, y.text, z.text)
            }
            BodyPartKind::Value(e) => write!(f, "{e}"),
        }
    }
}

impl Parser<'_> {
    /// Parses `table NAME(ARGUMENT: UNIT, …): UNIT = { argument: value, … } monotone, constant;`, or a file's name in
    /// place of the braces.
    pub fn table(&mut self) -> Read<ItemKind> {
        let (_, name) = self.keyword_and_name()?;
        let open = format!("`(` and the argument of `{}`", name.text);
        self.need(Token::Sign("("), &open)?;
        let arguments = self.list(|parser| {
            let argument = parser.name("the name of the argument")?;
            Ok((argument, parser.unit_behind_colon()?))
        })?;
        if let Some((third, _)) = arguments.get(2) {
            let message = "a table has one or two arguments";
            return self.refuse(Diagnostic::new(Kind::Grammar, third.span, message));
        }
        self.need(Token::Sign(")"), "`)` after the argument")?;
        let unit = self.unit_behind_colon()?;
        self.need(Token::Sign("="), &format!("`=` after `{}`", name.text))?;
        let (mut columns, mut rows, mut file) = (Vec::new(), Vec::new(), None);
        if self.peek() == Token::Text {
            let span = self.here();
            file = Some(Name::new(self.quoted("the name of a file")?, span));
        } else {
            self.need(
                Token::Sign("{"),
                "`{` and the knots, as in `{ 0: 1.2, 5: 1.4, 10: 1.3 }`",
            )?;
            let second = arguments.get(1).map(|(name, _)| name.text.clone());
            match self.knots(second) {
                Ok(knots) => (columns, rows) = knots,
                Err(reported) => {
                    self.leave_braces();
                    return Err(reported);
                }
            }
        }
        let (mut interpolation, mut continuation) = <(Interpolation, Continuation)>::default();
        // The word for the curve, and the one for its ends.
        let mut stated: [Option<Span>; 2] = [None; 2];
        let known = ["monotone", "linear", "constant"];
        while self.peek() == Token::Name && (known.contains(&self.raw()) || !self.first_on_line()) {
            match self.raw() {
                "monotone" => interpolation = Interpolation::Monotone,
                "linear" => interpolation = Interpolation::Linear,
                "constant" => continuation = Continuation::Constant,
                _ => return self.expected_or(WAYS, &known),
            }
            let (word, here) = (self.raw(), self.here());
            if let Some(first) = stated[usize::from(word == "constant")].replace(here) {
                let fault = match self.slice(first) {
                    own if own == word => stated_twice(word, first, here),
                    other => {
                        let message = format!("a table cannot be both `{other}` and `{word}`");
                        Diagnostic::new(Kind::Duplicate, here, message)
                            .label(first, "stated here")
                            .label(here, "and here")
                            .help("keep one of them")
                    }
                };
                return self.refuse(fault);
            }
            self.advance();
            if self.eat(Token::Sign(",")) && self.peek() != Token::Name {
                return self.expected_or(WAYS, &[]);
            }
        }
        self.semicolon("this `table`")?;
        Ok(ItemKind::Table(Table {
            name,
            arguments,
            unit,
            file,
            columns,
            rows,
            interpolation,
            continuation,
        }))
    }

    /// Parses the knots of a table, in which the name of the `second` argument begins the line of its own knots.
    fn knots(&mut self, second: Option<String>) -> Read<Knots> {
        let mut columns = Vec::new();
        if let Some(second) = &second {
            let line = format!("`{second}: (…),` with the knots of the second argument");
            let found = self.name(&line)?;
            if found.text != *second {
                let message = format!("the second argument is `{second}`, not `{}`", found.text);
                return self.refuse(Diagnostic::new(Kind::Name, found.span, message));
            }
            self.need(Token::Sign(":"), &format!("`:` after `{second}`"))?;
            columns = self.quantities("a knot of the second argument")?;
            self.behind_knot()?;
        }
        let mut rows = Vec::new();
        while !self.eat(Token::Sign("}")) {
            let argument = self.quantity("the argument of a knot")?;
            self.need(Token::Sign(":"), "`:` between argument and value of a knot")?;
            let values = match second {
                Some(_) => self.quantities("a value of the row")?,
                None => vec![self.quantity("the value at a knot")?],
            };
            rows.push((argument, values));
            self.behind_knot()?;
        }
        Ok((columns, rows))
    }

    fn quantities(&mut self, what: &str) -> Read<Vec<Quantity>> {
        self.need(Token::Sign("("), &format!("`(` and {what}"))?;
        let quantities = self.list(|parser| parser.quantity(what))?;
        self.need(Token::Sign(")"), "`,` or `)`")?;
        Ok(quantities)
    }

    fn behind_knot(&mut self) -> Read<()> {
        if self.peek() == Token::Sign("}") {
            return Ok(());
        }
        self.need(Token::Sign(","), "`,` or `}` after a knot")
    }

    fn leave_braces(&mut self) {
        while !matches!(self.peek(), Token::Sign("}" | ";") | Token::End) {
            self.advance();
        }
        self.eat(Token::Sign("}"));
    }
}

/// Knots of the second argument, and each of the first with its values.
type Knots = (Vec<Quantity>, Vec<(Quantity, Vec<Quantity>)>);

const WAYS: &str = "`monotone`, `linear`, `constant` or `;` after the knots";
