//! Self-contained HTML pages: paragraphs, tables and figures in sections.

use identify::DataFault;

use crate::certificate::CertificateNote;
use crate::figure::Figure;
use crate::figures::svg::{STYLE, escape, without_style};
use crate::table::{Column, Table};
use identify::wording::{capitalized, counted};

/// Maximum number of faults in the measured data that the table of a page lists.
const MAX_FAULTS: usize = 60;
/// Maximum size in bytes of a CSV table that is embedded in a page; the page links to the file of a larger table.
const MAX_EMBEDDED: usize = 10_000;

/// HTML text. Conversion from a string escapes it; tags and classes are fixed texts of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Html(String);

impl From<&str> for Html {
    fn from(text: &str) -> Html {
        Html(escape(text))
    }
}

impl From<String> for Html {
    fn from(text: String) -> Html {
        Html(escape(&text))
    }
}

impl From<&String> for Html {
    fn from(text: &String) -> Html {
        Html(escape(text))
    }
}

impl Html {
    /// Empty text.
    pub fn new() -> Html {
        Html::default()
    }

    /// Markup that is valid HTML and contains no unescaped text from outside, such as MathML.
    pub(crate) fn trusted(markup: impl Into<String>) -> Html {
        Html(markup.into())
    }

    /// Element with a class, which may be empty, and its content.
    pub fn of(tag: &'static str, class: &str, content: impl Into<Html>) -> Html {
        let class = match class {
            "" => String::new(),
            class => format!(" class=\"{class}\""),
        };
        Html(format!("<{tag}{class}>{}</{tag}>", content.into().0))
    }

    /// Emphasised text.
    pub fn strong(text: impl Into<Html>) -> Html {
        Html::of("b", "", text)
    }

    /// Short label in a cell of a table.
    pub fn tag(text: impl Into<Html>) -> Html {
        Html::of("span", "tag", text)
    }

    /// Short label that warns.
    pub fn warning_tag(text: impl Into<Html>) -> Html {
        Html::of("span", "tag warn", text)
    }

    /// Link to `to`, whose part after `#` must be percent-encoded.
    pub fn link(to: &str, text: impl Into<Html>) -> Html {
        Html(format!("<a href=\"{}\">{}</a>", escape(to), text.into().0))
    }

    /// Whether the text is empty.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The HTML text.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// The text without its markup.
    pub(crate) fn text(&self) -> String {
        let outside = self.0.split('<').enumerate().map(|(i, part)| match i {
            0 => part,
            _ => part.split_once('>').map_or("", |(_, text)| text),
        });
        let text: String = outside.collect();
        let text = text.replace("&lt;", "<").replace("&gt;", ">");
        text.replace("&quot;", "\"")
            .replace("&amp;", "&")
            .trim()
            .to_owned()
    }

    /// This text followed by `more`.
    #[must_use]
    pub fn then(mut self, more: impl Into<Html>) -> Html {
        self.0 += &more.into().0;
        self
    }

    /// Appends `more`.
    pub fn push(&mut self, more: impl Into<Html>) {
        self.0 += &more.into().0;
    }

    /// Appends an element on a line of its own.
    pub fn element(&mut self, tag: &'static str, class: &str, content: impl Into<Html>) {
        self.push(Html::of(tag, class, content));
        self.0.push('\n');
    }

    /// Appends an element with an id, on a line of its own.
    pub fn element_with_id(
        &mut self,
        tag: &'static str,
        id: &str,
        class: &str,
        content: impl Into<Html>,
    ) {
        let element = Html::of(tag, class, content);
        let rest = &element.0[1 + tag.len()..];
        self.0 += &format!("<{tag} id=\"{}\"{rest}\n", escape(id));
    }

    /// Appends a paragraph.
    pub fn paragraph(&mut self, text: impl Into<Html>) {
        self.element("p", "words", text);
    }

    /// Appends a paragraph in small letters.
    pub fn note(&mut self, text: impl Into<Html>) {
        self.element("p", "note", text);
    }

    /// Appends a heading within a section.
    pub fn heading(&mut self, text: impl Into<Html>) {
        self.element("h3", "", text);
    }

    /// Appends a list of `items`; nothing if there are none.
    pub fn list<T: Into<Html>>(&mut self, class: &str, items: impl IntoIterator<Item = T>) {
        let mut list = Html::new();
        for item in items {
            list.element("li", "", item);
        }
        if !list.is_empty() {
            self.element("ul", class, Html::trusted("\n").then(list));
        }
    }

