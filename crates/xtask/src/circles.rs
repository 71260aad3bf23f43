//! Detection of import cycles between the modules of a crate.
//!
//! A module imports another if a path in its code, its attributes or the arguments of its macros resolves to an item of
//! the other, with re-exports followed. The children of one parent are compared with each other, each as a whole with
//! all modules inside it; a parent and its child may use each other.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Item, UseTree};

use crate::source;

/// Path of a module from its crate's root, one name per segment; empty for the root itself.
type ModulePath = Vec<String>;

/// Imports, re-exports and definitions of a source file. All paths to items start at the crate's root.
#[derive(Default)]
struct Module {
    file: PathBuf,
    /// Paths of the items that the code of the file mentions or that its non-public `use` declarations import.
    named: BTreeSet<Vec<String>>,
    /// Maps each name that a `use` declaration of the file introduces (`b` in `use a::b`), whether public or not, to
    /// the path of the imported item.
    exports: BTreeMap<String, Vec<String>>,
    /// Paths of the modules from which the file imports all public names, as in `use a::*`.
    globs: Vec<Vec<String>>,
    /// Names of the items that the file defines, such as types and functions.
    defined: BTreeSet<String>,
}

/// Returns an error that lists the import cycles between the source files of each crate, if there are any.
pub fn check(root: &Path) -> Result<()> {
    let mut circles = Vec::new();
    let mut files = 0;
    for folder in source::crates(root)? {
        if source::is_generated(&folder) {
            continue;
        }
        let modules = modules(&folder.join("src"))?;
        files += modules.len();
        for circle in circles_of(&modules) {
            let names = circle.iter().map(|module| {
                let file = &modules[module].file;
                format!("  {}", source::relative(root, file))
            });
            circles.push(names.collect::<Vec<_>>().join("\n"));
        }
    }
    if !circles.is_empty() {
        bail!(
            "{} import circles:\n{}",
            circles.len(),
            circles.join("\n\n")
        );
    }
    println!("no import circle among the modules of {files} files");
    Ok(())
}

fn modules(source: &Path) -> Result<BTreeMap<ModulePath, Module>> {
    let mut modules = BTreeMap::new();
    let is_test = |file: &Path| {
        let parts = file.with_extension("");
        parts
            .iter()
            .any(|part| part == "tests" || part == "test_support")
    };
    for file in source::rust_files(source)? {
        if is_test(file.strip_prefix(source)?) {
            continue;
        }
        let path = module_path(file.strip_prefix(source)?);
        let tree = syn::parse_file(&source::read(&file)?)?;
        let mut module = Module {
            file,
            ..Module::default()
        };
        let mut reader = Reader {
            here: path.clone(),
            module: &mut module,
        };
        reader.visit_file(&tree);
        modules.insert(path, module);
    }
    Ok(modules)
}

/// Module path of a file: `a::b` for both `a/b.rs` and `a/b/mod.rs`.
fn module_path(file: &Path) -> ModulePath {
    let mut path: ModulePath = file
        .with_extension("")
        .iter()
        .map(|part| part.to_string_lossy().into_owned())
        .collect();
    if path
        .last()
        .is_some_and(|last| ["mod", "lib", "main"].contains(&last.as_str()))
    {
        path.pop();
    }
    path
}

/// Syntax visitor that collects the imports and definitions of a source file; inline modules, such as tests, are
/// skipped.
struct Reader<'m> {
    here: ModulePath,
    module: &'m mut Module,
}

