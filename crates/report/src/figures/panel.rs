//! One panel: axes, lines, dots.

use super::axis::number;
use super::layout::{Layout, Scale};
use super::svg::{Svg, cut};

/// A line with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its name, shown at its end.
    pub name: String,
    /// Its points; it is broken where one is not finite.
    pub points: Vec<(f64, f64)>,
}

/// Something that happens at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Its name.
    pub name: String,
    /// Where, on both axes; a place on the first axis alone where the second is not finite.
    pub at: (f64, f64),
}

/// Points that no line joins.
#[derive(Clone, Debug, PartialEq)]
pub struct Dots {
    /// How they look.
    pub look: Look,
    /// Where; one that is not finite is left out.
    pub points: Vec<(f64, f64)>,
}

/// How dots look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// In the colour of the line of this index.
    Colour(usize),
    /// Grey, behind what matters.
    Pale,
    /// Small crosses.
    Cross,
}

/// A bar on the horizontal axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Its height.
    pub height: f64,
}

/// Lines over one pair of axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Title: what is shown, and its unit.
    pub title: String,
    /// Title of the horizontal axis, with its unit.
    pub across: String,
    /// At most four lines.
    pub lines: Vec<Line>,
    /// Whether the lines are thin and unbroken, for dots to lie upon.
    pub thin: bool,
    /// Dots, above the lines.
    pub dots: Vec<Dots>,
    /// Bars, which stand on 0.
    pub bars: Vec<Bar>,
    /// Events.
    pub marks: Vec<Mark>,
    /// Heights that a broken line is drawn at.
    pub levels: Vec<f64>,
    /// Heights between which the ground is shaded.
    pub band: Option<(f64, f64)>,
    /// Range of the vertical axis; by what is drawn where none is given.
    pub up: Option<(f64, f64)>,
    /// Height of the plot, where it is not the usual one.
    pub height: Option<f64>,
    /// Whether one unit is as long on both axes.
    pub map: bool,
    /// Least and greatest height of a map, where they are not the usual ones.
    pub heights: Option<(f64, f64)>,
    /// Whether points of equal coordinates are joined by a line.
    pub diagonal: bool,
}

/// A figure of panels, one below the other.
pub fn figure(title: &str, panels: &[Panel]) -> String {
    figure_of(Layout::COLUMN, title, panels)
}

/// The same in another width.
pub fn figure_of(layout: Layout, title: &str, panels: &[Panel]) -> String {
    let layout = layout.fitted(panels);
    let mut svg = Svg::new();
    let shown = cut(title, layout.width - 20.0, 1.25 * layout.letter());
    svg.text(
        "title",
        (layout.margin, 2.0 * layout.letters),
        "start",
        &shown,
    );
    let mut top = 2.0 * layout.letters + 8.0;
    for panel in panels {
        top = panel.draw(&mut svg, &layout, top);
    }
    let size = (layout.width, top + 6.0);
    svg.finish(title, size, layout.most, layout.letters)
}

impl Panel {
    /// Draws the panel below `top` and gives where it ends.
    fn draw(&self, svg: &mut Svg, layout: &Layout, top: f64) -> f64 {
        let scale = self.scale(layout, top);
        let (width, letter) = (layout.width, layout.letter());
        let title = cut(&self.title, width - 20.0, 1.05 * letter);
        svg.text("panel", (layout.margin, scale.top - 11.0), "start", &title);
        self.draw_ground(svg, &scale);
        self.draw_axes(svg, &scale, layout.letters);

        self.draw_marks(svg, &scale, width, letter);
        let kind = if self.thin { 't' } else { 'c' };
        for (i, line) in self.lines.iter().enumerate() {
            let points = line.points.iter();
            svg.path(
                &format!("{kind}{}", i % 4),
                points.map(|(x, y)| (scale.x(*x), scale.y(*y))),
            );
        }
        for dots in &self.dots {
            let points = dots.points.iter();
            let points = points.map(|(x, y)| (scale.x(*x), scale.y(*y)));
            match dots.look {
                Look::Colour(i) => svg.dots(&format!("d{}", i % 4), points),
                Look::Pale => svg.dots("dg", points),
                Look::Cross => svg.crosses("dx", points),
            }
        }
        self.draw_places(svg, &scale, width, letter);
        self.draw_names(svg, &scale, width, letter);
        scale.bottom() + layout.below
    }

    /// What lies behind the axes.
    fn draw_ground(&self, svg: &mut Svg, scale: &Scale) {
        if let Some((low, high)) = self.band {
            let (top, bottom) = (scale.y(high), scale.y(low));
            if top.is_finite() && bottom.is_finite() {
                let top = top.max(scale.top);
                let size = (scale.width, bottom.min(scale.bottom()) - top);
                svg.block("band", (scale.left, top), size);
            }
        }
    }

    fn draw_axes(&self, svg: &mut Svg, scale: &Scale, letters: f64) {
        let (bottom, right) = (scale.bottom(), scale.right());
        let (at, decimals) = scale.ticks_across();
        for tick in at {
            let x = scale.x(tick);
            svg.line("grid", (x, scale.top), (x, bottom));
            let place = (x, bottom + 4.0 + letters);
            svg.text("tick", place, "middle", &number(tick, decimals));
        }
        let place = (scale.left + scale.width / 2.0, bottom + 8.0 + 2.0 * letters);
        svg.text("across", place, "middle", &self.across);
        let (at, decimals) = scale.ticks_up();
        for tick in at {
            let y = scale.y(tick);
            let class = if tick == 0.0 { "zero" } else { "grid" };
            svg.line(class, (scale.left, y), (right, y));
            let place = (scale.left - 7.0, y + 5.0);
            svg.text("tick", place, "end", &number(tick, decimals));
        }
        for bar in &self.bars {
            let (left, end) = (scale.x(bar.from), scale.x(bar.to));
            let y = scale.y(bar.height);
            // A hair of ground between neighbours.
            svg.block("bar", (left + 0.5, y), (end - left - 1.0, bottom - y));
        }
        svg.line("axis", (scale.left, bottom), (right, bottom));
        svg.line("axis", (scale.left, scale.top), (scale.left, bottom));
        for level in self.levels.iter().filter(|level| level.is_finite()) {
            let y = scale.y(*level);
            svg.line("level", (scale.left, y), (right, y));
        }
        if self.diagonal {
            let low = scale.across.0.max(scale.up.0);
            let high = scale.across.1.min(scale.up.1);
            let ends = [low, high].map(|v| (scale.x(v), scale.y(v)));
            svg.path("diagonal", ends.into_iter());
        }
    }
}
