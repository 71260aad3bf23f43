//! Whether there are states at which a model can be checked: within its limits, and with the unknowns of its blocks
//! `solve { … }` determined.

use crate::options::Options;
use crate::random::Random;
use crate::row::{Row, Verdict};
use crate::sample;
use model_spec::model::{ExprKind, Model, ValidityLimit};
use oracle::{Point, Tree};

/// Name of this check in reports: the unknowns of blocks `solve` are determined at some states.
pub const DETERMINED: &str = "unknowns determined";

/// Name of the check that a state within the limits of validity is found.
const WITHIN: &str = "limits of validity";

/// That no state within the limits of validity was found, so that no other check can be made; otherwise `None`.
pub fn unreached(model: &Model, options: &Options) -> Option<Row> {
    let mut random = Random::new(options.seed, WITHIN);
    let point = sample::near(model, &mut random);
    let why = "no state within them was found; give the states values within, as in `position (x, y, z) in N = (7e6, 0, 0) m`";
    (!sample::is_valid(model, &point)).then(|| Row::unverified(WITHIN, why))
}

/// Number of random points at which a block is tried.
const POINTS: usize = 20;

/// A fault if the equations of a block determine its unknowns at none of the points that are tried, so that no other
/// check can be made; otherwise `None`.
pub fn fault(model: &Model, options: &Options) -> Option<Row> {
    let is_determinacy =
        |limit: &&ValidityLimit| matches!(limit.value.kind, ExprKind::Determinacy(_));
    let mut never: Vec<&ValidityLimit> = model.limits.iter().filter(is_determinacy).collect();
    let mut random = Random::new(options.seed, DETERMINED);
    for k in 0..=POINTS {
        if never.is_empty() {
            return None;
        }
        let point = match k {
            0 => Point::defaults(model),
            _ => sample::anywhere(model, &mut random),
        };
        let tree = Tree::new(model, &point);
        // NaN is not determined.
        never.retain(|limit| {
            let value = tree.scalar(&limit.value);
            value.is_nan() || value <= limit.bound
        });
    }
    let faults = never.iter().map(|limit| {
        let reason = limit.reason.trim_end_matches(" here");
        format!("{reason}: at none of {POINTS} random states")
    });
    let faults: Vec<String> = faults.collect();
    let row = Row::counted(DETERMINED, POINTS, &faults, "");
    (row.verdict == Verdict::Refuted).then_some(row)
}
