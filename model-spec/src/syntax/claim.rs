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
        let word = self.raw();
        const WORDS: [&str; 9] = [
            "mass", "inertia", "fixed", "axis", "position", "velocity", "angular", "force",
            "moment",
        ];
        if !WORDS.contains(&word) {
            let what = "`mass`, `position`, `velocity`, `force`, `inertia`, `fixed in`, `axis`, `angular velocity` or `moment`";
            return self.expected_word(what, &WORDS);
        }
        self.advance();
        let kind = match word {
            "mass" => ClaimPartKind::Mass(self.expr()?),
            "inertia" => ClaimPartKind::Inertia(Box::new(self.inertia()?)),
            "fixed" => ClaimPartKind::Fixed(self.in_frame("`fixed`")?),
            "axis" => ClaimPartKind::Axis(self.expr()?),
            "position" => ClaimPartKind::Position(self.expr()?),
            "velocity" => ClaimPartKind::Velocity(self.expr()?),
            "force" => ClaimPartKind::Force(self.expr()?),
            "moment" => ClaimPartKind::Moment(self.expr()?),
            _ => {
                self.need_word("velocity", "`angular`")?;
                ClaimPartKind::AngularVelocity(self.expr()?)
            }
        };
        self.semicolon("this statement")?;
        Ok(ClaimPart {
            kind,
            span: start.to(self.behind()),
        })
    }
}

impl Display for Claim {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "claim {} {} {{", self.class.keyword(), self.name.text)?;
        for part in &self.parts {
            writeln!(f, "  {};", part.kind)?;
        }
        f.write_char('}')
    }
}

impl Display for ClaimPartKind {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{} ", self.words())?;
        match self {
            ClaimPartKind::Inertia(inertia) => write!(f, "{inertia}"),
            ClaimPartKind::Fixed(frame) => f.write_str(&frame.text),
            ClaimPartKind::Mass(e)
            | ClaimPartKind::Axis(e)
            | ClaimPartKind::Position(e)
            | ClaimPartKind::Velocity(e)
            | ClaimPartKind::AngularVelocity(e)
            | ClaimPartKind::Force(e)
            | ClaimPartKind::Moment(e) => write!(f, "{e}"),
        }
    }
}
