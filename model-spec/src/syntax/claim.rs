//! Parser and printer of claims.

use std::fmt::{Display, Formatter, Result, Write};

use super::ast::{BodyClass, Claim, ClaimPart, ClaimPartKind, ItemKind};
use super::parser::{Parser, Read};

impl Parser<'_> {
    /// Parses `claim body NAME { … }` or `claim point NAME { … }`.
    pub fn claim(&mut self) -> Read<ItemKind> {
        self.advance();
        let word = self.raw();
        let class = match word {
            "body" => BodyClass::Rigid,
            "point" => BodyClass::Point,
            _ => return self.expected_word("`body` or `point` after `claim`", &["body", "point"]),
        };
        self.advance();
        let name = self.name(&format!("a name after `claim {word}`"))?;
        let parts = self.braces(&format!("`claim {word} {}`", name.text), Self::claim_part)?;
        Ok(ItemKind::Claim(Claim { class, name, parts }))
    }

    fn claim_part(&mut self) -> Read<ClaimPart> {
        let start = self.here();
        const FIRST: [&str; 9] = [
            "mass", "inertia", "fixed", "axis", "position", "velocity", "angular", "force",
            "moment",
        ];
        let word = self.raw();
        let words = ClaimPart::WORDS.into_iter();
        let Some(words) = { words }.find(|words| words.split(' ').next() == Some(word)) else {
            let what = "`mass`, `position`, `velocity`, `force`, `inertia`, `fixed in`, `axis`, `angular velocity` or `moment`";
            return self.expected_word(what, &FIRST);
        };
        self.advance();
        if word == "angular" {
            self.need_word("velocity", "`angular`")?;
        }
        let kind = match word {
            "inertia" => ClaimPartKind::Inertia(Box::new(self.inertia()?)),
            "fixed" => ClaimPartKind::Fixed(self.in_frame("`fixed`")?),
            _ => ClaimPartKind::Value(self.expr()?),
        };
        self.semicolon("this statement")?;
        let span = start.to(self.behind());
        Ok(ClaimPart { words, kind, span })
    }
}

impl Display for Claim {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "claim {} {} {{", self.class.keyword(), self.name.text)?;
        for part in &self.parts {
            writeln!(f, "  {part};")?;
        }
        f.write_char('}')
    }
}

impl Display for ClaimPart {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{} ", self.words)?;
        match &self.kind {
            ClaimPartKind::Inertia(inertia) => write!(f, "{inertia}"),
            ClaimPartKind::Fixed(frame) => f.write_str(&frame.text),
            ClaimPartKind::Value(e) => write!(f, "{e}"),
        }
    }
}
