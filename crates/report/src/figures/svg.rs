//! Writer of SVG documents.

use std::fmt::Write;

/// Style sheet of every figure; a page includes it once.
pub(crate) const STYLE: &str = r#"text { font-family: system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; fill: #333 }
text.title { font-size: 1.2em; font-weight: 600; fill: #111 }
text.panel { font-weight: 600; fill: #111 }
text.mark { font-size: 0.93em; fill: #555 }
text.c0, circle.c0 { fill: #0072b2 } text.c1, circle.c1 { fill: #c04a00 } text.c2, circle.c2 { fill: #00795a } text.c3, circle.c3 { fill: #a8518a }
text.c0, text.c1, text.c2, text.c3 { font-weight: 600 }
text.dark { fill: #111 } text.pale { fill: #fff } text.little { font-size: 0.77em }
line.grid { stroke: #e4e4e4 } line.zero { stroke: #a0a0a0 } line.axis { stroke: #777 }
line.mark { stroke: #777; stroke-dasharray: 2 4 } circle.mark { fill: #fff; stroke: #333; stroke-width: 1.5 }
line.level { stroke: #555; stroke-dasharray: 6 4 }
rect.ground { fill: #fff } rect.band { fill: #e9eef3 } rect.bar { fill: #0072b2 } rect.bar.loose { fill: #d9813f }
path { fill: none; stroke-width: 2.2; stroke-linejoin: round }
path.c0 { stroke: #0072b2 } path.c1 { stroke: #d55e00; stroke-dasharray: 9 3 } path.c2 { stroke: #009e73; stroke-dasharray: 3 3 } path.c3 { stroke: #cc79a7; stroke-dasharray: 10 3 2 3 }
path.t0 { stroke: #0072b2 } path.t1 { stroke: #d55e00 } path.t2 { stroke: #009e73 } path.t3 { stroke: #cc79a7 }
path.t0, path.t1, path.t2, path.t3 { stroke-width: 1.2 }
path.d0 { stroke: #0072b2 } path.d1 { stroke: #d55e00 } path.d2 { stroke: #009e73 } path.d3 { stroke: #cc79a7 } path.dx { stroke: #111 } path.dg { stroke: #8a8a8a }
path.d0, path.d1, path.d2, path.d3, path.dg { stroke-width: 3; stroke-linecap: round } path.dx { stroke-width: 1.3 }
path.diagonal { stroke: #777; stroke-width: 1 } path.ribbon { fill: #cfe2f1; stroke: none }
g.value circle { fill: #0072b2; fill-opacity: 0 } g.value text { display: none; font-weight: 600; fill: #111; paint-order: stroke; stroke: #fff; stroke-width: 5px; stroke-linejoin: round }
g.value { outline: none; cursor: default } g.value:hover text, g.value:focus text { display: inline } g.value:hover circle, g.value:focus circle { fill-opacity: .45 }
rect.bar.explanation { fill: #0072b2 } rect.bar.alarm { fill: #d9813f } rect.bar.calm { fill: #b4b9c0 }
circle.before { fill: #fff; stroke: #d55e00; stroke-width: 2 } circle.after { fill: #0072b2 } line.join { stroke: #9aa0a8; stroke-width: 2 }
line.reach { stroke: #0072b2; stroke-width: 2 } text.strong { font-weight: 600; fill: #0060a0 } text.weak { fill: #777 }
rect.alike { fill: #00437c } rect.positive { fill: #b24800 } rect.unknown { fill: #c9b9b9 }
"#;

pub(crate) struct Svg {
    body: String,
}

impl Svg {
    pub(crate) fn new() -> Svg {
        let body = String::new();
        Svg { body }
    }

    pub(crate) fn line(&mut self, class: &str, (x1, y1): (f64, f64), (x2, y2): (f64, f64)) {
        let _ = writeln!(
            self.body,
            r#"<line class="{class}" x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}"/>"#
        );
    }

    /// Draws text; `anchor` is `start`, `middle` or `end`.
    pub(crate) fn text(&mut self, class: &str, (x, y): (f64, f64), anchor: &str, text: &str) {
        let text = escape(text);
        let _ = writeln!(
            self.body,
            r#"<text class="{class}" x="{x:.1}" y="{y:.1}" text-anchor="{anchor}">{text}</text>"#
        );
    }

    pub(crate) fn dot(&mut self, class: &str, (x, y): (f64, f64)) {
        let _ = writeln!(
            self.body,
            r#"<circle class="{class}" cx="{x:.1}" cy="{y:.1}" r="3.5"/>"#
        );
    }

    /// Adds a point with a tooltip. `size` is the width of the figure and of one character.
    pub(crate) fn value(&mut self, (x, y): (f64, f64), size: (f64, f64), text: &str) {
        let half = 0.53 * size.1 * text.chars().count() as f64;
        let middle = x.clamp(half + 2.0, (size.0 - half - 2.0).max(half + 2.0));
        let base = if y > 40.0 { y - 10.0 } else { y + 22.0 };
        let text = escape(text);
        let _ = writeln!(
            self.body,
            r#"<g class="value" tabindex="-1"><title>{text}</title><circle cx="{x:.1}" cy="{y:.1}" r="6"/><text x="{middle:.1}" y="{base:.1}" text-anchor="middle">{text}</text></g>"#
        );
    }

    pub(crate) fn block(&mut self, class: &str, (x, y): (f64, f64), (wide, tall): (f64, f64)) {
        let (wide, tall) = (wide.max(0.0), tall.max(0.0));
        let _ = writeln!(
            self.body,
            r#"<rect class="{class}" x="{x:.1}" y="{y:.1}" width="{wide:.1}" height="{tall:.1}"/>"#
        );
    }

    /// Draws a rectangle with the opacity `cover`, 0 to 1.
    pub(crate) fn veil(
        &mut self,
        class: &str,
        cover: f64,
        (x, y): (f64, f64),
        (wide, tall): (f64, f64),
    ) {
        let _ = writeln!(
            self.body,
            r#"<rect class="{class}" fill-opacity="{cover:.2}" x="{x:.1}" y="{y:.1}" width="{wide:.1}" height="{tall:.1}"/>"#
        );
    }

    /// Draws a line through the points, interrupted where they are not finite.
    pub(crate) fn path(&mut self, class: &str, points: impl Iterator<Item = (f64, f64)>) {
        let mut data = String::new();
        let mut pen = 'M';
        for (x, y) in points {
            if x.is_finite() && y.is_finite() {
                let _ = write!(data, "{pen}{x:.1} {y:.1}");
                pen = 'L';
            } else {
                pen = 'M';
            }
        }
        let _ = writeln!(self.body, r#"<path class="{class}" d="{data}"/>"#);
    }

    /// Draws dots as one path, which needs a tenth of the text of circles.
    pub(crate) fn dots(&mut self, class: &str, points: impl Iterator<Item = (f64, f64)>) {
        self.marks(class, points, 0.0, "h0");
    }

    pub(crate) fn crosses(&mut self, class: &str, points: impl Iterator<Item = (f64, f64)>) {
        self.marks(class, points, 3.0, "l6 6m-6 0l6 -6");
    }

    fn marks(
        &mut self,
        class: &str,
        points: impl Iterator<Item = (f64, f64)>,
        offset: f64,
        mark: &str,
    ) {
        let mut data = String::new();
        for (x, y) in points.filter(|(x, y)| x.is_finite() && y.is_finite()) {
            let _ = write!(data, "M{:.1} {:.1}{mark}", x - offset, y - offset);
        }
        if !data.is_empty() {
            let _ = writeln!(self.body, r#"<path class="{class}" d="{data}"/>"#);
        }
    }

    /// The document, whose width adapts to the page up to `most` pixels; `letters` is the size of the text.
    pub(crate) fn finish(
        self,
        title: &str,
        (width, height): (f64, f64),
        most: f64,
        letters: f64,
    ) -> String {
        let title = escape(title);
        format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height:.0}" width="{width}" height="{height:.0}" font-size="{letters}" style="width:100%;max-width:{most}px;height:auto;background:#fff" role="img" aria-label="{title}">
<title>{title}</title>
<style>
{STYLE}</style>
<rect class="ground" width="{width}" height="{height:.0}"/>
{}</svg>
"#,
            self.body
        )
    }
}

/// Removes the style sheets of figures, for a page that includes them.
pub(crate) fn without_style(svg: &str) -> String {
    let parts = svg.split("<style>\n");
    let after = |part| str::split_once(part, "</style>\n").map_or(part, |(_, after)| after);
    parts.map(after).collect()
}

/// Shortens a text to the width `room` with `…` at the end; `letter` is the width of one character.
pub(crate) fn cut(text: &str, room: f64, letter: f64) -> String {
    // Wide East Asian characters count twice; combining marks have no width.
    let wide = |c: char| match c {
        '\u{300}'..='\u{36f}' => 0.0,
        '\u{1100}'.. => 2.0 * letter,
        _ => letter,
    };
    if text.chars().map(wide).sum::<f64>() <= room {
        return text.to_owned();
    }
    let mut left = room - letter;
    let kept = text.chars().take_while(|c| {
        left -= wide(*c);
        left >= 0.0
    });
    kept.chain(['…']).collect()
}

pub(crate) fn escape(text: &str) -> String {
    // Control characters except for line breaks and tabs are not permitted in XML, even as references.
    let printable = text
        .chars()
        .filter(|c| matches!(c, '\n' | '\t') || !c.is_control())
        .filter(|c| !matches!(c, '\u{fffe}' | '\u{ffff}'));
    printable.fold(String::new(), |mut text, c| {
        match c {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '"' => text.push_str("&quot;"),
            c => text.push(c),
        }
        text
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_cut_where_there_is_no_room() {
        assert_eq!(cut("throw01.csv", 110.0, 10.0), "throw01.csv");
        assert_eq!(cut("throw01.csv", 60.0, 10.0), "throw…");
        assert_eq!(cut("φ\u{307}", 10.0, 10.0), "φ\u{307}");
        assert_eq!(cut("飛盤", 30.0, 10.0), "飛…");
    }

    #[test]
    fn what_xml_cannot_hold_is_left_out() {
        assert_eq!(escape("a\u{1}<b>\u{ffff}&\"'"), "a&lt;b&gt;&amp;&quot;'");
        assert_eq!(escape("a\n\tb\r"), "a\n\tb");
    }
}
