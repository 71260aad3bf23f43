//! Figure of a report: SVG for wide and for narrow screens, caption and CSV table.

use flight::files::ResultFile;

use crate::figures::chart::Chart;
use crate::figures::csv::of_panels;
use crate::figures::svg::escape;
use crate::figures::triangle::Triangle;
use crate::figures::{Layout, Panel, figure_of};

/// Figure of a report.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// File name without `.svg`; consists of letters, digits and hyphens.
    pub name: String,
    /// Title.
    pub title: String,
    /// Caption: how to read the figure; also the description for screen readers.
    pub caption: String,
    /// SVG text.
    pub svg: String,
    /// Whether the first SVG is as wide as a page.
    pub is_full: bool,
    /// SVG text for narrow screens; `None` if the first fits them.
    pub narrow: Option<String>,
    /// CSV table of the data shown; empty if the page does not offer it.
    pub csv: String,
}

impl Figure {
    /// Figure from its caption and CSV table (`texts`), drawn for the layout `wide` and for narrow screens.
    pub(crate) fn in_layouts(
        name: impl Into<String>,
        title: &str,
        [caption, csv]: [String; 2],
        wide: Layout,
        draw: &dyn Fn(Layout) -> String,
    ) -> Figure {
        let drawn = |layout| described(&draw(layout), &caption);
        Figure {
            name: name.into(),
            title: title.to_owned(),
            svg: drawn(wide),
            is_full: wide.width > Layout::COLUMN.width,
            narrow: (wide != Layout::SMALL).then(|| drawn(Layout::SMALL)),
            caption,
            csv,
        }
    }

    /// Figure of panels, with their data as CSV table.
    pub fn of_panels(
        name: impl Into<String>,
        title: &str,
        caption: impl Into<String>,
        wide: Layout,
        panels: &[Panel],
    ) -> Figure {
        let texts = [caption.into(), of_panels(panels)];
        Figure::in_layouts(name, title, texts, wide, &|layout| {
            figure_of(layout, title, panels)
        })
    }

    pub(crate) fn of_chart(name: &str, chart: &Chart, caption: &str, wide: Layout) -> Figure {
        let texts = [caption.to_owned(), chart.csv()];
        Figure::in_layouts(name, &chart.title, texts, wide, &|layout| {
            chart.draw(layout)
        })
    }

    pub(crate) fn of_triangle(
        name: &str,
        triangle: &Triangle<'_>,
        caption: &str,
        wide: Layout,
    ) -> Figure {
        let texts = [caption.to_owned(), triangle.csv()];
        Figure::in_layouts(name, triangle.title, texts, wide, &|layout| {
            triangle.draw(layout)
        })
    }

    /// Path of the CSV table, beside the page.
    pub(crate) fn table_path(&self) -> String {
        format!("figure-data/{}.csv", self.name)
    }

    /// Result files of the figure: SVG and CSV table.
    pub fn files(self) -> [ResultFile; 2] {
        let table = self.table_path();
        [
            ResultFile::new(self.name + ".svg", self.svg),
            ResultFile::new(table, self.csv),
        ]
    }
}

/// Adds a text description for screen readers to an SVG.
fn described(svg: &str, words: &str) -> String {
    let more = format!("</title>\n<desc>{}</desc>\n", escape(words));
    svg.replacen("</title>\n", &more, 1)
}
