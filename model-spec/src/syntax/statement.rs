//! Parser for the statements of a file.

use super::ast::{
    Equation, Frame, FrameKind, Input, Item, ItemKind, Let, Limit, Load, LoadClass, Marker, Name,
    Observe, Parameter, ParameterClass, State,
};
use super::parser::{Parser, Read, Reported, STATEMENTS};
use super::token::Token;
use crate::diagnostic::{Diagnostic, Kind};

impl Parser<'_> {
    /// Parses one statement with the `///` lines that precede it.
    pub fn statement(&mut self) -> Read<Item> {
        let doc = self.doc();
        let start = self.here();
        if self.peek() != Token::Name {
            return self.expected("a statement");
        }
        let word = self.raw();
        let kind = match word {
            "model" => self.named("model", ItemKind::Model)?,
            "reference" => self.named("reference", ItemKind::Reference)?,
            "param" | "coefficient" => self.constant()?,
            "input" => self.input()?,
            "state" => self.state()?,
            "frame" => self.frame()?,
            "body" | "point" => self.body()?,
            "claim" => self.claim()?,
            "table" => self.table()?,
            "let" => self.binding()?,
            "force" | "moment" => self.load()?,
            "der" => self.equation()?,
            "marker" => self.marker()?,
            "observe" => self.observe()?,
            "clock" => {
                self.advance();
                self.clock()?
            }
            "limit" => self.limit()?,
            "check" => self.check_case()?,
            "effect" => self.effect(doc.clone())?,
            _ => return self.no_statement(word),
        };
        Ok(Item::new(kind, doc, start.to(self.behind())))
    }

    /// Reports that `word` does not begin a statement in this context. Always returns `Err`.
    pub fn no_statement<T>(&mut self, word: &str) -> Read<T> {
        let span = self.here();
        let block = match word {
            "set" | "expect" => Some("check \"…\""),
            "replace" | "site" | "source" | "variables" | "negligible" | "increases"
            | "decreases" => Some("effect NAME"),
            "mass" | "inertia" | "fixed" | "axis" | "position" | "velocity" | "angular" => {
                Some("body NAME")
            }
            _ => None,
        };
        let message = match block {
            Some(block) => format!("`{word}` stands inside `{block} {{ }}`, not here"),
            None => format!("no statement begins with `{word}`"),
        };
        let mut fault = Diagnostic::new(Kind::Grammar, span, message);
        if block.is_none() {
            let is_definition = self.peek_at(1) == Token::Equals;
            let definition = format!("a quantity is named with `let {word} = …;`");
            fault = fault.help_if(is_definition.then_some(definition));
            fault = fault.did_you_mean(word, self.suggestions(&STATEMENTS));
        }
        self.report(fault);
        Err(Reported)
    }

    fn named(&mut self, word: &str, make: impl Fn(Name) -> ItemKind) -> Read<ItemKind> {
        self.advance();
        let name = self.name(&format!("a name after `{word}`"))?;
        self.semicolon(&format!("this `{word}`"))?;
        Ok(make(name))
    }

    /// Parses `param NAME = value unit in lo .. hi;` or `coefficient …`.
    pub fn constant(&mut self) -> Read<ItemKind> {
        let class = match self.raw() {
            "param" => ParameterClass::Param,
            _ => ParameterClass::Coefficient,
        };
        let word = self.raw();
        self.advance();
        let name = self.name(&format!("a name after `{word}`"))?;
        self.need(
            Token::Equals,
            &format!("`=` and the default of `{}`", name.text),
        )?;
        let value = self.quantity("a number")?;
        let bounds = if self.eat_word("in") {
            let least = self.quantity("the least value")?;
            if !self.eat(Token::To) {
                let help = format!("write `in {least} .. 10`");
                return self
                    .expected_help("`..` between the least and the greatest value", Some(help));
            }
            Some((least, self.quantity("the greatest value")?))
        } else {
            None
        };
        self.semicolon(&format!("this `{word}`"))?;
        Ok(ItemKind::Parameter(Parameter {
            class,
            name,
            value,
            bounds,
        }))
    }

    /// Parses `input NAME in FRAME = (a, b, c) unit;`.
    pub fn input(&mut self) -> Read<ItemKind> {
        self.advance();
        let name = self.name("a name after `input`")?;
        self.need_word(
            "in",
            "the name of the input, with the frame of its components",
        )?;
        let frame = self.name("the name of a frame after `in`")?;
        self.need(Token::Equals, "`=` and the default components")?;
        let value = self.triple_of_numbers()?;
        let unit = self.optional_unit()?;
        self.semicolon("this `input`")?;
        Ok(ItemKind::Input(Input {
            name,
            frame,
            value,
            unit,
        }))
    }

    /// Parses three literals in parentheses, such as `(1, 2, 3)`.
    pub fn triple_of_numbers(&mut self) -> Read<[super::ast::Number; 3]> {
        self.need(Token::Open, "`(` and three numbers")?;
        let a = self.number("a number")?;
        self.need(Token::Comma, "`,` and the second component")?;
        let b = self.number("a number")?;
        self.need(Token::Comma, "`,` and the third component")?;
        let c = self.number("a number")?;
        self.need(Token::Close, "`)` after three components")?;
        Ok([a, b, c])
    }

    /// Parses `state NAME = value unit;`.
    pub fn state(&mut self) -> Read<ItemKind> {
        self.advance();
        let name = self.name("a name after `state`")?;
        let what = format!("`=` and the value of `{}` at the start", name.text);
        self.need(Token::Equals, &what)?;
        let value = self.quantity("a number")?;
        self.semicolon("this `state`")?;
        Ok(ItemKind::State(State { name, value }))
    }

    /// Parses `frame N;`, `frame A = N turned ANGLE about AXIS;`, `frame C = N by quaternion (a, b, c, d);`.
    fn frame(&mut self) -> Read<ItemKind> {
        self.advance();
        let name = self.name("a name after `frame`")?;
        if self.eat(Token::Semicolon) {
            return Ok(ItemKind::Frame(Frame {
                name,
                kind: FrameKind::Inertial,
            }));
        }
        self.need(Token::Equals, "`;` or `=` after the name of the frame")?;
        let parent = self.name("the frame that this one is turned from")?;
        let kind = if self.eat_word("turned") {
            let angle = self.name("the name of the angle after `turned`")?;
            self.need_word("about", "the angle")?;
            let axis = self.axis("the axis: 1, 2 or 3")?;
            FrameKind::Turned {
                parent,
                angle,
                axis,
            }
        } else if self.eat_word("by") {
            self.need_word("quaternion", "`by`")?;
            self.need(
                Token::Open,
                "`(` and the four components, scalar part first",
            )?;
            let a = self.name("the name of a state")?;
            self.need(Token::Comma, "`,` and the second component")?;
            let b = self.name("the name of a state")?;
            self.need(Token::Comma, "`,` and the third component")?;
            let c = self.name("the name of a state")?;
            self.need(Token::Comma, "`,` and the fourth component")?;
            let d = self.name("the name of a state")?;
            self.need(Token::Close, "`)` after four components")?;
            FrameKind::Quaternion {
                parent,
                states: [a, b, c, d],
            }
        } else {
            return self.expected("`turned ANGLE about AXIS` or `by quaternion (…)`");
        };
        self.semicolon("this `frame`")?;
        Ok(ItemKind::Frame(Frame { name, kind }))
    }

    /// Parses `let NAME: unit = …;`.
    pub fn binding(&mut self) -> Read<ItemKind> {
        self.advance();
        let name = self.name("a name after `let`")?;
        self.binding_rest(name).map(ItemKind::Let)
    }

    /// Parses the rest of a `let` statement after its name: `: unit = …;`, where `: unit` is optional.
    pub fn binding_rest(&mut self, name: Name) -> Read<Let> {
        let unit = self.unit_behind_colon()?;
        self.need(Token::Equals, &format!("`=` after `{}`", name.text))?;
        let value = self.expr()?;
        self.semicolon(&format!("the definition of `{}`", name.text))?;
        Ok(Let { name, unit, value })
    }

    /// Parses `force NAME = …;` or `moment NAME = …;`.
    pub fn load(&mut self) -> Read<ItemKind> {
        let class = match self.raw() {
            "force" => LoadClass::Force,
            _ => LoadClass::Moment,
        };
        let word = self.raw();
        self.advance();
        let name = self.name(&format!("a name after `{word}`"))?;
        self.need(Token::Equals, &format!("`=` after `{}`", name.text))?;
        let value = self.expr()?;
        self.semicolon(&format!("this `{word}`"))?;
        Ok(ItemKind::Load(Load { class, name, value }))
    }

    /// Parses `der(STATE) = …;`.
    pub fn equation(&mut self) -> Read<ItemKind> {
        self.advance();
        self.need(Token::Open, "`(` after `der`")?;
        let state = self.name("the name of a state")?;
        self.need(Token::Close, "`)` after the state")?;
        self.need(Token::Equals, &format!("`=` after `der({})`", state.text))?;
        let value = self.expr()?;
        self.semicolon("this equation")?;
        Ok(ItemKind::Equation(Equation { state, value }))
    }

    /// Parses `marker NAME in FRAME;`.
    fn marker(&mut self) -> Read<ItemKind> {
        self.advance();
        let name = self.name("a name after `marker`")?;
        self.need_word(
            "in",
            "the name of the marker, with the frame it is fixed in",
        )?;
        let frame = self.name("the name of a frame after `in`")?;
        self.semicolon("this `marker`")?;
        Ok(ItemKind::Marker(Marker { name, frame }))
    }

    /// Parses `observe NAME = …;`.
    pub fn observe(&mut self) -> Read<ItemKind> {
        self.advance();
        let name = self.name("a name after `observe`")?;
        self.need(Token::Equals, &format!("`=` after `{}`", name.text))?;
        let value = self.expr()?;
        self.semicolon("this `observe`")?;
        Ok(ItemKind::Observe(Observe { name, value }))
    }

    /// Parses the rest of a clock statement after the keyword: `clock EXPR;`, or `replace clock = EXPR;` in an effect.
    pub fn clock(&mut self) -> Read<ItemKind> {
        let value = self.expr()?;
        self.semicolon("this `clock`")?;
        Ok(ItemKind::Clock(value))
    }

    /// Parses `limit EXPR > bound "reason";`.
    fn limit(&mut self) -> Read<ItemKind> {
        self.advance();
        let value = self.expr()?;
        if self.peek() == Token::Less {
            let help =
                "a limit says what must stay above a bound: write `limit -x > -bound` instead";
            return self.expected_help("`>`", Some(help.to_owned()));
        }
        self.need(Token::Greater, "`>` and the bound of the limit")?;
        let bound = self.quantity("a number, the bound")?;
        if self.peek() == Token::Semicolon {
            let help = "say what happens there, as in `limit z > 0 \"it has landed\";`".to_owned();
            return self.expected_help("the reason of the limit", Some(help));
        }
        let reason = self.quoted("the reason of the limit")?;
        self.semicolon("this `limit`")?;
        Ok(ItemKind::Limit(Limit {
            value,
            bound,
            reason,
        }))
    }
}
