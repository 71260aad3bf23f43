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
