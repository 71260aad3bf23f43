//! Parser for `effect` statements.

use super::ast::{Effect, EffectPart, Item, ItemKind, Name, Need, Observe};
use super::parser::{Parser, Read};
use super::token::Token;

impl Parser<'_> {
    /// Parses `effect NAME on MODEL, MODEL { … }`; `doc` is the documentation of the effect.
    pub fn effect(&mut self, doc: String) -> Read<ItemKind> {
        self.advance();
        let name = self.name("a name after `effect`")?;
        let on = match self.eat_word("on") {
            true => self.list(|parser| parser.name("the name of a model after `on`"))?,
            false => Vec::new(),
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
        let kind = match self.raw() {
            "source" => {
                self.advance();
                let text = self.quoted("where the effect is described")?;
                self.semicolon("this `source`")?;
                return Ok(EffectPart::Citation(text, start.to(self.behind())));
            }
            "needs" => {
                self.advance();
                let needs = self.list(Self::needed_quantity)?;
                self.semicolon("this `needs`")?;
                return Ok(EffectPart::Needs(needs));
            }
            "generalises" => {
                self.advance();
                let names = self.list(|parser| parser.name("the name of an effect"))?;
                self.semicolon("this `generalises`")?;
                return Ok(EffectPart::Generalises(names));
            }
            word @ ("increases" | "decreases") => {
                self.advance();
                let text = self.quoted("what the effect does then")?;
                self.semicolon("this sentence")?;
                let span = start.to(self.behind());
                return Ok(match word {
                    "increases" => EffectPart::Increases(text, span),
                    _ => EffectPart::Decreases(text, span),
                });
            }
            "site" => {
                self.advance();
                let name = self.name("where the effect acts, such as `drag`")?;
                self.semicolon("this `site`")?;
                return Ok(EffectPart::Site(name));
            }
            "variables" => {
                self.advance();
                let what = "what the effect depends on, such as `alpha`";
                let names = self.list(|parser| parser.name(what))?;
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
            "table" => self.table()?,
            "let" => self.binding()?,
            "force" | "moment" => self.load()?,
            _ => {
                let what = "`source`, `needs`, `generalises`, `site`, `variables`, `coefficient`, `input`, \
                            `state`, `der`, `replace`, `table`, `let`, `force`, `moment` or `negligible`";
                const WORDS: [&str; 17] = [
                    "source",
                    "needs",
                    "generalises",
                    "increases",
                    "decreases",
                    "site",
                    "variables",
                    "coefficient",
                    "input",
                    "state",
                    "der",
                    "replace",
                    "table",
                    "let",
                    "force",
                    "moment",
                    "negligible",
                ];
                return self.expected_word(what, &WORDS);
            }
        };
        let item = Item::new(kind, doc, start.to(self.behind()));
        Ok(EffectPart::Add(Box::new(item)))
    }

    /// Parses a quantity that an effect needs: `NAME`, `NAME: UNIT` or `vector NAME: UNIT`, each optionally followed by
    /// the fallback `or EXPR`.
    fn needed_quantity(&mut self) -> Read<Need> {
        let is_vector = self.at_word("vector") && self.peek_at(1) == Token::Name;
        if is_vector {
            self.advance();
        }
        let name = self.name("the name of a quantity that the effect needs")?;
        let unit = self.unit_behind_colon()?;
        let otherwise = match self.eat_word("or") {
            true => Some(self.expr()?),
            false => None,
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
            "observe" if self.peek_at(1) == Token::Equals => {
                let name = Name::new("", start);
                self.advance();
                self.advance();
                let value = self.expr()?;
                self.semicolon("this `replace`")?;
                ItemKind::Observe(Observe { name, value })
            }
            "der" if self.peek_at(1) == Token::Open => self.equation()?,
            "force" | "moment" if equals_after_two => self.load()?,
            "observe" if equals_after_two => self.observe()?,
            "let" if equals_after_two => self.binding()?,
            _ => {
                let name = self.name("what is replaced")?;
                ItemKind::Let(self.binding_rest(name)?)
            }
        };
        let item = Item::new(kind, doc, start.to(self.behind()));
        Ok(EffectPart::Replace(Box::new(item)))
    }
}
