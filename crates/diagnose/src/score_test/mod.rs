//! Score (Lagrange multiplier) tests of all candidate effects and library terms, without a refit.

mod effective_score;
mod local_elimination;
mod null_distribution;
mod score_tests;

pub(crate) use local_elimination::{eliminate_locals, keep_directions};
pub(crate) use null_distribution::{chi2_ln_sf, ln_p_to_z};
pub(crate) use score_tests::{MIN_TOLERANCE, ScoreTest, ScoreTests};
