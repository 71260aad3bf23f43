//! What is not arithmetic: a model's constants, the table of its functions, the list of all models.

use super::quoted;
use crate::compile::Compiled;
use model_spec::model::Model;
use std::fmt::Write;

/// A number that tells texts of models apart (FNV-1a, 64 bits, over all texts that the model was made from).
pub fn source_hash(model: &Model) -> u64 {
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    for source in &model.sources {
        for byte in source.text.bytes().chain([0xff]) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    hash
}

/// `mod.rs` of a model.
pub(super) fn module(compiled: &Compiled, model: &Model) -> String {
    let layout = &compiled.layout;
    let mut text = String::from("// Written by `hyzer generate`; changes belong in the model.\n");
    for line in model.doc.lines() {
        let _ = writeln!(text, "{}", format!("//! {line}").trim_end());
    }
    if model.doc.trim().is_empty() {
        let _ = writeln!(text, "//! `{}`.", compiled.name);
    }
    text.push_str("//!\n//! | function | operations |\n//! |---|---|\n");
    for function in compiled.functions() {
        let _ = writeln!(
            text,
            "//! | `{}` | {} |",
            function.name,
            crate::count::count(&function.program)
        );
    }
    text.push('\n');
    // modules in the order of rustfmt
    let mut modules: Vec<&str> = compiled
        .functions()
        .iter()
        .map(|function| function.name)
        .collect();
    modules.sort_unstable();
    let declared: String = modules
        .iter()
        .map(|name| format!("mod {name};\n"))
        .collect();
    text.push_str(&declared);
    text.push('\n');
    for name in &modules {
        let _ = writeln!(text, "pub use {name}::{name};");
    }
    text.push('\n');

    let numbers = |values: &[f64]| values.iter().map(|v| format!("{v:?}")).collect::<Vec<_>>();
    let strings = |values: &[String]| values.iter().map(|v| quoted(v)).collect::<Vec<_>>();
    list(
        &mut text,
        "STATES",
        "States, in order.",
        "&str",
        &strings(&layout.states),
    );
    list(
        &mut text,
        "INITIAL",
        "States where a release does not say otherwise.",
        "f64",
        &numbers(&layout.initial),
    );
    list(
        &mut text,
        "PARAMETERS",
        "Constants of the body and the place, coefficients, components of the inputs, in order.",
        "&str",
        &strings(&layout.parameters),
    );
    list(
        &mut text,
        "DEFAULTS",
        "Default values of `PARAMETERS`.",
        "f64",
        &numbers(&layout.defaults),
    );
    scalar(
        &mut text,
        "PARAMS",
        "How many of them are constants of the body and the place.",
        "usize",
        layout.params,
    );
    scalar(
        &mut text,
        "COEFFICIENTS",
        "How many are coefficients, after those.",
        "usize",
        layout.coefficients,
    );
    list(
        &mut text,
        "PREPARED",
        "What `prepare` computes.",
        "&str",
        &strings(&compiled.prepared),
    );
    list(
        &mut text,
        "QUANTITIES",
        "What `quantities` computes.",
        "&str",
        &strings(&layout.quantities),
    );
    let bounds: Vec<f64> = model.limits.iter().map(|limit| limit.bound).collect();
    list(
        &mut text,
        "LIMITS",
        "The model holds where each of `limits` is above its bound.",
        "f64",
        &numbers(&bounds),
    );
    let reasons: Vec<String> = model
        .limits
        .iter()
        .map(|limit| limit.reason.clone())
        .collect();
    list(
        &mut text,
        "LIMIT_REASONS",
        "What happens at each limit.",
        "&str",
        &strings(&reasons),
    );
    pattern(
        &mut text,
        "J_PATTERN",
        "(row, column) of each entry of `j`.",
        compiled.f_jac.pattern("j"),
    );
    pattern(
        &mut text,
        "JP_PATTERN",
        "(row, column) of each entry of `jp`.",
        compiled.f_jac_par.pattern("jp"),
    );
    let observe = &compiled.observe_jac;
    pattern(
        &mut text,
        "DY_DX_PATTERN",
        "(row, column) of each entry of `dy_dx`.",
        observe.pattern("dy_dx"),
    );
    pattern(
        &mut text,
        "DY_DP_PATTERN",
        "(row, column) of each entry of `dy_dp`.",
        observe.pattern("dy_dp"),
    );
    pattern(
        &mut text,
        "DY_DMARKER_PATTERN",
        "(row, column) of each entry of `dy_dmarker`.",
        observe.pattern("dy_dmarker"),
    );
    let _ = writeln!(
        text,
        "/// Tells whether this code belongs to a model's text.\npub const SOURCE_HASH: u64 = {:#x};\n",
        source_hash(model)
    );
    equations(&mut text, compiled);
    text
}

fn list(text: &mut String, name: &str, doc: &str, kind: &str, values: &[String]) {
    let _ = writeln!(
        text,
        "/// {doc}\n#[rustfmt::skip]\npub const {name}: [{kind}; {}] = [",
        values.len()
    );
    let mut line = String::from("   ");
    for value in values {
        if line.len() + value.len() + 2 > super::WIDTH {
            let _ = writeln!(text, "{line}");
            line = String::from("   ");
        }
        let _ = write!(line, " {value},");
    }
    if !values.is_empty() {
        let _ = writeln!(text, "{line}");
    }
    text.push_str("];\n\n");
}

fn scalar(text: &mut String, name: &str, doc: &str, kind: &str, value: usize) {
    let _ = writeln!(text, "/// {doc}\npub const {name}: {kind} = {value};\n");
}

/// One row of the matrix a line.
fn pattern(text: &mut String, name: &str, doc: &str, entries: &[(u32, u32)]) {
    let _ = writeln!(
        text,
        "/// {doc}\n#[rustfmt::skip]\npub const {name}: [(u32, u32); {}] = [",
        entries.len()
    );
    for row in entries.chunk_by(|a, b| a.0 == b.0) {
        let row: Vec<String> = row.iter().map(|(r, c)| format!("({r}, {c}),")).collect();
        let _ = writeln!(text, "    {}", row.join(" "));
    }
    text.push_str("];\n\n");
}

/// The implementation of the crate's trait, over slices.
fn equations(text: &mut String, compiled: &Compiled) {
    let kind = type_name(&compiled.name);
    let _ = writeln!(
        text,
        "/// These equations as a type.\n#[derive(Clone, Copy, Debug)]\npub struct {kind};\n"
    );
    let _ = writeln!(text, "impl crate::Equations for {kind} {{");
    let _ = writeln!(text, "    const MODEL: &'static crate::Model = &MODEL;\n");
    for function in compiled.functions() {
        let mut arguments: Vec<String> = Vec::new();
        let mut passed: Vec<String> = Vec::new();
        for (name, kind) in super::function::inputs(compiled, function.name) {
            if kind.starts_with('&') {
                arguments.push(format!("{name}: &[T]"));
                passed.push(format!("crate::array({name})"));
            } else {
                arguments.push(format!("{name}: T"));
                passed.push(name.to_string());
            }
        }
        for section in &function.sections {
            let name = super::function::output(section.name);
            arguments.push(format!("{name}: &mut [T]"));
            passed.push(format!("crate::array_mut({name})"));
        }
        let name = function.name;
        let _ = writeln!(text, "    #[rustfmt::skip]\n    #[inline(always)]");
        let _ = writeln!(
            text,
            "    fn {name}<T: lanes::Real>({}) {{",
            arguments.join(", ")
        );
        let _ = writeln!(text, "        {name}({});\n    }}", passed.join(", "));
        text.push('\n');
    }
    text.truncate(text.trim_end().len());
    text.push_str("\n}\n\n");
    let observed = !compiled.layout.marker.is_empty();
    let _ = writeln!(
        text,
        "/// The table of this model, for callers that pick one by name."
    );
    let _ = writeln!(text, "pub static MODEL: crate::Model = crate::Model {{");
    let _ = writeln!(text, "    name: {},", quoted(&compiled.name));
    let _ = writeln!(text, "    source_hash: SOURCE_HASH,");
    for (field, value) in [
        ("states", "STATES"),
        ("initial", "INITIAL"),
        ("parameters", "PARAMETERS"),
        ("defaults", "DEFAULTS"),
        ("prepared", "PREPARED"),
        ("quantity_names", "QUANTITIES"),
        ("limit_bounds", "LIMITS"),
        ("limit_reasons", "LIMIT_REASONS"),
        ("j_pattern", "J_PATTERN"),
        ("jp_pattern", "JP_PATTERN"),
        ("dy_dx_pattern", "DY_DX_PATTERN"),
        ("dy_dp_pattern", "DY_DP_PATTERN"),
        ("dy_dmarker_pattern", "DY_DMARKER_PATTERN"),
    ] {
        let _ = writeln!(text, "    {field}: &{value},");
    }
    let _ = writeln!(
        text,
        "    params: PARAMS,\n    coefficients: COEFFICIENTS,\n    observed: {observed},"
    );
    for function in compiled.functions() {
        let name = function.name;
        let _ = writeln!(text, "    {name}: crate::plain::{name}::<{kind}>,");
    }
    text.push_str("};\n");
}

/// `disc_quaternion` as `DiscQuaternion`.
fn type_name(name: &str) -> String {
    name.split('_')
        .map(|word| {
            let mut letters = word.chars();
            letters.next().map_or_else(String::new, |first| {
                first.to_uppercase().chain(letters).collect()
            })
        })
        .collect()
}

/// `lib.rs` of the crate of generated models.
pub fn library(names: &[String]) -> String {
    let mut sorted = names.to_vec();
    sorted.sort();
    let mut text = String::from(include_str!("library.txt"));
    let modules: String = sorted
        .iter()
        .map(|name| format!("pub mod {name};\n"))
        .collect();
    let models: Vec<String> = names.iter().map(|name| format!("&{name}::MODEL")).collect();
    let mut table = format!("pub static MODELS: &[&Model] = &[{}];", models.join(", "));
    if table.len() > super::WIDTH || models.join(", ").len() > 60 {
        table = String::from("#[rustfmt::skip]\npub static MODELS: &[&Model] = &[\n");
        for model in &models {
            let _ = writeln!(table, "    {model},");
        }
        table.push_str("];");
    }
    let arms: String = names
        .iter()
        .map(|name| {
            format!(
                "        {} => Some(visitor.visit::<{name}::{}>()),\n",
                quoted(name),
                type_name(name)
            )
        })
        .collect();
    text = text
        .replace("@MODULES@\n", &modules)
        .replace("@MODELS@", &table)
        .replace("@ARMS@\n", &arms);
    text
}
