//! Parser for `table` statements.

use super::ast::{Continuation, Interpolation, ItemKind, Quantity, Table};
use super::parser::{Parser, Read};
use super::token::Token;

impl Parser<'_> {
    /// Parses `table NAME(ARGUMENT: UNIT): UNIT = { argument: value, … } monotone, constant;`.
    pub fn table(&mut self) -> Read<ItemKind> {
        let (_, name) = self.keyword_and_name()?;
        let open = format!("`(` and the argument of `{}`", name.text);
        self.need(Token::Open, &open)?;
        let argument = self.name("the name of the argument")?;
        let argument_unit = self.unit_behind_colon()?;
        self.need(Token::Close, "`)` after the argument")?;
        let unit = self.unit_behind_colon()?;
        self.need(Token::Equals, &format!("`=` after `{}`", name.text))?;
        self.need(
            Token::OpenBrace,
            "`{` and the knots, as in `{ 0: 1.2, 5: 1.4, 10: 1.3 }`",
        )?;
        let knots = match self.knots() {
            Ok(knots) => knots,
            Err(reported) => {
                self.leave_braces();
                return Err(reported);
            }
        };
        let (mut interpolation, mut continuation) = <(Interpolation, Continuation)>::default();
        while self.peek() == Token::Name && !self.first_on_line() {
            match self.raw() {
                "monotone" => interpolation = Interpolation::Monotone,
                "constant" => continuation = Continuation::Constant,
                _ => return self.expected_word(WAYS, &["monotone", "constant"]),
            }
            self.advance();
            if self.eat(Token::Comma) && self.peek() != Token::Name {
                return self.expected_word(WAYS, &[]);
            }
        }
        self.semicolon("this `table`")?;
        Ok(ItemKind::Table(Table {
            name,
            argument,
            argument_unit,
            unit,
            knots,
            interpolation,
            continuation,
        }))
    }

    /// Parses the knots `argument: value, …` and the closing `}`; a comma may follow the last knot.
    fn knots(&mut self) -> Read<Vec<(Quantity, Quantity)>> {
        let mut knots = Vec::new();
        while !self.eat(Token::CloseBrace) {
            let argument = self.quantity("the argument of a knot")?;
            self.need(Token::Colon, "`:` between argument and value of a knot")?;
            knots.push((argument, self.quantity("the value at a knot")?));
            if self.peek() != Token::CloseBrace {
                self.need(Token::Comma, "`,` or `}` after a knot")?;
            }
        }
        Ok(knots)
    }

    /// After an error, skips to the end of a block of knots.
    fn leave_braces(&mut self) {
        while !matches!(
            self.peek(),
            Token::CloseBrace | Token::Semicolon | Token::End
        ) {
            self.advance();
        }
        self.eat(Token::CloseBrace);
    }
}

const WAYS: &str = "`monotone`, `constant` or `;` after the knots";