impl Reader<'_> {
    /// Converts a path in the source code of the file, such as `super::a::b`, to a path from the crate's root. `None`
    /// if the path is empty or leads above the root.
    fn absolute(&self, path: &[String]) -> Option<Vec<String>> {
        let mut base = self.here.clone();
        let mut rest = path;
        match rest.first()?.as_str() {
            "crate" => {
                base.clear();
                rest = &rest[1..];
            }
            "self" => rest = &rest[1..],
            "super" => {
                while rest.first().is_some_and(|part| part == "super") {
                    base.pop()?;
                    rest = &rest[1..];
                }
            }
            _ => {}
        }
        base.extend(rest.iter().cloned());
        Some(base)
    }

    fn use_tree(&mut self, tree: &UseTree, prefix: &mut Vec<String>, is_public: bool) {
        match tree {
            UseTree::Path(path) => {
                prefix.push(path.ident.to_string());
                self.use_tree(&path.tree, prefix, is_public);
                prefix.pop();
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.use_tree(tree, prefix, is_public);
                }
            }
            UseTree::Name(name) => self.used(&name.ident.to_string(), None, prefix, is_public),
            UseTree::Rename(rename) => {
                let (name, new) = (rename.ident.to_string(), rename.rename.to_string());
                self.used(&name, Some(new), prefix, is_public);
            }
            UseTree::Glob(_) => {
                if let Some(path) = self.absolute(prefix) {
                    self.module.named.insert(path.clone());
                    self.module.globs.push(path);
                }
            }
        }
    }

    /// Collects the paths, such as `crate::a::b`, in the arguments of an attribute or a macro.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut path: Vec<String> = Vec::new();
        let mut joined = false;
        for token in tokens {
            match token {
                TokenTree::Ident(ident) => {
                    if !joined {
                        self.path(&path);
                        path.clear();
                    }
                    path.push(ident.to_string());
                    joined = false;
                }
                TokenTree::Punct(punct) if punct.as_char() == ':' => joined = true,
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Punct(_) | TokenTree::Literal(_) => joined = false,
            }
        }
        self.path(&path);
    }

    fn path(&mut self, path: &[String]) {
        if path.len() > 1
            && let Some(path) = self.absolute(path)
        {
            self.module.named.insert(path);
        }
    }

    fn used(&mut self, name: &str, rename: Option<String>, prefix: &[String], is_public: bool) {
        let mut path = prefix.to_vec();
        if name != "self" {
            path.push(name.to_owned());
        }
        let Some(path) = self.absolute(&path) else {
            return;
        };
        let key = rename.or_else(|| path.last().cloned()).unwrap_or_default();
        self.module.exports.insert(key, path.clone());
        // A module that only re-exports a name does not depend on it.
        if !is_public {
            self.module.named.insert(path);
        }
    }
}

impl<'a> Visit<'a> for Reader<'_> {
    fn visit_item(&mut self, item: &'a Item) {
        match item {
            Item::Mod(inner) if inner.content.is_some() => {}
            Item::Use(item) => {
                let is_public = !matches!(item.vis, syn::Visibility::Inherited);
                self.use_tree(&item.tree, &mut Vec::new(), is_public);
            }
            _ => {
                self.module.defined.extend(name_of(item));
                visit::visit_item(self, item);
            }
        }
    }

    fn visit_attribute(&mut self, attribute: &'a syn::Attribute) {
        if let syn::Meta::List(list) = &attribute.meta {
            self.tokens(list.tokens.clone());
        }
    }

    fn visit_macro(&mut self, call: &'a syn::Macro) {
        // Code that is written, not run.
        if call.path.is_ident("quote") {
            return;
        }
        self.tokens(call.tokens.clone());
        visit::visit_macro(self, call);
    }

    fn visit_path(&mut self, path: &'a syn::Path) {
        let parts: Vec<String> = path
            .segments
            .iter()
            .map(|part| part.ident.to_string())
            .collect();
        self.path(&parts);
        visit::visit_path(self, path);
    }
}

fn name_of(item: &Item) -> Option<String> {
    let ident = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        _ => return None,
    };
    Some(ident.to_string())
}

/// Import cycles of a crate: among the children of each module, every child with all modules inside it.
fn circles_of(modules: &BTreeMap<ModulePath, Module>) -> Vec<Vec<ModulePath>> {
    let mut levels: BTreeMap<usize, BTreeMap<ModulePath, BTreeSet<ModulePath>>> = BTreeMap::new();
    for (here, module) in modules {
        for depth in 1..=here.len() {
            let level = levels.entry(depth).or_default();
            level.entry(here[..depth].to_vec()).or_default();
        }
        for path in &module.named {
            let Some(there) = target(modules, here, path) else {
                continue;
            };
            let common = here.iter().zip(&there).take_while(|(a, b)| a == b).count();
            // Otherwise one of the two is inside the other.
            if common < here.len().min(there.len()) {
                let level = levels.entry(common + 1).or_default();
                let imports = level.entry(here[..=common].to_vec()).or_default();
                imports.insert(there[..=common].to_vec());
                level.entry(there[..=common].to_vec()).or_default();
            }
        }
    }
    levels.values().flat_map(strong_components).collect()
}

/// Module that defines the item to which `path` refers when used in the module `here`; `None` if no module of the crate
/// defines it.
fn target(
    modules: &BTreeMap<ModulePath, Module>,
    here: &ModulePath,
    path: &[String],
) -> Option<ModulePath> {
    let mut path = path.to_vec();
    // The path may start with a name that the file imports.
    if path.len() > here.len() + 1
        && let Some(exported) = modules[here].exports.get(&path[here.len()])
        && path.starts_with(here)
    {
        path.splice(..=here.len(), exported.iter().cloned());
    }
    for _ in 0..16 {
        let depth = (0..=path.len())
            .rev()
            .find(|&depth| modules.contains_key(&path[..depth]))?;
        let module = &modules[&path[..depth]];
        let Some(name) = path.get(depth) else {
            return Some(path);
        };
        if module.defined.contains(name) {
            return Some(path[..depth].to_vec());
        }
        if let Some(exported) = module.exports.get(name) {
            path.splice(..=depth, exported.iter().cloned());
            continue;
        }
        let defines = |glob: &&Vec<String>| {
            modules
                .get(*glob)
                .is_some_and(|module| module.defined.contains(name))
        };
        return module.globs.iter().find(defines).cloned();
    }
    None
}

