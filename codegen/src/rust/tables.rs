//! Generated constants of tables: knots and cubics, named after the table.

use super::function::HEADER;
use super::print;
use super::scalar::Scalar;
use super::table_names::{names, used_by};
use crate::compile::Compiled;
use crate::table::{PiecewiseCubic, TableFunction, Tables};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::collections::BTreeSet;

/// Text of the source file with the tables of a model in the crate `generated`; `None` if the model uses no tables.
pub(super) fn file(compiled: &Compiled) -> Option<String> {
    let items = items(compiled, &quote!(pub(super)));
    let title = print::inner_doc(&format!("Tables of `{}`.", compiled.name));
    (!items.is_empty()).then(|| print::file(&[HEADER], quote!(#title #items)))
}

pub(super) fn items(compiled: &Compiled, visibility: &TokenStream) -> TokenStream {
    let mut items = TokenStream::new();
    let functions = compiled.functions();
    let Some(with_tables) = functions.iter().find(|f| !used_by(f).is_empty()) else {
        return items;
    };
    let tables = &with_tables.program.tables;
    let used: BTreeSet<TableFunction> = functions.into_iter().flat_map(used_by).collect();
    let mut table = None;
    for function in used {
        if table != Some(function.table()) {
            table = Some(function.table());
            items.extend(knots(tables, function, visibility));
        }
        items.extend(cubics(tables, function, visibility));
    }
    items
}

fn attributes() -> TokenStream {
    quote!(#[allow(non_upper_case_globals, clippy::all, clippy::pedantic)])
}

fn knots(tables: &Tables, function: TableFunction, visibility: &TokenStream) -> TokenStream {
    let table = tables.table(function.table());
    let [name, _] = names(tables, function);
    let knots = table.cubic(0).knots();
    let mut doc = format!(
        "Table `{}`, arguments `{}` of its knots",
        table.name, table.argument
    );
    if table.unit_texts[0] != "1" {
        doc.push_str(&format!(" in {}", table.unit_texts[0]));
    }
    doc.push('.');
    if !table.doc.is_empty() {
        doc.push_str(&format!("\n\n{}", table.doc));
    }
    let (doc, fill, attributes) = (print::doc(&doc), print::fill(), attributes());
    let len = Literal::usize_unsuffixed(knots.len());
    let knots = numbers(knots);
    quote!(#fill #doc #attributes #visibility const #name: [f64; #len] = #knots;)
}

fn cubics(tables: &Tables, function: TableFunction, visibility: &TokenStream) -> TokenStream {
    let [_, name] = names(tables, function);
    let cubic: &PiecewiseCubic = tables.of(function);
    let what = match function.order() {
        0 => format!("Table `{}`", tables.name(function)),
        1 => format!(
            "Derivative of the table `{}`",
            tables.table(function.table()).name
        ),
        order => format!(
            "Derivative of order {order} of the table `{}`",
            tables.table(function.table()).name
        ),
    };
    let doc = format!(
        "{what}: coefficients of the powers 0 to 3 of the distance from the knot below, before the first knot and from each."
    );
    let (doc, fill, attributes) = (print::doc(&doc), print::fill(), attributes());
    let len = Literal::usize_unsuffixed(cubic.cubics().len());
    let rows = cubic.cubics().iter().map(|row| numbers(row));
    quote!(#fill #doc #attributes #visibility const #name: [[f64; 4]; #len] = [#(#rows),*];)
}

fn numbers(values: &[f64]) -> TokenStream {
    let values = values.iter();
    let values = values.map(|&value| Scalar::F64.constant(value, false).tokens);
    quote!([#(#values),*])
}
