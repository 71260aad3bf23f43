//! Names of the constants of a table in generated code, and the helper function that looks up a table.

use crate::functions::MathFunction;
use crate::program::{Function, Op, Unary};
use crate::table::{TableFunction, Tables};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeSet;

/// Name of the function that looks up a table: a method of `lanes::Real`, and a helper function in `f64` code.
pub(super) const METHOD: &str = "piecewise_cubic";

/// Suffixes of the constants of a table; the cubics of a derivative add its order.
const ENDS: [&str; 2] = ["_KNOTS", "_CUBICS"];

/// Whether a name contains a suffix that is reserved for the generated constants of tables.
pub(super) fn is_constant(name: &str) -> bool {
    ENDS.iter().any(|end| name.contains(end))
}

pub(super) fn names(tables: &Tables, function: TableFunction) -> [Ident; 2] {
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

pub(super) fn used_by(function: &Function) -> BTreeSet<TableFunction> {
    let statements = function.program.statements.iter();
    let used = statements.filter_map(|statement| match statement.op {
        Op::Unary(Unary::Call(MathFunction::Table(function)), _) => Some(function),
        _ => None,
    });
    used.collect()
}

pub(super) fn import(function: &Function) -> TokenStream {
    let tables = &function.program.tables;
    let used = used_by(function).into_iter();
    let names: BTreeSet<Ident> = used.flat_map(|f| names(tables, f)).collect();
    if names.is_empty() {
        return TokenStream::new();
    }
    quote!(use super::tables::{#(#names),*};)
}

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
