//! Operations, counted by the tool that counts those of the peers.

use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// Operations of one of the disc's functions; calls of ours that the tool does not know, such as `recip_or_zero`, are one each.
pub fn ours(root: &Path, function: &str) -> Option<u64> {
    let output = Command::new("python3")
        .arg(root.join("benches/peers/count_ops.py"))
        .arg(root.join(format!("crates/generated/src/disc/{function}.rs")))
        .arg(function)
        .output()
        .ok()?;
    let counts: Value = serde_json::from_slice(&output.stdout).ok()?;
    let of = &counts[function];
    let calls = of["calls"].as_object();
    let calls: u64 = calls.map_or(0, |calls| calls.values().filter_map(Value::as_u64).sum());
    Some(of["total"].as_u64()? + calls)
}
