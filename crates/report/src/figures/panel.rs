//! One panel: axes, lines, names.

use super::axis::{number, range, ticks, with_room};
use super::svg::Svg;

/// Width of a figure; heights follow from what is in it.
const WIDTH: f64 = 520.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 44.0;
const PLOT: f64 = WIDTH - LEFT - RIGHT;
/// Space above a panel, for its title.
const ABOVE: f64 = 36.0;
/// Space below it, for the numbers and the title of its axis.
const BELOW: f64 = 46.0;
/// Height of a plot in time, and least and greatest of a map.
const HEIGHT: f64 = 150.0;
const MAP_HEIGHTS: (f64, f64) = (90.0, 340.0);
/// Names at the ends of lines stand this far apart at least.
const LETTER: f64 = 16.0;

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

/// Lines over one pair of axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Title: what is shown, and its unit.
    pub title: String,
    /// Title of the horizontal axis, with its unit.
    pub across: String,
    /// At most four lines.
    pub lines: Vec<Line>,
    /// Events.
    pub marks: Vec<Mark>,
    /// Whether one unit is as long on both axes.
    pub map: bool,
}

/// A figure of panels, one below the other.
pub fn figure(title: &str, panels: &[Panel]) -> String {
    let mut svg = Svg::new();
    svg.text("title", (14.0, 28.0), "start", title);
    let mut top = 36.0;
    for panel in panels {
        top = panel.draw(&mut svg, top);
    }
    svg.finish(title, WIDTH, top + 6.0)
}

/// From numbers to places on the figure.
struct Scale {
    across: (f64, f64),
    up: (f64, f64),
    top: f64,
    height: f64,
}

impl Scale {
    fn x(&self, value: f64) -> f64 {
        LEFT + PLOT * (value - self.across.0) / (self.across.1 - self.across.0)
    }
    fn y(&self, value: f64) -> f64 {
        self.top + self.height * (self.up.1 - value) / (self.up.1 - self.up.0)
    }
}

impl Panel {
    fn scale(&self, top: f64) -> Scale {
        let points = || {
            self.lines
                .iter()
                .flat_map(|line| line.points.iter().copied())
        };
        let mut across = range(points().map(|p| p.0));
        let mut up = with_room(range(points().map(|p| p.1)));
        let mut height = HEIGHT;
        if self.map {
            across = with_room(across);
            let (wide, tall) = (across.1 - across.0, up.1 - up.0);
            height = (PLOT * tall / wide).clamp(MAP_HEIGHTS.0, MAP_HEIGHTS.1);
            // Whichever axis has room to spare shows more, so that both have one scale.
            let unit = (PLOT / wide).min(height / tall);
            across = about(across, PLOT / unit);
            up = about(up, height / unit);
        } else if across.0 == across.1 {
            across = with_room(across);
        }
        Scale {
            across,
            up,
            top: top + ABOVE,
            height,
        }
    }

    /// Draws the panel below `top` and gives where it ends.
    fn draw(&self, svg: &mut Svg, top: f64) -> f64 {
        let scale = self.scale(top);
        let (bottom, right) = (scale.top + scale.height, LEFT + PLOT);
        svg.text("panel", (14.0, scale.top - 11.0), "start", &self.title);

        let (at, decimals) = ticks(scale.across, 6);
        for tick in at {
            let x = scale.x(tick);
            svg.line("grid", (x, scale.top), (x, bottom));
            svg.text(
                "tick",
                (x, bottom + 18.0),
                "middle",
                &number(tick, decimals),
            );
        }
        svg.text(
            "across",
            (LEFT + PLOT / 2.0, bottom + 36.0),
            "middle",
            &self.across,
        );
        let most = (scale.height / 30.0).clamp(3.0, 5.0) as usize;
        let (at, decimals) = ticks(scale.up, most);
        for tick in at {
            let y = scale.y(tick);
            svg.line(
                if tick == 0.0 { "zero" } else { "grid" },
                (LEFT, y),
                (right, y),
            );
            svg.text(
                "tick",
                (LEFT - 7.0, y + 5.0),
                "end",
                &number(tick, decimals),
            );
        }
        svg.line("axis", (LEFT, bottom), (right, bottom));
        svg.line("axis", (LEFT, scale.top), (LEFT, bottom));

        self.draw_marks(svg, &scale);
        for (i, line) in self.lines.iter().enumerate() {
            svg.path(
                &format!("c{}", i % 4),
                line.points.iter().map(|(x, y)| (scale.x(*x), scale.y(*y))),
            );
        }
        self.draw_dots(svg, &scale);
        self.draw_names(svg, &scale);
        bottom + BELOW
    }

