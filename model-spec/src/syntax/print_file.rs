//! Printing of whole files, for example of a model with effects applied.

use std::fmt::{self, Display, Formatter, Result, Write};

use super::ast::*;
use super::of_kind;
use super::print::{behind, listed};

impl Display for File {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        lines(f, "//!", &self.doc, "")?;
        let mut before: Option<&ItemKind> = None;
        let mut at = 0;
        let changed = self.changed_bodies();
        while let Some(own) = self.items.get(at) {
            // Of a changed body, the statements that it stands for are written instead.
            if own
                .kind
                .of_body()
                .is_some_and(|body| changed.contains(&body))
            {
                at += 1;
                continue;
            }
            let (item, count) = written(own, &self.items[at..]);
            at += count;
            // Empty lines around blocks and between different kinds of statement.
            let block = matches!(
                item.kind,
                ItemKind::Body(_)
                    | ItemKind::Claim(_)
                    | ItemKind::Solve(_)
                    | ItemKind::Check(_)
                    | ItemKind::Effect(_)
                    | ItemKind::Function(_)
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

impl File {
    /// Names of the further bodies of whose statements one has been changed.
    fn changed_bodies(&self) -> Vec<&str> {
        let items = self.items.iter().enumerate();
        let is_changed = |(at, item): (usize, &'_ Item)| written(item, &self.items[at..]).1 == 1;
        let bodies = items.filter(|(_, item)| item.expanded.is_some());
        let bodies = bodies.filter(|own| is_changed(*own));
        of_kind!(bodies.map(|(_, item)| item), ItemKind::Body)
            .map(|body| body.name.text.as_str())
            .collect()
    }
}

impl ItemKind {
    /// Name of the body that the statement declares or acts on.
    fn of_body(&self) -> Option<&str> {
        let name = match self {
            ItemKind::Body(body) => Some(&body.name),
            ItemKind::Load(load) => load.on.as_ref(),
            _ => None,
        };
        name.map(|name| name.text.as_str())
    }
}

/// Statement to be printed for the first of `items`, and number of items that it stands for: the statement as it was
/// written, if all that it was expanded to follows unchanged.
fn written<'a>(first: &'a Item, items: &'a [Item]) -> (&'a Item, usize) {
    let Some(origin) = &first.expanded else {
        return (first, 1);
    };
    let expanded = &origin.from.expanded;
    let kinds = items.iter().map(|item| &item.kind).take(expanded.len());
    if kinds.eq(expanded) {
        (&origin.from.written, expanded.len())
    } else {
        (first, 1)
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
        write_kind(f, self, &Elements::default())
    }
}

/// What a statement for the elements of an array has besides that for one quantity.
#[derive(Default)]
struct Elements {
    /// Subscripts with their brackets.
    subscripts: String,
    /// Indices with ` for ` before them.
    indices: String,
    /// Defaults of the elements.
    values: Vec<String>,
}

impl Elements {
    fn of(array: &Array) -> Elements {
        Elements {
            subscripts: format!("[{}]", listed(&array.subscripts)),
            indices: match array.indices.is_empty() {
                true => String::new(),
                false => format!(" for {}", listed(&array.indices)),
            },
            values: array.values.iter().map(|own| own.text.clone()).collect(),
        }
    }
}

fn write_kind(f: &mut Formatter<'_>, kind: &ItemKind, of: &Elements) -> Result {
    let (subscripts, indices) = (&of.subscripts, &of.indices);
    match kind {
        ItemKind::Model(name) => write!(f, "model {};", name.text),
        ItemKind::Reference(name) => write!(f, "reference {};", name.text),
        ItemKind::Parameter(c) => write_parameter(f, c, of),
        ItemKind::Input(i) => {
            let [x, y, z] = &i.value;
            write!(f, "input {} in {} = ", i.name.text, i.frame.text)?;
            let unit = behind(" ", &i.unit);
            write!(f, "({}, {}, {}){unit};", x.text, y.text, z.text)
        }
        ItemKind::State(s) => {
            write!(
                f,
                "state {}{subscripts}{indices} = {};",
                s.name.text, s.value
            )
        }
        ItemKind::Frame(frame) => write!(f, "frame {}{};", frame.name.text, frame.kind),
        ItemKind::Body(body) => write!(f, "{body}"),
        ItemKind::Claim(claim) => write!(f, "claim {claim}"),
        ItemKind::Solve(solve) => write!(f, "{solve}"),
        ItemKind::Balance(own) => write!(f, "claim der({}) = {};", own.quantity, own.change),
        ItemKind::Table(table) => write!(f, "{table}"),
        ItemKind::Include(file) => write!(f, "include \"{}\";", file.text),
        ItemKind::Let(l) => {
            // `param` before a number declares a parameter of the model.
            let is_number = matches!(l.value.kind, ExprKind::Number(_));
            f.write_str(match l.is_constant && !is_number {
                true => "param ",
                false => "let ",
            })?;
            write_let(f, l, of)
        }
        ItemKind::Load(l) => {
            let (word, name) = (l.class.keyword(), &l.name.text);
            write!(f, "{word} {name}{subscripts}")?;
            { l.on.iter() }.try_for_each(|body| write!(f, " on {}", body.text))?;
            write!(f, "{indices} = {};", l.value)
        }
        ItemKind::Equation(e) => {
            write!(
                f,
                "der({}{subscripts}){indices} = {};",
                e.state.text, e.value
            )
        }
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
        ItemKind::Function(function) => write!(f, "{function}"),
        ItemKind::Array(array) => write_kind(f, &array.statement, &Elements::of(array)),
    }
}

fn write_parameter(f: &mut Formatter<'_>, c: &Parameter, of: &Elements) -> Result {
    let (word, Quantity { number, unit, .. }) = (c.class.keyword(), &c.value);
    write!(f, "{word} {}{}", c.name.text, of.subscripts)?;
    // The unit of an input stands before its default.
    if c.class == ParameterClass::Input {
        f.write_str(&behind(": ", unit))?;
    }
    write!(f, "{} = ", of.indices)?;
    if c.class == ParameterClass::Input {
        f.write_str(&number.text)?;
    } else if of.values.is_empty() {
        write!(f, "{}", c.value)?;
    } else {
        write!(f, "({}){}", of.values.join(", "), behind(" ", unit))?;
    }
    if let Some((least, greatest)) = &c.bounds {
        write!(f, " in {least} .. {greatest}")?;
    }
    f.write_char(';')
}

impl Display for Table {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let arguments = self.arguments.iter();
        let arguments = listed(arguments.map(|(name, of)| name.text.clone() + &behind(": ", of)));
        let (name, value) = (&self.name.text, behind(": ", &self.unit));
        write!(f, "table {name}({arguments}){value} = ")?;
        match &self.file {
            Some(file) => write!(f, "\"{}\"", file.text)?,
            None => self.write_knots(f)?,
        }
        let interpolation = match self.interpolation {
            Interpolation::Spline => None,
            Interpolation::Monotone => Some("monotone"),
            Interpolation::Linear => Some("linear"),
        };
        let is_constant = self.continuation == Continuation::Constant;
        let ways = interpolation.into_iter();
        let ways: Vec<&str> = ways.chain(is_constant.then_some("constant")).collect();
        let gap = if ways.is_empty() { "" } else { " " };
        write!(f, "{gap}{};", ways.join(", "))
    }
}

impl Table {
    fn write_knots(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "{{")?;
        if let [_, (second, _)] = &self.arguments[..] {
            writeln!(f, "  {}: ({}),", second.text, listed(&self.columns))?;
            for (argument, values) in &self.rows {
                writeln!(f, "  {argument}: ({}),", listed(values))?;
            }
        } else {
            for (argument, values) in &self.rows {
                writeln!(f, "  {argument}: {},", listed(values))?;
            }
        }
        f.write_char('}')
    }
}

fn joined(names: &[Name]) -> String {
    listed(names.iter().map(|name| &name.text))
}

fn write_let(f: &mut Formatter<'_>, l: &Let, of: &Elements) -> Result {
    let (name, unit) = (&l.name.text, behind(": ", &l.unit));
    write!(
        f,
        "{name}{}{unit}{} = {};",
        of.subscripts, of.indices, l.value
    )
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
            FrameKind::Fixed {
                parent,
                angle,
                axis,
            } => write!(f, " = {} turned {angle} about {axis}", parent.text),
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
                    numbers => write!(f, "({})", listed(numbers.iter().map(|n| &n.text)))?,
                }
                write!(f, "{};", behind(" ", unit))
            }
            CheckPart::Expect {
                name,
                derivative,
                value,
                within,
                is_relative,
                ..
            } => {
                let what = if *derivative {
                    format!("der({})", name.text)
                } else {
                    name.text.clone()
                };
                let relative = if *is_relative { " relative" } else { "" };
                write!(f, "expect {what} = {value} within {within}{relative};")
            }
        }
    }
}

impl Display for Need {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let vector = if self.is_vector { "vector " } else { "" };
        write!(f, "{vector}{}{}", self.name.text, behind(": ", &self.unit))?;
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
                EffectPart::Needs(needs) => writeln!(f, "  needs {};", listed(needs))?,
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
                        ItemKind::Let(l) => write_let(f, l, &Elements::default())?,
                        ItemKind::Array(Array { statement, .. })
                            if matches!(**statement, ItemKind::Let(_)) =>
                        {
                            let written = item.kind.to_string();
                            f.write_str(written.trim_start_matches("let "))?;
                        }
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
mod tests;
