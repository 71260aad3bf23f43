//! Statements `include "FILE";`: the file that one names, and the files that one may name.

use std::path::Path;

use serde_json::{Value, json};

use super::document::Document;
use super::uri;

/// Greatest number of files that are offered, and of entries of folders that are looked at.
const MAX_FILES: (usize, usize) = (100, 2000);
/// Depth of the folders below that of the text.
const MAX_DEPTH: usize = 3;

/// Text between the quotes of the `include` around a byte offset, as far as it is on the line.
fn quoted(text: &str, offset: usize) -> Option<&str> {
    let start = text[..offset].rfind('\n').map_or(0, |end| end + 1);
    let end = text[offset..]
        .find('\n')
        .map_or(text.len(), |end| offset + end);
    let line = &text[start..end];
    let open = line.find('"')?;
    let is_include = line[..open].trim() == "include" && offset > start + open;
    let inner = &line[open + 1..];
    let inner = inner.split('"').next().unwrap_or(inner);
    (is_include && offset <= start + open + 1 + inner.len()).then_some(inner)
}

/// Location of the file that the statement at a byte offset includes; `None` elsewhere.
pub fn definition(document: &Document, offset: usize) -> Option<Value> {
    let named = quoted(&document.text, offset)?;
    let path = Path::new(&document.path).parent()?.join(named);
    let start = json!({ "line": 0, "character": 0 });
    path.is_file().then(|| {
        json!({ "uri": uri::of(&path.to_string_lossy()), "range": { "start": start, "end": start } })
    })
}

/// Files that the statement at a byte offset may include; `None` elsewhere.
pub fn files(document: &Document, offset: usize) -> Option<Value> {
    quoted(&document.text, offset)?;
    let own = Path::new(&document.path);
    let (mut found, mut looked_at) = (Vec::new(), 0);
    let mut open = vec![(own.parent()?.to_path_buf(), String::new(), 0)];
    while let Some((folder, before, depth)) = open.pop() {
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        for entry in entries {
            looked_at += 1;
            if looked_at > MAX_FILES.1 {
                open.clear();
                break;
            }
            let (path, name) = (entry.path(), entry.file_name());
            let name = format!("{before}{}", name.to_string_lossy());
            if path.is_dir() && depth < MAX_DEPTH {
                open.push((path, format!("{name}/"), depth + 1));
            } else if path.extension().is_some_and(|end| end == "hyz") && path != own {
                found.push(name);
            }
        }
    }
    found.sort();
    found.truncate(MAX_FILES.0);
    let items = found
        .iter()
        .map(|name| json!({ "label": name, "kind": 17 }));
    Some(items.collect())
}
