//! Generated constants of a model: names, default values, sparsity patterns.

use super::names::{CONSTANTS, ident};
use super::{print, source_hash};
use crate::compile::Compiled;
use model_spec::model::Model;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

pub(super) fn items(model: &Model, compiled: &Compiled, attributes: &TokenStream) -> TokenStream {
    let layout = &compiled.layout;
    let bounds: Vec<f64> = model.limits.iter().map(|limit| limit.bound).collect();
    let reasons: Vec<String> = model.limits.iter().map(|l| l.reason.clone()).collect();
    let observe = &compiled.observe_jac;
    let values = [
        strings(&layout.states),
        numbers(&layout.initial),
        strings(&layout.parameters),
        numbers(&layout.defaults),
        number(layout.params),
        number(layout.coefficients),
        strings(&compiled.prepared),
        strings(&layout.quantities),
        numbers(&bounds),
        strings(&reasons),
        pairs(compiled.f_jac.pattern("j")),
        pairs(compiled.f_jac_par.pattern("jp")),
        pairs(observe.pattern("dy_dx")),
        pairs(observe.pattern("dy_dp")),
        pairs(observe.pattern("dy_dmarker")),
        hash(model),
    ];
    let items = CONSTANTS.iter().zip(values).map(|((name, doc), value)| {
        let (name, doc, fill) = (ident(name), print::doc(doc), print::fill());
        let Value { kind, value } = value;
        quote!(#fill #doc #attributes pub const #name: #kind = #value;)
    });
    items.collect()
}

/// Type and initializer of a generated constant.
struct Value {
    kind: TokenStream,
    value: TokenStream,
}

fn array(element: TokenStream, values: Vec<TokenStream>) -> Value {
    let len = Literal::usize_unsuffixed(values.len());
    Value {
        kind: quote!([#element; #len]),
        value: quote!([#(#values),*]),
    }
}

fn strings(values: &[String]) -> Value {
    array(quote!(&str), values.iter().map(|v| quote!(#v)).collect())
}

fn numbers(values: &[f64]) -> Value {
    let one = |&value: &f64| super::scalar::Scalar::F64.constant(value, false).tokens;
    array(quote!(f64), values.iter().map(one).collect())
}

fn pairs(values: &[(u32, u32)]) -> Value {
    let one = |&(row, column): &(u32, u32)| {
        let [row, column] = [row, column].map(Literal::u32_unsuffixed);
        quote!((#row, #column))
    };
    array(quote!((u32, u32)), values.iter().map(one).collect())
}

fn number(value: usize) -> Value {
    let value = Literal::usize_unsuffixed(value);
    Value {
        kind: quote!(usize),
        value: quote!(#value),
    }
}

fn hash(model: &Model) -> Value {
    let digits = format!("{:#x}", source_hash(model)).parse();
    let value = digits.unwrap_or_else(|_| Literal::u64_unsuffixed(source_hash(model)));
    Value {
        kind: quote!(u64),
        value: quote!(#value),
    }
}
