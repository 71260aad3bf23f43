//! What holds, holds for every seed.

use crate::support::{QUICK, built_in, refuted};
use proptest::prelude::*;
use verify::Options;

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn every_seed_verifies(seed: u64, which in 0..model_spec::load::MODELS.len()) {
        let (name, _) = model_spec::load::MODELS[which];
        let report = verify::run(&built_in(name), &Options { seed, ..QUICK });
        prop_assert!(refuted(&report).is_empty(), "{}", report.table());
    }
}
