//! Tables in generated code: constants with the name of the table, and the function that looks one up.

use super::function::HEADER;
use super::print;
use super::scalar::Scalar;
use crate::compile::Compiled;
use crate::functions::MathFunction;
use crate::program::{Function, Op, Unary};
use crate::table::{PiecewiseCubic, TableFunction, Tables};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeSet;

use super::expr::Expr;

/// Method of `lanes::Real`, and helper function for `f64`, that looks up a table.
pub(super) const METHOD: &str = "piecewise_cubic";

/// Ends of the names of constants for the knots and for the cubics between them; derivatives have their order behind.
const ENDS: [&str; 2] = ["_KNOTS", "_CUBICS"];

/// Whether a name may be that of a constant of a table.
pub(super) fn is_constant(name: &str) -> bool {
    ENDS.iter().any(|end| name.contains(end))
}

/// Arguments of the call that looks up a table, behind the first.
pub(super) fn arguments(tables: &Tables, function: TableFunction) -> [Expr; 2] {
    names(tables, function).map(|name| Expr::atom(quote!(&#name)))
}

/// Names of the constants of a function: the knots of its table and its cubics.
fn names(tables: &Tables, function: TableFunction) -> [Ident; 2] {
    let table = &tables.table(function.table()).name;
    let [knots, cubics] = ENDS;
    let order = match function.order() {
        0 => String::new(),
        order => format!("_{order}"),
    };
    [
        format_ident!("{table}{knots}"),
        format_ident!("{table}{cubics}{order}"),
    ]
}

/// Tables and their derivatives that a function looks up, in order.
fn used_by(function: &Function) -> BTreeSet<TableFunction> {
    let statements = function.program.statements.iter();
    let used = statements.filter_map(|statement| match statement.op {
        Op::Unary(Unary::Call(MathFunction::Table(function)), _) => Some(function),
        _ => None,
    });
    used.collect()
}

/// Import of the constants that a function looks up, from the file of [`file`]; nothing without tables.
pub(super) fn import(function: &Function) -> TokenStream {
    let tables = &function.program.tables;
    let used = used_by(function).into_iter();
    let names: BTreeSet<Ident> = used.flat_map(|f| names(tables, f)).collect();
    match names.is_empty() {
        true => TokenStream::new(),
        false => quote!(use super::tables::{#(#names),*};),
    }
}

/// Source file of the tables of a model in the crate `generated`; `None` without tables.
pub(super) fn file(compiled: &Compiled) -> Option<String> {
    let items = items(compiled, &quote!(pub(super)));
    let title = print::inner_doc(&format!("Tables of `{}`.", compiled.name));
    (!items.is_empty()).then(|| print::file(&[HEADER], quote!(#title #items)))
}

/// Constants of all tables that a model looks up, with the given visibility.
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

/// Definition of the function that looks up a table, for `f64`.
pub(super) fn helper() -> TokenStream {
    quote! {
        /// Piecewise cubic: `cubics[0]` below the first knot, `cubics[i]` from `knots[i - 1]` on; each by the coefficients of
        /// the powers 0 to 3 of the distance from the knot below.
        fn piecewise_cubic(x: f64, knots: &[f64], cubics: &[[f64; 4]]) -> f64 {
            let below = knots.partition_point(|&knot| knot <= x);
            let h = x - knots[below.saturating_sub(1)];
            let [a, b, c, d] = cubics[below];
            ((d * h + c) * h + b) * h + a
        }
    }
}