    /// Appends a table; nothing if it has no rows.
    pub fn table(&mut self, table: &Table) {
        if !table.is_empty() {
            let scroll = "<div class=\"scroll\" tabindex=\"0\">\n";
            self.0 += &format!("{scroll}{}</div>\n", table.html().0);
        }
    }

    /// Appends a part of the page that is folded until its summary is clicked; nothing if it is empty.
    pub fn folded(&mut self, summary: impl Into<Html>, content: Html) {
        if !content.is_empty() {
            self.element(
                "details",
                "",
                Html::of("summary", "", summary).then("\n").then(content),
            );
        }
    }

    /// Appends a figure, with its caption if `captioned`.
    pub fn figure(&mut self, figure: &Figure, captioned: bool) {
        let svg = without_style(&figure.svg);
        let svg = match &figure.narrow {
            Some(narrow) => format!(
                "<div class=\"wide\">{svg}</div><div class=\"narrow\">{}</div>",
                without_style(narrow)
            ),
            None => svg,
        };
        let mut caption = Html::new();
        if captioned {
            caption.push(&figure.caption);
        }
        if !figure.csv.is_empty() {
            caption.push(if captioned { " " } else { "" });
            caption.push(table_link(figure));
        }
        let mut content = Html(svg + "\n");
        if !caption.is_empty() {
            content.push(Html::of("figcaption", "", caption));
        }
        self.element_with_id("figure", &figure.name, "", content);
    }

    /// Appends figures one below the other.
    pub fn figures<'a>(&mut self, figures: impl IntoIterator<Item = &'a Figure>, captioned: bool) {
        for figure in figures {
            self.figure(figure, captioned);
        }
    }

    /// Appends small figures side by side; those beyond the first `open` are folded.
    pub fn grid(&mut self, figures: &[Figure], open: usize, captioned: bool) {
        let grid = |figures: &[Figure]| {
            let (mut content, mut grid) = (Html::new(), Html::new());
            content.figures(figures, captioned);
            if !content.is_empty() {
                grid.element("div", "grid", Html::trusted("\n").then(content));
            }
            grid
        };
        let (first, rest) = figures.split_at(open.min(figures.len()));
        self.push(grid(first));
        self.folded(format!("{} more", rest.len()), grid(rest));
    }

    /// Appends warnings under a heading; nothing if there are none.
    pub fn alarms<T: Into<Html>>(&mut self, title: &str, items: impl IntoIterator<Item = T>) {
        let mut list = Html::new();
        list.list("", items);
        if !list.is_empty() {
            let title = Html::of("h2", "", title).then("\n");
            self.element("div", "alarms", title.then(list));
        }
    }

    /// Appends a section with a heading; nothing if its content is empty. `id` may be empty.
    pub fn section(&mut self, id: &str, title: &str, content: Html) {
        if content.is_empty() {
            return;
        }
        let content = Html::trusted("\n<h2>")
            .then(title)
            .then(Html::trusted("</h2>\n"))
            .then(content);
        match id {
            "" => self.element("section", "", content),
            id => self.element_with_id("section", id, "", content),
        }
    }

    /// Appends the reasons not to rely on a result, `what`; nothing if there are none.
    pub(crate) fn unreliable(&mut self, reasons: &[String], what: &str) {
        let mut list = Html::new();
        list.list("", reasons.iter().map(|reason| capitalized(reason)));
        if !list.is_empty() {
            let title = Html::of("p", "title", format!("Do not rely on this {what}"));
            let content = title.then("\n").then(list).0;
            self.0 += &format!("<div class=\"unreliable\" role=\"alert\">{content}</div>\n");
        }
    }

    /// Appends the statement about the verification certificate of the model.
    pub(crate) fn certificate(&mut self, note: &CertificateNote) {
        let class = if note.is_verified() { "calm" } else { "note" };
        self.element_with_id("p", "certificate", class, note.sentence());
    }

    /// Appends a section on the faults of the measured data; nothing if there are none.
    pub(crate) fn data_faults(&mut self, faults: &[DataFault]) {
        if faults.is_empty() {
            return;
        }
        let mut content = Html::new();
        content.paragraph(format!(
            "{} found in the measured data. The flights concerned are excluded, unless --trust-data is given.",
            counted(faults.len(), "fault")
        ));
        content.table(&data_faults(faults));
        if faults.len() > MAX_FAULTS {
            let all = faults.len();
            content.note(format!(
                "The first {MAX_FAULTS} of {all}; all are in report.json."
            ));
        }
        self.section("data-faults", "Faults of the data", content);
    }
}

