//! Bill of materials of the program: the packages it is built from, as CycloneDX 1.5.

use std::collections::BTreeSet;
use std::path::Path;

use anyhow::{Context, Result};
use cargo_metadata::{DependencyKind, Metadata, MetadataCommand, PackageId};
use serde_json::{Value, json};

use super::{TARGET, VERSION};

/// Writes `hyzer-VERSION.cdx.json`.
pub fn write(root: &Path, parts: &Path) -> Result<()> {
    let metadata = MetadataCommand::new()
        .manifest_path(root.join("Cargo.toml"))
        .other_options(["--locked", "--filter-platform", TARGET].map(str::to_owned))
        .exec()?;
    let used = used(&metadata)?;
    let packages = metadata.packages.iter().filter(|p| used.contains(&p.id));
    let mut components: Vec<Value> = packages
        .map(|package| {
            json!({
                "type": "library",
                "name": package.name.as_str(),
                "version": package.version.to_string(),
                "purl": format!("pkg:cargo/{}@{}", package.name, package.version),
                "licenses": package.license.iter().map(|l| json!({ "expression": l.replace('/', " OR ") })).collect::<Vec<_>>(),
            })
        })
        .collect();
    components.sort_by_key(|component| component["purl"].to_string());
    println!("{} packages", components.len());
    let bill = json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": { "component": { "type": "application", "name": "hyzer", "version": VERSION } },
        "components": components,
    });
    let text = serde_json::to_string_pretty(&bill)?;
    std::fs::write(parts.join(format!("hyzer-{VERSION}.cdx.json")), text + "\n")?;
    Ok(())
}

/// The packages that the program is linked from or built by, itself among them; those of tests are not.
fn used(metadata: &Metadata) -> Result<BTreeSet<PackageId>> {
    let graph = metadata
        .resolve
        .as_ref()
        .context("cargo metadata gave no dependencies")?;
    let root = graph
        .root
        .clone()
        .context("the workspace has no root package")?;
    let (mut used, mut next) = (BTreeSet::new(), vec![root]);
    while let Some(id) = next.pop() {
        if !used.insert(id.clone()) {
            continue;
        }
        let nodes = graph.nodes.iter().filter(|node| node.id == id);
        let needed = nodes.flat_map(|node| &node.deps).filter(|dependency| {
            let mut kinds = dependency.dep_kinds.iter();
            kinds.any(|kind| kind.kind != DependencyKind::Development)
        });
        next.extend(needed.map(|dependency| dependency.pkg.clone()));
    }
    Ok(used)
}
