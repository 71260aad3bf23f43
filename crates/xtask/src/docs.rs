//! Random sample of doc comments, for review by a reader who sees only the comment, the signature and the
//! header of the enclosing type or impl block.

use std::path::Path;

use anyhow::Result;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::source;

/// A doc comment with the signature of the item that it documents.
struct Documented {
    place: String,
    /// First line of the innermost block around the item, such as `impl Model {`; `None` if the item is not inside a
    /// block.
    parent: Option<String>,
    comment: Vec<String>,
    signature: String,
}

/// Prints `count` doc comments, drawn without replacement. The same seed selects the same comments of the same source
/// tree.
pub fn print_sample(root: &Path, seed: u64, count: usize) -> Result<()> {
    let mut all = Vec::new();
    for folder in source::crates(root)? {
        if source::is_generated(&folder) {
            continue;
        }
        for file in source::rust_files(&folder.join("src"))? {
            let place = source::relative(root, &file).to_string();
            all.extend(documented(&place, &source::read(&file)?));
        }
    }
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let total = all.len();
    let (drawn, _) = all.partial_shuffle(&mut random, count);
    for (number, item) in drawn.iter().enumerate() {
        println!("{}. {}", number + 1, item.place);
        if let Some(parent) = &item.parent {
            println!("  {parent}");
        }
        for line in &item.comment {
            println!("    /// {line}");
        }
        println!("    {}\n", item.signature);
    }
    println!("{} of {total} doc comments, seed {seed}", drawn.len());
    Ok(())
}

fn documented(file: &str, text: &str) -> Vec<Documented> {
    let mut found = Vec::new();
    let mut comment: Vec<String> = Vec::new();
    let raw: Vec<&str> = text.lines().collect();
    let lines: Vec<&str> = raw.iter().map(|line| line.trim()).collect();
    for (number, line) in lines.iter().enumerate() {
        if let Some(rest) = line.strip_prefix("///") {
            comment.push(rest.trim().to_owned());
        } else if !line.starts_with("#[") && !comment.is_empty() {
            found.push(Documented {
                place: format!("{file}:{}", number + 1),
                parent: parent(&raw[..=number]),
                comment: std::mem::take(&mut comment),
                signature: signature(&lines[number..]),
            });
        }
    }
    found
}

/// First line of the innermost block around the last of `lines`: the nearest preceding line that is less indented and
/// ends with `{`. `None` if there is no such line.
fn parent(lines: &[&str]) -> Option<String> {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let (item, above) = lines.split_last()?;
    let opens = |line: &&&str| {
        line.trim_end().ends_with('{')
            && indent(line) < indent(item)
            && !line.trim().starts_with('}')
    };
    above
        .iter()
        .rev()
        .find(opens)
        .map(|line| line.trim().to_owned())
}

/// Signature of the item that starts at the first of `lines`: all lines up to the first that ends with `{`, `;`, `,` or
/// `}`, joined by spaces.
fn signature(lines: &[&str]) -> String {
    let ends = |line: &&str| line.ends_with(['{', ';', ',', '}']) && !line.ends_with("(,");
    let last = lines.iter().position(ends).unwrap_or(0);
    lines[..=last].join(" ")
}
