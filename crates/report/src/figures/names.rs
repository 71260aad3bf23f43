//! Labels of lines and events within a panel, placed without overlaps.

use model_spec::sort_by_number;

use super::layout::Scale;
use super::panel::{Line, Panel};
use super::svg::{Svg, cut};

impl Panel {
    /// Draws the names of the lines at their right ends, moved so that they do not overlap.
    pub(super) fn draw_names(&self, svg: &mut Svg, scale: &Scale, width: f64, letter: f64) {
        // Minimum vertical distance of two names.
        let apart = 2.05 * letter;
        let last = |line: &Line| {
            let mut points = line.points.iter().rev();
            points.find(|p| p.1.is_finite()).map(|p| scale.y(p.1))
        };
        let lines = self.lines.iter().enumerate();
        let mut names: Vec<(f64, usize)> = lines.filter_map(|(i, l)| Some((last(l)?, i))).collect();
        sort_by_number(&mut names, |name| name.0);
        let mut least = scale.top - 4.0;
        for name in &mut names {
            name.0 = name.0.max(least);
            least = name.0 + apart;
        }
        let mut greatest = scale.bottom() + 4.0;
        for name in names.iter_mut().rev() {
            name.0 = name.0.min(greatest);
            greatest = name.0 - apart;
        }
        // In a map, lines can end anywhere; the title of the map gives their names.
        for (y, i) in names.into_iter().filter(|_| !self.map) {
            let x = scale.right() + 6.0;
            let name = cut(&self.lines[i].name, width - x - 2.0, 1.05 * letter);
            svg.text(&format!("c{}", i % 4), (x, y + 5.0), "start", &name);
        }
    }

    /// Draws the marks without y as vertical lines; a label without space is omitted.
    pub(super) fn draw_marks(&self, svg: &mut Svg, scale: &Scale, width: f64, letter: f64) {
        let title = self.title.chars().count() as f64;
        let mut free = (14.0 + 1.1 * letter * title).max(scale.left - 20.0);
        for mark in self.marks.iter().filter(|mark| !mark.at.1.is_finite()) {
            let x = scale.x(mark.at.0);
            svg.line("mark", (x, scale.top), (x, scale.bottom()));
            let half = 0.45 * letter * mark.name.chars().count() as f64;
            let middle = x.min(width - 8.0 - half);
            if middle - half > free && half > 0.0 {
                svg.text("mark", (middle, scale.top - 4.0), "middle", &mark.name);
                free = middle + half + 6.0;
            }
        }
    }

    /// Draws the other marks: dots, each with its label at the corner where it covers the fewest labels and points.
    pub(super) fn draw_places(&self, svg: &mut Svg, scale: &Scale, width: f64, letter: f64) {
        let places = self.lines.iter().flat_map(|line| &line.points);
        let places: Vec<(f64, f64)> = places.map(|(x, y)| (scale.x(*x), scale.y(*y))).collect();
        let mut taken: Vec<LabelBox> = Vec::new();
        for mark in self.marks.iter().filter(|mark| mark.at.1.is_finite()) {
            let (x, y) = (scale.x(mark.at.0), scale.y(mark.at.1));
            svg.dot("mark", (x, y));
            let wide = 0.9 * letter * mark.name.chars().count() as f64;
            let corners = [
                (x + 7.0, y - 6.0),
                (x + 7.0, y + 17.0),
                (x - 7.0 - wide, y - 6.0),
                (x - 7.0 - wide, y + 17.0),
            ];
            let boxes = corners.map(|(left, base)| LabelBox {
                left,
                right: left + wide,
                top: base - 12.0,
                bottom: base + 4.0,
            });
            let cost = |b: &LabelBox| {
                let outside = b.left < scale.left || b.right > width - 4.0;
                let beyond = b.top < scale.top - 8.0 || b.bottom > scale.bottom();
                let covered = places.iter().filter(|p| b.holds(**p)).count();
                1000 * usize::from(outside || beyond)
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

struct LabelBox {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl LabelBox {
    fn holds(&self, (x, y): (f64, f64)) -> bool {
        self.left < x && x < self.right && self.top < y && y < self.bottom
    }
    fn meets(&self, other: &LabelBox) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

#[cfg(test)]
mod tests {
    use crate::Figure;
    use crate::figures::tests::texts;
    use crate::figures::{Layout, Mark, Panel};

    /// Of the four places beside a mark in a corner, one is inside.
    #[test]
    fn the_label_of_a_mark_in_a_corner_is_inside() {
        let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)];
        let of = |at: (f64, f64)| {
            let mut panel = Panel::new("height", "distance").line("", corners);
            panel.marks = vec![Mark::new("landing", at)];
            let svg = Figure::of_panels("path", "t", "c", Layout::COLUMN, &[panel]).svg;
            let tree = roxmltree::Document::parse(&svg).unwrap();
            let mut dots = tree
                .descendants()
                .filter(|node| node.has_tag_name("circle"));
            let dot = dots
                .find(|node| node.attribute("class") == Some("mark"))
                .unwrap();
            let dot = ["cx", "cy"].map(|name| dot.attribute(name).unwrap().parse().unwrap());
            let texts = texts(&svg);
            let label = texts.into_iter().find(|own| own.0 == "landing").unwrap().1;
            (dot, label)
        };
        for (at, sign) in
            corners
                .into_iter()
                .zip([[1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [-1.0, 1.0]])
        {
            let (dot, label): ([f64; 2], [f64; 2]) = of(at);
            let off = [label[0] - dot[0], label[1] - dot[1]];
            assert!(
                off[0] * sign[0] > 0.0 && off[1] * sign[1] > 0.0,
                "{at:?} {off:?}"
            );
        }
    }
}
