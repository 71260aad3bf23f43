//! Chart with labelled rows: bars or dots along a common horizontal axis.

use super::Layout;
use super::axis::{number, ticks};
use super::csv::Table;
use super::svg::{Svg, cut};
use identify::numbers::{significant, stated};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Axis {
    /// From 0.
    Linear,
    /// Logarithmic, from the given value.
    Log(f64),
    /// ln(1 + value): nearly linear up to 1, logarithmic for large values.
    Sizes,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shape {
    Bar(f64, &'static str),
    Dot(f64, &'static str),
    Span(f64, f64, &'static str),
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row {
    /// Label at the left end, with its CSS class.
    pub(crate) name: String,
    pub(crate) class: &'static str,
    pub(crate) shapes: Vec<Shape>,
    /// Text at the right end; may be empty.
    pub(crate) words: String,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Chart {
    pub(crate) title: String,
    /// Shapes and their meanings.
    pub(crate) legend: Vec<(Shape, String)>,
    /// From top to bottom.
    pub(crate) rows: Vec<Row>,
    pub(crate) axis: Axis,
    /// Title of the axis, with its unit.
    pub(crate) across: String,
    /// Dashed vertical line across all rows: its value, and its label.
    pub(crate) level: Option<(f64, String)>,
}

impl Row {
    pub(crate) fn new(name: &str, class: &'static str, shapes: Vec<Shape>) -> Row {
        Row {
            name: name.to_owned(),
            class,
            shapes,
            words: String::new(),
        }
    }

    pub(crate) fn words(self, words: String) -> Row {
        Row { words, ..self }
    }
}

impl Chart {
    pub(crate) fn new(title: &str, rows: Vec<Row>, axis: Axis, across: &str) -> Chart {
        Chart {
            title: title.to_owned(),
            legend: Vec::new(),
            rows,
            axis,
            across: across.to_owned(),
            level: None,
        }
    }

    pub(crate) fn draw(&self, layout: Layout) -> String {
        let (letters, letter) = (layout.letters, layout.letter());
        let mut svg = Svg::new();
        let title = cut(&self.title, layout.width - 16.0, 1.25 * letter);
        svg.text("title", (2.0, 2.0 * letters), "start", &title);
        let mut top = self.draw_legend(&mut svg, &layout, 2.0 * letters + 12.0);
        let words = |text: &str| text.chars().count() as f64 * letter;
        let names = self.rows.iter().map(|row| 1.06 * words(&row.name));
        let left = 12.0 + names.fold(20.0, f64::max).min(0.5 * layout.width);
        let notes = self.rows.iter().map(|row| words(&row.words));
        let right = layout.width - 10.0 - notes.fold(14.0, f64::max).min(0.25 * layout.width);
        let greatest = self.greatest();
        let place = |value: f64| {
            let part = self.axis.part(value, greatest).clamp(0.0, 1.0);
            left + (right - left) * part
        };
        let step = letters + 7.0;
        let has_level = self.level.is_some();
        top += if has_level { letters + 8.0 } else { 6.0 };
        let bottom = top + step * self.rows.len() as f64 + 2.0;
        let mut free = f64::NEG_INFINITY;
        for (value, text) in self.axis.ticks(greatest, ((right - left) / 52.0) as usize) {
            let (x, half) = (place(value), 0.5 * words(&text));
            svg.line("grid", (x, top), (x, bottom));
            if x - half > free {
                svg.text("tick", (x, bottom + 4.0 + letters), "middle", &text);
                free = x + half + 8.0;
            }
        }
        for (i, row) in self.rows.iter().enumerate() {
            let middle = top + step * (i as f64 + 0.5) + 1.0;
            let name = cut(&row.name, left - 10.0, 1.06 * letter);
            let base = middle + 0.36 * letters;
            svg.text(row.class, (left - 8.0, base), "end", &name);
            for shape in &row.shapes {
                draw_shape(&mut svg, shape, middle, letters, left, &place);
            }
            // The texts at the right end form a separate column.
            svg.text("mark", (layout.width - 4.0, base), "end", &row.words);
        }
        for (i, row) in self.rows.iter().enumerate() {
            let middle = top + step * (i as f64 + 0.5) + 1.0;
            for (value, what) in self.values(row) {
                let text = format!("{}{what}: {}", row.name, significant(value, 4));
                svg.value((place(value), middle), (layout.width, letter), &text);
            }
        }
        svg.line("axis", (left, top), (left, bottom));
        svg.line("axis", (left, bottom), (right, bottom));
        if let Some((value, name)) = self.level.as_ref().filter(|l| l.0.is_finite()) {
            let x = place(*value);
            svg.line("level", (x, top - 4.0), (x, bottom));
            let half = 0.5 * words(name);
            let x = x.clamp(half + 4.0, (layout.width - half - 4.0).max(half + 4.0));
            svg.text("mark", (x, top - 8.0), "middle", name);
        }
        let below = bottom + 8.0 + 2.0 * letters;
        let across = cut(&self.across, layout.width - 16.0, letter);
        let half = 0.5 * words(&across);
        let middle = (0.5 * (left + right)).clamp(half + 4.0, layout.width - half - 4.0);
        svg.text("across", (middle, below), "middle", &across);
        let size = (layout.width, below + 12.0);
        svg.finish(&self.title, size, layout.most, letters)
    }

    /// Value of each bar and dot of a row, and its meaning by the legend after a comma, or nothing.
    fn values<'a>(&'a self, row: &'a Row) -> impl Iterator<Item = (f64, String)> + 'a {
        let of = |shape: &Shape| match *shape {
            Shape::Bar(value, class) | Shape::Dot(value, class) => Some((value, class)),
            Shape::Span(..) => None,
        };
        let meaning = move |class: &str| {
            let mut legend = self.legend.iter();
            let found = legend.find(|(shape, _)| of(shape).is_some_and(|(_, c)| c == class));
            found.map_or_else(String::new, |(_, words)| format!(", {words}"))
        };
        let values = row.shapes.iter().filter_map(of);
        let finite = values.filter(|(value, _)| value.is_finite());
        finite.map(move |(value, class)| (value, meaning(class)))
    }

    /// CSV table with a line for each bar, dot and line.
    pub(crate) fn csv(&self) -> String {
        let mut table = Table::new(&["row", "kind", "value", "to"]);
        for row in &self.rows {
            for shape in &row.shapes {
                let (class, value, to) = match *shape {
                    Shape::Bar(value, class) | Shape::Dot(value, class) => (class, value, None),
                    Shape::Span(from, to, class) => (class, from, Some(to)),
                };
                table.text(&row.name).text(class).number(value);
                table.optional(to).end();
            }
        }
        if let Some((value, name)) = &self.level {
            table.text(name).text("level").number(*value);
            table.optional(None).end();
        }
        table.finish()
    }

    fn greatest(&self) -> f64 {
        let shapes = self.rows.iter().flat_map(|row| &row.shapes);
        let ends = shapes.map(|shape| match shape {
            Shape::Bar(value, _) | Shape::Dot(value, _) => *value,
            Shape::Span(from, to, _) => from.max(*to),
        });
        let level = self.level.iter().map(|l| l.0);
        let all = ends.chain(level).filter(|v| v.is_finite());
        let most = all.fold(0.0, f64::max);
        if most > 0.0 { most * 1.02 } else { 1.0 }
    }

    /// Draws the legend from the height `top` on; returns its lower edge.
    fn draw_legend(&self, svg: &mut Svg, layout: &Layout, top: f64) -> f64 {
        if self.legend.is_empty() {
            return top;
        }
        let (letters, letter) = (layout.letters, layout.letter());
        let (mut x, mut y) = (2.0, top + 0.9 * letters);
        for (shape, words) in &self.legend {
            let wide = 20.0 + letter * words.chars().count() as f64;
            if x > 2.0 && x + wide > layout.width - 4.0 {
                (x, y) = (2.0, y + letters + 6.0);
            }
            let middle = y - 0.35 * letters;
            match shape {
                Shape::Bar(_, class) => svg.block(class, (x, middle - 5.0), (12.0, 10.0)),
                Shape::Dot(_, class) => svg.dot(class, (x + 6.0, middle)),
                Shape::Span(_, _, class) => svg.line(class, (x, middle), (x + 12.0, middle)),
            }
            svg.text("mark", (x + 17.0, y), "start", words);
            x += wide + 12.0;
        }
        y + 6.0
    }
}

fn draw_shape(
    svg: &mut Svg,
    shape: &Shape,
    middle: f64,
    letters: f64,
    left: f64,
    place: &impl Fn(f64) -> f64,
) {
    match *shape {
        Shape::Bar(value, class) if value.is_finite() => {
            let tall = letters - 1.0;
            let wide = (place(value) - left).max(1.0);
            svg.block(class, (left, middle - 0.5 * tall), (wide, tall));
        }
        Shape::Dot(value, class) if value.is_finite() => {
            svg.dot(class, (place(value), middle));
        }
        Shape::Span(from, to, class) if from.is_finite() && to.is_finite() => {
            svg.line(class, (place(from), middle), (place(to), middle));
        }
        _ => {}
    }
}

impl Axis {
    /// Position of a value as a fraction of the axis, whose right end is `greatest`; negative left of it.
    fn part(self, value: f64, greatest: f64) -> f64 {
        let part = match self {
            Axis::Linear => value / greatest,
            Axis::Log(least) => (value / least).ln() / (greatest / least).ln(),
            Axis::Sizes => value.max(0.0).ln_1p() / greatest.ln_1p(),
        };
        if part.is_nan() { 0.0 } else { part }
    }

    fn ticks(self, greatest: f64, most: usize) -> Vec<(f64, String)> {
        let most = most.clamp(3, 8);
        if self == Axis::Linear {
            let (at, decimals) = ticks((0.0, greatest), most);
            let text = |t: f64| (t, number(t, decimals));
            return at.into_iter().map(text).collect();
        }
        let least = match self {
            Axis::Log(least) => least,
            _ => 1.0,
        };
        let first = least.log10().floor().max(-12.0) as i32;
        let last = greatest.log10().ceil().min(300.0) as i32;
        let all = (first..=last).flat_map(|power| {
            let unit = |m: f64| {
                if power < 0 {
                    m / 10_f64.powi(-power)
                } else {
                    m * 10_f64.powi(power)
                }
            };
            [1.0, 2.0, 5.0].map(unit)
        });
        let mut all: Vec<f64> = all.filter(|v| (least..=greatest).contains(v)).collect();
        // If there are too many ticks, keeps only powers of ten, and then only every n-th of these.
        if all.len() > most + 2 {
            all.retain(|v| (v.log10() - v.log10().round()).abs() < 1e-9);
        }
        if all.len() > most {
            let step = all.len().div_ceil(most);
            all = all.into_iter().step_by(step).collect();
        }
        let zero = (self == Axis::Sizes).then_some(0.0);
        let all = zero.into_iter().chain(all);
        all.map(|t| (t, stated(t))).collect()
    }
}

/// Linear axis for positive values, or logarithmic if they differ by more than a factor of 30.
pub(crate) fn axis_for(values: impl Iterator<Item = f64> + Clone) -> Axis {
    let good = values.filter(|v| v.is_finite() && *v > 0.0);
    let least = good.clone().fold(f64::INFINITY, f64::min);
    let most = good.fold(0.0, f64::max);
    // Values below 1e-6 of the largest do not extend the logarithmic range.
    if most > 30.0 * least {
        Axis::Log((0.8 * least).max(1e-6 * most))
    } else {
        Axis::Linear
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::tests::texts;

    #[test]
    fn ticks_of_a_logarithmic_axis_are_round_numbers_within_it() {
        let all = |least: f64, greatest: f64| -> Vec<f64> {
            let ticks = Axis::Log(least).ticks(greatest, 6);
            ticks.into_iter().map(|(value, _)| value).collect()
        };
        assert_eq!(all(0.01, 0.2), [0.01, 0.02, 0.05, 0.1, 0.2]);
        // Of many, powers of ten at equal distances.
        let wide = all(1e-6, 1e6);
        assert!((4..=6).contains(&wide.len()), "{wide:?}");
        for tick in wide {
            assert!((tick.log10() - tick.log10().round()).abs() < 1e-9, "{tick}");
        }
    }

    #[test]
    fn rows_are_below_the_title() {
        let rows = vec![Row::new("first", "strong", vec![Shape::Dot(1.0, "after")])];
        let layout = Layout::COLUMN;
        let chart = Chart::new("Estimates", rows, Axis::Linear, "sizes");
        let texts = texts(&chart.draw(layout));
        let base = |text: &str| texts.iter().find(|own| own.0 == text).expect(text).1[1];
        assert!(
            base("first") - layout.letters > base("Estimates"),
            "{texts:?}"
        );
        assert!(base("sizes") > base("first"));
    }
}
