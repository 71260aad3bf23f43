//! Parser for `effect` statements.

use super::ast::{Effect, EffectPart, Item, ItemKind, Name, Need, Observe};
use super::parser::{Parser, Read};
use super::token::Token;
use crate::location::Span;

impl Parser<'_> {
    pub fn effect(&mut self, doc: String) -> Read<ItemKind> {
        let (_, name) = self.keyword_and_name()?;
        let on = if self.eat_word("on") {
            self.list(|parser| parser.name("the name of a model after `on`"))?
        } else {
            Vec::new()
        };
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
        let word = self.raw();
        let kind = match word {
            "source" | "needs" | "generalises" | "increases" | "decreases" | "site"
            | "variables" | "negligible" => {
                self.advance();
                let part = self.stated_part(word, start)?;
                let statement = match word {
                    "increases" | "decreases" => "this sentence",
                    _ => &format!("this `{word}`"),
                };
                return self.semicolon(statement).map(|()| part);
            }
            "replace" => {
                self.advance();
                return self.replacement(doc);
            }
            "coefficient" | "param" => self.constant()?,
            "input" => self.input()?,
            "state" => self.state()?,
            "der" => self.equation()?,
            "function" => self.function()?,
            "table" => self.table()?,
            "let" => self.binding()?,
            "force" | "moment" => self.load()?,
            _ => return self.expected_statement_of("effect"),
        };
        let item = Item::new(kind, doc, start.to(self.behind()));
        Ok(EffectPart::Add(Box::new(item)))
    }

    fn stated_part(&mut self, word: &str, start: Span) -> Read<EffectPart> {
        Ok(match word {
            "source" => {
                let text = self.quoted("where the effect is described")?;
                EffectPart::Citation(text, start.to(self.here()))
            }
            "needs" => EffectPart::Needs(self.list(Self::needed_quantity)?),
            "generalises" => {
                EffectPart::Generalises(self.list(|parser| parser.name("the name of an effect"))?)
            }
            "increases" => {
                let text = self.quoted("what the effect does then")?;
                EffectPart::Increases(text, start.to(self.here()))
            }
            "decreases" => {
                let text = self.quoted("what the effect does then")?;
                EffectPart::Decreases(text, start.to(self.here()))
            }
            "site" => EffectPart::Site(self.name("where the effect acts, such as `drag`")?),
            "variables" => {
                let what = "what the effect depends on, such as `alpha`";
                let names = self.list(|parser| parser.name(what))?;
                EffectPart::Variables(names, start.to(self.here()))
            }
            _ => {
                let name =
                    self.name_or_element("the name of a coefficient or a state of this effect")?;
                self.eat(Token::Sign("="));
                EffectPart::Negligible(name, self.quantity("a number")?)
            }
        })
    }

    /// Parses a needed quantity: `NAME`, `NAME: UNIT` or `vector NAME: UNIT`, with an optional `or EXPR`.
    fn needed_quantity(&mut self) -> Read<Need> {
        let is_vector = self.at_word("vector") && self.peek_at(1) == Token::Name;
        if is_vector {
            self.advance();
        }
        let name = self.name("the name of a quantity that the effect needs")?;
        let unit = self.unit_behind_colon()?;
        let otherwise = if self.eat_word("or") {
            Some(self.expr()?)
        } else {
            None
        };
        Ok(Need {
            name,
            is_vector,
            unit,
            otherwise,
        })
    }

    fn replacement(&mut self, doc: String) -> Read<EffectPart> {
        let start = self.here();
        let equals_after_two = self.peek_at(1) == Token::Name;
        let kind = match self.raw() {
            "inertia"
                if self.peek_at(1) != Token::Sign("=") && self.peek_at(1) != Token::Sign(":") =>
            {
                self.advance();
                let inertia = self.inertia()?;
                self.semicolon("this `replace`")?;
                return Ok(EffectPart::ReplaceInertia(
                    Box::new(inertia),
                    start.to(self.behind()),
                ));
            }
            "clock" if self.peek_at(1) == Token::Sign("=") => {
                self.advance();
                self.advance();
                self.clock()?
            }
            "observe" if self.peek_at(1) == Token::Sign("=") => {
                let name = Name::new("", start);
                self.advance();
                self.advance();
                let value = self.expr()?;
                self.semicolon("this `replace`")?;
                ItemKind::Observe(Observe { name, value })
            }
            "der" if self.peek_at(1) == Token::Sign("(") => self.equation()?,
            "force" | "moment" if equals_after_two => self.load()?,
            "observe" if equals_after_two => self.observe()?,
            "let" if equals_after_two => self.binding()?,
            _ => {
                let name = self.name("what is replaced")?;
                self.binding_or_array(name)?
            }
        };
        let item = Item::new(kind, doc, start.to(self.behind()));
        Ok(EffectPart::Replace(Box::new(item)))
    }
}
