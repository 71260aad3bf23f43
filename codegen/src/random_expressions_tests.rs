//! Property tests: compiled random expressions and their derivatives are compared with evaluation by dual numbers.

use crate::differentiate::{EliminationOrder, LinearizedGraph, share_values};
use crate::functions::{BinaryFunction, MathFunction};
use crate::graph::{ExprGraph, NodeId, Symbol};
use crate::number::Number;
use crate::program::Program;
use crate::schedule::{Namer, schedule};
use crate::ssa::{Ssa, build};
use crate::table::{TableFunction, TableId, Tables};
use crate::tape::{Inputs, Tape};
use num_dual::{Dual64, DualNum};
use oracle::scalar::{Elementary, NumDual, Real};
use proptest::prelude::*;
use proptest::sample::Index;
use std::sync::LazyLock;

/// Number of variables of a random expression.
const VARIABLES: usize = 3;
/// Limit on the |value| and |derivative| of every subexpression. A random expression that reaches the limit is
/// discarded, because cancellation between larger values would hide errors.
const MAX_MAGNITUDE: f64 = 1e3;

/// Step of a random expression: an operation on the values x and y of two earlier steps, or on x alone.
#[derive(Clone, Copy, Debug)]
enum Step {
    Add,
    Sub,
    Mul,
    Scale,
    Square,
    Cube,
    /// x / (1 + y²)
    Over,
    /// sqrt(1 + x²)
    Norm,
    /// sqrt(x² + y²)
    Hypot,
    Angle,
    Min,
    Max,
    Call(MathFunction),
    /// Lookup of x in the table that the model text [`TABLE`] declares.
    Table,
}

/// Text of a model with one table. Its cubic spline is, in terms of u = 1 - |x - 1|, the function (3u - u³)/2 where
/// u > 0, and 3u/2 elsewhere.
const TABLE: &str = "model table; param tau = 1 s; state a = 0; frame N;
    table hill(x) = { 0: 0, 1: 1, 2: 0 }; der(a) = hill(a)/tau;";

/// Whether the function may occur in random expressions: false for functions with jumps or infinite slopes.
fn is_smooth(function: &MathFunction) -> bool {
    use MathFunction::{Heaviside, NonZero, Sign, Sqrt};
    !matches!(function, Heaviside | NonZero | Sign | Sqrt)
}

fn steps() -> impl Strategy<Value = Vec<(Step, Index, Index)>> {
    let step = prop::sample::select(vec![
        Step::Add,
        Step::Sub,
        Step::Mul,
        Step::Mul,
        Step::Scale,
        Step::Square,
        Step::Cube,
        Step::Over,
        Step::Norm,
        Step::Hypot,
        Step::Angle,
        Step::Min,
        Step::Max,
        Step::Table,
    ]);
    let called: Vec<_> = MathFunction::ALL.into_iter().filter(is_smooth).collect();
    let call = prop::sample::select(called).prop_map(Step::Call);
    let step = prop_oneof![2 => step, 1 => call];
    prop::collection::vec((step, any::<Index>(), any::<Index>()), 1..20)
}

fn node(graph: &mut ExprGraph, step: Step, x: NodeId, y: NodeId) -> NodeId {
    let one_plus_square = |graph: &mut ExprGraph, x| {
        let square = graph.power(x, 4);
        graph.sum(vec![(Number::ONE, square)], Number::ONE)
    };
    match step {
        Step::Add => graph.add(x, y),
        Step::Sub => graph.sub(x, y),
        Step::Mul => graph.mul(x, y),
        Step::Scale => graph.scale(Number::fraction(-3, 2), x),
        Step::Square => graph.power(x, 4),
        Step::Cube => graph.power(x, 6),
        Step::Over => {
            let divisor = one_plus_square(graph, y);
            graph.div(x, divisor)
        }
        Step::Norm => {
            let square = one_plus_square(graph, x);
            graph.sqrt(square)
        }
        Step::Hypot => {
            let (x, y) = (graph.power(x, 4), graph.power(y, 4));
            let square = graph.add(x, y);
            graph.sqrt(square)
        }
        Step::Angle => graph.call2(BinaryFunction::Atan2, x, y),
        Step::Min => graph.call2(BinaryFunction::Min, x, y),
        Step::Max => graph.call2(BinaryFunction::Max, x, y),
        Step::Call(function) => graph.call(function, x),
        Step::Table => {
            let value = TableFunction::value_of(TableId::new(0));
            graph.call(MathFunction::Table(value), x)
        }
    }
}

/// Value and derivative of the operation `step` for the operands `x` and `y`, computed with dual numbers by the
/// textbook definition of the operation. `None` if the operands are within 1e-3 of a point where the operation is not
/// smooth.
fn value(step: Step, x: Dual64, y: Dual64) -> Option<Dual64> {
    let smooth = |margin: f64| margin.abs() > 1e-3;
    let one = Dual64::from(1.0);
    Some(match step {
        Step::Add => x + y,
        Step::Sub => x - y,
        Step::Mul => x * y,
        Step::Scale => x * -1.5,
        Step::Square => x * x,
        Step::Cube => x * x * x,
        Step::Over => x / (one + y * y),
        Step::Norm => (one + x * x).sqrt(),
        Step::Hypot => {
            let square = x * x + y * y;
            smooth(square.re).then(|| square.sqrt())?
        }
        Step::Angle => {
            let square = x.re * x.re + y.re * y.re;
            let regular = smooth(square) && (y.re > 0.0 || smooth(x.re));
            let slope = (y.re * x.eps - x.re * y.eps) / square;
            regular.then(|| Dual64::new(x.re.atan2(y.re), slope))?
        }
        Step::Min | Step::Max => {
            let first = (x.re < y.re) == matches!(step, Step::Min);
            smooth(x.re - y.re).then_some(if first { x } else { y })?
        }
        Step::Table => {
            let u = one - if x.re < 1.0 { one - x } else { x - one };
            let cube = if u.re > 0.0 { u * u * u } else { u * 0.0 };
            (u * 3.0 - cube) * 0.5
        }
        Step::Call(MathFunction::Abs) => smooth(x.re).then_some(if x.re < 0.0 { -x } else { x })?,
        Step::Call(function) => {
            let regular = match function {
                MathFunction::Log => x.re > 1e-3,
                MathFunction::Asin => x.re.abs() < 0.99,
                _ => true,
            };
            let function = Elementary::named(function.name()).filter(|_| regular)?;
            NumDual(x).elementary(function).0
        }
    })
}

