//! A page of words, tables and figures in sections: for results that need no page of their own kind.

use minijinja::context;
use minijinja::value::Value;
use serde::Serialize;

use crate::figures::svg::{STYLE, without_style};
use crate::figures::{Layout, Panel, figure_of};
use crate::fit::page::{plain_values, rendered};

/// A page.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    /// Command that made it, such as `hyzer design`.
    pub kind: String,
    /// Title.
    pub title: String,
    /// First paragraphs: the answer.
    pub lead: Vec<String>,
    /// What a reader must know before using the answer; may be empty.
    pub warnings: Vec<String>,
    /// The rest.
    pub sections: Vec<Section>,
}

/// Part of a page under a heading.
#[derive(Clone, Debug, Default)]
pub struct Section {
    /// Heading.
    pub title: String,
    /// Paragraphs.
    pub words: Vec<String>,
    /// A table; without columns there is none.
    pub table: Table,
    /// Figures.
    pub figures: Vec<SheetFigure>,
}

/// Table of texts; the first column is aligned to the left, others to the right.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Table {
    /// Names of the columns.
    pub head: Vec<String>,
    /// Cells, row by row.
    pub rows: Vec<Vec<String>>,
}

/// A figure: panels below one another.
#[derive(Clone, Debug, Default)]
pub struct SheetFigure {
    /// Name of its file without `.svg`.
    pub name: String,
    /// Title, drawn above it.
    pub title: String,
    /// What it shows, in words.
    pub caption: String,
    /// Its panels.
    pub panels: Vec<Panel>,
}

impl SheetFigure {
    /// The figure as SVG of column width.
    pub fn svg(&self) -> String {
        figure_of(Layout::COLUMN, &self.title, &self.panels)
    }
}

impl Sheet {
    /// Figures of all sections.
    pub fn figures(&self) -> impl Iterator<Item = &SheetFigure> {
        self.sections.iter().flat_map(|section| &section.figures)
    }

    /// The page: one file that loads nothing.
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
            css => Value::from_safe_string(include_str!("fit/page.css").to_owned()),
            style => Value::from_safe_string(STYLE.to_owned()),
            kind => &self.kind,
            title => &self.title,
            lead => &self.lead,
            warnings => &self.warnings,
            sections => self.sections.iter().map(section).collect::<Vec<_>>(),
            version => env!("CARGO_PKG_VERSION"),
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
