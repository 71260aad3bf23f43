//! What a figure draws, read from its SVG.

use roxmltree::{Document, Node};

fn numbers<const N: usize>(node: Node<'_, '_>, names: [&str; N]) -> [f64; N] {
    names.map(|name| node.attribute(name).expect(name).parse().expect("a number"))
}

/// Texts with their places.
pub fn texts(svg: &str) -> Vec<(String, [f64; 2])> {
    let tree = Document::parse(svg).expect("well-formed");
    let texts = tree
        .descendants()
        .filter(|node| node.tag_name().name() == "text");
    let each = texts.map(|node| {
        (
            node.text().unwrap_or("").to_owned(),
            numbers(node, ["x", "y"]),
        )
    });
    each.collect()
}

/// Left and upper edge, width and height of each rectangle but the ground.
pub fn blocks(svg: &str) -> Vec<[f64; 4]> {
    let tree = Document::parse(svg).expect("well-formed");
    let blocks = tree
        .descendants()
        .filter(|node| node.tag_name().name() == "rect");
    let blocks = blocks.filter(|node| node.attribute("class") != Some("ground"));
    let each = blocks.map(|node| numbers(node, ["x", "y", "width", "height"]));
    each.collect()
}
