//! Parser for statements with a block: bodies and check cases.

use super::ast::{
    Body, BodyClass, BodyPart, BodyPartKind, Check, CheckPart, Expr, Inertia, ItemKind, Name,
};
use super::parser::{Parser, Read};
use super::token::Token;

impl Parser<'_> {
    /// Parses `body NAME { … }` or `point NAME { … }`.
    pub fn body(&mut self) -> Read<ItemKind> {
        let (word, name) = self.keyword_and_name()?;
        let class = if word == "body" {
            BodyClass::Rigid
        } else {
            BodyClass::Point
        };
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
        let open = "`(` and the names of three states";
        self.tuple(open, "name", "names", |p| p.name("the name of a state"))
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
            let rows: [[Expr; 3]; 3] = self.tuple("`(`", "row", "rows", Self::triple)?;
            rows.map(|row| row.map(Some))
        } else {
            return self.expected("`diag(a, b, c)` or three rows `((…), (…), (…))`");
        };
        let frame = self.in_frame("the moments of inertia")?;
        Ok(Inertia { rows, frame })
    }

    fn triple(&mut self) -> Read<[Expr; 3]> {
        let open = "`(` and three moments of inertia";
        self.tuple(open, "of three", "of them", Self::expr)
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
