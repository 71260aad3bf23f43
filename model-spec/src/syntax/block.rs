//! Parser for statements with a block: bodies and check cases.

use super::ast::{
    Body, BodyClass, BodyPart, BodyPartKind, Check, CheckPart, Expr, Inertia, ItemKind, Name,
};
use super::parser::{Parser, Read};
use super::token::Token;

impl Parser<'_> {
    /// Parses `body NAME { … }` or `point NAME { … }`.
    pub fn body(&mut self) -> Read<ItemKind> {
        let class = match self.raw() {
            "body" => BodyClass::Rigid,
            _ => BodyClass::Point,
        };
        let word = class.keyword();
        self.advance();
        let name = self.name(&format!("a name after `{word}`"))?;
        let parts = self.braces(&format!("`{word} {}`", name.text), Self::body_part)?;
        Ok(ItemKind::Body(Body { class, name, parts }))
    }

    fn body_part(&mut self) -> Read<BodyPart> {
        let start = self.here();
        let word = self.raw();
        const WORDS: [&str; 6] = [
            "mass", "inertia", "fixed", "position", "velocity", "angular",
        ];
        if !WORDS.contains(&word) {
            let what =
                "`mass`, `inertia`, `fixed in`, `position`, `velocity` or `angular velocity`";
            return self.expected_word(what, &WORDS);
        }
        self.advance();
        let kind = match word {
            "mass" => BodyPartKind::Mass(self.expr()?),
            "inertia" => BodyPartKind::Inertia(Box::new(self.inertia()?)),
            "fixed" => BodyPartKind::Fixed(self.in_frame("`fixed`")?),
            "position" => {
                let names = self.triple_of_names()?;
                BodyPartKind::Position(names, self.in_frame("the coordinates")?)
            }
            "velocity" => {
                let names = self.triple_of_names()?;
                BodyPartKind::Velocity(names, self.in_frame("the components")?)
            }
            _ => {
                self.need_word("velocity", "`angular`")?;
                if self.at_word("in") {
                    BodyPartKind::AngularVelocityIn(self.in_frame("`angular velocity`")?)
                } else {
                    let names = self.triple_of_names()?;
                    BodyPartKind::AngularVelocity(names, self.in_frame("the components")?)
                }
            }
        };
        self.semicolon("this statement")?;
        Ok(BodyPart {
            kind,
            span: start.to(self.behind()),
        })
    }

    /// Parses `in FRAME` and returns the frame's name; `after` describes the preceding text in error messages.
    pub fn in_frame(&mut self, after: &str) -> Read<Name> {
        self.need_word("in", after)?;
        self.name("the name of a frame after `in`")
    }

    fn triple_of_names(&mut self) -> Read<[Name; 3]> {
        self.need(Token::Open, "`(` and the names of three states")?;
        let a = self.name("the name of a state")?;
        self.need(Token::Comma, "`,` and the second name")?;
        let b = self.name("the name of a state")?;
        self.need(Token::Comma, "`,` and the third name")?;
        let c = self.name("the name of a state")?;
        self.need(Token::Close, "`)` after three names")?;
        Ok([a, b, c])
    }

    /// Parses an inertia tensor: `diag(a, b, c) in FRAME` or `((a, b, c), (d, e, f), (g, h, i)) in FRAME`.
    pub fn inertia(&mut self) -> Read<Inertia> {
        let rows = if self.eat_word("diag") {
            let [a, b, c] = self.triple()?;
            [
                [Some(a), None, None],
                [None, Some(b), None],
                [None, None, Some(c)],
            ]
        } else if self.peek() == Token::Open {
            self.advance();
            let a = self.triple()?;
            self.need(Token::Comma, "`,` and the second row")?;
            let b = self.triple()?;
            self.need(Token::Comma, "`,` and the third row")?;
            let c = self.triple()?;
            self.need(Token::Close, "`)` after three rows")?;
            [a.map(Some), b.map(Some), c.map(Some)]
        } else {
            return self.expected("`diag(a, b, c)` or three rows `((…), (…), (…))`");
        };
        let frame = self.in_frame("the moments of inertia")?;
        Ok(Inertia { rows, frame })
    }

    fn triple(&mut self) -> Read<[Expr; 3]> {
        self.need(Token::Open, "`(` and three moments of inertia")?;
        let a = self.expr()?;
        self.need(Token::Comma, "`,` and the second of three")?;
        let b = self.expr()?;
        self.need(Token::Comma, "`,` and the third of three")?;
        let c = self.expr()?;
        self.need(Token::Close, "`)` after three of them")?;
        Ok([a, b, c])
    }

    /// Parses `check "title" { … }`.
    pub fn check_case(&mut self) -> Read<ItemKind> {
        self.advance();
        let title = self.quoted("the title of the check")?;
        let parts = self.braces("this `check`", Self::check_part)?;
        Ok(ItemKind::Check(Check { title, parts }))
    }

    fn check_part(&mut self) -> Read<CheckPart> {
        let start = self.here();
        if self.eat_word("set") {
            let name = self.name("what is set")?;
            self.need(Token::Equals, &format!("`=` after `{}`", name.text))?;
            let value = if self.peek() == Token::Open {
                self.triple_of_numbers()?.into()
            } else {
                vec![self.number("a number")?]
            };
            let unit = self.optional_unit()?;
            self.semicolon("this `set`")?;
            return Ok(CheckPart::Set {
                name,
                value,
                unit,
                span: start.to(self.behind()),
            });
        }
        if !self.eat_word("expect") {
            return self.expected_word("`set` or `expect`", &["set", "expect"]);
        }
        let mut name = self.name("what is expected: a named quantity or `der(STATE)`")?;
        let derivative = name.text == "der" && self.eat(Token::Open);
        if derivative {
            name = self.name("the name of a state")?;
            self.need(Token::Close, "`)` after the state")?;
        }
        self.need(Token::Equals, "`=` and the expected value")?;
        let value = self.quantity("a number")?;
        if !self.eat_word("within") {
            let help = "add the greatest difference: `within 1e-9`".to_owned();
            return self.expected_help("`within` after the expected value", Some(help));
        }
        let within = self.quantity("the greatest difference")?;
        self.semicolon("this `expect`")?;
        Ok(CheckPart::Expect {
            name,
            derivative,
            value,
            within,
            span: start.to(self.behind()),
        })
    }
}