/// Random expression in two forms: as the node `root` of a graph, and as value and derivatives that were computed with
/// dual numbers.
struct Case {
    graph: ExprGraph,
    root: NodeId,
    value: f64,
    derivatives: [f64; VARIABLES],
    magnitude: f64,
}

/// Builds a random expression from `steps`, with its value and derivatives at the point `at`. `None` if an operation is
/// not smooth at that point, or if a value or derivative is not below [`MAX_MAGNITUDE`] in magnitude.
fn case(steps: &[(Step, Index, Index)], at: [f64; VARIABLES]) -> Option<Case> {
    static TABLES: LazyLock<Tables> = LazyLock::new(|| {
        let model = model_spec::load::from_text("table.hyz", TABLE, &[]).expect("a model");
        Tables::of_model(&model)
    });
    let mut graph = ExprGraph::with_tables(TABLES.clone(), Vec::new());
    let symbols = [0, 1, 2].map(|k| graph.symbol(Symbol::State(k)));
    let mut nodes = symbols.to_vec();
    let seeded = |wrt: usize| (0..VARIABLES).map(move |k| Dual64::new(at[k], f64::from(k == wrt)));
    let mut values: [Vec<Dual64>; VARIABLES] = [0, 1, 2].map(|wrt| seeded(wrt).collect());
    let mut magnitude = 1.0_f64;
    for (step, x, y) in steps {
        let (x, y) = (x.index(nodes.len()), y.index(nodes.len()));
        nodes.push(node(&mut graph, *step, nodes[x], nodes[y]));
        for values in &mut values {
            let result = value(*step, values[x], values[y])?;
            magnitude = magnitude.max(result.re.abs()).max(result.eps.abs());
            values.push(result);
        }
    }
    let last = nodes.len() - 1;
    (magnitude < MAX_MAGNITUDE).then(|| Case {
        graph,
        root: nodes[last],
        value: values[0][last].re,
        derivatives: [0, 1, 2].map(|wrt: usize| values[wrt][last].eps),
        magnitude,
    })
}

fn namer() -> Namer {
    Namer::new(&["a", "b", "c"].map(String::from), &[], &[])
}

fn run(program: &Program, at: [f64; VARIABLES]) -> Vec<f64> {
    let mut out = vec![0.0; program.outputs.len()];
    let inputs = Inputs {
        t: 0.0,
        x: &at,
        p: &[],
        prepared: &[],
        marker: &[],
    };
    Tape::new(program).eval(inputs, &mut Vec::new(), &mut out);
    out
}

fn evaluated(case: &mut Case, ssa: &Ssa, at: [f64; VARIABLES]) -> Vec<f64> {
    let program = schedule(ssa, &mut case.graph, &mut namer(), None, &[]);
    run(&program, at)
}

fn close(got: f64, wanted: f64, magnitude: f64) -> bool {
    (got - wanted).abs() <= 1e-10 * magnitude * magnitude
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn simplified_and_optimised_values_are_those_of_the_definition(
        steps in steps(),
        at in prop::array::uniform3(-2.0..2.0_f64),
    ) {
        let Some(mut case) = case(&steps, at) else { return Ok(()) };
        let mut ssa = build(&case.graph, &[case.root]);
        let plain = evaluated(&mut case, &ssa, at)[0];
        ssa.optimise();
        let optimised = evaluated(&mut case, &ssa, at)[0];
        for got in [plain, optimised] {
            prop_assert!(close(got, case.value, case.magnitude), "{got}, not {}", case.value);
        }
    }

    #[test]
    fn derivatives_by_elimination_are_those_of_dual_numbers(
        steps in steps(),
        at in prop::array::uniform3(-2.0..2.0_f64),
    ) {
        let Some(mut case) = case(&steps, at) else { return Ok(()) };
        let mut ssa = build(&case.graph, &[case.root]);
        ssa.optimise();
        for order in [EliminationOrder::FewestEdges, EliminationOrder::FewestProducts] {
            let first = case.graph.local_count();
            let jacobian = case.graph.scope(first..first, |graph| {
                let roots = share_values(&ssa, graph, &mut namer());
                let rows = ["y".to_string()];
                let symbols = [0, 1, 2].map(Symbol::State);
                let names = ["a", "b", "c"].map(String::from);
                let linearized = LinearizedGraph::new(graph, &roots, &rows, &symbols, &names);
                linearized.eliminate_vertices(graph, order)
            });
            let mut entries = build(&case.graph, &jacobian.entries);
            entries.optimise();
            let entries = evaluated(&mut case, &entries, at);
            let mut got = [0.0; VARIABLES];
            for (&(_, column), entry) in jacobian.pattern.iter().zip(entries) {
                got[column as usize] = entry;
            }
            for (got, wanted) in got.into_iter().zip(case.derivatives) {
                prop_assert!(close(got, wanted, case.magnitude), "{got}, not {wanted}");
            }
        }
    }
}
