//! Levels that hold for the whole crate: what counts as noise, as the same, as far above the noise. Ratios are those of
//! residual scales, robust standard deviations of residuals, to the noise or to the scales of other flights. Simulated
//! flights with wrong models, outliers and wrong starts, whose fits must arrive, set their values.

/// Ratio up to which residuals are at the noise, and equal.
pub const AT_NOISE: f64 = 1.1;

/// Ratio up to which residuals are near the noise: a model that leaves more does not describe the flights in detail.
pub const NEAR_NOISE: f64 = 1.3;

/// Ratio up to which residuals of a single flight, or from a single step, may be noise.
pub const ROUGHLY_NOISE: f64 = 2.0;

/// Ratio above which residuals are far above the noise or unlike those of others: the model is wrong, or the minimum.
pub const FAR_ABOVE: f64 = 3.0;

/// Ratio above which a flight is none of the same body, or nothing can be said of a fit.
pub const HOPELESS: f64 = 10.0;

/// Ratio to the residuals before, at which those of another start or scale are clearly smaller.
pub const CLEARLY_SMALLER: f64 = 0.7;

/// Number of standard errors at which a difference is significant, and of standard deviations at which a value is an
/// outlier; noise exceeds it once in two million.
pub const SIGNIFICANT: f64 = 5.0;

/// Standard error, in typical magnitudes or standard deviations of a prior, above which the data leave a quantity open.
pub const UNDETERMINED: f64 = 0.5;

/// Least noise of a coordinate that residuals are held against, m: rounding and integration errors contribute to them.
pub const LEAST_NOISE: f64 = 1e-5;

/// Ratio of a variance to the median of many above which a sample contains an outlier.
pub const OUTLIER_VARIANCE: f64 = SIGNIFICANT * SIGNIFICANT;

/// Number of robust standard deviations above which a value is unlike the others, an outlier: noise exceeds it with
/// probability 7 × 10⁻⁶, and smooth paths are rarely as wrong.
pub const UNLIKE: f64 = 4.5;

/// Relative standard error of a robust standard deviation of normal values, times the root of their number.
pub const ROBUST_ERROR: f64 = 1.17;

/// Relative size of what rounding leaves of a quantity that is zero; also the increase of the diagonal of a normal
/// matrix, which makes it invertible.
pub const ROUNDING: f64 = 1e-9;

/// Ratio of a time between samples, or a time span of several, to the usual one, above which samples are missing.
pub const MAX_GAP: f64 = 1.5;

/// Ratio of a time between samples to the usual one, above which nothing is inferred of what happens between them.
pub const LONG_GAP: f64 = 3.5;

/// Relative difference up to which times between samples are the same, so that what was computed of them is used again.
pub const SAME_TIME: f64 = 1e-6;

/// Eigenvalue, squared pivot or damping of a matrix with unit diagonal, below which a direction depends on the others.
pub const RANK: f64 = 1e-12;

/// Number of neighbours on each side of a sample by which it is judged; two of them may be outliers.
pub const NEIGHBOURS: usize = 4;

/// Number of samples from which a series is a recording: its noise is estimated, and gaps in it are missing samples.
pub const MIN_SERIES: usize = 20;

/// Number of values from which a median or a variance is one of many; fewer may all be unusual.
pub const MIN_VALUES: usize = 8;

/// Number of samples before and after an event, such as a contact, by which it is judged: later ones belong to the next.
pub const BESIDE: usize = 8;

/// Number of samples that stand for a whole flight where each costs much, such as an integration or a pose.
pub const FEW_SAMPLES: usize = 12;

/// Number of flights that stand for all of them where each costs much, such as a fit.
pub const FEW_FLIGHTS: usize = 6;

/// Maximum number of rounds that start from what the one before has mended: what these do not mend is wrong otherwise.
pub const ROUNDS: usize = 3;

/// Maximum number of fits whose weights follow from the residuals of the one before: most agree after three or four.
pub const REWEIGHTINGS: usize = 8;

/// Maximum number of markers whose distances are compared: the pairs of more add little.
pub const MAX_MARKERS: usize = 8;

/// Maximum number of guesses from which one state is sought: most lead to few states.
pub const GUESSES: usize = 6;

/// Least number of samples of a segment of a flight for a guess; a flight with fewer is one segment.
pub const SEGMENT_SAMPLES: usize = 12;

/// Duration, s, of a segment of a flight that is short enough for a guess: forces hardly change in it.
pub const SEGMENT: f64 = 0.15;

/// Number of flights from which statements are made of the differences between flights.
pub const MIN_POPULATION: usize = 4;

/// Standard error of a direction, in typical magnitudes, above which the flights do not show it at all.
pub const CONFOUNDED: f64 = 1e3;

/// Share of the squares up to which what an explanation leaves of them is little; rounding of what it explains leaves 0.14.
pub const EXPLAINED: f64 = 0.2;

/// Relative difference up to which two sizes are alike: intervals, ratios of distances, initial states.
pub const ALIKE: f64 = 0.1;

/// Relative difference up to which results are the same: of iterations, of noise, of two ways to one acceleration.
pub const SAME: f64 = 0.005;

/// Ratio of a misfit to the least one up to which another meaning of readings is as good.
pub const AS_GOOD: f64 = 1.2;

/// Least cosine of the angle between two vectors with one direction, 30°.
pub const ALONG: f64 = 0.866;

/// Least vertical component of a direction that points up: noise and friction turn the others.
pub const UPWARD: f64 = 0.3;

/// Greatest delay of readings that is compared, in intervals between them.
pub const MAX_DELAY: i32 = 12;

/// Whether a ratio of sums of squares is clearly above that of noise of unknown size: by twice the gain of the
/// log-likelihood of this number of values.
pub fn is_clear(ratio: f64, count: f64) -> bool {
    ratio > NEAR_NOISE * NEAR_NOISE && count * ratio.ln() > SIGNIFICANT * SIGNIFICANT
}
