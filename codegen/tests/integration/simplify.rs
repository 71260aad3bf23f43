//! What the constructors of the graph make of an expression, one line each.

use crate::support::print::show;
use codegen::functions::{BinaryFunction, MathFunction};
use codegen::graph::{ExprGraph, NodeId, Symbol};
use codegen::number::Number;

struct Bench {
    g: ExprGraph,
}

impl Bench {
    fn new() -> Bench {
        let mut g = ExprGraph::default();
        for k in 0..6 {
            g.symbol(Symbol::State(k));
        }
        Bench { g }
    }

    fn s(&mut self, k: u32) -> NodeId {
        self.g.symbol(Symbol::State(k))
    }

    fn norm(&mut self, parts: &[NodeId]) -> NodeId {
        let squares: Vec<_> = parts
            .iter()
            .map(|&part| (Number::ONE, self.g.power(part, 4)))
            .collect();
        let sum = self.g.sum(squares, Number::ZERO);
        self.g.sqrt(sum)
    }
}

fn simplified(build: impl Fn(&mut Bench, [NodeId; 4]) -> NodeId) -> String {
    let mut bench = Bench::new();
    let leaves = [0, 1, 2, 3].map(|k| bench.s(k));
    let node = build(&mut bench, leaves);
    show(&bench.g, node, &|symbol| match symbol {
        Symbol::State(k) => ["a", "b", "c", "d", "e", "f"][k as usize].to_string(),
        other => format!("{other:?}"),
    })
}

