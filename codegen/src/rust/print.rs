//! Printing of tokens by `prettyplease`, and insertion of the comments, blank lines and filled arrays that tokens
//! cannot express.
//!
//! Comments are encoded as the pseudo-attribute `#[comment = "…"]`, which `prettyplease` prints as `//…`. Comments
//! whose text starts with `@` are markers, which [`finish`] replaces.

use proc_macro2::TokenStream;
use quote::quote;

/// Maximum line width in printed arrays and trailing comments, characters.
const WIDTH: usize = 100;

/// Text of a marker comment in generated code; [`finish`] replaces the comment by a blank line.
const BLANK: &str = "@blank";
/// Prefix of a comment that [`finish`] moves behind the next statement.
const TRAILING: &str = "@trailing ";
/// Comment before an array whose lines [`finish`] fills.
const FILL: &str = "@fill";

pub(super) fn comment(text: &str) -> TokenStream {
    let text = format!(" {text}");
    quote!(#[comment = #text])
}

pub(super) fn blank_line() -> TokenStream {
    quote!(#[comment = #BLANK])
}

/// Comment at the end of the following statement, or before it if the line is long.
pub(super) fn trailing_comment(text: &str) -> TokenStream {
    let text = format!("{TRAILING}{text}");
    quote!(#[comment = #text])
}

/// Tokens that mark the following array constant to be printed with several elements per line.
pub(super) fn fill() -> TokenStream {
    quote!(#[comment = #FILL])
}

/// Tokens of an outer doc comment for an item, with one line per line of `text`.
pub(super) fn doc(text: &str) -> TokenStream {
    let lines = text.lines().map(doc_line);
    quote!(#(#[doc = #lines])*)
}

/// Tokens of an inner doc comment for the enclosing module, with one line per line of `text`.
pub(super) fn inner_doc(text: &str) -> TokenStream {
    let lines = text.lines().map(doc_line);
    quote!(#(#![doc = #lines])*)
}

fn doc_line(line: &str) -> String {
    let line: String = line.chars().filter(|c| !c.is_control()).collect();
    match line.trim_end() {
        "" => String::new(),
        line => format!(" {line}"),
    }
}

/// Text of a source file: the header lines as comments, then the tokens.
pub(super) fn file(header: &[impl AsRef<str>], tokens: TokenStream) -> String {
    let file: syn::File = syn::parse2(tokens).expect("the backend emits the tokens of a Rust file");
    let mut text = String::new();
    for line in header {
        let line: String = line.as_ref().chars().filter(|c| !c.is_control()).collect();
        text.push_str(format!("// {line}").trim_end());
        text.push('\n');
    }
    let printed = finish(&prettyplease::unparse(&file));
    if !printed.starts_with("//!") {
        text.push('\n');
    }
    text.push_str(&printed);
    text
}

/// Carries out the marker comments of printed code, and separates items by blank lines.
fn finish(printed: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut trailing: Option<String> = None;
    let mut rest = printed.lines().peekable();
    while let Some(line) = rest.next() {
        let marker = line.trim_start().strip_prefix("//");
        if let Some(note) = marker.and_then(|marker| marker.strip_prefix(TRAILING)) {
            trailing = Some(note.to_string());
            continue;
        }
        match marker {
            Some(BLANK) => push_blank(&mut lines),
            Some(FILL) => {
                if lines.last().is_some_and(|last| ends_item(last)) {
                    push_blank(&mut lines);
                }
                while let Some(line) = rest.next_if(|line| !line.ends_with('[')) {
                    lines.push(line.to_string());
                    if line.ends_with(';') {
                        break;
                    }
                }
                if let Some(open) = rest.next_if(|line| line.ends_with('[')) {
                    lines.push(open.to_string());
                    let mut elements = Vec::new();
                    while let Some(element) = rest.next_if(|line| line.starts_with(' ')) {
                        elements.push(element.trim());
                    }
                    lines.extend(filled(&elements));
                }
            }
            _ => {
                if lines.last().is_some_and(|last| separate(last, line)) {
                    push_blank(&mut lines);
                }
                match trailing.take() {
                    Some(note) => push_noted(&mut lines, line, &note),
                    None => lines.push(line.to_string()),
                }
            }
        }
    }
    lines.join("\n") + "\n"
}

fn push_blank(lines: &mut Vec<String>) {
    let after_text = lines.last().is_some_and(|last| !last.is_empty());
    if after_text && !lines.last().is_some_and(|last| last.ends_with('{')) {
        lines.push(String::new());
    }
}

fn push_noted(lines: &mut Vec<String>, line: &str, note: &str) {
    let end = format!("{line} // {note}");
    if line.ends_with(';') && end.chars().count() <= WIDTH {
        lines.push(end);
    } else {
        let indent = &line[..line.len() - line.trim_start().len()];
        lines.push(format!("{indent}// {note}"));
        lines.push(line.to_string());
    }
}

/// Whether a line of code ends an item or a method.
fn ends_item(line: &str) -> bool {
    let indent = line.len() - line.trim_start().len();
    match indent {
        0 => line.ends_with('}') || line.ends_with(';'),
        4 => line == "    }",
        _ => false,
    }
}

/// Whether a blank line separates two lines: after inner docs, and between items.
fn separate(last: &str, line: &str) -> bool {
    const LISTS: [&str; 4] = ["mod ", "use ", "pub mod ", "pub use "];
    let indent = |line: &str| line.len() - line.trim_start().len();
    let in_list = LISTS
        .iter()
        .any(|list| last.starts_with(list) && line.starts_with(list));
    let starts_item = [
        "///", "//", "#[", "pub ", "fn ", "impl", "struct ", "static ", "const ",
    ]
    .iter()
    .chain(&LISTS)
    .any(|start| line.trim_start().starts_with(start));
    let after_inner_docs = last.starts_with("//!") && !line.starts_with("//!");
    after_inner_docs || (ends_item(last) && indent(last) == indent(line) && starts_item && !in_list)
}

/// Elements of an array in filled lines; each row of pairs starts a new one.
fn filled(elements: &[&str]) -> Vec<String> {
    let row = |element: &str| {
        let inside = element.strip_prefix('(')?;
        inside.split(',').next().map(str::to_string)
    };
    let mut lines: Vec<String> = Vec::new();
    let mut last_row = None;
    for element in elements {
        let this_row = row(element);
        match lines.last_mut() {
            Some(line)
                if this_row == last_row
                    && line.chars().count() + 1 + element.chars().count() <= WIDTH =>
            {
                line.push(' ');
                line.push_str(element);
            }
            _ => lines.push(format!("    {element}")),
        }
        last_row = this_row;
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_blank_lines_and_tables_survive_printing() {
        let (blank, source) = (blank_line(), comment("disc.hyz:75  let v = a · b;"));
        let (short, long) = (trailing_comment("d_v_d_a"), trailing_comment("d_v_d_b"));
        let (fill, doc, inner) = (fill(), doc("Double.\n\n  Indented."), inner_doc("A file."));
        let pairs = (0..40_usize).map(|k| (k / 25, k)).map(|(row, column)| {
            let [row, column] = [row, column].map(proc_macro2::Literal::usize_unsuffixed);
            quote!((#row, #column))
        });
        let tokens = quote! {
            #inner
            mod a;
            mod b;
            use b::c;
            #doc
            fn f() {
                let a = 1.0;
                #blank #source
                let v = a * b;
                #short
                j[0] = v;
                #long
                j[1] = a_rather_long_name.mul_add(another_rather_long_name, yet_another_rather_long_name_that_is_long);
            }
            #fill
            /// Pairs.
            pub const PAIRS: [(u32, u32); 40] = [#(#pairs),*];
            #fill
            pub const ONE: [f64; 1] = [0.5];
            impl A {
                fn a() {}
                fn b() { g(); }
                fn c() {}
            }
        };
        let text = file(&["Header."], tokens);
        let expected = "\
// Header.
//! A file.

mod a;
mod b;

use b::c;

/// Double.
///
///   Indented.
fn f() {
    let a = 1.0;

    // disc.hyz:75  let v = a · b;
    let v = a * b;
    j[0] = v; // d_v_d_a
    // d_v_d_b
    j[1] = a_rather_long_name
        .mul_add(another_rather_long_name, yet_another_rather_long_name_that_is_long);
}

/// Pairs.
pub const PAIRS: [(u32, u32); 40] = [
    (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10),
    (0, 11), (0, 12), (0, 13), (0, 14), (0, 15), (0, 16), (0, 17), (0, 18), (0, 19), (0, 20),
    (0, 21), (0, 22), (0, 23), (0, 24),
    (1, 25), (1, 26), (1, 27), (1, 28), (1, 29), (1, 30), (1, 31), (1, 32), (1, 33), (1, 34),
    (1, 35), (1, 36), (1, 37), (1, 38), (1, 39),
];

pub const ONE: [f64; 1] = [0.5];

impl A {
    fn a() {}
    fn b() {
        g();
    }

    fn c() {}
}
";
        assert_eq!(text, expected);
    }
}
