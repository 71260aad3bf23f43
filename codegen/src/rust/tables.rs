//! Generated constants of tables: knots and cubics, named after the table.

use super::function::HEADER;
use super::print;
use super::scalar::Scalar;
use super::table_names::{names, of_two, surfaces_of, used_by};
use crate::compile::Compiled;
use crate::table::{PiecewiseCubic, TableFunction, TableId, Tables};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::collections::{BTreeMap, BTreeSet};

/// Text of the source file with the tables of a model in the crate `generated`; `None` if the model uses no tables.
pub(super) fn file(compiled: &Compiled) -> Option<String> {
    let items = items(compiled, &quote!(pub(super)));
    let title = print::inner_doc(&format!("Tables of `{}`.", compiled.name));
    (!items.is_empty()).then(|| print::file(&[HEADER], quote!(#title #items)))
}

pub(super) fn items(compiled: &Compiled, visibility: &TokenStream) -> TokenStream {
    let mut items = TokenStream::new();
    let functions = compiled.functions();
    let tables = &compiled.f.program.tables;
    let surfaces = functions.iter().flat_map(|f| surfaces_of(f));
    let surfaces: BTreeMap<TableId, TableFunction<2>> = surfaces.collect();
    for function in surfaces.into_values() {
        items.extend(of_surface(tables, function, visibility));
    }
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
    let (argument, unit) = &table.arguments[0];
    let mut doc = format!(
        "Table `{}`, arguments `{argument}` of its knots",
        table.name
    );
    if unit != "1" {
        doc.push_str(&format!(" in {unit}"));
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
    let what = match function.orders()[0] {
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

/// Constants of a table of two arguments: knots of each, and cells.
fn of_surface(
    tables: &Tables,
    function: TableFunction<2>,
    visibility: &TokenStream,
) -> TokenStream {
    let table = tables.table(function.table());
    let bicubic = table.bicubic();
    let [x, y, cells] = of_two(tables, function);
    let (fill, attributes) = (print::fill(), attributes());
    let of_argument = |k: usize, name| {
        let (argument, unit) = &table.arguments[k];
        let doc = print::doc(&format!(
            "Table `{}`, knots of the argument `{argument}` in {unit}.",
            table.name
        ));
        let knots = bicubic.knots()[k];
        let (len, knots) = (Literal::usize_unsuffixed(knots.len()), numbers(knots));
        quote!(#fill #doc #attributes #visibility const #name: [f64; #len] = #knots;)
    };
    let (x, y) = (of_argument(0, x), of_argument(1, y));
    let mut doc = format!("Table `{}`: coefficients of its cells.", table.name);
    if !table.doc.is_empty() {
        doc.push_str(&format!("\n\n{}", table.doc));
    }
    let doc = print::doc(&doc);
    let len = Literal::usize_unsuffixed(bicubic.cells().len());
    let rows = bicubic.cells().iter().map(|row| numbers(row));
    quote!(#x #y #fill #doc #attributes #visibility const #cells: [[f64; 16]; #len] = [#(#rows),*];)
}

fn numbers(values: &[f64]) -> TokenStream {
    let values = values.iter();
    let values = values.map(|&value| Scalar::F64.constant(value, false).tokens);
    quote!([#(#values),*])
}
