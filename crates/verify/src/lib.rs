//! Independent checks of a model: reference implementations, identities, metamorphic relations, derivatives, exact
//! arithmetic, mutants, backends. [`run`] runs all checks and returns a report.
//!
//! ```
//! let ball = model_spec::load::inspect("ball", &[]).unwrap();
//! let report = verify::run(&ball, &verify::Options { cases: 20, ..Default::default() });
//! assert!(report.holds(), "{}", report.table());
//! ```
//!
//! Errors are relative to the sum of the magnitudes of the terms that make up a value (see
//! [`oracle::scalar::ErrorBound`]), so cancellation neither hides a fault nor looks like one.

pub mod balance_rank;
pub mod checks;
mod constrained;
pub mod difference;
pub mod engine;
mod evaluation;
mod expressions;
mod field;
pub mod flights;
mod integration;
mod meaning;
pub mod mutants;
mod options;
mod pairing;
pub mod random;
pub mod record;
pub mod refute;
pub mod report;
pub mod rounding;
mod row;
pub mod same_motion;
pub mod sample;
pub mod subject;
mod symbolic;

use codegen::Compiled;
use engine::{Engine, Values};
use model_spec::load::Loaded;
use model_spec::model::Model;
use mutants::equivalence::Original;
pub use options::{Options, TOLERANCE};
use random::Random;
pub use report::Report;
use report::Row;
use rounding::{Effort, Rounding};
pub use row::set_table_width;
use same_motion::SameMotion;
use subject::Subject;

/// Number of points at which backends are compared; not a multiple of any number of lanes.
const BACKEND_POINTS: usize = 37;

/// Runs every check of a loaded model; the report does not depend on the number of processors. Numerical checks run
/// only if the language checker produced a model.
pub fn run(loaded: &Loaded, options: &Options) -> Report {
    let mut report = Report {
        model: loaded
            .sources
            .first()
            .map_or_else(String::new, |s| s.name.clone()),
        seed: options.seed,
        rows: vec![checks::units::check(loaded)],
        refuted: Vec::new(),
        mutants: None,
    };
    let Some(model) = &loaded.model else {
        return report;
    };
    report.model.clone_from(&model.name);
    let nowhere = checks::determined::fault(model, options);
    if let Some(row) = nowhere.or_else(|| checks::determined::unreached(model, options)) {
        report.rows.push(row);
        return report;
    }
    let compiled = codegen::compile(model);
    let engine = Engine::new(&compiled);
    let subject = Subject::new(model, &engine);
    let mut checks = numerical(&subject, &compiled, options);
    if options.effects {
        checks.push(Box::new(|| checks::effects::rows(loaded, options).into()));
    }
    report.rows.extend(rows_of(&checks));
    report.refuted = refute::refutations(&subject, options);
    if options.mutants && loaded.diagnostics.is_empty() {
        let original = Original::new(&subject);
        let table = mutants::run(&loaded.file, &loaded.sources, &original, options);
        report.rows.push(table.row());
        report.mutants = Some(table);
    }
    report
}

/// Checks for each pair of models whether their accelerations and flights are equal.
pub fn same_motion(models: &[Model], options: &Options) -> SameMotion {
    let values: Vec<Values> = models.iter().map(Values::of).collect();
    let subjects: Vec<Subject<'_>> = models
        .iter()
        .zip(&values)
        .map(|(model, values)| Subject::new(model, values))
        .collect();
    same_motion::compare(&subjects, options)
}

/// Rounding errors of every backend, and bits that every statement loses, at the points of [`Effort::DETAILS`].
pub fn rounding(model: &Model, options: &Options) -> Rounding {
    let compiled = codegen::compile(model);
    let engine = Engine::new(&compiled);
    let subject = Subject::new(model, &engine);
    rounding::measure(&subject, &compiled, options, Effort::DETAILS)
}

/// Numerical checks of a model with a compiled program, which may be of another model.
pub fn rows_of_code(model: &Model, compiled: &Compiled, options: &Options) -> Vec<Row> {
    let engine = Engine::new(compiled);
    let subject = Subject::new(model, &engine);
    rows_of(&numerical(&subject, compiled, options))
}

/// One or several checks.
type Check<'a> = Box<dyn Fn() -> Vec<Row> + Sync + 'a>;

fn rows_of(checks: &[Check<'_>]) -> Vec<Row> {
    flight::parallel::each(checks.len(), |index| checks[index]())
        .into_iter()
        .flatten()
        .collect()
}

fn numerical<'a>(
    subject: &'a Subject<'a>,
    compiled: &'a Compiled,
    options: &'a Options,
) -> Vec<Check<'a>> {
    vec![
        Box::new(|| vec![checks::reference::reference(subject, options)]),
        Box::new(|| vec![checks::reference::tree(subject, options)]),
        Box::new(|| checks::claim::check(subject, options).into_iter().collect()),
        Box::new(|| { checks::balances::check(subject, options).into_iter() }.collect()),
        Box::new(|| vec![checks::identities::check(subject, options)]),
        Box::new(|| vec![flights::invariants(subject, options)]),
        Box::new(|| vec![flights::momenta(subject, options)]),
        Box::new(|| vec![checks::metamorphic::check(subject, options)]),
        Box::new(|| checks::derivatives::check(subject, compiled, options)),
        Box::new(|| vec![checks::exact::check(subject, options)]),
        Box::new(|| {
            vec![checks::exact_functions::check(
                subject.model,
                compiled,
                options,
            )]
        }),
        Box::new(|| backends(subject.model, compiled, options).into()),
        Box::new(|| {
            let measured = rounding::measure(subject, compiled, options, Effort::ROW);
            vec![rounding::row(&measured)]
        }),
        Box::new(|| vec![checks::backends::generated_code(subject.model)]),
        Box::new(|| vec![singular_points(subject.model, compiled)]),
        Box::new(|| vec![checks::cases::check(subject)]),
    ]
}

/// Compares the backends with each other at random points, with and without fused multiplications and additions.
fn backends(model: &Model, compiled: &Compiled, options: &Options) -> [Row; 2] {
    let mut random = Random::new(options.seed, checks::backends::BACKENDS);
    let points = sample::points(model, BACKEND_POINTS, &mut random);
    let runs = checks::backends::runs(model, compiled, &points);
    [
        checks::backends::check(compiled, &runs),
        checks::backends::check_fma(compiled, &points, &runs),
    ]
}

fn singular_points(model: &Model, compiled: &Compiled) -> Row {
    let singular = checks::singular::points(model);
    let points: Vec<_> = singular.iter().map(|(_, point)| point.clone()).collect();
    let runs = checks::backends::runs(model, compiled, &points);
    checks::singular::check(&singular, compiled, &runs)
}
