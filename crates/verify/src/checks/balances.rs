//! Checks the changes of quantities along the motion that a model claims, such as of its energy and momentum.

use super::precision::Tally;
use crate::options::Options;
use crate::random::Random;
use crate::row::{Row, Verdict, Worst};
use crate::sample;
use crate::subject::{Subject, is_fault, moving_as_stated};
use oracle::Tree;
use std::collections::BTreeMap;

/// Name of this check in reports: `claim der(QUANTITY) = CHANGE;` along the equations of the model.
pub const BALANCES: &str = "claimed balances";

/// Checks whether quantities change along the motion as the model claims; `None` if it claims no change.
pub fn check(subject: &Subject<'_>, options: &Options) -> Option<Row> {
    let model = subject.model;
    if model.balances.is_empty() {
        return None;
    }
    let mut random = Random::new(options.seed, BALANCES);
    let mut tally = Tally::default();
    let mut broken: BTreeMap<String, f64> = BTreeMap::new();
    for _ in 0..options.cases {
        let point = subject.without_effects(sample::point(model, &mut random));
        let Some(moving) = moving_as_stated(subject, &point) else {
            return Some(Row::unverified(
                BALANCES,
                "there are no equations to evaluate",
            ));
        };
        let tree = Tree::new(model, &moving);
        let mut worst = Worst::default();
        for own in &model.balances {
            let text = model.text(own.span);
            let sides = [&own.quantity, &own.change].map(|e| tree.value(e).components());
            for (quantity, change) in sides[0].iter().zip(&sides[1]) {
                let error = (quantity.derivative - change.value).relative_error(0.0);
                worst.update(error, || text.clone());
                if is_fault(error) {
                    let so_far = broken.entry(text.clone()).or_default();
                    *so_far = so_far.max(error);
                }
            }
        }
        tally.add_point(model, &point, worst);
    }
    let row = tally.row(BALANCES, options.cases, options.cases);
    let lines = broken.into_iter();
    let lines = lines.map(|(text, error)| format!("`{text}`: off by {error:.0e} of its terms"));
    let lines: Vec<String> = lines.collect();
    Some(match row.verdict {
        Verdict::Holds => row.with_detail("quantities change as the model claims"),
        _ => row.with_detail(lines.join("\n")),
    })
}
