//! Figures: panels drawn one below the other or side by side, as SVG.

use super::axis::number;
use super::layout::{Layout, Scale};
use super::panel::{Dots, Look, Panel};
use super::svg::{Svg, cut};
use crate::thin::stride;
use identify::numbers::significant;

const MAX_VALUES: usize = 6;

/// Draws the panels one below the other, in a column of the default width, as SVG.
pub fn figure(title: &str, panels: &[Panel]) -> String {
    figure_of(Layout::COLUMN, title, panels)
}

/// Draws the panels one below the other with the dimensions of a layout, as SVG.
pub fn figure_of(layout: Layout, title: &str, panels: &[Panel]) -> String {
    let layout = layout.fitted(panels);
    let mut svg = Svg::new();
    let shown = cut(title, layout.width - 20.0, 1.25 * layout.letter());
    let place = (layout.margin, 2.0 * layout.letters);
    svg.text("title", place, "start", &shown);
    let mut top = 2.0 * layout.letters + 8.0;
    for row in panels.chunks(layout.columns) {
        let panels = row.iter().enumerate();
        let bottoms = panels.map(|(i, panel)| panel.draw(&mut svg, &layout.column(i), top));
        top = bottoms.fold(top, f64::max);
    }
    let size = (layout.width, top + 6.0);
    svg.finish(title, size, layout.most, layout.letters)
}

fn draw_dots<'d>(svg: &mut Svg, scale: &Scale, all: impl IntoIterator<Item = &'d Dots>) {
    for dots in all {
        let points = dots.points.iter();
        let points = points.map(|(x, y)| (scale.x(*x), scale.y(*y)));
        match dots.look {
            Look::Colour(i) => svg.dots(&format!("d{}", i % 4), points),
            Look::Pale => svg.dots("dg", points),
            Look::Cross => svg.crosses("dx", points),
        }
    }
}

impl Panel {
    /// Draws the panel with its upper edge at `top`; returns its lower edge.
    fn draw(&self, svg: &mut Svg, layout: &Layout, top: f64) -> f64 {
        let scale = self.scale(layout, top);
        let (width, letter) = (layout.width, layout.letter());
        let room = width - layout.margin - 18.0;
        let title = cut(&self.title, room, 1.05 * letter);
        svg.text("panel", (layout.margin, scale.top - 11.0), "start", &title);
        self.draw_ground(svg, &scale);
        self.draw_axes(svg, &scale, layout.letters);

        self.draw_ribbon(svg, &scale);
        self.draw_marks(svg, &scale, width, letter);
        let (behind, front): (Vec<_>, Vec<_>) =
            self.dots.iter().partition(|dots| dots.look == Look::Pale);
        draw_dots(svg, &scale, behind);
        let kind = if self.thin { 't' } else { 'c' };
        for (i, line) in self.lines.iter().enumerate() {
            let points = line.points.iter();
            let points = points.map(|(x, y)| (scale.x(*x), scale.y(*y)));
            svg.path(&format!("{kind}{}", i % 4), points);
        }
        draw_dots(svg, &scale, front);
        self.draw_places(svg, &scale, width, letter);
        self.draw_names(svg, &scale, width, letter);
        self.draw_values(svg, &scale, (width, letter));
        scale.bottom() + layout.below
    }

    /// Draws the band whose limits vary along x.
    fn draw_ribbon(&self, svg: &mut Svg, scale: &Scale) {
        let finite = |r: &&(f64, f64, f64)| [r.0, r.1, r.2].iter().all(|v| v.is_finite());
        let points: Vec<_> = self.ribbon.iter().filter(finite).collect();
        if points.len() < 2 {
            return;
        }
        let inside = |y: f64| scale.y(y).clamp(scale.top, scale.bottom());
        let upper = points.iter().map(|r| (scale.x(r.0), inside(r.2)));
        let lower = points.iter().rev().map(|r| (scale.x(r.0), inside(r.1)));
        svg.path("ribbon", upper.chain(lower));
    }

    /// Adds tooltips to the bars and to some points of the lines. `size` is the width of the figure and of one character.
    fn draw_values(&self, svg: &mut Svg, scale: &Scale, size: (f64, f64)) {
        let number = |v: f64| significant(v, 4);
        let mut value = |x: f64, y: f64, text: String| {
            let place = (scale.x(x), scale.y(y));
            let is_inside = scale.top <= place.1 && place.1 <= scale.bottom();
            if is_inside && place.0.is_finite() {
                svg.value(place, size, &text);
            }
        };
        for line in self.lines.iter().filter(|line| line.points.len() > 1) {
            let name = match line.name.as_str() {
                "" => String::new(),
                name => format!("{name}: "),
            };
            for (x, y) in stride(&line.points, MAX_VALUES) {
                value(x, y, format!("{name}{} at {}", number(y), number(x)));
            }
        }
        for bar in stride(&self.bars, 2 * MAX_VALUES) {
            let (from, to) = (number(bar.from), number(bar.to));
            let text = format!("{} from {from} to {to}", number(bar.height));
            value(0.5 * (bar.from + bar.to), bar.height, text);
        }
    }

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
            // A narrow gap separates adjacent bars.
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
