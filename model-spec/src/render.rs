//! Text output of diagnostics: excerpts of the source with marked spans.

use ariadne::{CharSet, Color, Config, IndexType, Label, Report, ReportKind};

use crate::diagnostic::{self, Diagnostic, MAX_SHOWN};
use crate::location::{Source, Span, line_and_column, line_of};

const MAX_LINE_BYTES: usize = 300;

/// Formats diagnostics in the order of their spans, in ANSI colours if `color`; counts those beyond 50.
pub fn render(diagnostics: &[Diagnostic], sources: &[Source], color: bool) -> String {
    let mut ordered: Vec<&Diagnostic> = diagnostics.iter().collect();
    ordered.sort_by_key(|d| d.span);
    let texts: Vec<(String, ariadne::Source<&str>)> = sources
        .iter()
        .map(|s| (s.name.clone(), ariadne::Source::from(s.text.as_str())))
        .collect();
    let mut out = String::new();
    for diagnostic in ordered.iter().take(MAX_SHOWN) {
        if !out.is_empty() {
            out.push('\n');
        }
        if drawable(diagnostic, sources) {
            draw(diagnostic, &texts, color, &mut out);
        } else {
            write_plain(diagnostic, sources, &mut out);
        }
    }
    if let Some(more) = ordered.len().checked_sub(MAX_SHOWN).filter(|&n| n > 0) {
        let noun = if more == 1 { "fault" } else { "faults" };
        out.push_str(&format!("\n… and {more} more {noun}\n"));
    }
    out
}

/// Whether all spans of a diagnostic can be shown as excerpts.
fn drawable(diagnostic: &Diagnostic, sources: &[Source]) -> bool {
    let fits = |span: Span| {
        let Some(source) = sources.get(usize::from(span.source)) else {
            return false;
        };
        let text = &source.text;
        let range = span.range();
        if text.is_empty() || range.end > text.len() || text.get(range.clone()).is_none() {
            return false;
        }
        let start = text[..range.start].rfind('\n').map_or(0, |i| i + 1);
        let end = text[range.end..]
            .find('\n')
            .map_or(text.len(), |i| range.end + i);
        end - start <= MAX_LINE_BYTES || text[start..end].lines().all(|l| l.len() <= MAX_LINE_BYTES)
    };
    fits(diagnostic.span) && diagnostic.labels.iter().all(|l| fits(l.span))
}

fn draw(
    diagnostic: &Diagnostic,
    texts: &[(String, ariadne::Source<&str>)],
    color: bool,
    out: &mut String,
) {
    let place = |span: Span| {
        let mut range = span.range();
        // An empty span is widened to the character before, so that it can be underlined.
        if range.is_empty() {
            let text = texts[usize::from(span.source)].1.text();
            range.start = text[..range.start]
                .char_indices()
                .next_back()
                .map_or(0, |c| c.0);
        }
        (span.source, range)
    };
    let config = Config::default()
        .with_color(color)
        .with_index_type(IndexType::Byte)
        .with_char_set(CharSet::Unicode)
        .with_tab_width(4);
    let mut report = Report::build(ReportKind::Error, place(diagnostic.span))
        .with_config(config)
        .with_code(diagnostic.kind.slug())
        .with_message(&diagnostic.message);
    // A label on the line of the error replaces the plain underline.
    let line = |span: Span| {
        let text = texts[usize::from(span.source)].1.text();
        line_of(text, span.range().start)
    };
    let own = |l: &diagnostic::Label| {
        l.span.source == diagnostic.span.source && line(l.span) == line(diagnostic.span)
    };
    if !diagnostic.labels.iter().any(own) {
        report.add_label(
            Label::new(place(diagnostic.span))
                .with_message("here")
                .with_color(Color::Red)
                .with_order(-1),
        );
    }
    // Labels inside or on the line of the error first, then the others, each in source order.
    let mut labels: Vec<&diagnostic::Label> = diagnostic.labels.iter().collect();
    labels.sort_by_key(|l| (!diagnostic.span.contains(l.span) && !own(l), l.span));
    for (i, label) in labels.into_iter().enumerate() {
        let color = if label.span == diagnostic.span {
            Color::Red
        } else {
            Color::Blue
        };
        report.add_label(
            Label::new(place(label.span))
                .with_message(&label.text)
                .with_color(color)
                .with_order(i as i32),
        );
    }
    for note in &diagnostic.notes {
        report.add_note(note);
    }
    if let Some(help) = &diagnostic.help {
        report.add_help(help);
    }
    let mut bytes = Vec::new();
    if report.finish().write(Texts(texts), &mut bytes).is_ok() {
        let text = String::from_utf8_lossy(&bytes);
        let mut lines = text.lines().peekable();
        let mut place = String::new();
        while let Some(line) = lines.next() {
            // Omit a header that repeats the location of the preceding excerpt.
            if let Some((_, at)) = line.split_once("─[") {
                if at == place {
                    lines.next();
                    continue;
                }
                at.clone_into(&mut place);
            }
            out.push_str(line.trim_end());
            out.push('\n');
        }
    }
}

struct Texts<'a>(&'a [(String, ariadne::Source<&'a str>)]);

impl<'a> ariadne::Cache<u16> for Texts<'a> {
    type Storage = &'a str;

    fn fetch(&mut self, id: &u16) -> Result<&ariadne::Source<&'a str>, impl std::fmt::Debug> {
        self.0
            .get(usize::from(*id))
            .map(|(_, source)| source)
            .ok_or("no such text")
    }

    fn display<'b>(&self, id: &'b u16) -> Option<impl std::fmt::Display + 'b> {
        self.0.get(usize::from(*id)).map(|(name, _)| name.clone())
    }
}

/// Appends a diagnostic as plain text without source excerpts.
fn write_plain(diagnostic: &Diagnostic, sources: &[Source], out: &mut String) {
    let at = |span: Span| match sources.get(usize::from(span.source)) {
        Some(source) if source.text.is_empty() => source.name.clone(),
        Some(source) => {
            let (line, column) = line_and_column(&source.text, span.range().start);
            format!("{}:{line}:{column}", source.name)
        }
        None => String::new(),
    };
    out.push_str(&format!(
        "[{}] Error: {}\n",
        diagnostic.kind.slug(),
        diagnostic.message
    ));
    out.push_str(&format!("   at {}\n", at(diagnostic.span)));
    for label in &diagnostic.labels {
        out.push_str(&format!("   at {}: {}\n", at(label.span), label.text));
    }
    for note in &diagnostic.notes {
        out.push_str(&format!("   Note: {note}\n"));
    }
    if let Some(help) = &diagnostic.help {
        out.push_str(&format!("   Help: {help}\n"));
    }
}
