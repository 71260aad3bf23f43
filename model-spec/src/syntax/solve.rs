//! Parser and printer of the block `solve { … }`.

use std::fmt::{self, Display, Formatter, Write};

use super::ast::{ImplicitEquation, ItemKind, Solve, UnknownQuantity};
use super::parser::{Parser, Read};
use super::token::Token;

enum Part {
    Unknown(UnknownQuantity),
    Equation(ImplicitEquation),
}

impl Parser<'_> {
    /// Parses `solve NAME { unknown NAME: TYPE; LEFT = RIGHT; }`.
    pub fn solve(&mut self) -> Read<ItemKind> {
        self.advance();
        let name = match self.peek() {
            Token::Name => Some(self.name("the name of the block")?),
            _ => None,
        };
        let mut solve = Solve {
            name,
            unknowns: Vec::new(),
            equations: Vec::new(),
        };
        for part in self.braces(&solve.title(), Self::solve_part)? {
            match part {
                Part::Unknown(unknown) => solve.unknowns.push(unknown),
                Part::Equation(equation) => solve.equations.push(equation),
            }
        }
        Ok(ItemKind::Solve(solve))
    }

    fn solve_part(&mut self) -> Read<Part> {
        let doc = self.doc();
        let start = self.here();
        if self.raw() == "unknown" && self.peek_at(1) == Token::Name {
            let (_, name) = self.keyword_and_name()?;
            let of = self.type_behind_colon()?;
            self.semicolon("this `unknown`")?;
            return Ok(Part::Unknown(UnknownQuantity { name, doc, of }));
        }
        let left = self.expr()?;
        self.need(Token::Sign("="), "`=` and the other side of the equation")?;
        let right = self.expr()?;
        self.semicolon("this equation")?;
        let span = start.to(self.behind());
        Ok(Part::Equation(ImplicitEquation { left, right, span }))
    }
}

impl Display for Solve {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("solve ")?;
        if let Some(name) = &self.name {
            write!(f, "{} ", name.text)?;
        }
        f.write_str("{\n")?;
        for own in &self.unknowns {
            for line in own.doc.lines() {
                writeln!(f, "  /// {line}")?;
            }
            writeln!(f, "  unknown {}{};", own.name.text, own.of)?;
        }
        for own in &self.equations {
            writeln!(f, "  {} = {};", own.left, own.right)?;
        }
        f.write_char('}')
    }
}
