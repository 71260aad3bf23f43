//! Printing of whole files, for example of a model with effects applied.

use std::fmt::{self, Display, Formatter, Result, Write};

use super::ast::*;

impl Display for File {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        lines(f, "//!", &self.doc, "")?;
        let mut before: Option<&ItemKind> = None;
        for item in &self.items {
            // Empty lines around blocks and between different kinds of statement.
            let block = matches!(
                item.kind,
                ItemKind::Body(_) | ItemKind::Claim(_) | ItemKind::Check(_) | ItemKind::Effect(_)
            );
            let changed = before
                .is_some_and(|b| std::mem::discriminant(b) != std::mem::discriminant(&item.kind));
            if before.is_some() && (block || changed) {
                writeln!(f)?;
            }
            write_item(f, item, "")?;
            before = Some(&item.kind);
        }
        Ok(())
    }
}

fn lines(f: &mut Formatter<'_>, mark: &str, doc: &str, indent: &str) -> Result {
    if doc.is_empty() {
        return Ok(());
    }
    for line in doc.split('\n') {
        writeln!(f, "{}", format!("{indent}{mark} {line}").trim_end())?;
    }
    Ok(())
}

fn write_item(f: &mut Formatter<'_>, item: &Item, indent: &str) -> Result {
    lines(f, "///", &item.doc, indent)?;
    writeln!(f, "{indent}{}", item.kind)
}

impl Display for ItemKind {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            ItemKind::Model(name) => write!(f, "model {};", name.text),
            ItemKind::Reference(name) => write!(f, "reference {};", name.text),
            ItemKind::Parameter(c) => {
                let (word, name) = (c.class.keyword(), &c.name.text);
                match &c.value {
                    Quantity {
                        number,
                        unit: Some(unit),
                        ..
                    } if c.class == ParameterClass::Input => {
                        write!(f, "{word} {name}: {unit} = {}", number.text)?;
                    }
                    value => write!(f, "{word} {name} = {value}")?,
                }
                if let Some((least, greatest)) = &c.bounds {
                    write!(f, " in {least} .. {greatest}")?;
                }
                f.write_char(';')
            }
            ItemKind::Input(i) => {
                let [x, y, z] = &i.value;
                write!(
                    f,
                    "input {} in {} = ({}, {}, {})",
                    i.name.text, i.frame.text, x.text, y.text, z.text
                )?;
                if let Some(unit) = &i.unit {
                    write!(f, " {unit}")?;
                }
                f.write_char(';')
            }
            ItemKind::State(s) => write!(f, "state {} = {};", s.name.text, s.value),
            ItemKind::Frame(frame) => write!(f, "frame {}{};", frame.name.text, frame.kind),
            ItemKind::Body(body) => {
                writeln!(f, "{} {} {{", body.class.keyword(), body.name.text)?;
                for part in &body.parts {
                    writeln!(f, "  {};", part.kind)?;
                }
                f.write_char('}')
            }
            ItemKind::Claim(claim) => write!(f, "{claim}"),
            ItemKind::Table(table) => write!(f, "{table}"),
            ItemKind::Let(l) => {
                write!(f, "let ")?;
                write_let(f, l)
            }
            ItemKind::Load(l) => {
                write!(f, "{} {} = {};", l.class.keyword(), l.name.text, l.value)
            }
            ItemKind::Equation(e) => write!(f, "der({}) = {};", e.state.text, e.value),
            ItemKind::Marker(m) => write!(f, "marker {} in {};", m.name.text, m.frame.text),
            ItemKind::Observe(o) if o.name.text.is_empty() => write!(f, "observe = {};", o.value),
            ItemKind::Observe(o) => write!(f, "observe {} = {};", o.name.text, o.value),
            ItemKind::Clock(value) => write!(f, "clock {value};"),
            ItemKind::Limit(l) => write!(f, "limit {} > {} \"{}\";", l.value, l.bound, l.reason),
            ItemKind::Check(check) => {
                writeln!(f, "check \"{}\" {{", check.title)?;
                for part in &check.parts {
                    writeln!(f, "  {part}")?;
                }
                f.write_char('}')
            }
            ItemKind::Effect(effect) => write!(f, "{effect}"),
        }
    }
}

impl Display for Table {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let unit = |unit: &Option<UnitExpr>| {
            let text = unit.as_ref().map(|unit| format!(": {unit}"));
            text.unwrap_or_default()
        };
        let (argument, value) = (unit(&self.argument_unit), unit(&self.unit));
        let name = &self.name.text;
        writeln!(
            f,
            "table {name}({}{argument}){value} = {{",
            self.argument.text
        )?;
        for (argument, value) in &self.knots {
            writeln!(f, "  {argument}: {value},")?;
        }
        let monotone = self.interpolation == Interpolation::Monotone;
        let constant = self.continuation == Continuation::Constant;
        f.write_str(match (monotone, constant) {
            (false, false) => "};",
            (true, false) => "} monotone;",
            (false, true) => "} constant;",
            (true, true) => "} monotone, constant;",
        })
    }
}

