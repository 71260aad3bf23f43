//! Names of the constants of a table in generated code, and the helper function that looks up a table.

use crate::functions::{BinaryFunction, MathFunction};
use crate::program::{Binary, Function, Op, Unary};
use crate::table::{TableFunction, TableId, Tables};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::collections::{BTreeMap, BTreeSet};

/// Name of the function that looks up a table: a method of `lanes::Real`, and a helper function in `f64` code.
pub(super) const METHOD: &str = "piecewise_cubic";

/// Name of the function that looks up a table of two arguments.
pub(super) const METHOD_OF_TWO: &str = "piecewise_bicubic";

/// Suffixes of the constants of a table; the cubics of a derivative add its order.
const ENDS: [&str; 2] = ["_KNOTS", "_CUBICS"];

/// Suffixes of the constants of a table of two arguments.
const ENDS_OF_TWO: [&str; 3] = ["_KNOTS_1", "_KNOTS_2", "_BICUBICS"];

/// Whether a name contains a suffix that is reserved for the generated constants of tables.
pub(super) fn is_constant(name: &str) -> bool {
    let ends = ENDS.iter().chain(&ENDS_OF_TWO);
    ends.into_iter().any(|end| name.contains(end))
}

pub(super) fn names(tables: &Tables, function: TableFunction) -> [Ident; 2] {
    let table = &tables.table(function.table()).name;
    let [knots, cubics] = ENDS;
    let order = match function.orders()[0] {
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

/// Names of the knots of both arguments and of the cells.
pub(super) fn of_two(tables: &Tables, function: TableFunction<2>) -> [Ident; 3] {
    let table = &tables.table(function.table()).name;
    ENDS_OF_TWO.map(|end| format_ident!("{table}{end}"))
}

/// Tables of two arguments that a function looks up, each by one of the functions that use it.
pub(super) fn surfaces_of(function: &Function) -> BTreeMap<TableId, TableFunction<2>> {
    let statements = function.program.statements.iter();
    let used = statements.filter_map(|statement| match statement.op {
        Op::Binary(Binary::Call(BinaryFunction::Table(function)), ..) => {
            Some((function.table(), function))
        }
        _ => None,
    });
    used.collect()
}

pub(super) fn import(function: &Function) -> TokenStream {
    let tables = &function.program.tables;
    let used = used_by(function).into_iter();
    let mut names: BTreeSet<Ident> = used.flat_map(|f| names(tables, f)).collect();
    let surfaces = surfaces_of(function).into_values();
    names.extend(surfaces.flat_map(|surface| of_two(tables, surface)));
    if names.is_empty() {
        return TokenStream::new();
    }
    quote!(use super::tables::{#(#names),*};)
}

pub(super) fn helper_of_two() -> TokenStream {
    quote! {
        /// Piecewise bicubic or its derivative of the given orders: cells by intervals of `x`, then of `y`; each by the
        /// coefficients of `h^a k^b` at index `4 a + b`, with the distances from the knots below.
        fn piecewise_bicubic(x: f64, y: f64, orders: [usize; 2], knots: [&[f64]; 2], cells: &[[f64; 16]]) -> f64 {
            let below = [0, 1].map(|k| knots[k].partition_point(|&knot| knot <= [x, y][k]));
            let [h, k] = [0, 1].map(|k| [x, y][k] - knots[k][below[k].saturating_sub(1)]);
            let cell = &cells[below[0] * (knots[1].len() + 1) + below[1]];
            let falling = |n: usize, order: usize| (n + 1..=n + order).map(|n| n as f64).product::<f64>();
            (orders[0]..4).rev().fold(0.0, |value, a| {
                let row = (orders[1]..4).rev().fold(0.0, |row, b| {
                    let factor = falling(a - orders[0], orders[0]) * falling(b - orders[1], orders[1]);
                    row * k + factor * cell[4 * a + b]
                });
                value * h + row
            })
        }
    }
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
