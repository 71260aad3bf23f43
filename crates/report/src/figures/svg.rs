//! Writing SVG.

use std::fmt::Write;

/// An SVG that is being drawn, downwards.
pub(super) struct Svg {
    body: String,
}

impl Svg {
    pub(super) fn new() -> Svg {
        Svg {
            body: String::new(),
        }
    }

    pub(super) fn line(&mut self, class: &str, (x1, y1): (f64, f64), (x2, y2): (f64, f64)) {
        let _ = writeln!(
            self.body,
            r#"<line class="{class}" x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}"/>"#
        );
    }

    /// Text whose anchor is `start`, `middle` or `end`; its colour that of the class.
    pub(super) fn text(&mut self, class: &str, (x, y): (f64, f64), anchor: &str, text: &str) {
        let text = escape(text);
        let _ = writeln!(
            self.body,
            r#"<text class="{class}" x="{x:.1}" y="{y:.1}" text-anchor="{anchor}">{text}</text>"#
        );
    }

    pub(super) fn dot(&mut self, class: &str, (x, y): (f64, f64)) {
        let _ = writeln!(
            self.body,
            r#"<circle class="{class}" cx="{x:.1}" cy="{y:.1}" r="3.5"/>"#
        );
    }

    /// A line through points; broken where one of them is not finite.
    pub(super) fn path(&mut self, class: &str, points: impl Iterator<Item = (f64, f64)>) {
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

    /// The whole file. The text grows with the figure, to 640 pixels of width and no more.
    pub(super) fn finish(self, title: &str, width: f64, height: f64) -> String {
        let title = escape(title);
        format!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height:.0}" width="{width}" height="{height:.0}" style="width:100%;max-width:640px;height:auto;background:#fff" role="img" aria-label="{title}">
<title>{title}</title>
<style>
text {{ font: 14px system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; fill: #333 }}
text.title {{ font-size: 17px; font-weight: 600; fill: #111 }}
text.panel {{ font-weight: 600; fill: #111 }}
text.mark {{ font-size: 13px; fill: #555 }}
text.c0, circle.c0 {{ fill: #0072b2 }} text.c1, circle.c1 {{ fill: #c04a00 }} text.c2, circle.c2 {{ fill: #00795a }} text.c3, circle.c3 {{ fill: #a8518a }}
text.c0, text.c1, text.c2, text.c3 {{ font-weight: 600 }}
line.grid {{ stroke: #e4e4e4 }} line.zero {{ stroke: #a0a0a0 }} line.axis {{ stroke: #777 }}
line.mark {{ stroke: #777; stroke-dasharray: 2 4 }} circle.mark {{ fill: #fff; stroke: #333; stroke-width: 1.5 }}
path {{ fill: none; stroke-width: 2.2; stroke-linejoin: round }}
path.c0 {{ stroke: #0072b2 }} path.c1 {{ stroke: #d55e00; stroke-dasharray: 9 3 }} path.c2 {{ stroke: #009e73; stroke-dasharray: 3 3 }} path.c3 {{ stroke: #cc79a7; stroke-dasharray: 10 3 2 3 }}
</style>
<rect width="{width}" height="{height:.0}" fill="#fff"/>
{}</svg>
"##,
            self.body
        )
    }
}

fn escape(text: &str) -> String {
    let printable = text.chars().filter(|c| !c.is_control());
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