/// One HTML page.
#[derive(Clone, Debug, Default)]
pub struct Page {
    /// Command that created the page, such as `hyzer design`.
    pub kind: &'static str,
    /// Title of the page, as text for the browser.
    pub title: String,
    /// Heading of the page, whose secondary words may be in `span` elements; empty if it is the title.
    pub heading: Html,
    /// Content of the page.
    pub body: Html,
}

impl Page {
    /// Renders the page as one self-contained file.
    pub fn html(&self) -> String {
        let title = Html::from(&self.title);
        let heading = if self.heading.is_empty() {
            &title
        } else {
            &self.heading
        };
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n<style>\n{STYLE}{}</style>\n\
             </head>\n<body>\n<main>\n<header>\n<p class=\"kind\">{}</p>\n<h1>{}</h1>\n</header>\n{}</main>\n</body>\n\
             </html>\n",
            title.0,
            include_str!("page.css"),
            self.kind,
            heading.0,
            self.body.0,
        )
    }
}

/// Table of the first [`MAX_FAULTS`] faults of the measured data.
pub(crate) fn data_faults(faults: &[DataFault]) -> Table {
    use Column::{File, Plain, Text};
    let mut table = Table::new()
        .with(File, &["flight"])
        .with(Plain, &["fault"])
        .with(Text, &["found", "correction"]);
    for fault in faults.iter().take(MAX_FAULTS) {
        table.row([
            (&fault.file).into(),
            fault.fault.name().replace('_', " ").into(),
            (&fault.detail).into(),
            (&fault.correction).into(),
        ]);
    }
    table
}

/// Link to the CSV table of a figure: a data URI, or the path of the file if the table is large.
fn table_link(figure: &Figure) -> Html {
    let to = match figure.csv.len() <= MAX_EMBEDDED {
        true => format!("data:text/csv;charset=utf-8,{}", encoded(&figure.csv)),
        false => figure.table_path(),
    };
    let (name, path) = (escape(&figure.name), escape(&figure.table_path()));
    Html(format!(
        "<a class=\"csv\" download=\"{name}.csv\" href=\"{}\" title=\"The numbers behind the figure, also in {path}\">CSV</a>",
        escape(&to)
    ))
}

/// Percent-encodes the characters that the path of a data URI or the fragment of a link must not contain; control
/// characters are dropped.
pub(crate) fn encoded(text: &str) -> String {
    let mut encoded = String::with_capacity(text.len() + text.len() / 8);
    for c in text.chars() {
        match c {
            '%' | '#' | '"' | '<' | '>' | ' ' | '&' | '\'' | '\n' | '\r' => {
                encoded += &format!("%{:02X}", u32::from(c));
            }
            c if c.is_control() => {}
            c => encoded.push(c),
        }
    }
    encoded
}

/// Link to a flight in the page of flights in three dimensions; `name` is its name there.
pub(crate) fn flight_link(name: &str, text: &str) -> Html {
    Html::link(&format!("flights.html#{}", encoded(name)), text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::{Layout, Line, Panel};

    #[test]
    fn texts_are_escaped_and_figures_are_drawn_twice() {
        let mut table = Table::new()
            .with(Column::Name, &["name"])
            .with(Column::Number, &["value, m"]);
        table.row(["<x>".into(), "1.5".into()]);
        let panel = Panel {
            lines: vec![Line {
                name: String::new(),
                points: vec![(0.0, 0.0), (1.0, 2.0)],
            }],
            ..Panel::default()
        };
        let mut body = Html::new();
        body.table(&table);
        body.figure(
            &Figure::of_panels("path", "", "", Layout::COLUMN, &[panel]),
            true,
        );
        let page = Page {
            title: "A <b> & c".into(),
            body,
            ..Page::default()
        };
        let html = page.html();
        assert!(html.contains("A &lt;b&gt; &amp; c") && html.contains("&lt;x&gt;"));
        assert!(!html.contains("<x>") && !html.contains("http-equiv"));
        assert_eq!(html.matches("<svg").count(), 2);
        assert_eq!(html.matches("<td class=\"n\">1.5").count(), 1);
        assert_eq!(
            html.matches("<th").count() - html.matches("<thead").count(),
            html.matches(" scope=").count()
        );
    }
}
