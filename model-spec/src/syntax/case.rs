//! Parser for observations, and for cases with known answers.

use super::ast::{Check, CheckPart, ItemKind, Marker, Observe};
use super::parser::{Parser, Read};
use super::token::Token;
use crate::diagnostic::MAX_SHOWN;

impl Parser<'_> {
    pub fn marker(&mut self) -> Read<ItemKind> {
        let (_, name) = self.keyword_and_name()?;
        let frame = self.in_frame("the name of the marker, with the frame it is fixed in")?;
        if self.peek() == Token::Sign("=") {
            let help = format!(
                "the place of a marker comes with each recording, and one statement stands for all markers: write \
                 `marker {} in {};`",
                name.text, frame.text
            );
            return self.expected_help("`;` at the end of this `marker`", Some(help));
        }
        self.semicolon("this `marker`")?;
        Ok(ItemKind::Marker(Marker { name, frame }))
    }

    pub fn observe(&mut self) -> Read<ItemKind> {
        let (_, name) = self.keyword_and_name()?;
        let value = self.definition(&name.text, "this `observe`")?;
        Ok(ItemKind::Observe(Observe { name, value }))
    }

    pub fn check_case(&mut self) -> Read<ItemKind> {
        self.advance();
        let title = self.quoted("the title of the check")?;
        let parts = self.block("this `check`", Self::check_part)?;
        Ok(ItemKind::Check(Check { title, parts }))
    }

    fn check_part(&mut self) -> Read<CheckPart> {
        let start = self.here();
        if self.eat_word("set") {
            let name = self.name_or_element("what is set")?;
            let what = format!("`=` after `{}`", name.text);
            self.need_not_part(Token::Sign("="), &what, |_| parts_advice(&name.text))?;
            let value = if self.peek() == Token::Sign("(") {
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
            if (self.peek(), self.peek_at(1)) == (Token::Name, Token::Sign("=")) {
                let help = format!("write `set {} = …;`", self.raw());
                return self.expected_help("`set` or `expect`", Some(help));
            }
            return self.expected_statement_of("check");
        }
        let mut name =
            self.name_or_element("what is expected: a named quantity or `der(STATE)`")?;
        let derivative = name.text == "der" && self.eat(Token::Sign("("));
        if derivative {
            name = self.name_or_element("the name of a state")?;
            let advice = |own: &Self| own.number_advice(&name.text, true);
            self.need_not_part(Token::Sign(")"), "`)` after the state", advice)?;
        }
        let advice = |own: &Self| own.number_advice(&name.text, derivative);
        self.need_not_part(Token::Sign("="), "`=` and the expected value", advice)?;
        if self.peek() == Token::Sign("(") {
            let help = advice(self);
            return self.expected_help("a number", Some(help));
        }
        let value = self.quantity("a number")?;
        if !self.eat_word("within") {
            let help = "add the greatest difference: `within 1e-9`".to_owned();
            return self.expected_help("`within` after the expected value", Some(help));
        }
        let within = self.quantity("the greatest difference")?;
        let is_relative = self.eat_word("relative");
        self.semicolon("this `expect`")?;
        Ok(CheckPart::Expect {
            name,
            derivative,
            value,
            within,
            is_relative,
            span: start.to(self.behind()),
        })
    }

    /// [`Parser::need`] behind a name, with `advice` where a component of it stands there.
    fn need_not_part(
        &mut self,
        token: Token,
        what: &str,
        advice: impl Fn(&Self) -> String,
    ) -> Read<()> {
        match self.peek() {
            Token::Sign(".") => {
                let help = advice(self);
                self.expected_help(what, Some(help))
            }
            _ => self.need(token, what),
        }
    }

    /// States that a body of the text names for its `position`, `velocity` or `angular_velocity`.
    fn states_of(&self, name: &str) -> Option<[&str; 3]> {
        // Errors that are not shown need no search.
        let is_shown = self.lexed.diagnostics.len() < MAX_SHOWN;
        let tokens = if is_shown {
            &self.lexed.tokens[..]
        } else {
            &[]
        };
        let text =
            |at: usize| &self.slice_all()[tokens[at].start as usize..tokens[at].end as usize];
        let is_here = |&at: &usize| {
            let is_angular = at > 0 && text(at - 1) == "angular";
            let own = if is_angular {
                "angular_velocity"
            } else {
                text(at)
            };
            own == name && text(at + 1) == "(" && text(at + 7) == ")"
        };
        let at = (0..tokens.len().saturating_sub(7)).find(is_here)?;
        Some([2, 4, 6].map(|k| text(at + k)))
    }

    /// What a case expects in place of a vector, which is `name`, or its derivative.
    fn number_advice(&self, name: &str, derivative: bool) -> String {
        if !derivative {
            return format!(
                "expect each component by itself, of a quantity such as `let {name}_3 = {name}.3;`"
            );
        }
        derivatives_advice(&self.states_of(name).map_or(vec!["STATE"], Vec::from))
    }
}

/// What a case expects in place of the derivative of a vector of these states.
pub(crate) fn derivatives_advice(states: &[&str]) -> String {
    let all: Vec<String> = { states.iter() }
        .map(|own| format!("`expect der({own}) = …`"))
        .collect();
    format!(
        "expect the derivative of each state by itself: {}",
        all.join(", ")
    )
}

fn parts_advice(name: &str) -> String {
    format!(
        "set all components: `set {name} = (…, …, …);`, with their unit; one of an input is `{name}_x`, `{name}_y` or \
         `{name}_z`"
    )
}
