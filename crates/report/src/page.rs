//! Self-contained HTML pages: paragraphs, tables and figures in sections.

use flight::files::ResultFile;
use identify::DataFault;

use crate::faults::data_faults;
use crate::figure::Figure;
use crate::figures::svg::{STYLE, escape, without_style};
use crate::html::Html;
use crate::table::Table;
use crate::thin::MAX_ROWS;
use identify::wording::{capitalized, counted};

/// Maximum size in bytes of a CSV table that is embedded in a page; the page links to the file of a larger table.
const MAX_EMBEDDED: usize = 10_000;

impl Html {
    /// Appends a table; nothing if it has no rows.
    pub fn table(&mut self, table: &Table) {
        if !table.is_empty() {
            self.scrolled("div", "scroll", Html::from("\n").then(table.html()));
        }
    }

    /// Appends a figure, with its caption if `captioned`.
    pub fn figure(&mut self, figure: Figure, captioned: bool) {
        self.drawn(figure, captioned, "-1");
    }

    /// Appends a figure with its caption, in which the keyboard reaches the points with tooltips.
    pub(crate) fn leading_figure(&mut self, figure: Option<Figure>) {
        if let Some(figure) = figure {
            self.drawn(figure, true, "0");
        }
    }

    fn drawn(&mut self, figure: Figure, captioned: bool, tab_index: &str) {
        let mut svg = without_style(&figure.svg);
        if let Some(narrow) = &figure.narrow {
            let narrow = without_style(narrow);
            let class = match figure.is_full {
                true => "wide full",
                false => "wide",
            };
            svg = format!("<div class=\"{class}\">{svg}</div><div class=\"narrow\">{narrow}</div>");
        }
        let index = format!("tabindex=\"{tab_index}\"");
        let mut caption = Html::new();
        if captioned {
            caption.push(&figure.caption);
        }
        if !figure.csv.is_empty() {
            caption.push(if captioned { " " } else { "" });
            caption.push(table_link(&figure));
        }
        let mut content = Html::trusted(svg.replace("tabindex=\"-1\"", &index) + "\n");
        if !caption.is_empty() {
            content.push(Html::of("figcaption", "", caption));
        }
        self.element_with_id("figure", &figure.name, "", content);
        self.figures.push(figure);
    }

    /// Appends what a page begins with: the words, beside them a figure, and below them what is `gain`.
    pub(crate) fn opening(&mut self, lead: Html, picture: Html, gain: Html) {
        let mut opening = Html::from("\n");
        opening.element("div", "words lead", lead);
        opening.element("div", "picture", picture);
        opening.element("div", "gain", gain);
        self.element("div", "opening", opening);
    }

    /// Appends figures one below the other.
    pub fn figures(&mut self, figures: impl IntoIterator<Item = Figure>, captioned: bool) {
        for figure in figures {
            self.figure(figure, captioned);
        }
    }

    /// Appends small figures side by side; those beyond the first `open` are folded.
    pub fn grid(&mut self, mut figures: Vec<Figure>, open: usize, captioned: bool) {
        let grid = |figures: Vec<Figure>| {
            let (mut content, mut grid) = (Html::new(), Html::new());
            content.figures(figures, captioned);
            if !content.is_empty() {
                grid.element("div", "grid", Html::from("\n").then(content));
            }
            grid
        };
        let rest = figures.split_off(open.min(figures.len()));
        self.push(grid(figures));
        self.folded(format!("{} more", rest.len()), grid(rest));
    }

    /// Appends the reasons not to rely on a result, `what`; nothing if there are none.
    pub(crate) fn unreliable(&mut self, reasons: &[String], what: &str) {
        let mut list = Html::new();
        list.list("", reasons.iter().map(|reason| capitalized(reason)));
        if !list.is_empty() {
            let title = Html::of("p", "title", format!("Do not rely on this {what}"));
            let open = Html::trusted("<div class=\"unreliable\" role=\"alert\">");
            let content = open.then(title).then("\n").then(list);
            self.push(content.then(Html::trusted("</div>\n")));
        }
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
        let all = faults.len();
        if all > MAX_ROWS {
            content.note(format!(
                "The first {MAX_ROWS} of {all}; all are in report.json."
            ));
        }
        self.section("data-faults", "Faults of the data", content);
    }
}

/// Heading of a page: two names, and between them words in small letters.
pub(crate) fn heading(name: &str, words: &'static str, other: &str) -> Html {
    let words = Html::of("span", "", words);
    Html::from(name).then(" ").then(words).then(" ").then(other)
}

/// One HTML page.
#[derive(Clone, Debug, Default)]
pub struct Page {
    /// Command that created the page.
    pub kind: &'static str,
    /// Title for the browser.
    pub title: String,
    /// Heading, whose secondary words may be in `span` elements; empty if it is the title.
    pub heading: Html,
    /// Content.
    pub body: Html,
}

impl Page {
    /// Renders the page as one self-contained file.
    pub fn html(&self) -> String {
        let title = Html::from(&self.title);
        let has_heading = !self.heading.is_empty();
        let heading = if has_heading { &self.heading } else { &title };
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n<style>\n{STYLE}{}</style>\n\
             </head>\n<body>\n<main>\n<header>\n<p class=\"kind\">{}</p>\n<h1>{}</h1>\n</header>\n{}</main>\n</body>\n\
             </html>\n",
            title.as_str(),
            include_str!("page.css"),
            self.kind,
            heading.as_str(),
            self.body.as_str(),
        )
    }

    /// The page as one self-contained file, and its figures in order of appearance.
    pub fn parts(self) -> (String, Vec<Figure>) {
        (self.html(), self.body.figures)
    }

    /// Result files of the page: `report.html`, and those of its figures.
    pub fn files(self) -> impl Iterator<Item = ResultFile> {
        let (html, figures) = self.parts();
        let page = std::iter::once(ResultFile::new("report.html", html));
        page.chain(figures.into_iter().flat_map(Figure::files))
    }
}

/// Link to the CSV table of a figure: a data URI, or the path of the file if the table is large.
fn table_link(figure: &Figure) -> Html {
    let to = if figure.csv.len() <= MAX_EMBEDDED {
        format!("data:text/csv;charset=utf-8,{}", encoded(&figure.csv))
    } else {
        figure.table_path()
    };
    let (name, path) = (escape(&figure.name), escape(&figure.table_path()));
    Html::trusted(format!(
        "<a class=\"csv\" download=\"{name}.csv\" href=\"{}\" title=\"The numbers behind the figure, also in {path}\">CSV</a>",
        escape(&to)
    ))
}

/// Percent-encodes the path of a data URI or the fragment of a link.
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

/// Link to a flight, by its name in the page of flights in three dimensions.
pub(crate) fn flight_link(name: &str, text: &str) -> Html {
    Html::link(&format!("flights.html#{}", encoded(name)), text)
}

/// Sentence on the page of flights in three dimensions.
pub(crate) fn watch() -> Html {
    let link = Html::link("flights.html", "flights.html");
    Html::from("The flights can be watched in ")
        .then(link)
        .then(".")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::{Layout, Panel};

    #[test]
    fn texts_are_escaped_and_figures_are_drawn_twice() {
        let table = Table::of([("<x>", "1.5")])
            .name("name", |row| row.0)
            .number("value, m", |row| row.1)
            .table();
        let panel = Panel::default().line("", [(0.0, 0.0), (1.0, 2.0)]);
        let mut body = Html::new();
        body.table(&table);
        body.figure(
            Figure::of_panels("path", "", "", Layout::COLUMN, &[panel]),
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
