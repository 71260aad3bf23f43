//! Contents of a panel: lines, dots and bars with one pair of axes.

/// Line through points, with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Name at the line's end; may be empty.
    pub name: String,
    /// Points in data units; the line is interrupted where they are not finite.
    pub points: Vec<(f64, f64)>,
}

impl Line {
    /// Line through `points`, with its name.
    pub fn new(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Line {
        Line {
            name: name.into(),
            points: points.into_iter().collect(),
        }
    }
}

/// Labelled event or limit, drawn as a dot or a vertical line.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Label; may be empty.
    pub name: String,
    /// Position in data units; a vertical line if y is not finite.
    pub at: (f64, f64),
}

impl Mark {
    /// Mark at a point.
    pub fn new(name: impl Into<String>, at: (f64, f64)) -> Mark {
        let name = name.into();
        Mark { name, at }
    }

    /// Vertical line at `x`.
    pub fn vertical(name: impl Into<String>, x: f64) -> Mark {
        Mark::new(name, (x, f64::NAN))
    }
}

/// Points with one style.
#[derive(Clone, Debug, PartialEq)]
pub struct Dots {
    /// Style.
    pub look: Look,
    /// Points in data units; those that are not finite are not drawn.
    pub points: Vec<(f64, f64)>,
}

impl Dots {
    /// Dots at `points`.
    pub fn new(look: Look, points: impl IntoIterator<Item = (f64, f64)>) -> Dots {
        let points = points.into_iter().collect();
        Dots { look, points }
    }
}

/// Style of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// In the colour of the line with this index.
    Colour(usize),
    /// Grey, behind all others.
    Pale,
    /// Small crosses.
    Cross,
}

/// Bar of a histogram, in data units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// Left edge.
    pub from: f64,
    /// Right edge.
    pub to: f64,
    /// Height.
    pub height: f64,
}

impl Bar {
    /// Bars between the midpoints of the points (x, height), which are in ascending order of x.
    pub(crate) fn between_midpoints(points: &[(f64, f64)]) -> Vec<Bar> {
        let middle = |i: usize| 0.5 * (points[i].0 + points[i + 1].0);
        let bar = |(i, &(x, height)): (usize, &(f64, f64))| Bar {
            from: if i == 0 { x } else { middle(i - 1) },
            to: if i + 1 == points.len() { x } else { middle(i) },
            height,
        };
        points.iter().enumerate().map(bar).collect()
    }
}

/// Panel of a figure: what has one pair of axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Title: the quantity on the vertical axis, with its unit.
    pub title: String,
    /// Title of the horizontal axis.
    pub across: String,
    /// Lines; four have distinct colours.
    pub lines: Vec<Line>,
    /// Whether the lines are thin and solid, as a background for dots.
    pub thin: bool,
    /// Points, in front of the lines.
    pub dots: Vec<Dots>,
    /// Bars of a histogram.
    pub bars: Vec<Bar>,
    /// Labelled events and limits.
    pub marks: Vec<Mark>,
    /// Heights of dashed horizontal lines.
    pub levels: Vec<f64>,
    /// Shaded range of the vertical axis, such as the noise level.
    pub band: Option<(f64, f64)>,
    /// Shaded band behind the lines: points (x, lower, upper).
    pub ribbon: Vec<(f64, f64, f64)>,
    /// Range of the vertical axis; by default that of the data.
    pub up: Option<(f64, f64)>,
    /// Range of the horizontal axis; by default that of the data.
    pub along: Option<(f64, f64)>,
    /// Height of the plot area, SVG units; by default that of the layout.
    pub height: Option<f64>,
    /// Whether both axes have the same scale.
    pub map: bool,
    /// Smallest and largest height of a map, SVG units.
    pub heights: Option<(f64, f64)>,
    /// Whether the line y = x is drawn.
    pub diagonal: bool,
}

impl Panel {
    /// Panel without contents, with the titles of its axes.
    pub fn new(title: impl Into<String>, across: impl Into<String>) -> Panel {
        Panel {
            title: title.into(),
            across: across.into(),
            ..Panel::default()
        }
    }

    /// Adds a line.
    #[must_use]
    pub fn line(
        mut self,
        name: impl Into<String>,
        points: impl IntoIterator<Item = (f64, f64)>,
    ) -> Panel {
        self.lines.push(Line::new(name, points));
        self
    }

    /// Adds dots.
    #[must_use]
    pub fn dots(mut self, look: Look, points: impl IntoIterator<Item = (f64, f64)>) -> Panel {
        self.dots.push(Dots::new(look, points));
        self
    }
}

/// Panel of numbers of samples below another panel: points (x, number) in ascending order of x.
pub(crate) fn samples_below(across: String, points: &[(f64, f64)]) -> Panel {
    Panel {
        bars: Bar::between_midpoints(points),
        height: Some(44.0),
        ..Panel::new("Samples", across)
    }
}

#[cfg(test)]
mod tests {
    use super::Bar;

    #[test]
    fn bars_meet_half_way_between_their_points() {
        let bars = Bar::between_midpoints(&[(0.0, 1.0), (2.0, 3.0), (6.0, 2.0)]);
        let edges: Vec<[f64; 3]> = bars
            .iter()
            .map(|own| [own.from, own.to, own.height])
            .collect();
        assert_eq!(edges, [[0.0, 1.0, 1.0], [1.0, 4.0, 3.0], [4.0, 6.0, 2.0]]);
    }
}
