//! Contents of a panel: lines, dots and bars with one pair of axes.

/// Line through several points, with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Name, drawn at the line's end; may be empty.
    pub name: String,
    /// Points (x, y) in data units; the line is interrupted at points that are not finite.
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

/// Labelled event or limit in a panel, such as a landing or an end of a confidence interval, drawn as a dot or a
/// vertical line.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Label of the event; may be empty.
    pub name: String,
    /// Position (x, y) in data units. If y is not finite, the event is drawn as a vertical line at x.
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

/// Points of a scatter plot that share one style.
#[derive(Clone, Debug, PartialEq)]
pub struct Dots {
    /// Style with which the points are drawn.
    pub look: Look,
    /// Positions (x, y) in data units; points that are not finite are not drawn.
    pub points: Vec<(f64, f64)>,
}

impl Dots {
    /// Dots at `points`.
    pub fn new(look: Look, points: impl IntoIterator<Item = (f64, f64)>) -> Dots {
        let points = points.into_iter().collect();
        Dots { look, points }
    }
}

/// Style of scatter points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// Dots in the colour of the line with this index.
    Colour(usize),
    /// Grey dots, behind all other dots.
    Pale,
    /// Small crosses, used for outliers.
    Cross,
}

/// One bar of a histogram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// Position of the left edge on the x axis, data units.
    pub from: f64,
    /// Position of the right edge on the x axis, data units.
    pub to: f64,
    /// Height of the bar on the y axis, data units.
    pub height: f64,
}

impl Bar {
    /// Bars at the points (x, height), which are in ascending order of x. Each bar extends to the midpoints between its
    /// x and the neighbouring values of x. The first bar begins and the last bar ends at its own x.
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

/// Panel of a figure: lines, dots and bars with one pair of axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Title above the panel: the quantity on the vertical axis, with its unit.
    pub title: String,
    /// Title of the horizontal axis, with its unit.
    pub across: String,
    /// Lines of the panel; at most four have distinct colours.
    pub lines: Vec<Line>,
    /// Whether all lines are drawn thin and solid, as a background for dots.
    pub thin: bool,
    /// Scatter points of the panel, drawn on top of the lines.
    pub dots: Vec<Dots>,
    /// Bars of a histogram, which start at 0.
    pub bars: Vec<Bar>,
    /// Labelled events and limits, such as a landing, drawn as dots or vertical lines.
    pub marks: Vec<Mark>,
    /// Values on the vertical axis at which dashed horizontal lines are drawn.
    pub levels: Vec<f64>,
    /// Range (lower, upper) of the vertical axis that is shaded, such as the noise level.
    pub band: Option<(f64, f64)>,
    /// Band with limits that vary along x, such as a confidence band: points (x, lower, upper) in data units, drawn
    /// behind the lines.
    pub ribbon: Vec<(f64, f64, f64)>,
    /// Range (minimum, maximum) of the vertical axis; `None` computes it from the data.
    pub up: Option<(f64, f64)>,
    /// Range (minimum, maximum) of the horizontal axis; `None` computes it from the data.
    pub along: Option<(f64, f64)>,
    /// Height of the plot area, SVG units; `None` uses the default of the layout.
    pub height: Option<f64>,
    /// Whether both axes have the same scale, as in a map.
    pub map: bool,
    /// Minimum and maximum height of the plot area if `map` is set, SVG units; `None` uses default fractions of its
    /// width.
    pub heights: Option<(f64, f64)>,
    /// Whether the diagonal y = x is drawn, for comparison with equality.
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

/// Panel of the numbers of samples below another panel: points (x, number of samples) in ascending order of x.
pub(crate) fn samples_below(across: String, points: &[(f64, f64)]) -> Panel {
    Panel {
        bars: Bar::between_midpoints(points),
        height: Some(44.0),
        ..Panel::new("Samples", across)
    }
}
