//! Snapshot of the public API of the library `hyzer`: every item that `src/lib.rs` exports, with the public fields,
//! variants and methods of its types, in `docs/reference/api.txt`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use anyhow::{Context, Result, bail};
use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::{Fields, ImplItem, Item, TraitItem, UseTree, Visibility};

use crate::source;

/// File of the snapshot, relative to the root of the repository.
const SNAPSHOT: &str = "docs/reference/api.txt";

/// Maximum number of public items of the library.
const MAX_ITEMS: usize = 450;

/// Writes the snapshot, or with `check` returns an error that lists how the API differs from it.
pub fn run(root: &Path, check: bool) -> Result<()> {
    let lines = lines(root)?;
    if lines.len() > MAX_ITEMS {
        bail!("{} public items, at most {MAX_ITEMS}", lines.len());
    }
    let path = root.join(SNAPSHOT);
    let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
    if !check {
        std::fs::write(&path, text)?;
        println!("{SNAPSHOT}: {} public items", lines.len());
        return Ok(());
    }
    let known = source::read(&path)?;
    let known: BTreeSet<String> = known.lines().map(str::to_owned).collect();
    let removed = known.difference(&lines).map(|line| format!("- {line}"));
    let added = lines.difference(&known).map(|line| format!("+ {line}"));
    let changes: Vec<String> = removed.chain(added).collect();
    if !changes.is_empty() {
        bail!(
            "the public API differs from {SNAPSHOT}; if that is meant, run `cargo xtask api`:\n{}",
            changes.join("\n")
        );
    }
    println!("{} public items, as in {SNAPSHOT}", lines.len());
    Ok(())
}

fn lines(root: &Path) -> Result<BTreeSet<String>> {
    let library = syn::parse_file(&source::read(&root.join("src/lib.rs"))?)?;
    let mut crates: BTreeMap<String, Vec<Item>> = BTreeMap::new();
    let mut lines = BTreeSet::new();
    for (path, shown) in exports(&library.items, "") {
        let folder = folder(root, &path[0]);
        if !crates.contains_key(&path[0]) {
            crates.insert(path[0].clone(), items(&folder)?);
        }
        let name = path.last().context("an empty path")?;
        let of_item = item_lines(&crates[&path[0]], name, &shown);
        if of_item.is_empty() {
            bail!("src/lib.rs exports {}, which is not found", path.join("::"));
        }
        lines.extend(of_item);
    }
    Ok(lines)
}

/// Paths that the public `use` declarations export, with the name under which the library shows them.
fn exports(items: &[Item], prefix: &str) -> Vec<(Vec<String>, String)> {
    let is_public = |visibility: &Visibility| matches!(visibility, Visibility::Public(_));
    let mut found = Vec::new();
    for item in items {
        match item {
            Item::Use(item) if is_public(&item.vis) => {
                let mut leaves = Vec::new();
                leaves_of(&item.tree, &mut Vec::new(), &mut leaves);
                // `::dataset` is the crate, `dataset` the library's own module.
                let is_extern = item.leading_colon.is_some();
                found.extend(leaves.into_iter().map(|(mut path, name)| {
                    if is_extern {
                        path[0].insert_str(0, "::");
                    }
                    (path, format!("{prefix}{name}"))
                }));
            }
            Item::Mod(module) if is_public(&module.vis) => {
                if let Some((_, items)) = &module.content {
                    found.extend(exports(items, &format!("{prefix}{}::", module.ident)));
                }
            }
            _ => {}
        }
    }
    found
}

fn leaves_of(tree: &UseTree, path: &mut Vec<String>, leaves: &mut Vec<(Vec<String>, String)>) {
    match tree {
        UseTree::Path(inner) => {
            path.push(inner.ident.to_string());
            leaves_of(&inner.tree, path, leaves);
            path.pop();
        }
        UseTree::Group(group) => {
            for tree in &group.items {
                leaves_of(tree, path, leaves);
            }
        }
        UseTree::Name(name) => {
            let name = name.ident.to_string();
            leaves.push(([path.clone(), vec![name.clone()]].concat(), name));
        }
        UseTree::Rename(rename) => {
            let path = [path.clone(), vec![rename.ident.to_string()]].concat();
            leaves.push((path, rename.rename.to_string()));
        }
        UseTree::Glob(_) => {}
    }
}

/// Folder of the source to which the first name of a path refers: a crate, or the library's own module.
fn folder(root: &Path, name: &str) -> std::path::PathBuf {
    let external = name.trim_start_matches("::").replace('_', "-");
    let candidates = [root.join("crates").join(&external), root.join(&external)];
    let own = root.join("src").join(format!("{name}.rs"));
    if own.is_file() {
        return own;
    }
    let found = candidates
        .into_iter()
        .find(|folder| folder.join("src").is_dir());
    found.map_or(own, |folder| folder.join("src"))
}

