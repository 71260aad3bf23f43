//! Contents of a panel: lines, dots and bars over one pair of axes.

/// A polyline with a label.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Label, shown at the line's end.
    pub name: String,
    /// Points (x, y) in data units; the line is interrupted at points that are not finite.
    pub points: Vec<(f64, f64)>,
}

/// A labelled event.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Label.
    pub name: String,
    /// Position (x, y) in data units; a vertical line at x where y is not finite.
    pub at: (f64, f64),
}

/// Points of a scatter plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Dots {
    /// Style of the points.
    pub look: Look,
    /// Positions (x, y) in data units; those that are not finite are not drawn.
    pub points: Vec<(f64, f64)>,
}

/// Style of scatter points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// Dots in the colour of the line of this index.
    Colour(usize),
    /// Grey dots, behind the others.
    Pale,
    /// Small crosses.
    Cross,
}

/// A bar of a histogram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// Left edge, data units.
    pub from: f64,
    /// Right edge, data units.
    pub to: f64,
    /// Height, data units.
    pub height: f64,
}

/// Lines, dots and bars over one pair of axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Title: what is shown, and its unit.
    pub title: String,
    /// Title of the horizontal axis, with its unit.
    pub across: String,
    /// Lines; at most four have distinct colours.
    pub lines: Vec<Line>,
    /// Whether lines are thin and solid, as a background for dots.
    pub thin: bool,
    /// Scatter points, drawn above the lines.
    pub dots: Vec<Dots>,
    /// Bars of a histogram, from 0 upwards.
    pub bars: Vec<Bar>,
    /// Labelled events.
    pub marks: Vec<Mark>,
    /// y values of dashed horizontal lines.
    pub levels: Vec<f64>,
    /// y range that is shaded.
    pub band: Option<(f64, f64)>,
    /// Band along x, such as a confidence band: points (x, lower, upper) in data units, drawn behind the lines.
    pub ribbon: Vec<(f64, f64, f64)>,
    /// Range of the vertical axis; from the data if `None`.
    pub up: Option<(f64, f64)>,
    /// Height of the plot, pixels; the layout's if `None`.
    pub height: Option<f64>,
    /// Whether both axes have the same scale.
    pub map: bool,
    /// Minimum and maximum height of a panel with equal scales, pixels; fractions of its width if `None`.
    pub heights: Option<(f64, f64)>,
    /// Whether the diagonal y = x is drawn.
    pub diagonal: bool,
}