fn joined(names: &[Name]) -> String {
    let names: Vec<&str> = names.iter().map(|name| name.text.as_str()).collect();
    names.join(", ")
}

fn write_let(f: &mut Formatter<'_>, l: &Let) -> Result {
    f.write_str(&l.name.text)?;
    if let Some(unit) = &l.unit {
        write!(f, ": {unit}")?;
    }
    write!(f, " = {};", l.value)
}

impl Display for FrameKind {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            FrameKind::Inertial => Ok(()),
            FrameKind::Turned {
                parent,
                angle,
                axis,
            } => {
                write!(f, " = {} turned {} about {axis}", parent.text, angle.text)
            }
            FrameKind::Quaternion {
                parent,
                states: [a, b, c, d],
            } => write!(
                f,
                " = {} by quaternion ({}, {}, {}, {})",
                parent.text, a.text, b.text, c.text, d.text
            ),
        }
    }
}

impl Display for BodyPartKind {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let mut names = |word: &str, [a, b, c]: &[Name; 3], frame: &Name| {
            write!(
                f,
                "{word} ({}, {}, {}) in {}",
                a.text, b.text, c.text, frame.text
            )
        };
        match self {
            BodyPartKind::Position(n, frame) => names("position", n, frame),
            BodyPartKind::Velocity(n, frame) => names("velocity", n, frame),
            BodyPartKind::AngularVelocity(n, frame) => names("angular velocity", n, frame),
            BodyPartKind::AngularVelocityIn(frame) => {
                write!(f, "angular velocity in {}", frame.text)
            }
            BodyPartKind::Mass(mass) => write!(f, "mass {mass}"),
            BodyPartKind::Inertia(inertia) => write!(f, "inertia {inertia}"),
            BodyPartKind::Fixed(frame) => write!(f, "fixed in {}", frame.text),
        }
    }
}

impl Display for Inertia {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let entry = |i: usize, j: usize| {
            self.rows[i][j]
                .as_ref()
                .map_or("0".to_owned(), Expr::to_string)
        };
        if self.rows[0][1].is_none() {
            write!(f, "diag({}, {}, {})", entry(0, 0), entry(1, 1), entry(2, 2))?;
        } else {
            let row = |i: usize| format!("({}, {}, {})", entry(i, 0), entry(i, 1), entry(i, 2));
            write!(f, "({}, {}, {})", row(0), row(1), row(2))?;
        }
        write!(f, " in {}", self.frame.text)
    }
}

impl Display for CheckPart {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            CheckPart::Set {
                name, value, unit, ..
            } => {
                write!(f, "set {} = ", name.text)?;
                match &value[..] {
                    [number] => f.write_str(&number.text)?,
                    numbers => {
                        let parts: Vec<&str> = numbers.iter().map(|n| n.text.as_str()).collect();
                        write!(f, "({})", parts.join(", "))?;
                    }
                }
                if let Some(unit) = unit {
                    write!(f, " {unit}")?;
                }
                f.write_char(';')
            }
            CheckPart::Expect {
                name,
                derivative,
                value,
                within,
                ..
            } => {
                let what = if *derivative {
                    format!("der({})", name.text)
                } else {
                    name.text.clone()
                };
                write!(f, "expect {what} = {value} within {within};")
            }
        }
    }
}

impl Display for Need {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let vector = if self.is_vector { "vector " } else { "" };
        write!(f, "{vector}{}", self.name.text)?;
        if let Some(unit) = &self.unit {
            write!(f, ": {unit}")?;
        }
        match &self.otherwise {
            Some(otherwise) => write!(f, " or {otherwise}"),
            None => Ok(()),
        }
    }
}

