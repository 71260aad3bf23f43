//! Parser and printer of the block `solve { … }`.

use std::fmt::{self, Display, Formatter, Write};

use super::ast::{Balance, ImplicitEquation, ItemKind, Solve, UnknownQuantity};
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
        let is_constraint = self.raw() == "constraint" && !self.is_operator_at(1);
        if is_constraint {
            self.advance();
        }
        let left = self.expr()?;
        self.need(Token::Sign("="), "`=` and the other side of the equation")?;
        let right = self.expr()?;
        let within = match is_constraint {
            true if !self.eat_word("within") => {
                let help = "add by how much the sides may differ: `within 1 mm`".to_owned();
                return self.expected_help("`within` after the constraint", Some(help));
            }
            true => Some(self.quantity("by how much the sides may differ")?),
            false => None,
        };
        self.semicolon("this equation")?;
        let span = start.to(self.behind());
        Ok(Part::Equation(ImplicitEquation {
            left,
            right,
            within,
            span,
        }))
    }
}

impl Parser<'_> {
    /// Parses the rest of `claim der(EXPR) = EXPR;` after `claim`.
    pub fn balance(&mut self) -> Read<ItemKind> {
        self.advance();
        self.need(Token::Sign("("), "`(` after `der`")?;
        let quantity = self.expr()?;
        self.need(Token::Sign(")"), "`)` after what changes")?;
        self.need(Token::Sign("="), "`=` and by what it changes")?;
        let change = self.expr()?;
        self.semicolon("this `claim`")?;
        Ok(ItemKind::Balance(Balance { quantity, change }))
    }

    /// Whether a sign that continues an expression stands `ahead` tokens ahead.
    pub fn is_operator_at(&self, ahead: usize) -> bool {
        matches!(
            self.peek_at(ahead),
            Token::Sign("*" | "/" | "+" | "-" | "^" | "=" | "·" | "×" | "." | "[")
        )
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
            match &own.within {
                Some(within) => writeln!(
                    f,
                    "  constraint {} = {} within {within};",
                    own.left, own.right
                )?,
                None => writeln!(f, "  {} = {};", own.left, own.right)?,
            }
        }
        f.write_char('}')
    }
}