/// Strongly connected components of the import graph with more than one module, which are the import cycles.
fn strong_components(arrows: &BTreeMap<ModulePath, BTreeSet<ModulePath>>) -> Vec<Vec<ModulePath>> {
    let reach: BTreeMap<&ModulePath, BTreeSet<&ModulePath>> = arrows
        .keys()
        .map(|from| (from, reachable(arrows, from)))
        .collect();
    let mut found: BTreeSet<Vec<ModulePath>> = BTreeSet::new();
    for (from, targets) in &reach {
        let mutual = targets.iter().filter(|to| reach[**to].contains(*from));
        let mut circle: Vec<ModulePath> = mutual.map(|to| (*to).clone()).collect();
        circle.sort();
        if circle.len() > 1 {
            found.insert(circle);
        }
    }
    found.into_iter().collect()
}

fn reachable<'a>(
    arrows: &'a BTreeMap<ModulePath, BTreeSet<ModulePath>>,
    from: &'a ModulePath,
) -> BTreeSet<&'a ModulePath> {
    let mut seen = BTreeSet::new();
    let mut pending = vec![from];
    while let Some(module) = pending.pop() {
        for next in &arrows[module] {
            if seen.insert(next) {
                pending.push(next);
            }
        }
    }
    seen
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{circles_of, modules};

    /// Import cycles between source files given as (path, text).
    fn circles(files: &[(&str, &str)]) -> Vec<Vec<String>> {
        let folder = tempfile::tempdir().expect("a folder");
        for (path, text) in files {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().expect("a parent")).expect("a folder");
            fs::write(path, text).expect("a file");
        }
        let found = circles_of(&modules(folder.path()).expect("modules"));
        let joined = |circle: &Vec<Vec<String>>| circle.iter().map(|m| m.join("::")).collect();
        found.iter().map(joined).collect()
    }

    #[test]
    fn two_files_that_import_each_other_are_a_circle() {
        let a = ("a.rs", "use crate::b::f; pub fn g() { f() }");
        let b = ("b.rs", "pub fn f() { super::a::g() }");
        assert_eq!(circles(&[("lib.rs", "mod a; mod b;"), a, b]), [["a", "b"]]);
    }

    #[test]
    fn a_circle_through_a_re_export_is_found() {
        let lib = ("lib.rs", "mod a; mod b; pub use a::g;");
        let a = ("a.rs", "use crate::b::f; pub fn g() { f() }");
        let b = ("b.rs", "use crate::g; pub fn f() { g() }");
        assert_eq!(circles(&[lib, a, b]), [["a", "b"]]);
    }

    #[test]
    fn folders_and_attributes_are_looked_into() {
        let lib = ("lib.rs", "mod a; mod b;");
        let a = ("a/mod.rs", "mod inner; pub use inner::S;");
        let inner = ("a/inner.rs", "pub struct S(crate::b::T);");
        let b = (
            "b.rs",
            "#[error(\"{}\", crate::a::inner::LAW)] pub struct T; pub fn f() { vec![1] }",
        );
        assert!(circles(&[lib, a, inner, b]).is_empty());
        let inner = (
            "a/inner.rs",
            "pub const LAW: i8 = 1; pub struct S(crate::b::T);",
        );
        assert_eq!(circles(&[lib, a, inner, b]), [["a", "b"]]);
        let b = ("b.rs", "pub struct T; pub fn f() { g!(1, super::a::S) }");
        assert_eq!(circles(&[lib, a, inner, b]), [["a", "b"]]);
    }

    #[test]
    fn nesting_and_tests_are_no_circle() {
        let a = (
            "a/mod.rs",
            "mod inner; pub struct S; pub fn f() { inner::g() }",
        );
        let inner = (
            "a/inner.rs",
            "use super::S; pub fn g() {} #[cfg(test)] mod tests { use crate::b::h; }",
        );
        let b = ("b.rs", "use crate::a::f; pub fn h() { f() }");
        assert!(circles(&[("lib.rs", "mod a; mod b;"), a, inner, b]).is_empty());
    }
}
