//! A model as a single source file, for use as a module of any crate.
//!
//! The file has no inner attributes or inner documentation, so that it works with `mod` and with `include!`.

use super::function::{self, HEADER};
use super::scalar::Scalar;
use super::{constants, helpers, names, print, tables};
use crate::backend::SourceFile;
use crate::compile::Compiled;
use model_spec::model::Model;
use quote::quote;

pub(super) fn file(model: &Model, compiled: &Compiled, scalar: Scalar) -> SourceFile {
    let inline = match scalar {
        Scalar::F64 => quote!(),
        // Functions that are not inlined are compiled for the baseline processor, where every operation on wide lanes
        // is a call.
        Scalar::Lanes => quote!(#[inline(always)]),
    };
    let attributes = quote! {
        #[allow(dead_code, non_snake_case, clippy::all, clippy::pedantic)]
        #inline
    };
    let constants = constants::items(model, compiled, &quote!(#[allow(dead_code)]));
    let tables = tables::items(compiled, &quote!());
    let functions = compiled
        .functions()
        .map(|function| function::item(compiled, function, scalar, attributes.clone()));
    let functions = quote!(#(#functions)*);
    let (import, helpers) = match scalar {
        Scalar::F64 => (quote!(), helpers::used_in(&functions)),
        Scalar::Lanes => (
            quote!(
                use lanes::Real;
            ),
            quote!(),
        ),
    };
    let text = print::file(
        &header(model),
        quote!(#import #constants #tables #functions #helpers),
    );
    SourceFile {
        path: format!("{}.rs", names::file_stem(&compiled.name)),
        text,
    }
}

fn header(model: &Model) -> Vec<String> {
    let mut lines = vec![HEADER.to_string(), String::new()];
    let doc = model.doc.trim();
    if doc.is_empty() {
        lines.push(format!("Model `{}`.", model.name));
    }
    lines.extend(doc.lines().map(str::to_string));
    lines.push(String::new());
    lines.push("Call `prepare` once per flight, then any other function with its result.".into());
    lines
}
