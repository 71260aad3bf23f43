//! Creation of text tables with a common layout.

use comfy_table::{ContentArrangement, Table};

/// Creates a text table with the given header, without colours; long cells are wrapped.
pub(crate) fn plain_table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(comfy_table::presets::ASCII_MARKDOWN);
    table
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_width(150);
    table.set_header(header.to_vec());
    table
}
