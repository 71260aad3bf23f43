//! Common-subexpression elimination: shares pairs of factors and pairs of terms that several definitions contain.

mod candidates;
mod products;
mod sums;

use super::{DefId, Ssa};
use crate::graph::FastMap;
use model_spec::index::IndexVec;
use std::hash::Hash;

pub(super) use products::share as share_products;
pub(super) use sums::share as share_sums;

/// Merges definitions with equal `parts`, and replaces those with a `single` part by that part.
fn merge_equal<P: Eq + Hash>(
    ssa: &mut Ssa,
    parts: impl Fn(&Ssa, DefId) -> &[P],
    single: impl Fn(&[P]) -> Option<DefId>,
) {
    let mut canonical: FastMap<&[P], DefId> = FastMap::default();
    let mut target: IndexVec<DefId, DefId> = ssa.defs.indices().collect();
    for id in ssa.defs.indices() {
        let parts = parts(ssa, id);
        if !parts.is_empty() {
            target[id] = single(parts).unwrap_or_else(|| *canonical.entry(parts).or_insert(id));
        }
    }
    ssa.redirect(&target);
}