impl Display for Effect {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "effect {}", self.name.text)?;
        if !self.on.is_empty() {
            write!(f, " on {}", joined(&self.on))?;
        }
        writeln!(f, " {{")?;
        for part in &self.parts {
            match part {
                EffectPart::Citation(text, _) => writeln!(f, "  source \"{text}\";")?,
                EffectPart::Needs(needs) => {
                    f.write_str("  needs ")?;
                    for (i, need) in needs.iter().enumerate() {
                        write!(f, "{}{need}", if i == 0 { "" } else { ", " })?;
                    }
                    writeln!(f, ";")?;
                }
                EffectPart::Generalises(names) => {
                    writeln!(f, "  generalises {};", joined(names))?;
                }
                EffectPart::Increases(text, _) => writeln!(f, "  increases \"{text}\";")?,
                EffectPart::Decreases(text, _) => writeln!(f, "  decreases \"{text}\";")?,
                EffectPart::Site(name) => writeln!(f, "  site {};", name.text)?,
                EffectPart::Variables(names, _) => {
                    writeln!(f, "  variables {};", joined(names))?;
                }
                EffectPart::Negligible(name, value) => {
                    writeln!(f, "  negligible {} {value};", name.text)?;
                }
                EffectPart::ReplaceInertia(inertia, _) => {
                    writeln!(f, "  replace inertia {inertia};")?;
                }
                EffectPart::Add(item) => write_item(f, item, "  ")?,
                EffectPart::Replace(item) => {
                    lines(f, "///", &item.doc, "  ")?;
                    f.write_str("  replace ")?;
                    match &item.kind {
                        ItemKind::Let(l) => write_let(f, l)?,
                        ItemKind::Clock(value) => write!(f, "clock = {value};")?,
                        other => write!(f, "{other}")?,
                    }
                    writeln!(f)?;
                }
            }
        }
        f.write_char('}')
    }
}

impl fmt::Display for Item {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write_item(f, self, "")
    }
}

#[cfg(test)]
mod tests {
    use crate::load::{BODIES, EFFECTS, MODELS, REFUTED};
    use crate::syntax::parse;

    #[test]
    fn what_is_written_reads_the_same() {
        for (name, text) in MODELS.iter().chain(BODIES).chain(REFUTED).chain(EFFECTS) {
            let once = parse(name, text).file.to_string();
            let read = parse(name, &once);
            assert!(
                read.diagnostics.is_empty(),
                "{name}: {:?}",
                read.diagnostics
            );
            assert_eq!(read.file.to_string(), once, "{name}");
            assert_eq!(read.file.doc, parse(name, text).file.doc);
        }
    }

    #[test]
    fn every_form_of_statement_is_written() {
        let text = "\
//! doc
model probe;
/// a unit with a half power
param k = -3e-5 kg*m^(1/2)/s^2 in -1 .. 0;
input wind in N = (0, -1, 2) m/s;
frame N;
frame C = N by quaternion (q0, q1, q2, q3);

body probe {
  mass 2*k;
  inertia ((k, 0, 0), (0, k, 0), (0, 0, k)) in C;
  fixed in C;
  position (x, y, z) in N;
  velocity (u, v, w) in N;
  angular velocity (p, q, r) in C;
  angular velocity in N;
}

claim body top {
  mass 2*k;
  inertia ((k, 0, 0), (0, k, 0), (0, 0, k)) in C;
  fixed in C;
  axis C.3;
  position (x, y, z) in N;
  velocity velocity - wind;
  angular velocity (p, q, r) in C;
  force weight*N.3;
  moment cross(position, N.3);
}

claim point p {
  mass k;
}

let a: N*m = -x^2*(y + z)^(1/2)/(k*3) - (x - (y - z)) + 2 [m/s^2]*time;
let b = ((x*y)^2)^3 + x^y^2 + (-x)^2 + -(x*y);
let c = (x, y, z) in N + unit(wind, N.3) × C.1 · wind;

clock 1 + 2*k;

check \"a\" {
  set wind = (1, 2, 3) m/s;
  expect der(x) = 3 m/s within 1e-9;
}

/// doc
effect e on probe, disc {
  source \"somewhere\";
  site drag;
  variables alpha, spin;
  input marker_is in N = (0, 0, 0);
  coefficient c_0 = 0;
  negligible c_0 0.1;
  replace a = previous*c_0;
  replace observe mark = previous;
  replace clock = previous*(1 + c_0);
  state W_x = 0 m/s;
  der(W_x) = 0;
  replace inertia diag(k, k, k) in C;
}

effect general {
  needs V: m/s, vector air_velocity: m/s or 2*velocity, alpha;
  generalises e, other;
  site drag;
  replace observe = previous + mass*inertial.3;
  replace der(x) = previous;
}
";
        let parsed = parse("probe", text);
        assert!(parsed.diagnostics.is_empty(), "{:?}", parsed.diagnostics);
        let once = parsed.file.to_string();
        let again = parse("probe", &once);
        assert!(
            again.diagnostics.is_empty(),
            "{once}\n{:?}",
            again.diagnostics
        );
        assert_eq!(again.file.to_string(), once);
        for part in [
            "k = -3e-5 kg*m^(1/2)/s^2 in",
            "2 [m/s^2]*time",
            "-(x*y)",
            "x - (y - z)",
            "velocity velocity - wind;",
            "claim point p {\n  mass k;\n}",
        ] {
            assert!(once.contains(part), "{part} in\n{once}");
        }
    }
}
