//! Random sample of doc comments, for review by a reader who sees only the comment and the signature.

use std::path::Path;

use anyhow::Result;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::source;

/// A doc comment with the signature of its item.
struct Documented {
    place: String,
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
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    for (number, line) in lines.iter().enumerate() {
        if let Some(rest) = line.strip_prefix("///") {
            comment.push(rest.trim().to_owned());
        } else if !line.starts_with("#[") && !comment.is_empty() {
            found.push(Documented {
                place: format!("{file}:{}", number + 1),
                comment: std::mem::take(&mut comment),
                signature: signature(&lines[number..]),
            });
        }
    }
    found
}

/// Lines of an item, joined, up to the line that opens its body or ends it. `lines` starts at the item.
fn signature(lines: &[&str]) -> String {
    let ends = |line: &&str| line.ends_with(['{', ';', ',', '}']) && !line.ends_with("(,");
    let last = lines.iter().position(ends).unwrap_or(0);
    lines[..=last].join(" ")
}
