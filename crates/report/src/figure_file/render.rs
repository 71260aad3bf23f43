//! Rendering of SVG by usvg, svg2pdf and resvg.

use std::sync::{Arc, LazyLock};

use resvg::tiny_skia::{Pixmap, Transform};
use svg2pdf::usvg::fontdb::Database;
use svg2pdf::usvg::{Options, Tree};

use super::{FigureError, FigureKind};

/// Number of pixels of a PNG figure for each SVG unit.
const SCALE: f32 = 2.0;
/// Family of the fonts of this crate, in the style sheet of the figures; also the default.
const FAMILY: &str = "DejaVu Sans";

pub(super) fn draw(kind: FigureKind, svg: &str) -> Result<Vec<u8>, FigureError> {
    let tree = Tree::from_str(svg, &options())?;
    match kind {
        FigureKind::Pdf => pdf(&tree),
        FigureKind::Png => png(&tree),
    }
}

fn options() -> Options<'static> {
    static FONTS: LazyLock<Arc<Database>> = LazyLock::new(|| {
        let mut fonts = Database::new();
        fonts.load_font_data(include_bytes!("../../fonts/DejaVuSans.ttf").to_vec());
        fonts.load_font_data(include_bytes!("../../fonts/DejaVuSans-Bold.ttf").to_vec());
        fonts.set_sans_serif_family(FAMILY);
        Arc::new(fonts)
    });
    Options {
        font_family: FAMILY.to_owned(),
        fontdb: Arc::clone(&FONTS),
        ..Options::default()
    }
}

fn pdf(tree: &Tree) -> Result<Vec<u8>, FigureError> {
    let (file, page) = (
        svg2pdf::ConversionOptions::default(),
        svg2pdf::PageOptions::default(),
    );
    svg2pdf::to_pdf(tree, file, page).map_err(|error| FigureError::Pdf(error.to_string()))
}

fn png(tree: &Tree) -> Result<Vec<u8>, FigureError> {
    let (wide, tall) = (tree.size().width(), tree.size().height());
    let pixels = |length: f32| (SCALE * length).ceil() as u32;
    let pixmap = Pixmap::new(pixels(wide), pixels(tall));
    let mut pixmap = pixmap.ok_or(FigureError::Size(wide, tall))?;
    let transform = Transform::from_scale(SCALE, SCALE);
    resvg::render(tree, transform, &mut pixmap.as_mut());
    let encoded = pixmap.encode_png();
    encoded.map_err(|error| FigureError::Png(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::{Layout, Line, Panel, figure_of};

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
}
