//! Knots of a table from a text with a knot in each line, numbers separated by commas, semicolons or tabs.
//!
//! With one argument a line has the knot and the value. With two arguments the first line has the knots of the second
//! argument behind a field that is not read, each further line a knot of the first and the values there.

use crate::diagnostic::{Diagnostic, Kind};
use crate::location::Span;
use crate::syntax::ast::Quantity;
use crate::syntax::quantity::beyond_range;

/// Maximum number of lines and of fields in a line: beyond the bounds of a table, whose errors say more.
const MAX_COUNT: usize = 20_000;

/// Knots of the second argument, and each of the first with its values.
type Knots = (Vec<Quantity>, Vec<(Quantity, Vec<Quantity>)>);

/// A field of a line, without spaces and quotation marks.
struct Field<'t> {
    text: &'t str,
    span: Span,
}

pub(super) fn knots(text: &str, source: u16, arguments: usize) -> Result<Knots, Diagnostic> {
    let mut rows = lines(text, source)?;
    let mut columns = Vec::new();
    let is_number = |field: &Field<'_>| field.text.parse::<f64>().is_ok();
    if arguments == 2 {
        let first = rows.drain(..1.min(rows.len())).flatten().skip(1);
        columns = first.map(number).collect::<Result<_, _>>()?;
    } else if rows.first().is_some_and(|row| !row.iter().any(is_number)) {
        rows.remove(0);
    }
    let rows = rows.into_iter().map(|row| {
        let count = row.len();
        let span = row[0].span;
        let mut numbers = row.into_iter().map(number);
        let knot = numbers.next().unwrap_or_else(|| Err(wrong(span, "")))?;
        if arguments == 1 && count != 2 {
            let message = format!("a line has a knot and its value, but here are {count} fields");
            return Err(Diagnostic::new(Kind::Value, span, message));
        }
        Ok((knot, numbers.collect::<Result<Vec<_>, _>>()?))
    });
    Ok((columns, rows.collect::<Result<_, _>>()?))
}

/// Fields of each line that is neither empty nor a comment.
fn lines(text: &str, source: u16) -> Result<Vec<Vec<Field<'_>>>, Diagnostic> {
    let is_read = |line: &str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    let separator = [';', '\t'].into_iter().find(|&c| {
        let mut lines = text.lines().filter(|line| is_read(line));
        lines.any(|line| line.contains(c))
    });
    let separator = separator.unwrap_or(',');
    let mut rows = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let mut at = start;
        start += line.len();
        if !is_read(line) {
            continue;
        }
        let fields = line.split(separator).take(MAX_COUNT).map(|field| {
            let trimmed = field.trim().trim_matches('"');
            let from = at + field.find(trimmed).unwrap_or(0);
            at += field.len() + separator.len_utf8();
            let span = Span {
                start: u32::try_from(from).unwrap_or(u32::MAX),
                end: u32::try_from(from + trimmed.len()).unwrap_or(u32::MAX),
                source,
            };
            Field {
                text: trimmed,
                span,
            }
        });
        rows.push(fields.collect());
        if rows.len() > MAX_COUNT {
            let message = format!("the file has more than {MAX_COUNT} lines");
            return Err(Diagnostic::new(Kind::Limit, Span::default(), message));
        }
    }
    Ok(rows)
}

fn number(field: Field<'_>) -> Result<Quantity, Diagnostic> {
    match field.text.parse::<f64>() {
        Ok(value)
            if value == 0.0
                && let Some((what, bound)) = beyond_range(field.text) =>
        {
            let message = format!("the number {} is too {what}", field.text);
            Err(Diagnostic::new(Kind::Value, field.span, message).note(bound))
        }
        Ok(value) if value.is_finite() => Ok(Quantity::new(format!("{value:?}"), None, field.span)),
        _ => Err(wrong(field.span, field.text)),
    }
}

fn wrong(span: Span, text: &str) -> Diagnostic {
    let message = format!(
        "expected a number, found `{}`",
        crate::syntax::token::clip(text)
    );
    let fault = Diagnostic::new(Kind::Value, span, message);
    fault.note("fields are separated by `,`, or by `;` or tabs where the file has one; decimals have a point")
}
