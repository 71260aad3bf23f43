//! Figures as PDF and PNG files: `cargo test --features hyzer-report/pictures --test pictures`.

use report::FigureKind;
use report::figures::{Layout, Line, Panel, figure_of};

fn drawn(title: &str) -> String {
    let panel = Panel {
        title: "φ\u{307}, 10⁻³ rad/s".into(),
        across: "α, °".into(),
        lines: vec![Line {
            name: "before".into(),
            points: vec![(0.0, 1.0), (1.0, 2.0)],
        }],
        ..Panel::default()
    };
    figure_of(Layout::SMALL, title, &[panel])
}

#[test]
fn a_figure_is_a_file_of_each_kind() {
    let pdf = FigureKind::Pdf.draw(&drawn("C_L over α")).unwrap();
    assert!(pdf.starts_with(b"%PDF-"));
    let png = FigureKind::Png.draw(&drawn("C_L over α")).unwrap();
    assert!(png.starts_with(b"\x89PNG"));
    let wide = u32::from_be_bytes(png[16..20].try_into().unwrap());
    assert_eq!(f64::from(wide), 2.0 * Layout::SMALL.width);
    assert!(FigureKind::Pdf.draw("<svg").is_err());
}

/// A figure's title is rendered in the PNG image, and a different one gives another image; tooltips are not.
#[test]
fn text_is_drawn_and_values_are_not() {
    let pixels = |svg: &str| FigureKind::Png.draw(svg).unwrap();
    assert_ne!(pixels(&drawn("C_L over α")), pixels(&drawn("C_D over α")));
    let svg = drawn("C_L over α");
    let first = svg.find("<g class=\"value\"").unwrap();
    let without = format!("{}</svg>", &svg[..first]);
    assert_eq!(pixels(&svg), pixels(&without));
}
