//! Generic page of paragraphs, tables and figures in sections, for results without a page template for their kind.

use minijinja::context;
use minijinja::value::Value;
use serde::Serialize;

use crate::figures::svg::without_style;
use crate::figures::{Layout, Panel, figure_of};
use crate::fit::page::{plain_values, rendered};
use flight::files::ResultFile;

/// HTML page of paragraphs, tables and figures.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    /// Command that created the page, such as `hyzer design`.
    pub kind: String,
    /// Title of the page.
    pub title: String,
    /// First paragraphs of the page, which state the main result.
    pub lead: Vec<String>,
    /// Warnings that a reader must know before using the result; may be empty.
    pub warnings: Vec<String>,
    /// Sections that follow the first paragraphs.
    pub sections: Vec<Section>,
}

/// Section of a page: heading, paragraphs, table and figures.
#[derive(Clone, Debug, Default)]
pub struct Section {
    /// Heading of the section.
    pub title: String,
    /// Paragraphs of text, shown before the table of the section.
    pub words: Vec<String>,
    /// Table of the section; not shown if it has no columns.
    pub table: Table,
    /// Figures of the section, after its table.
    pub figures: Vec<SheetFigure>,
}

/// Table with cells of text; the first column is aligned to the left, all others to the right.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Table {
    /// Headings of the columns.
    pub head: Vec<String>,
    /// Rows of cells, each with one cell for each column.
    pub rows: Vec<Vec<String>>,
}

/// Figure of a page: panels drawn one below the other.
#[derive(Clone, Debug, Default)]
pub struct SheetFigure {
    /// Name of the figure's file without `.svg`.
    pub name: String,
    /// Title, drawn above the panels.
    pub title: String,
    /// Caption that describes the figure.
    pub caption: String,
    /// Panels of the figure from top to bottom.
    pub panels: Vec<Panel>,
}

impl SheetFigure {
    /// Draws the figure with the width of a text column; returns the SVG text.
    pub fn svg(&self) -> String {
        figure_of(Layout::COLUMN, &self.title, &self.panels)
    }
}

impl Sheet {
    /// SVG file of each figure, in the order in which the figures appear on the page.
    pub fn figure_files(&self) -> impl Iterator<Item = ResultFile> {
        let figures = self.sections.iter().flat_map(|section| &section.figures);
        figures.map(|figure| ResultFile::new(format!("{}.svg", figure.name), figure.svg()))
    }

    /// Renders the page as one self-contained HTML file.
    pub fn html(&self) -> String {
        let safe = |svg: &str| Value::from_safe_string(without_style(svg));
        let figure = |figure: &SheetFigure| {
            context! {
                name => &figure.name,
                caption => &figure.caption,
                svg => safe(&figure.svg()),
                narrow => safe(&figure_of(Layout::SMALL, &figure.title, &figure.panels)),
            }
        };
        let section = |section: &Section| {
            context! {
                title => &section.title,
                words => &section.words,
                table => plain_values(&section.table),
                figures => section.figures.iter().map(figure).collect::<Vec<_>>(),
            }
        };
        let context = context! {
            kind => &self.kind,
            title => &self.title,
            lead => &self.lead,
            warnings => &self.warnings,
            sections => self.sections.iter().map(section).collect::<Vec<_>>(),
        };
        rendered(include_str!("sheet.html"), context)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_escaped_and_figures_are_drawn_twice() {
        let sheet = Sheet {
            title: "A <b> & c".into(),
            sections: vec![Section {
                title: "Path".into(),
                table: Table {
                    head: vec!["name".into(), "value, m".into()],
                    rows: vec![vec!["<x>".into(), "1.5".into()]],
                },
                figures: vec![SheetFigure {
                    name: "path".into(),
                    panels: vec![Panel {
                        lines: vec![crate::figures::Line {
                            name: String::new(),
                            points: vec![(0.0, 0.0), (1.0, 2.0)],
                        }],
                        ..Panel::default()
                    }],
                    ..SheetFigure::default()
                }],
                ..Section::default()
            }],
            ..Sheet::default()
        };
        let html = sheet.html();
        assert!(html.contains("A &lt;b&gt; &amp; c") && html.contains("&lt;x&gt;"));
        assert!(!html.contains("<x>") && !html.contains("http-equiv"));
        assert_eq!(html.matches("<svg").count(), 2);
        assert_eq!(html.matches("<td class=\"n\">1.5").count(), 1);
    }
}
