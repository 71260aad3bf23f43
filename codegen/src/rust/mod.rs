//! Rust backends: token trees by `quote`, printed by `prettyplease`.
//!
//! [`PlainRust`] writes a model as one module over `f64` without dependencies, for use in any crate. [`LanesRust`]
//! writes the same module generic over [`lanes::Real`]. [`emit`] and [`library`] write the crate `generated` of this
//! repository, whose models can also be selected at run time.

mod constants;
mod expression;
mod function;
mod helpers;
mod library;
mod module;
mod names;
mod print;
mod scalar;
mod signature;
mod table_names;
mod tables;

pub use library::library;

pub(crate) use function::file as function_file;

use crate::backend::{Backend, SourceFile};
use crate::compile::Compiled;
use model_spec::model::Model;
use scalar::Scalar;

/// Backend of one module per model, on `f64`, without dependencies.
#[derive(Clone, Copy, Debug)]
pub struct PlainRust;

/// Backend of one module per model, generic over [`lanes::Real`].
#[derive(Clone, Copy, Debug)]
pub struct LanesRust;

impl Backend for PlainRust {
    fn name(&self) -> &'static str {
        "rust"
    }

    fn description(&self) -> &'static str {
        "Rust module over f64, without dependencies"
    }

    fn emit(&self, model: &Model, compiled: &Compiled) -> Vec<SourceFile> {
        vec![module::file(model, compiled, Scalar::F64)]
    }
}

impl Backend for LanesRust {
    fn name(&self) -> &'static str {
        "rust-lanes"
    }

    fn description(&self) -> &'static str {
        "Rust module generic over lanes::Real, for SIMD; needs the crate lanes"
    }

    fn emit(&self, model: &Model, compiled: &Compiled) -> Vec<SourceFile> {
        vec![module::file(model, compiled, Scalar::Lanes)]
    }
}

/// Source files of one model in the crate `generated`: `disc/mod.rs`, `disc/f.rs`, …
pub fn emit(compiled: &Compiled, model: &Model) -> Vec<SourceFile> {
    let folder = names::file_stem(&compiled.name);
    let mut files = vec![SourceFile {
        path: format!("{folder}/mod.rs"),
        text: library::model_module(compiled, model),
    }];
    files.extend(tables::file(compiled).map(|text| SourceFile {
        path: format!("{folder}/tables.rs"),
        text,
    }));
    for function in compiled.functions() {
        files.push(SourceFile {
            path: format!("{folder}/{}.rs", function.name),
            text: function::file(compiled, function),
        });
    }
    files
}

/// Hash (64-bit FNV-1a) of all source texts of a model.
pub fn source_hash(model: &Model) -> u64 {
    let texts = model.sources.iter();
    let bytes = texts.flat_map(|source| source.text.bytes().chain([0xff]));
    model_spec::fingerprint(&bytes.collect::<Vec<u8>>())
}
