//! Layout of a figure: dimensions, and the map from data units to positions.

use super::axis::{number, range, ticks, with_room};
use super::panel::Panel;

/// Dimensions of a figure in SVG units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// Width.
    pub width: f64,
    /// Maximum width on a page, pixels.
    pub most: f64,
    /// Size of the text.
    pub letters: f64,
    /// Number of panels side by side.
    pub(super) columns: usize,
    /// Left margin of titles.
    pub(super) margin: f64,
    pub(super) left: f64,
    pub(super) right: f64,
    /// Default height of the plot area of a panel.
    pub(super) height: f64,
    /// Space above a plot area for its title.
    pub(super) above: f64,
    /// Space below a plot area for tick labels and axis title.
    pub(super) below: f64,
}

impl Layout {
    /// In a text column.
    pub const COLUMN: Layout = Layout {
        width: 520.0,
        most: 640.0,
        letters: 14.0,
        columns: 1,
        margin: 14.0,
        left: 62.0,
        right: 44.0,
        height: 150.0,
        above: 36.0,
        below: 46.0,
    };
    /// One of several in a row, or as wide as a phone.
    pub const SMALL: Layout = Layout {
        width: 360.0,
        most: 460.0,
        letters: 13.0,
        columns: 1,
        margin: 2.0,
        left: 44.0,
        right: 22.0,
        height: 118.0,
        above: 32.0,
        below: 42.0,
    };
    /// As wide as the page.
    pub const WIDE: Layout = Layout {
        width: 1080.0,
        most: 1180.0,
        left: 50.0,
        right: 22.0,
        ..Layout::SMALL
    };

    pub(super) fn plot(&self) -> f64 {
        self.width - self.left - self.right
    }

    /// Approximate mean width of a character.
    pub(crate) fn letter(&self) -> f64 {
        0.56 * self.letters
    }

    pub(crate) fn with_columns(self, columns: usize) -> Layout {
        Layout { columns, ..self }
    }

    pub(super) fn column(&self, index: usize) -> Layout {
        let wide = self.width / self.columns as f64;
        let start = wide * (index % self.columns) as f64;
        Layout {
            width: start + wide,
            margin: start + self.margin,
            left: start + self.left,
            ..*self
        }
    }

    /// The layout with margins wide enough for the tick labels and line names of `panels`.
    pub(super) fn fitted(mut self, panels: &[Panel]) -> Layout {
        let letter = self.letter();
        let (mut left, mut right) = (self.left, self.right);
        for panel in panels {
            let scale = panel.scale(&self.column(0), 0.0);
            let (at, decimals) = scale.ticks_up();
            for tick in at {
                left = left.max(15.0 + letter * number(tick, decimals).chars().count() as f64);
            }
            let names = panel.lines.iter().filter(|_| !panel.map);
            let longest = names.map(|l| l.name.chars().filter(|c| *c != '\u{307}').count());
            // Names are bold and therefore slightly wider.
            right = right.max(14.0 + 1.1 * letter * longest.max().unwrap_or(0) as f64);
        }
        let wide = self.width / self.columns as f64;
        self.left = left.min(0.3 * wide);
        self.right = right.min(0.25 * wide);
        self
    }
}

/// Smallest and largest height of a map, as fractions of its width.
const MAP_HEIGHTS: (f64, f64) = (0.22, 0.82);

/// Linear map of one panel from data units to positions.
pub(super) struct Scale {
    pub(super) across: (f64, f64),
    pub(super) up: (f64, f64),
    pub(super) left: f64,
    pub(super) width: f64,
    pub(super) top: f64,
    pub(super) height: f64,
}

impl Scale {
    pub(super) fn x(&self, value: f64) -> f64 {
        self.left + self.width * (value - self.across.0) / (self.across.1 - self.across.0)
    }
    pub(super) fn y(&self, value: f64) -> f64 {
        self.top + self.height * (self.up.1 - value) / (self.up.1 - self.up.0)
    }
    pub(super) fn bottom(&self) -> f64 {
        self.top + self.height
    }
    pub(super) fn right(&self) -> f64 {
        self.left + self.width
    }
    pub(super) fn ticks_up(&self) -> (Vec<f64>, usize) {
        scale_of(self.up, (self.height / 28.0).clamp(3.0, 5.0) as usize)
    }
    pub(super) fn ticks_across(&self) -> (Vec<f64>, usize) {
        let most = if self.width < 500.0 { 6.0 } else { 12.0 };
        scale_of(self.across, (self.width / 52.0).clamp(4.0, most) as usize)
    }
}

/// Tick values within a range and the decimals of their labels: about `most`, or twice that if fewer than three result.
fn scale_of(of: (f64, f64), most: usize) -> (Vec<f64>, usize) {
    let found = ticks(of, most);
    let is_few = found.0.len() < 3;
    if is_few { ticks(of, 2 * most) } else { found }
}

impl Panel {
    /// Map from data units to positions for a panel with its upper edge at `top`.
    pub(super) fn scale(&self, layout: &Layout, top: f64) -> Scale {
        let points = || {
            let lines = self.lines.iter().flat_map(|line| &line.points);
            let dots = self.dots.iter().flat_map(|dots| &dots.points);
            let ends = |r: &(f64, f64, f64)| [(r.0, r.1), (r.0, r.2)];
            let ribbon = self.ribbon.iter().flat_map(ends);
            lines.chain(dots).copied().chain(ribbon)
        };
        let bars = || self.bars.iter();
        let places = bars().flat_map(|bar| [bar.from, bar.to]);
        let found = range(points().map(|p| p.0).chain(places));
        let mut across = self.along.unwrap_or(found);
        let heights = bars().flat_map(|bar| [0.0, bar.height]);
        let levels = self.levels.iter().copied();
        let band = self.band.iter().flat_map(|(low, high)| [*low, *high]);
        let heights = points().map(|p| p.1).chain(heights);
        let whole = range(heights.chain(levels).chain(band));
        let mut up = self.up.unwrap_or_else(|| with_room(whole));
        if !self.bars.is_empty() && self.up.is_none() {
            // Bars start at 0.
            up.0 = 0.0;
        }
        let plot = layout.plot();
        let mut height = self.height.unwrap_or(layout.height);
        if self.map {
            across = with_room(across);
            let (wide, tall) = (across.1 - across.0, up.1 - up.0);
            let default = (MAP_HEIGHTS.0 * plot, MAP_HEIGHTS.1 * plot);
            let (least, most) = self.heights.unwrap_or(default);
            height = (plot * tall / wide).clamp(least, most);
            // The axis with spare space is extended to a longer range, so that both axes have equal scale.
            let unit = (plot / wide).min(height / tall);
            across = about(across, plot / unit);
            up = about(up, height / unit);
        } else if across.0 == across.1 {
            across = with_room(across);
        }
        Scale {
            across,
            up,
            left: layout.left,
            width: plot,
            top: top + layout.above,
            height,
        }
    }
}

/// Interval of the given length with the same centre as (`low`, `high`).
fn about((low, high): (f64, f64), length: f64) -> (f64, f64) {
    let middle = 0.5 * (low + high);
    (middle - 0.5 * length, middle + 0.5 * length)
}
