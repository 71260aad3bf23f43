//! Parser for `effect` statements.

use super::ast::{Effect, EffectPart, Item, ItemKind};
use super::parser::{Parser, Read};
use super::token::Token;

impl Parser<'_> {
    /// Parses `effect NAME on MODEL, MODEL { … }`; `doc` is its documentation.
    pub fn effect(&mut self, doc: String) -> Read<ItemKind> {
        self.advance();
        let name = self.name("a name after `effect`")?;
        let mut on = Vec::new();
        if self.eat_word("on") {
            loop {
                on.push(self.name("the name of a model after `on`")?);
                if !self.eat(Token::Comma) {
                    break;
                }
            }
        }
        let parts = self.braces(&format!("`effect {}`", name.text), Self::effect_part)?;
        Ok(ItemKind::Effect(Effect {
            name,
            doc,
            on,
            parts,
        }))
    }

    fn effect_part(&mut self) -> Read<EffectPart> {
        let doc = self.doc();
        let start = self.here();
        let kind = match self.raw() {
            "source" => {
                self.advance();
                let text = self.quoted("where the effect is described")?;
                self.semicolon("this `source`")?;
                return Ok(EffectPart::Citation(text, start.to(self.behind())));
            }
            "site" => {
                self.advance();
                let name = self.name("where the effect acts, such as `drag`")?;
                self.semicolon("this `site`")?;
                return Ok(EffectPart::Site(name));
            }
            "variables" => {
                self.advance();
                let mut names = Vec::new();
                loop {
                    names.push(self.name("what the effect depends on, such as `alpha`")?);
                    if !self.eat(Token::Comma) {
                        break;
                    }
                }
                self.semicolon("this `variables`")?;
                return Ok(EffectPart::Variables(names, start.to(self.behind())));
            }
            "negligible" => {
                self.advance();
                let name = self.name("the name of a coefficient or a state of this effect")?;
                self.eat(Token::Equals);
                let value = self.quantity("a number")?;
                self.semicolon("this `negligible`")?;
                return Ok(EffectPart::Negligible(name, value));
            }
            "replace" => {
                self.advance();
                return self.replacement(doc);
            }
            "coefficient" | "param" => self.constant()?,
            "input" => self.input()?,
            "state" => self.state()?,
            "der" => self.equation()?,
            "let" => self.binding()?,
            "force" | "moment" => self.load()?,
            _ => {
                let what = "`source`, `site`, `variables`, `coefficient`, `input`, `state`, `der`, \
                            `replace`, `let`, `force`, `moment` or `negligible`";
                const WORDS: [&str; 12] = [
                    "source",
                    "site",
                    "variables",
                    "coefficient",
                    "input",
                    "state",
                    "der",
                    "replace",
                    "let",
                    "force",
                    "moment",
                    "negligible",
                ];
                return self.expected_word(what, &WORDS);
            }
        };
        let item = Item {
            kind,
            doc,
            span: start.to(self.behind()),
            effect: None,
        };
        Ok(EffectPart::Add(Box::new(item)))
    }

    fn replacement(&mut self, doc: String) -> Read<EffectPart> {
        let start = self.here();
        let equals_after_two = self.peek_at(1) == Token::Name;
        let kind = match self.raw() {
            "inertia" if self.peek_at(1) != Token::Equals && self.peek_at(1) != Token::Colon => {
                self.advance();
                let inertia = self.inertia()?;
                self.semicolon("this `replace`")?;
                return Ok(EffectPart::ReplaceInertia(
                    Box::new(inertia),
                    start.to(self.behind()),
                ));
            }
            "clock" if self.peek_at(1) == Token::Equals => {
                self.advance();
                self.advance();
                self.clock()?
            }
            "force" | "moment" if equals_after_two => self.load()?,
            "observe" if equals_after_two => self.observe()?,
            "let" if equals_after_two => self.binding()?,
            _ => {
                let name = self.name("what is replaced")?;
                ItemKind::Let(self.binding_rest(name)?)
            }
        };
        let item = Item {
            kind,
            doc,
            span: start.to(self.behind()),
            effect: None,
        };
        Ok(EffectPart::Replace(Box::new(item)))
    }
}