macro_rules! table {
    ($($name:ident: |$b:ident, $leaves:pat_param| $build:expr => $text:literal;)*) => {
        $(#[test] fn $name() { assert_eq!(simplified(|$b, $leaves| $build), $text); })*
    };
}

table! {
    like_terms_add_up: |b, [x, y, ..]| { let s = b.g.add(x, y); b.g.add(s, x) } => "2*a + b";
    what_cancels_is_gone: |b, [x, y, ..]| { let s = b.g.add(x, y); b.g.sub(s, x) } => "b";
    products_collect_exponents: |b, [x, y, ..]| { let p = b.g.mul(x, y); b.g.mul(p, x) } => "a^2*b";
    minus_minus: |b, [x, ..]| { let n = b.g.neg(x); b.g.neg(n) } => "a";
    zero_times: |b, [x, ..]| { let z = b.g.whole(0); b.g.mul(z, x) } => "0";
    signs_come_out_of_products: |b, [x, y, z, _]| { let d = b.g.sub(z, x); b.g.mul(d, y) } => "-b*(a - c)";
    common_factors_come_out_of_products: |b, [x, y, z, w]| {
        let (p, q) = (b.g.mul(x, y), b.g.mul(x, z)); let s = b.g.add(p, q); b.g.mul(s, w)
    } => "a*d*(b + c)";
    what_a_model_writes_times_1_stays_a_sum: |b, [x, y, z, _]| {
        let (p, q) = (b.g.mul(x, y), b.g.mul(x, z)); let s = b.g.sub(q, p);
        let one = b.g.whole(1); let t = b.g.times(s, one); b.g.over(t, one)
    } => "-a*b + a*c";
    root_squared: |b, [x, y, ..]| { let n = b.norm(&[x, y]); b.g.mul(n, n) } => "a^2 + b^2";
    x_over_root_x: |b, [x, y, ..]| { let n = b.norm(&[x, y]); let s = b.g.mul(n, n); b.g.div(s, n) } => "(a^2 + b^2)^(1/2)";
    norm_over_itself_is_a_mask: |b, [x, y, ..]| { let n = b.norm(&[x, y]); b.g.div(n, n) } => "nonzero(a^2 + b^2)";
    a_mask_times_its_argument: |b, [x, y, ..]| { let n = b.norm(&[x, y]); let m = b.g.div(n, n); b.g.mul(m, n) } => "(a^2 + b^2)^(1/2)";
    divisor_known_nonzero: |b, [x, ..]| { b.g.assume_nonzero(x); b.g.div(x, x) } => "1";
    unit_vector_along_itself: |b, [x, y, ..]| {
        let n = b.norm(&[x, y]); let (u, v) = (b.g.div(x, n), b.g.div(y, n));
        let (p, q) = (b.g.mul(x, u), b.g.mul(y, v)); b.g.add(p, q)
    } => "(a^2 + b^2)^(1/2)";
    sin_of_atan2: |b, [y, x, ..]| { let t = b.g.call2(BinaryFunction::Atan2, y, x); b.g.call(MathFunction::Sin, t) } => "a*(a^2 + b^2)^(-1/2)";
    cos_of_atan2_is_one_at_the_origin: |b, [y, x, ..]| { let t = b.g.call2(BinaryFunction::Atan2, y, x); b.g.call(MathFunction::Cos, t) }
        => "b*(a^2 + b^2)^(-1/2) - nonzero(a^2 + b^2) + 1";
    cos_of_atan2_times_the_radius: |b, [y, x, ..]| {
        let t = b.g.call2(BinaryFunction::Atan2, y, x); let c = b.g.call(MathFunction::Cos, t); let n = b.norm(&[x, y]); b.g.mul(c, n)
    } => "b";
    sin_squared_plus_cos_squared: |b, [x, y, ..]| {
        let (s, c) = (b.g.call(MathFunction::Sin, x), b.g.call(MathFunction::Cos, x));
        let (s, c) = (b.g.power(s, 4), b.g.power(c, 4)); let (s, c) = (b.g.mul(s, y), b.g.mul(c, y)); b.g.add(s, c)
    } => "b";
    sin_is_odd: |b, [x, ..]| { let n = b.g.neg(x); b.g.call(MathFunction::Sin, n) } => "-sin(a)";
    cos_is_even: |b, [x, ..]| { let n = b.g.neg(x); b.g.call(MathFunction::Cos, n) } => "cos(a)";
    root_of_a_square: |b, [x, ..]| { let s = b.g.power(x, 4); b.g.sqrt(s) } => "abs(a)";
    root_of_what_may_be_negative: |b, [x, ..]| b.g.sqrt(x) => "sqrt(a)";
    ratio_of_multiples: |b, [x, y, ..]| {
        let (two, four) = (b.g.whole(2), b.g.whole(4)); let (p, q) = (b.g.mul(two, x), b.g.mul(four, y)); b.g.div(p, q)
    } => "1/2*a*b^(-1)";
}

table! {
    a_vector_in_a_plane_from_its_projections: |b, [x, y, p, q]| {
        // (w·e1) e1 - (w·e2) e2 by its first component, e1 = (x, y)/n, e2 = (-y, x)/n, w = (p, q)
        let n = b.norm(&[x, y]);
        let (e, f) = (b.g.div(x, n), b.g.div(y, n));
        let (pe, qf, pf, qe) = (b.g.mul(p, e), b.g.mul(q, f), b.g.mul(p, f), b.g.mul(q, e));
        let (along, across) = (b.g.add(pe, qf), b.g.sub(qe, pf));
        let (first, second) = (b.g.mul(along, e), b.g.mul(across, f));
        let whole = b.g.sub(first, second);
        b.g.project(whole)
    } => "c*nonzero(a^2 + b^2)";
    an_unprofitable_product_stays_one: |b, [x, y, p, q]| {
        let (s, t) = (b.g.add(x, y), b.g.add(p, q)); let m = b.g.mul(s, t); let w = b.g.add(m, x); b.g.project(w)
    } => "a + (a + b)*(c + d)";
    a_mask_of_a_parameter_known_nonzero: |b, [x, ..]| { b.g.assume_nonzero(x); b.g.call(MathFunction::NonZero, x) } => "1";
    cosine_of_an_arcsine: |b, [x, ..]| { let t = b.g.call(MathFunction::Asin, x); b.g.call(MathFunction::Cos, t) }
        => "sqrt(-a^2 + 1)";
    logarithm_of_an_exponential: |b, [x, ..]| { let e = b.g.call(MathFunction::Exp, x); b.g.call(MathFunction::Log, e) } => "a";
}