    /// Names at the lines' ends, moved apart where they would overlap, and kept within the panel.
    fn draw_names(&self, svg: &mut Svg, scale: &Scale) {
        let last = |line: &Line| {
            line.points
                .iter()
                .rev()
                .find(|p| p.1.is_finite())
                .map(|p| scale.y(p.1))
        };
        let mut names: Vec<(f64, usize)> = self
            .lines
            .iter()
            .enumerate()
            .filter_map(|(i, l)| Some((last(l)?, i)))
            .collect();
        names.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut least = scale.top - 4.0;
        for name in &mut names {
            name.0 = name.0.max(least);
            least = name.0 + LETTER;
        }
        let mut greatest = scale.top + scale.height + 4.0;
        for name in names.iter_mut().rev() {
            name.0 = name.0.min(greatest);
            greatest = name.0 - LETTER;
        }
        // A map's lines end anywhere: their names are in its title.
        for (y, i) in names.into_iter().filter(|_| !self.map) {
            svg.text(
                &format!("c{}", i % 4),
                (LEFT + PLOT + 6.0, y + 5.0),
                "start",
                &self.lines[i].name,
            );
        }
    }

    /// Events that have a time alone: lines behind the others, with names above the plot.
    fn draw_marks(&self, svg: &mut Svg, scale: &Scale) {
        let mut free = LEFT + 150.0;
        for mark in self.marks.iter().filter(|mark| !mark.at.1.is_finite()) {
            let x = scale.x(mark.at.0);
            svg.line("mark", (x, scale.top), (x, scale.top + scale.height));
            // About seven units a letter; a name without room is left to the other panels.
            let half = 3.5 * mark.name.chars().count() as f64;
            let middle = x.min(WIDTH - 8.0 - half);
            if middle - half > free {
                svg.text("mark", (middle, scale.top - 4.0), "middle", &mark.name);
                free = middle + half + 6.0;
            }
        }
    }

    /// Events that have a place: dots, with names beside them where the fewest points of the lines are.
    fn draw_dots(&self, svg: &mut Svg, scale: &Scale) {
        let places = self.lines.iter().flat_map(|line| &line.points);
        let places: Vec<(f64, f64)> = places.map(|(x, y)| (scale.x(*x), scale.y(*y))).collect();
        let mut taken: Vec<Place> = Vec::new();
        for mark in self.marks.iter().filter(|mark| mark.at.1.is_finite()) {
            let (x, y) = (scale.x(mark.at.0), scale.y(mark.at.1));
            svg.dot("mark", (x, y));
            let wide = 7.0 * mark.name.chars().count() as f64;
            let corners = [
                (x + 7.0, y - 6.0),
                (x + 7.0, y + 17.0),
                (x - 7.0 - wide, y - 6.0),
                (x - 7.0 - wide, y + 17.0),
            ];
            let boxes = corners.map(|(left, base)| Place {
                left,
                right: left + wide,
                top: base - 12.0,
                bottom: base + 4.0,
            });
            let cost = |b: &Place| {
                let outside = b.left < LEFT || b.right > WIDTH - 4.0 || b.top < scale.top - 8.0;
                let below = b.bottom > scale.top + scale.height;
                let covered = places.iter().filter(|p| b.holds(**p)).count();
                1000 * usize::from(outside || below)
                    + 100 * taken.iter().filter(|t| t.meets(b)).count()
                    + covered
            };
            let Some(best) = boxes.into_iter().min_by_key(cost) else {
                continue;
            };
            svg.text("mark", (best.left, best.bottom - 4.0), "start", &mark.name);
            taken.push(best);
        }
    }
}

/// Where a name stands.
struct Place {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl Place {
    fn holds(&self, (x, y): (f64, f64)) -> bool {
        self.left < x && x < self.right && self.top < y && y < self.bottom
    }
    fn meets(&self, other: &Place) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

/// A range of this length with the same middle.
fn about((low, high): (f64, f64), length: f64) -> (f64, f64) {
    let middle = 0.5 * (low + high);
    (middle - 0.5 * length, middle + 0.5 * length)
}