/// All items of a source file, or of all files below a folder.
fn items(path: &Path) -> Result<Vec<Item>> {
    let files = if path.is_file() {
        vec![path.to_owned()]
    } else {
        source::rust_files(path)?
    };
    let mut items = Vec::new();
    for file in files {
        items.extend(syn::parse_file(&source::read(&file)?)?.items);
    }
    Ok(items)
}

/// One line for the item `name`, and one for each of its public fields, variants and methods.
fn item_lines(items: &[Item], name: &str, shown: &str) -> Vec<String> {
    let mut lines = Vec::new();
    for item in items {
        match item {
            Item::Struct(item) if item.ident == name => {
                lines.push(format!("struct {shown}"));
                lines.extend(fields(&item.fields).map(|field| format!("{shown}::{field}")));
            }
            Item::Enum(item) if item.ident == name => {
                lines.push(format!("enum {shown}"));
                let variants = item.variants.iter().filter(|own| !is_hidden(&own.attrs));
                lines.extend(variants.map(|variant| format!("{shown}::{}", variant.ident)));
            }
            Item::Fn(item) if item.sig.ident == name => {
                lines.push(format!("{shown}: {}", text(item.sig.to_token_stream())));
            }
            Item::Type(item) if item.ident == name => lines.push(format!("type {shown}")),
            Item::Const(item) if item.ident == name => lines.push(format!("const {shown}")),
            Item::Trait(item) if item.ident == name => {
                lines.push(format!("trait {shown}"));
                lines.extend(item.items.iter().filter_map(|item| match item {
                    TraitItem::Fn(item) => {
                        Some(format!("{shown}::{}", text(item.sig.to_token_stream())))
                    }
                    _ => None,
                }));
            }
            Item::Impl(item) if item.trait_.is_none() && is_of(&item.self_ty, name) => {
                lines.extend(item.items.iter().filter_map(|item| match item {
                    ImplItem::Fn(item)
                        if matches!(item.vis, Visibility::Public(_)) && !is_hidden(&item.attrs) =>
                    {
                        Some(format!("{shown}::{}", text(item.sig.to_token_stream())))
                    }
                    _ => None,
                }));
            }
            _ => {}
        }
    }
    lines
}

/// Whether an item is marked `#[doc(hidden)]`: public for the crates of the workspace, and no part of the API.
fn is_hidden(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let hidden = |meta: syn::MetaList| meta.tokens.to_string() == "hidden";
        attribute.path().is_ident("doc") && attribute.meta.require_list().cloned().is_ok_and(hidden)
    })
}

fn fields(fields: &Fields) -> impl Iterator<Item = String> {
    let public = fields
        .iter()
        .filter(|field| matches!(field.vis, Visibility::Public(_)) && !is_hidden(&field.attrs));
    public.filter_map(|field| {
        let name = field.ident.as_ref()?;
        Some(format!("{name}: {}", text(field.ty.to_token_stream())))
    })
}

fn is_of(ty: &syn::Type, name: &str) -> bool {
    match ty {
        syn::Type::Path(path) => path.path.segments.last().is_some_and(|s| s.ident == name),
        _ => false,
    }
}

/// Source text of tokens, with single spaces.
fn text(tokens: TokenStream) -> String {
    tokens
        .to_string()
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
}

#[cfg(test)]
mod tests {
    use super::{exports, item_lines};

    #[test]
    fn fields_variants_and_methods_of_what_is_exported_are_listed() {
        let library = "mod a; pub use a::{S, E as F}; use a::T; pub mod inner { pub use a::S; }";
        let library = syn::parse_file(library).expect("a file");
        let shown: Vec<String> = exports(&library.items, "")
            .into_iter()
            .map(|(_, n)| n)
            .collect();
        assert_eq!(shown, ["S", "F", "inner::S"]);
        let a =
            "pub struct S { pub x: f64, y: u8 } impl S { pub fn of(&self) -> u8 { 1 } fn no() {} }
                 pub enum E { A, B(u8) } impl Clone for S { fn clone(&self) -> S { todo() } }";
        let a = syn::parse_file(a).expect("a file").items;
        let of = |name: &str| item_lines(&a, name, name);
        assert_eq!(
            of("S"),
            ["struct S", "S::x: f64", "S::fn of (& self) -> u8"]
        );
        assert_eq!(of("E"), ["enum E", "E::A", "E::B"]);
    }
}
